# SPDX-License-Identifier: MIT
"""The view of a scripted PLC on the machine in each tick: the HLI by names.

Everything that it writes counts from the next tick on (RC-002).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, NoReturn, Protocol

from nctakt.base.diagnostics import NOTHING, Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.hli.checked_values import split_channel
from nctakt.hli.function_codes import function_of
from nctakt.hli.layout import AXIS, CHANNEL
from nctakt.hli.operator_panel import SETTABLE, OperatorPanel
from nctakt.hli.plc_entries import NamedValues, SpindleEntry, TechnologyEntry
from nctakt.kernel import codes
from nctakt.kernel.plc.technology_slots import Hli
from nctakt.messages import diagnostic
from nctakt.messages.folders import UNKNOWN_CHANNEL
from nctakt.messages.memory import NOT_VISIBLE_TO_PLC
from nctakt.messages.plc import (
    INVALID_AXIS_COMMAND,
    TOO_MANY_AXIS_COMMANDS,
    UNKNOWN_PLC_AXIS,
)
from nctakt.run.assembly import AssembledMachine
from nctakt.run.inputs import PLC


class AnyPlc(Protocol):
    """Any object that plays the PLC; a user's class need not derive from it."""

    def cycle(self, hli: PlcView) -> None:
        """Read inputs and set outputs through the interface image; called after each tick."""


class WatchedPlc:
    """A PLC whose methods and their times are known before a run."""

    def begin_run(self, hli: PlcView) -> None:
        """Raise ``Failure`` if the PLC waits for names that the machine does not have."""

    def unused_handlers(self, hli: PlcView) -> Sequence[Diagnostic]:
        """Return a diagnostic for each method and input that a run did not use."""
        return ()


