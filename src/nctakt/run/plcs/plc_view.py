# SPDX-License-Identifier: MIT
"""The view of a scripted PLC on the machine in each tick: the HLI by names.

Everything that it writes counts from the next tick on (RC-002).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, NoReturn, Protocol, TypeAlias

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.hli.checked_values import split_channel
from nctakt.hli.layout import AXIS, CHANNEL
from nctakt.hli.operator_panel import SETTABLE, OperatorPanel
from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
from nctakt.kernel import codes
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.kernel import Kernel
from nctakt.kernel.plc.technology_slots import Hli
from nctakt.kernel.tick.plc_calls import Delays, When
from nctakt.messages import diagnostic
from nctakt.messages.machines.folders import UNKNOWN_CHANNEL
from nctakt.messages.machines.memory import NOT_VISIBLE_TO_PLC
from nctakt.messages.plcs.plc import (
    INVALID_AXIS_COMMAND,
    TOO_MANY_AXIS_COMMANDS,
    UNKNOWN_PLC_AXIS,
)
from nctakt.run.access.bound_values import BoundValue
from nctakt.run.access.hli_values import AxisValues, ChannelValues
from nctakt.run.access.inputs import PLC
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.run.realtime.waiting_entries import waiting_functions, waiting_jobs


class AnyPlc(Protocol):
    """Any object that plays the PLC; a user's class need not derive from it."""

    def cycle(self, hli: PlcView) -> None:
        """Read inputs and set outputs through the interface image; called after each tick."""


#: A PLC in Python: an object, or a class that makes one.
GivenPlc: TypeAlias = AnyPlc | type[AnyPlc]


@dataclass(frozen=True, slots=True)
class Declaration:
    """The events that a PLC waits for, so that it is not called in ticks without any.

    ``call`` is due when a function or a job appears, one of ``whens`` becomes true, or the tick
    ``next_call`` has been run; then functions are acknowledged after their ``delays``.
    """

    whens: Sequence[When]
    delays: Delays
    call: Callable[[PlcView], object]
    next_call: Callable[[PlcView], int]


class WatchedPlc:
    """A PLC whose methods and their times are known before a run."""

    def begin_run(self, hli: PlcView) -> None:
        """Raise ``Failure`` if the PLC waits for names that the machine does not have."""

    def notes(self) -> Sequence[Diagnostic]:
        """Return notes about it before a run."""
        return ()

    def unused_handlers(self, hli: PlcView) -> Sequence[Diagnostic]:
        """Return a diagnostic for each method and input that a run did not use."""
        return ()

    def declaration(self, hli: PlcView) -> Declaration | None:
        """Return the events that it waits for; ``None`` if it is called after each tick."""
        return None

    def each_call(self) -> Callable[[PlcView], object] | None:
        """Return the function called after each tick instead of ``cycle``, if there is one."""
        return None

    def failure(self, error: BaseException, hli: PlcView) -> BaseException:
        """Return the exception to raise instead of an exception of the PLC."""
        return error


