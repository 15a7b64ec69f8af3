# SPDX-License-Identifier: MIT
"""Realtime cycles as nodes: their state, and how often the bodies of their branches ran.

In: the cycles at a moment. Out: an object for each that has existed since the server's start. A
cycle that is gone keeps its object, whose state says so.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from asyncua import ua

from nctakt.servers.opcua.live_space import LiveSpace
from nctakt.servers.opcua.model import nodes as refs
from nctakt.servers.opcua.model.companion import BASE_OBJECT, BASE_VARIABLE
from nctakt.servers.opcua.model.nodes import Nodes, VariableValue, standard
from nctakt.servers.opcua.space.machine_space import MachineSpace
from nctakt.servers.opcua.values import Live, NotSupported, Value, ValueSnapshot
from nctakt.session.engine import BranchState, CycleState

#: Cycles that get nodes at most; programs without end could define cycles without end.
MAX_CYCLES = 500

#: The key of a cycle: its name and its place.
Key = tuple[str, str, int]

_STRING, _COUNT = ua.VariantType.String, ua.VariantType.UInt64


def key_of(cycle: CycleState) -> Key:
    """Return the key of a cycle."""
    return cycle.name, cycle.span.file, cycle.span.line


class CycleSpace:
    """The realtime cycles below the interface."""

    def __init__(self, nodes: Nodes, machine: MachineSpace, live: LiveSpace) -> None:
        self._nodes = nodes
        self._machine = machine
        self._live = live
        self._known: dict[Key, ua.NodeId] = {}
        self._folder = "CncInterface.RealtimeCycles"
        folder = nodes.add_object(
            machine.id(self._folder), machine.name("RealtimeCycles"), standard(61)
        )
        nodes.refer(machine.interface, refs.HAS_COMPONENT, folder)

    def show(self, cycles: Sequence[CycleState]) -> list[ua.NodeId]:
        """Add the cycles that have no node yet; return their new nodes."""
        added = []
        for cycle in cycles:
            key = key_of(cycle)
            if key not in self._known and len(self._known) < MAX_CYCLES:
                self._known[key] = node = self._add(key, cycle)
                added.append(node)
        return added

    def _add(self, key: Key, cycle: CycleState) -> ua.NodeId:
        taken = {str(node.Identifier) for node in self._known.values()}
        name = cycle.name
        while f"{self._folder}.{name}" in taken:
            name += "'"
        path = f"{self._folder}.{name}"
        node = self._nodes.add_object(
            self._machine.id(path), self._machine.name(name), standard(BASE_OBJECT)
        )
        self._nodes.refer(self._machine.id(self._folder), refs.HAS_COMPONENT, node)
        for part, kind, read in (
            ("State", _STRING, _read(key, lambda found: found.state, "gone")),
            ("Scope", _STRING, lambda _: cycle.scope),
            ("Place", _STRING, lambda _: str(cycle.span)),
            ("Runs", _COUNT, _read(key, lambda found: found.runs)),
            ("Ran", _COUNT, _read(key, lambda found: sum(one.count for one in found.branches))),
        ):
            self._add_value(path, part, kind, read)
        for index, branch in enumerate(cycle.branches):
            own = f"{path}.Line_{branch.span.line}"
            if self._machine.id(own) in self._live.space:
                own += f"_{branch.span.column}"
            branch_node = self._nodes.add_object(
                self._machine.id(own),
                self._machine.name(own.rpartition(".")[2]),
                standard(BASE_OBJECT),
            )
            self._nodes.refer(node, refs.HAS_COMPONENT, branch_node)
            self._add_value(own, "Ran", _COUNT, _of_branch(key, index, lambda one: one.count))
            self._add_value(
                own, "Condition", ua.VariantType.Boolean, _of_branch(key, index, _truth_of)
            )
        return node

    def _add_value(
        self, path: str, name: str, kind: ua.VariantType, read: Callable[[ValueSnapshot], Value]
    ) -> None:
        node = self._machine.id(f"{path}.{name}")
        self._nodes.add_variable(
            node,
            self._machine.name(name),
            standard(BASE_VARIABLE),
            VariableValue(
                standard(int(kind)),
                ua.DataValue(StatusCode=ua.StatusCode(ua.StatusCodes.BadWaitingForInitialData)),
            ),
        )
        self._nodes.refer(self._machine.id(path), refs.HAS_COMPONENT, node)
        self._live.add(node, Live(kind, read, needs_state_view=True))


def _find(key: Key, moment: ValueSnapshot) -> CycleState | None:
    if moment.state_view is None:
        raise NotSupported(int(ua.StatusCodes.BadWaitingForInitialData))
    return next((one for one in moment.state_view.cycles if key_of(one) == key), None)


def _read(
    key: Key, value_of: Callable[[CycleState], Value], gone: Value = None
) -> Callable[[ValueSnapshot], Value]:
    def read(moment: ValueSnapshot) -> Value:
        found = _find(key, moment)
        if found is not None:
            return value_of(found)
        if gone is None:
            raise NotSupported(int(ua.StatusCodes.BadNoData))
        return gone

    return read


def _of_branch(
    key: Key, index: int, value_of: Callable[[BranchState], Value]
) -> Callable[[ValueSnapshot], Value]:
    return _read(key, lambda found: value_of(found.branches[index]))


def _truth_of(branch: BranchState) -> bool:
    if branch.truth is None:
        raise NotSupported(int(ua.StatusCodes.BadWaitingForInitialData))
    return branch.truth