class PlcView(OperatorPanel):
    """The PLC's side of one channel; ``of_channel(2)`` is that of the second one.

    The operator's values (``OperatorPanel``) are attributes, too. Raises ``Failure`` for an
    unknown attribute and suggests the nearest one.
    """

    __slots__ = ("_hli", "_index", "_machine")
    _hli: Hli
    _index: int
    _machine: AssembledMachine

    def __init__(self, machine: AssembledMachine, index: int = 0) -> None:
        _set(self, "_machine", machine)
        _set(self, "_index", index)
        _set(self, "_hli", machine.channels[index].hli)

    if not TYPE_CHECKING:  # type checkers would accept any name

        def __getattr__(self, name: str) -> NoReturn:
            raise AttributeError(_unknown(name, public_names(PlcView)), name=name, obj=self)

        def __setattr__(self, name: str, value: object) -> None:
            if name not in SETTABLE:
                raise AttributeError(_unknown(name, SETTABLE), name=name, obj=self)
            _set(self, name, value)

    def __repr__(self) -> str:
        return f"<PlcView of channel {self._index + 1}: {self.state}, after tick {self.tick}>"

    def of_channel(self, number: int) -> PlcView:
        """Return the PLC's side of a channel, from 1; raises ``Failure`` if there is none."""
        count = len(self._machine.channels)
        if not 0 < number <= count:
            raise Failure(diagnostic(UNKNOWN_CHANNEL, channel=number, count=count))
        return PlcView(self._machine, number - 1)

    @property
    def tick(self) -> int:
        """The number of the latest tick."""
        return self._machine.kernel.tick - 1

    @property
    def time_us(self) -> int:
        """The time at which the latest tick began, in microseconds."""
        return self.tick * self._machine.configuration.cycle_time_us

    @property
    def cycle_time_us(self) -> int:
        """The length of a tick in microseconds."""
        return self._machine.configuration.cycle_time_us

    def channel(self) -> NamedValues:
        """Return the channel by the names of ``hli_channel``: ``path_speed``, ``block`` …"""
        machine = self._machine
        panel = machine.assembled[self._index].panel
        shown = {value.entry.name: value.cell for value in panel.values() if not value.is_command}
        for entry in CHANNEL.entries:
            if entry.source:
                shown[entry.name] = machine.layout.channel_value(self._index, entry.source)
        return NamedValues({name: machine.cells[cell] for name, cell in shown.items()})

    def axis(self, name: str) -> NamedValues:
        """Return an axis by the names of ``hli_axis``: ``command``, ``target``, ``state`` …"""
        machine, index = self._machine, self._axis(name)
        return NamedValues(
            {
                entry.name: machine.cells[machine.layout.axis_value(index, entry.source)]
                for entry in AXIS.entries
                if entry.source
            }
        )

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
        """Return 0 if a request is accepted, -1 before it is latched, else the error's number."""
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
        return [*self._waiting(is_realtime=False), *self._waiting(is_realtime=True)]

    def _waiting(self, *, is_realtime: bool) -> Iterator[TechnologyEntry]:
        section = self._hli.realtime if is_realtime else self._hli.program
        cycle_time_us = self._machine.configuration.cycle_time_us
        parameters = self._machine.assembled[self._index].parameters
        for slot, function, sequence, tick, serial in section.entries():
            letter, number = function_of(function)
            stamp_us = tick * cycle_time_us
            parameter = parameters.function(letter, number)
            yield TechnologyEntry(
                letter,
                number,
                sequence,
                stamp_us,
                is_realtime,
                parameter.process_time_us,
                parameter.axis_name,
                slot,
                section.value_of(slot),
                serial,
                "MOS" if is_realtime else parameter.synchronisation,
            )

    def acknowledge(self, entry: TechnologyEntry) -> None:
        """Acknowledge a function; a warning (900671) is reported if it no longer waits.

        Raises ``ValueError`` for an entry that is not one of ``functions``.
        """
        self._machine.inputs.acknowledge(
            self._index, entry.is_realtime, entry.slot, entry.serial, entry.name
        )

    def spindle_jobs(self) -> list[SpindleEntry]:
        """Return the jobs of spindles that the PLC turns, in the order of the channel list."""
        spindles = self._machine.channels[self._index].context.spindles
        cycle_time_us = self._machine.configuration.cycle_time_us
        name, jobs = self._machine.registry.spindle, spindles.jobs()
        return [
            SpindleEntry(
                name(spindles.first_number + index),
                function,
                speed_v / 6.0,
                position,
                sense,
                tick * cycle_time_us,
                before_v / 6.0,
                index,
                serial,
            )
            for index, function, speed_v, position, sense, tick, before_v, serial in jobs
        ]

    def acknowledge_spindle(self, job: SpindleEntry) -> None:
        """Acknowledge a job as done; a warning (900671) is reported if it no longer waits.

        Raises ``ValueError`` for a job that is not one of ``spindle_jobs``.
        """
        self._machine.inputs.acknowledge_spindle(self._index, job.index, job.serial, job.name)

    def acknowledge_all(self) -> None:
        """Acknowledge all waiting functions and spindle jobs."""
        for job in self.spindle_jobs():
            self.acknowledge_spindle(job)
        for entry in self.functions():
            self.acknowledge(entry)

    def read(self, name: str) -> float | bool | str:
        """Return a V. variable after this tick; raises ``Failure`` for V.CH (RC-309)."""
        return self._machine.read(self._own(name))

    def write(self, name: str, value: float | bool | str) -> None:
        """Write a V.E variable; raises ``Failure`` for a wrong name or value."""
        self._machine.write(self._own(name), value, PLC)

    def _own(self, name: str) -> str:
        """Return the name with its channel; raises ``Failure`` for V.CH (RC-309)."""
        prefix, _, path = split_channel(name)
        own = self._machine.assembled[self._index].prefix if self._index else ""
        return f"{prefix or own}{_seen(path)}"


#: Sets an attribute without a check of its name.
_set = object.__setattr__


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