class PlcView(OperatorPanel):
    """The PLC's side of one channel; ``of_channel(2)`` is that of the second.

    The operator's values (``OperatorPanel``) are attributes, too; elements of the interface have
    the controller's paths as their keys. Raises ``Failure`` for an unknown attribute and suggests
    the nearest one. A PLC annotates it as ``nctakt.HliView``.

    >>> hli: HliView = Controller().hli
    >>> hli.override_pct, hli["gpCh[0]^.bahn_mc_control.override.state_r"]
    (100.0, 1000)
    """

    __slots__ = (
        "_axes", "_bound", "_channel", "_cycle_time_us", "_hli", "_index", "_kernel", "_machine",
        "_spindles",
    )  # fmt: skip
    _axes: dict[str, AxisValues]
    _bound: dict[str, BoundValue]
    _channel: ChannelValues | None
    _cycle_time_us: int
    _hli: Hli
    _index: int
    _kernel: Kernel
    _machine: AssembledMachine
    _spindles: Spindles

    def __init__(self, machine: AssembledMachine, index: int = 0) -> None:
        _set(self, "_machine", machine)
        _set(self, "_index", index)
        _set(self, "_hli", machine.channels[index].hli)
        _set(self, "_spindles", machine.channels[index].context.spindles)
        _set(self, "_kernel", machine.kernel)
        _set(self, "_cycle_time_us", machine.configuration.cycle_time_us)
        _set(self, "_axes", {})
        _set(self, "_bound", {})
        _set(self, "_channel", None)

    if not TYPE_CHECKING:  # type checkers would accept any name

        def __getattr__(self, name: str) -> NoReturn:
            raise AttributeError(_unknown(name, public_names(PlcView)), name=name, obj=self)

        def __setattr__(self, name: str, value: object) -> None:
            setter = _SETTERS.get(name)
            if setter is None:
                raise AttributeError(_unknown(name, SETTABLE), name=name, obj=self)
            setter(self, value)

    def __repr__(self) -> str:
        return f"<PlcView of channel {self._index + 1}: {self.state}, after tick {self.tick}>"

    def of_channel(self, number: int) -> PlcView:
        """Return the PLC's side of a channel, from 1; raises ``Failure`` if there is none."""
        count = len(self._machine.channels)
        if not 0 < number <= count:
            raise Failure(diagnostic(UNKNOWN_CHANNEL, channel=number, count=count))
        return PlcView(self._machine, number - 1)

    @property
    def channel_count(self) -> int:
        """The number of channels."""
        return len(self._machine.channels)

    @property
    def tick(self) -> int:
        """The number of the latest tick."""
        return self._kernel.tick - 1

    @property
    def time_us(self) -> int:
        """The time at which the latest tick began, in microseconds."""
        return (self._kernel.tick - 1) * self._cycle_time_us

    @property
    def cycle_time_us(self) -> int:
        """The length of a tick in microseconds."""
        return self._cycle_time_us

    def channel(self) -> ChannelValues:
        """Return the channel by the names of ``hli_channel``: ``path_speed``, ``block`` …"""
        if self._channel is None:
            machine = self._machine
            panel = machine.assembled[self._index].panel
            found = {value.entry.name: value.cell for value in panel.values()}
            for entry in CHANNEL.entries:
                if entry.source:
                    found[entry.name] = machine.layout.channel_value(self._index, entry.source)
            _set(self, "_channel", ChannelValues(machine.kernel, found))
        assert self._channel is not None
        return self._channel

    def axis(self, name: str) -> AxisValues:
        """Return an axis by the names of ``hli_axis``: ``command``, ``target``, ``state`` …"""
        axis = self._axes.get(name)
        return self._bind_axis(name) if axis is None else axis

    def _bind_axis(self, name: str) -> AxisValues:
        machine, index = self._machine, self._axis(name)
        found = {
            entry.name: machine.layout.axis_value(index, entry.source)
            for entry in AXIS.entries
            if entry.source
        }
        self._axes[name] = AxisValues(machine.kernel, found)
        return self._axes[name]

    def variable(self, name: str) -> BoundValue:
        """Return a V. variable or an operator's value, bound for any number of accesses.

        Its ``value`` is the present one; raises ``Failure`` for an unknown name, V.CH (RC-309).
        """
        bound = self._bound.get(name)
        if bound is None:
            bound = self._machine.access.bind(self._own(name)).of_source(PLC)
            if len(self._bound) < _MAX_BOUND:
                self._bound[name] = bound
        return bound

    # --- single axes, for the function blocks of ``plc/axes.py`` --------------------------------

    def _axis(self, name: str) -> int:
        """Return the number of an axis; raises ``Failure`` (900656) for an unknown name."""
        names = {axis.name: i for i, axis in enumerate(self._machine.configuration.axes)}
        if name not in names:
            near = nearest(str(name), names) or NOTHING
            known_names = ", ".join(names)
            raise Failure(diagnostic(UNKNOWN_PLC_AXIS, name=name, nearest=near, known=known_names))
        return names[name]

    def request_axis(
        self, kind: int, name: str, value: float, speed: float, mode: int, direction: int
    ) -> int:
        """Request a motion for the next tick and return its owner's number."""
        axis = self._axis(name)
        if kind not in (codes.HALT, codes.CLEAR_FAULT) and not (
            math.isfinite(value) and 0.0 < speed < math.inf
        ):
            raise Failure(diagnostic(INVALID_AXIS_COMMAND, name=name, value=value, speed=speed))
        owner = self._machine.inputs.request_axis(kind, axis, value, speed, mode, direction)
        if owner == 0:
            raise Failure(diagnostic(TOO_MANY_AXIS_COMMANDS, name=name))
        return owner

    def axis_answer(self, owner: int) -> int:
        """Return 0 if a request is accepted, -1 before it is latched, or the error's number."""
        return self._machine.kernel.requests.answer_to(owner)

    def is_axis_open(self, owner: int) -> bool:
        """Return whether a requested motion runs or waits."""
        return self._machine.kernel.requests.is_open(owner)

    def is_axis_active(self, name: str, owner: int) -> bool:
        """Return whether a requested motion is that of the axis now."""
        return self._machine.kernel.requests.is_active(self._axis(name), owner)

    def has_axis_arrived(self, name: str, owner: int) -> bool:
        """Return whether a requested motion has reached its target, and no later one has."""
        return self._machine.kernel.requests.has_arrived(self._axis(name), owner)

    def is_axis_at_speed(self, name: str) -> bool:
        """Return whether an endless motion has reached its speed."""
        return self._machine.single_axes.at_speed(self._axis(name))

    def axis_fault(self, name: str) -> int:
        """Return the number of the error that has stopped the axis."""
        return self._machine.single_axes.fault_of(self._axis(name))

    def known_functions(self) -> list[str]:
        """Return the M, H and T functions of the channel, and its spindles that the PLC turns."""
        parameters = self._machine.assembled[self._index].parameters
        return [
            *(f"M{number}" for number in parameters.m_functions),
            *(f"H{number}" for number in parameters.h_functions),
            *(f"T{number}" for number in self._tools()),
            *(spindle.name for spindle in parameters.spindles if spindle.plc_controlled),
        ]

    def _tools(self) -> Iterable[int]:
        """Return the tools of the list where T goes to the PLC (P-CHAN-00086)."""
        assembled = self._machine.assembled[self._index]
        has_output = assembled.parameters.tool_selection.output is not None
        return assembled.configuration.tools if has_output else ()

    # --- M, H and T functions -------------------------------------------------------------------

    def functions(self) -> list[TechnologyEntry]:
        """Return the waiting functions, those of the main program first, in their order."""
        parameters = self._machine.assembled[self._index].parameters
        return waiting_functions(self._hli, parameters, self._cycle_time_us)

    def acknowledge(self, entry: TechnologyEntry) -> None:
        """Acknowledge a function; a warning (900671) is reported if it no longer waits.

        Raises ``ValueError`` for an entry that is not one of ``functions``.
        """
        self._machine.inputs.acknowledge(
            self._index, entry.is_realtime, entry.slot, entry.serial, entry.name
        )

    def spindle_jobs(self) -> list[SpindleEntry]:
        """Return the jobs of spindles that the PLC turns, in the order of the channel list."""
        return waiting_jobs(self._spindles, self._machine.registry, self._cycle_time_us)

    def acknowledge_spindle(self, job: SpindleEntry) -> None:
        """Acknowledge a job as done; a warning (900671) is reported if it no longer waits.

        Raises ``ValueError`` for a job that is not one of ``spindle_jobs``.
        """
        self._machine.inputs.acknowledge_spindle(self._index, job.index, job.serial, job.name)

    def acknowledge_all(self) -> None:
        """Acknowledge all waiting functions and spindle jobs."""
        if self._spindles.has_jobs():
            for job in self.spindle_jobs():
                self.acknowledge_spindle(job)
        if self._hli.waiting_count():
            for entry in self.functions():
                self.acknowledge(entry)

    def read(self, name: str) -> float | bool | str:
        """Return a V. variable, or one of a PLC in Structured Text, after this tick.

        Raises ``Failure`` for V.CH (RC-309).
        """
        if name not in self._bound and self._is_structured(name):
            return self._machine.access.read(name)
        return (self._bound.get(name) or self.variable(name)).value

    def write(self, name: str, value: float | bool | str) -> None:
        """Write a V.E variable, or one of a PLC in Structured Text from its next cycle on.

        Raises ``Failure`` for a wrong name or value.
        """
        if name not in self._bound and self._is_structured(name):
            self._machine.access.write(name, value, PLC)
            return
        (self._bound.get(name) or self.variable(name)).write(value, PLC)

    def _is_structured(self, name: str) -> bool:
        """Return whether a name is a variable of a PLC in Structured Text in the same run."""
        named = self._machine.access.named
        return named is not None and isinstance(name, str) and named.knows(name)

    def __getitem__(self, path: str) -> float | bool | str:
        """Return an element of the interface by the controller's path; raises ``Failure``.

        Any channel and axis: ``hli["gpCh[0]^.bahn_state.coord_r[0].act_position_r"]``, in the units
        of the controller (0.1 µm, µm/s, 0.1 %).
        """
        return self._machine.interface.get(path)

    def __setitem__(self, path: str, value: float | bool | str) -> None:
        """Write an element of the interface by the controller's path; raises ``Failure``."""
        self._machine.write(path, value, PLC)

    def _own(self, name: str) -> str:
        """Return the name with its channel; raises ``Failure`` for V.CH (RC-309)."""
        prefix, _, path = split_channel(name)
        own = self._machine.assembled[self._index].prefix if self._index else ""
        return f"{prefix or own}{_seen(path)}"


#: Sets an attribute without a check of its name.
_set = object.__setattr__

#: Maximum number of names kept bound by a view; they can be spelled in any number of ways.
_MAX_BOUND = 10_000

#: Setters of the attributes that a PLC may set.
_SETTERS = {name: vars(OperatorPanel)[name].fset for name in SETTABLE}


def public_names(kind: type) -> list[str]:
    """Return the public names of a class."""
    return [name for name in dir(kind) if not name.startswith("_")]


def _unknown(name: str, names: Iterable[str]) -> str:
    near = nearest(name, names)
    return f"hli has no {name} to use" + (f"; did you mean {near}?" if near else "")


def _seen(name: str) -> str:
    """Return the name of a variable that a PLC sees; raises ``Failure`` for V.CH (RC-309)."""
    if name.upper().replace(" ", "").startswith(("V.CH.", "VS.CH.")):
        raise Failure(diagnostic(NOT_VISIBLE_TO_PLC, name=name))
    return name
