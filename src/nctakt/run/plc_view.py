# SPDX-License-Identifier: MIT
"""The view of a scripted PLC on the machine in each tick: the HLI by names.

Everything that it writes counts from the next tick on (RC-002).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, NoReturn, Protocol

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.text import nearest
from nctakt.hli.function_codes import function_of
from nctakt.hli.layout import AXIS, CHANNEL, LAMPS
from nctakt.kernel import codes
from nctakt.kernel.plc.technology_slots import Hli
from nctakt.messages import diagnostic
from nctakt.messages.folders import UNKNOWN_CHANNEL
from nctakt.messages.memory import NOT_VISIBLE_TO_PLC
from nctakt.messages.plc import (
    INVALID_AXIS_COMMAND,
    TOO_MANY_AXIS_COMMANDS,
    UNKNOWN_HLI_VALUE,
    UNKNOWN_PLC_AXIS,
)
from nctakt.run.assembly import AssembledMachine
from nctakt.run.inputs import PLC
from nctakt.run.variable_access import split_channel


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


#: The states of a channel in the order of their numbers.
STATES = ("ready", "running", "error", "reset")

#: The states of backward motion on the path, in the order of their numbers.
RETRACES = ("front", "backward", "forward")


#: The values of ``PlcView.axis`` and ``PlcView.channel``.
AXIS_NAMES = tuple(entry.name for entry in AXIS.entries if entry.source)
CHANNEL_NAMES = tuple(
    entry.name for entry in (*LAMPS, *CHANNEL.entries) if entry in LAMPS or entry.source
)


@dataclass(frozen=True, slots=True)
class TechnologyEntry:
    """A function that waits for its acknowledgement.

    ``letter`` is M, H or T, ``sequence`` its number among those of the same tick and section,
    ``time_us`` its time stamp. ``is_realtime``: a realtime cycle has commanded it (POS_RT).
    ``synchronisation`` is its type: MOS for those of cycles, else that of the channel list
    (P-CHAN-00041, P-CHAN-00027).
    ``process_time_us`` is its time in the channel list (P-CHAN-00040, P-CHAN-00026), ``axis`` its
    axis or spindle (P-CHAN-00039, P-CHAN-00025), empty for the channel. ``value`` is its value in
    the program, as in ``M110=130``, 0 without one. ``serial`` distinguishes it from earlier entries
    in its slot.
    """

    letter: str
    number: int
    sequence: int
    time_us: int
    is_realtime: bool
    process_time_us: float
    axis: str
    slot: int
    value: int = 0
    serial: int = 0
    synchronisation: str = "MOS"

    @property
    def identifier(self) -> str:
        """``POS_RT`` for a function of a realtime cycle, else empty."""
        return "POS_RT" if self.is_realtime else ""

    @property
    def name(self) -> str:
        """The function as in a program: ``M100``."""
        return f"{self.letter}{self.number}"

    @property
    def key(self) -> tuple[str, int]:
        """Its section and slot."""
        return "realtime" if self.is_realtime else "program", self.slot

    @property
    def stamp(self) -> tuple[int, int]:
        """The numbers that distinguish it from earlier entries in its slot."""
        return self.time_us, self.sequence


@dataclass(frozen=True, slots=True)
class SpindleEntry:
    """A job of a spindle that the PLC turns, until it is acknowledged.

    ``function``: M 3, 4, 5 or 19. ``speed``: in revolutions per minute. ``position``: of M19, in
    degrees. ``direction``: of M19, 1 forward, -1 backward, 0 the shorter way. ``speed_before``: the
    speed after the last acknowledged job, in revolutions per minute, negative under M4. ``index``:
    that of the spindle in the channel. ``serial`` distinguishes it from earlier jobs.
    """

    spindle: str
    function: int
    speed: float
    position: float
    direction: int
    time_us: int
    speed_before: float
    index: int
    serial: int = 0

    @property
    def name(self) -> str:
        """The name of the spindle."""
        return self.spindle

    @property
    def key(self) -> tuple[str, int]:
        """The index of its spindle."""
        return "spindle", self.index

    @property
    def stamp(self) -> tuple[int, int]:
        """The numbers that distinguish it from earlier jobs of the spindle."""
        return self.time_us, self.function


class NamedValues(dict[str, float]):
    """Values by the names of the interface; raises ``Failure`` (901012) for another name."""

    __slots__ = ()

    def __missing__(self, name: object) -> float:
        near = nearest(str(name), self) or NOTHING
        raise Failure(diagnostic(UNKNOWN_HLI_VALUE, name=name, nearest=near, known=", ".join(self)))


class PlcView:
    """The PLC's side of one channel; ``of_channel(2)`` is that of the second one.

    Raises ``Failure`` for an unknown attribute and suggests the nearest one.
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

    @property
    def override_pct(self) -> float:
        """The operator's override of the path in percent."""
        return float(self.read("HLI.OVERRIDE"))

    @override_pct.setter
    def override_pct(self, value: float) -> None:
        if not 0.0 <= value < float("inf"):
            raise ValueError(f"an override of {value} % is not possible")
        self.write("HLI.OVERRIDE", value)

    @property
    def feed_hold(self) -> bool:
        """Whether the path is held."""
        return bool(self.read("HLI.FEED_HOLD"))

    @feed_hold.setter
    def feed_hold(self, value: bool) -> None:
        self.write("HLI.FEED_HOLD", value)

    @property
    def single_block(self) -> bool:
        """Whether the channel stops before each block (MO-6)."""
        return bool(self.read("HLI.SINGLE_BLOCK"))

    @single_block.setter
    def single_block(self, value: bool) -> None:
        self.write("HLI.SINGLE_BLOCK", value)

    @property
    def optional_stop(self) -> bool:
        """Whether M01 stops the program as M00 does."""
        return bool(self.read("HLI.OPTIONAL_STOP"))

    @optional_stop.setter
    def optional_stop(self, value: bool) -> None:
        self.write("HLI.OPTIONAL_STOP", value)

    @property
    def backward_motion(self) -> bool:
        """Whether backward motion on the path is commanded (MO-7)."""
        return bool(self.read("HLI.BACKWARD_MOTION"))

    @backward_motion.setter
    def backward_motion(self, value: bool) -> None:
        self.write("HLI.BACKWARD_MOTION", value)

    @property
    def retrace(self) -> str:
        """Backward motion on the path: ``front``, or in the history ``backward`` or ``forward``."""
        return RETRACES[int(self.read("HLI.RETRACE"))]

    @property
    def history(self) -> int:
        """The number of blocks in the history of the path."""
        return int(self.read("HLI.HISTORY"))

    @property
    def history_size(self) -> int:
        """The maximum number of blocks in the history (P-STUP-00033)."""
        return int(self.read("HLI.HISTORY_SIZE"))

    def start(self) -> None:
        """Press START: the selected program begins, or continues after M00 or single block."""
        self.write("HLI.START", 1.0)

    def reset(self) -> None:
        """Press RESET: the program is aborted, the path brakes to a standstill (RC-007)."""
        self.write("HLI.RESET", 1.0)

    @property
    def state(self) -> str:
        """The state of the channel: ``ready``, ``running``, ``error`` or ``reset``."""
        return STATES[int(self.read("HLI.STATE"))]

    @property
    def is_paused(self) -> bool:
        """Whether single block, M00 or M01 waits for START."""
        return bool(self.read("HLI.PAUSED"))

    @property
    def is_armed(self) -> bool:
        """Whether a selected program waits for START."""
        return bool(self.read("HLI.ARMED"))

    @property
    def error(self) -> int:
        """The number of the error that has stopped the channel, 0 without one."""
        return int(self.read("HLI.ERROR"))

    def _own(self, name: str) -> str:
        """Return the name with its channel; raises ``Failure`` for V.CH (RC-309)."""
        prefix, _, path = split_channel(name)
        own = self._machine.assembled[self._index].prefix if self._index else ""
        return f"{prefix or own}{_seen(path)}"


#: Sets an attribute without a check of its name.
_set = object.__setattr__

#: The attributes of ``PlcView`` that a PLC may set.
SETTABLE = tuple(
    name
    for name, value in vars(PlcView).items()
    if isinstance(value, property) and value.fset is not None
)


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
