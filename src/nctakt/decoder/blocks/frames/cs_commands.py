# SPDX-License-Identifier: MIT
"""``#CS``, ``#ACS``, ``#BCS``, ``#ECS`` -> commands for the active coordinate system (MO-8).

In: the tree of a checked command. Stored systems are numbered separately for each kind; one without
a number gets the next free one. At most five of a kind are stored, ten are active at a time.
Systems with names (``#CS ADD``) form a stack; ``#CS SELECT`` activates it from the bottom up to one
of them.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence

from nctakt.base.diagnostics import NOTHING, Span
from nctakt.decoder.state.geometry.coordinate_systems import (
    LAYERS,
    MAIN_AXES,
    Placement,
    effector_placement,
    placement_of,
)
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.messages.path.coordinate_systems import (
    COORDINATE_SYSTEM_DURING_COMPENSATION,
    COORDINATE_SYSTEM_NAME_TAKEN,
    COORDINATE_SYSTEM_NOT_STORED,
    COORDINATE_SYSTEM_STACK_FULL,
    CS_SELECT_DURING_CS_ON,
    EFFECTOR_SYSTEM_WITH_OTHERS,
    INVALID_COORDINATE_SYSTEM_NUMBER,
    LINEAR_AXES_MISSING,
    MACHINE_SYSTEM_MISSING,
    NO_COORDINATE_SYSTEM_ACTIVE,
    TOO_MANY_ACTIVE_SYSTEMS,
    TOO_MANY_COORDINATE_SYSTEMS,
    UNKNOWN_COORDINATE_SYSTEM_NAME,
)
from nctakt.messages.path.transformations import COORDINATE_SYSTEM_DURING_PTP
from nctakt.nc import tree
from nctakt.nc.meaning.coordinates import FIXED_ROTATION, MACHINE_SYSTEM, CsCommand, cs_command

#: Maximum number of stored systems of a kind, and of systems on the stack.
MAX_STORED = 5
#: Maximum number of active systems of all kinds.
MAX_ACTIVE = 10

_CS, _ECS = LAYERS.index("CS"), LAYERS.index("ECS")


class _StoredSystems:
    """The systems of one kind by their numbers, and the number of the latest one."""

    def __init__(self) -> None:
        self.by_number: dict[int, Placement] = {}
        self.latest = 0


class CsCommands:
    """The commands of one program about its coordinate systems."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        self._listed = values.environment.parameters.coordinate_systems
        self._is_fixed = self._listed.is_rotation_fixed
        self._has_own_offsets = self._listed.has_own_offsets
        self._stored = {kind: _StoredSystems() for kind in LAYERS}
        self._stack: dict[str, Placement] = {}
        self._selected = 0

    def command(self, statement: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute one command."""
        command = cs_command(statement)
        assert command is not None
        if command.action.startswith("MODE"):
            self._set_mode(command.name, is_on=command.action == "MODE ON")
            return
        span = statement.span
        offsets = self._environment.offsets
        if self._values.state.path.compensation.is_active:
            self._values.fail(COORDINATE_SYSTEM_DURING_COMPENSATION, span, command=command.shown)
        is_defined = command.action in ("DEF", "DEF ACT", "ADD")
        if offsets.transformation.is_straight and not is_defined:
            self._values.fail(COORDINATE_SYSTEM_DURING_PTP, span, command=command.shown)
        is_off = command.action.startswith("OFF")
        if offsets.systems.count_of(_ECS) and not (is_off or is_defined):
            other = "#ECS ON"
            self._values.fail(EFFECTOR_SYSTEM_WITH_OTHERS, span, command=command.shown, other=other)
        if is_off:
            yield from self._off(command, span, number)
            return
        self._check_axes(span)
        if command.action == "ADD":
            yield from self._add(command, span, number)
        elif command.action == "SELECT":
            yield from self._select(command.name, span, number)
        else:
            system = yield from self._system(command, span, number)
            if command.action == "ON":
                yield from self._enter(LAYERS.index(command.kind), system, span, number)

    def stored(self, value: float, span: Span, kind: str = "CS") -> Placement:
        """Return the stored system of a number."""
        identity = int(arithmetic.round_half_even(value))
        systems = self._stored[kind].by_number
        if identity in systems:
            return systems[identity]
        listed = self._from_list(str(identity))
        if listed is None:
            known = ", ".join([*map(str, systems), *self._listed.systems]) or NOTHING
            self._values.fail(
                COORDINATE_SYSTEM_NOT_STORED, span, kind=kind, id=identity, known=known
            )
        return listed

    def _from_list(self, name: str) -> Placement | None:
        """Return a system of the channel list (P-CHAN-00490); ``None`` if there is none."""
        components = self._listed.systems.get(name)
        if components is None:
            return None
        return placement_of(components, is_fixed=self._is_fixed)

    def _set_mode(self, word: str, *, is_on: bool) -> None:
        if word == FIXED_ROTATION:
            self._is_fixed = is_on
        else:
            self._has_own_offsets = is_on

    def enter_effector(
        self, direction: Sequence[float], span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Activate the system along the tool (``#ECS ON``); it has the program's zero."""
        command, systems = "#ECS ON", self._environment.offsets.systems
        if self._values.state.path.compensation.is_active:
            self._values.fail(COORDINATE_SYSTEM_DURING_COMPENSATION, span, command=command)
        if systems.is_active:
            kind = next(kind for kind in reversed(LAYERS) if systems.count_of(LAYERS.index(kind)))
            self._values.fail(
                EFFECTOR_SYSTEM_WITH_OTHERS, span, command=command, other=f"#{kind} ON"
            )
        self._check_axes(span)
        plane, has_first_there = self._listed.effector_plane, self._listed.has_first_effector_axis
        system = effector_placement(direction, plane, has_first_there=has_first_there)
        yield from self._enter(_ECS, system, span, number)

    # --- activation -----------------------------------------------------------------------------

    def _enter(
        self, layer: int, system: Placement, span: Span, number: int
    ) -> Generator[Command, Answer]:
        """Activate a system of a kind, an index of ``LAYERS``."""
        offsets = self._environment.offsets
        if offsets.systems.count >= MAX_ACTIVE:
            self._values.fail(TOO_MANY_ACTIVE_SYSTEMS, span, maximum=MAX_ACTIVE)
        axes = len(self._environment.axes) if self._has_own_offsets else MAIN_AXES
        source = self._environment.source_id(span)
        yield from offsets.enter_system(layer, system, axes, source, number)

    def _off(self, command: CsCommand, span: Span, number: int) -> Generator[Command, Answer]:
        """Deactivate the last system of a kind, or all of them; a selected stack as a whole."""
        layer = LAYERS.index(command.kind)
        count = self._environment.offsets.systems.count_of(layer)
        if command.action == "OFF":
            if not count:
                self._values.warn(NO_COORDINATE_SYSTEM_ACTIVE, span, kind=command.kind)
                return
            is_stack = layer == _CS and count <= self._selected
            count = self._selected if is_stack else 1
        yield from self._leave(layer, count, self._environment.source_id(span), number)

    def _leave(
        self, layer: int, count: int, source: int, number: int
    ) -> Generator[Command, Answer]:
        """Deactivate ``count`` systems of a kind, the innermost first."""
        offsets = self._environment.offsets
        for _ in range(count):
            yield from offsets.leave_system(layer, source, number)
        self._selected = min(self._selected, offsets.systems.count_of(_CS))

    def _add(self, command: CsCommand, span: Span, number: int) -> Generator[Command, Answer]:
        """Push a system onto the stack (``#CS ADD``) without activating it."""
        name, names = command.name, ", ".join(self._stack)
        if name in self._stack:
            self._values.fail(COORDINATE_SYSTEM_NAME_TAKEN, span, name=name, known=names)
        if len(self._stack) >= MAX_STORED:
            self._values.fail(
                COORDINATE_SYSTEM_STACK_FULL, span, name=name, maximum=MAX_STORED, known=names
            )
        assert command.components is not None
        self._stack[command.name] = yield from self._evaluated(command.components, number)

    def _select(self, name: str, span: Span, number: int) -> Generator[Command, Answer]:
        """Activate the stack from the bottom up to a system (``#CS SELECT``).

        MCS is the system of an active transformation, below the stack.
        """
        offsets = self._environment.offsets
        is_machine = name == MACHINE_SYSTEM
        if is_machine and not offsets.transformation.is_transformation:
            self._values.fail(MACHINE_SYSTEM_MISSING, span)
        if name not in self._stack and not is_machine:
            names = ", ".join(self._stack) or NOTHING
            self._values.fail(UNKNOWN_COORDINATE_SYSTEM_NAME, span, name=name, known=names)
        if offsets.systems.count_of(_CS) > self._selected:
            self._values.fail(CS_SELECT_DURING_CS_ON, span)
        source = self._environment.source_id(span)
        yield from self._leave(_CS, self._selected, source, number)
        if is_machine:
            return
        for other, system in self._stack.items():
            yield from self._enter(_CS, system, span, number)
            self._selected += 1
            if other == name:
                return

    def _check_axes(self, span: Span) -> None:
        axes = self._environment.axes
        if self._environment.places.lacks_any(range(MAIN_AXES)) or not all(
            axis.is_linear for axis in axes[:MAIN_AXES]
        ):
            self._values.fail(LINEAR_AXES_MISSING, span)

    # --- definition -----------------------------------------------------------------------------

    def _evaluated(
        self, components: Sequence[tree.Expression], number: int
    ) -> Generator[Command, Answer, Placement]:
        """Return where a system of these components lies."""
        values: list[float] = []
        for index, component in enumerate(components):
            value = yield from self._values.evaluate(component, number)
            values.append(value * self._values.state.length_unit_mm if index < 3 else value)
        return placement_of(values, is_fixed=self._is_fixed)

    def _system(
        self, command: CsCommand, span: Span, number: int
    ) -> Generator[Command, Answer, Placement]:
        """Return the system of DEF, DEF ACT or ON; store it if it has a number."""
        kind = command.kind
        if command.name:
            listed = self._from_list(command.name)
            if listed is None:
                known = ", ".join(self._listed.systems) or NOTHING
                self._values.fail(
                    COORDINATE_SYSTEM_NOT_STORED, span, kind=kind, id=command.name, known=known
                )
            return listed
        systems = self._stored[kind]
        identity = systems.latest
        if command.identity is not None:
            value = yield from self._values.evaluate(command.identity, number)
            identity = int(arithmetic.round_half_even(value))
        if command.action == "DEF ACT":
            system = self._environment.offsets.systems.placement()
        elif command.components is None:
            return self.stored(identity, span, kind)
        else:
            system = yield from self._evaluated(command.components, number)
        if command.identity is None:
            if command.action == "ON":
                return system
            free = range(1, MAX_STORED + 2)
            identity = next(each for each in free if each not in systems.by_number)
        elif identity < 1:
            self._values.fail(INVALID_COORDINATE_SYSTEM_NUMBER, span, kind=kind, id=identity)
        if identity not in systems.by_number and len(systems.by_number) >= MAX_STORED:
            self._values.fail(TOO_MANY_COORDINATE_SYSTEMS, span, kind=kind, maximum=MAX_STORED)
        systems.by_number[identity] = system
        systems.latest = identity
        return system
