# SPDX-License-Identifier: MIT
"""Values of the components of axes, spindles and channels, taken from the session.

In: a machine as described by its lists, moments of its session. Out: values of the companion model.
A quantity that nctakt does not model raises ``NotSupported``: it has no value, least of all 0.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import PurePath

from asyncua import ua

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.decoder.state.queued.in_force import InForce
from nctakt.hli.layout import spindle_value_name
from nctakt.hli.plc_entries import TechnologyEntry
from nctakt.kernel import codes
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.machine import ChannelConfiguration
from nctakt.servers.opcua.values import NotSupported, Value, ValueSnapshot
from nctakt.session.channel_states import ChannelState
from nctakt.session.engine import StepResult

#: Reads a value of a moment.
Reader = Callable[[ValueSnapshot], Value]


@dataclass(frozen=True, slots=True)
class Shown:
    """The value of a component; ``unit``, ``low`` and ``high``: of an analog one.

    ``names``: of the session. ``write_name``: the value that a client writes. ``signal``: the one
    whose past it has, times ``factor``.
    """

    read: Reader
    names: tuple[str, ...] = ()
    needs_state_view: bool = False
    unit: str = ""
    low: float = 0.0
    high: float = 0.0
    write_name: str = ""
    signal: str = ""
    factor: float = 1.0


@dataclass(frozen=True, slots=True)
class ShownPosition:
    """A position: its actual, command and remaining values, its unit and range."""

    actual: str
    command: str
    to_go: str
    unit: str
    low: float
    high: float


def _missing(moment: ValueSnapshot) -> Value:
    raise NotSupported


#: A component that nctakt does not model.
NOT_MODELLED = Shown(_missing)
#: Those of a drive, of which only the units are known.
_LOADS = {
    "ActLoad": Shown(_missing, unit="%"),
    "ActPower": Shown(_missing, unit="kW"),
    "ActTorque": Shown(_missing, unit="N·m"),
    "CmdTorque": Shown(_missing, unit="N·m"),
}


def fixed(value: Value) -> Shown:
    """Return a component whose value never changes."""
    return Shown(lambda _: value)


def signal(name: str, unit: str = "", low: float = 0.0, high: float = 0.0) -> Shown:
    """Return a component that shows a signal."""
    return Shown(lambda moment: moment.values[name], (name,), False, unit, low, high, signal=name)


def state_of(moment: ValueSnapshot, number: int) -> ChannelState:
    """Return the state of a channel, counted from 1."""
    if moment.state_view is None:
        raise NotSupported(int(ua.StatusCodes.BadWaitingForInitialData))
    return moment.state_view.channels[number - 1]


# --- axes -----------------------------------------------------------------------------------------


def axis_components(
    axis: AxisConfiguration, name: str, prefix: str, index: int, number: int, channel: ua.NodeId
) -> Mapping[str, Shown | ShownPosition]:
    """Return the components of an axis, the ``index``-th of channel ``number``.

    ``prefix``: of the names of its channel's signals.
    """
    state = f"{prefix}{name}.STATE"
    unit = "mm" if axis.is_linear else "°"

    to_go = f"{prefix}{name}.MCS.DIST_TO_GO"
    command, target = f"{prefix}{name}.ACS.ACT_POS", f"{prefix}{name}.ACS.CMD_POS"

    def status(moment: ValueSnapshot) -> int:
        is_endless = moment.values[state] in (codes.CONTINUOUS_MOTION, codes.STOPPING)
        is_there = moment.values[command] == moment.values[target]
        return _IN_POSITION if is_there and not is_endless else _MOVING

    def zero_offset(moment: ValueSnapshot) -> float:
        return state_of(moment, number).zero_offsets[index]

    low, high = axis.reachable
    position = ShownPosition(f"{prefix}{name}.ACS.CUR_POS", command, to_go, unit, low, high)
    return {
        "ActChannel": fixed(channel),
        **_LOADS,
        "IsInactive": fixed(False),
        "IsVirtual": fixed(True),
        "ActStatus": Shown(status, (state, command, target)),
        "IsReferenced": fixed(True),
        "IsRotational": fixed(not axis.is_linear),
        "PosDirect": position,
        "PosIndirect": position,
        "ZeroOffset": Shown(zero_offset, (), True, unit, low, high),
    }


#: Values of CncAxisStatus.
_IN_POSITION, _MOVING = range(2)


# --- spindles -------------------------------------------------------------------------------------

#: Values of CncSpindleStatus.
_STOPPED, _IN_TARGET_AREA, _ACCELERATING, _DECELERATING = range(4)

#: Values of CncSpindleTurnDirection.
_NO_DIRECTION, _CLOCKWISE, _COUNTER_CLOCKWISE = range(3)

#: Components that are known of a spindle only if the CNC turns it.
_KNOWN_TO_CNC: Mapping[str, Shown] = {
    "CmdOverride": Shown(_missing, unit="%"),
    "ActSpeed": Shown(_missing, unit="1/min"),
    "ActStatus": NOT_MODELLED,
    "ActTurnDirection": NOT_MODELLED,
}


def _cnc_spindle(
    name: str, prefix: str, max_speed: float, max_pct: float, index: int, number: int
) -> Mapping[str, Shown]:
    """Return the components of a spindle that the CNC turns."""
    speed = f"{prefix}{name}.SPEED"

    def status(moment: ValueSnapshot) -> int:
        actual, latest = moment.number(speed), state_of(moment, number).spindles[index]
        if actual == 0.0 and (latest.speed == 0.0 or not latest.is_open):
            return _STOPPED
        if not latest.is_open:
            return _IN_TARGET_AREA
        is_faster = abs(actual) < abs(latest.speed) and actual * latest.speed >= 0.0
        return _ACCELERATING if is_faster else _DECELERATING

    def direction(moment: ValueSnapshot) -> int:
        actual = moment.number(speed)
        if actual == 0.0:
            return _NO_DIRECTION
        return _CLOCKWISE if actual > 0.0 else _COUNTER_CLOCKWISE

    override = signal(f"{prefix}{spindle_value_name(name)}", "%", 0.0, max_pct)
    return {
        "CmdOverride": _written(override),
        "ActSpeed": Shown(
            lambda moment: abs(moment.number(speed)),
            (speed,),
            False,
            "1/min",
            0.0,
            max_speed,
            signal=speed,
        ),
        "ActStatus": Shown(status, (speed,), True),
        "ActTurnDirection": Shown(direction, (speed,)),
    }


def spindle_components(
    name: str,
    prefix: str,
    max_speed: float,
    max_pct: float,
    index: int,
    number: int,
    *,
    plc: bool,
    channel: ua.NodeId,
) -> Mapping[str, Shown | ShownPosition]:
    """Return the components of a spindle, the ``index``-th of channel ``number``.

    ``max_speed`` in 1/min, ``max_pct``: P-AXIS-00109. ``plc``: the PLC turns it, and the CNC
    knows none of its actual values.
    """
    known = _KNOWN_TO_CNC
    if not plc:
        known = _cnc_spindle(name, prefix, max_speed, max_pct, index, number)

    def speed(moment: ValueSnapshot) -> float:
        return abs(state_of(moment, number).spindles[index].speed)

    angle = "" if plc else f"{prefix}{name}.POSITION"
    return {
        "ActChannel": fixed(channel),
        **_LOADS,
        "IsInactive": fixed(False),
        "IsVirtual": fixed(True),
        "ActGear": NOT_MODELLED,
        "CmdGear": NOT_MODELLED,
        "ActOverride": Shown(_missing, unit="%"),
        "CmdSpeed": Shown(speed, (), True, "1/min", 0.0, max_speed),
        "AnglePos": ShownPosition(angle, "", "", "°", 0.0, 360.0),
        **known,
    }


# --- channels -------------------------------------------------------------------------------------

#: Values of CncChannelStatus and CncChannelProgramStatus.
_ACTIVE, _INTERRUPTED, _RESET = range(3)
_PROGRAM_STOPPED, _RUNNING, _WAITING, _PROGRAM_INTERRUPTED, _CANCELED = range(5)

#: The value of CncOperationMode for programs.
_AUTOMATIC = 2

#: Axes of the tool centre point.
TCP_AXES = ("X", "Y", "Z", "A", "B", "C")


class ProgramTexts:
    """The lines of programs, for those who show the current block; read once, when needed."""

    def __init__(
        self, known: Mapping[str, Sequence[str]], read: Callable[[str], Sequence[str]]
    ) -> None:
        self._lines = dict(known)
        self._read = read

    def around(self, span: Span) -> list[str]:
        """Return the line before a position, that line, the one after; empty: there is none."""
        lines = self._of(span.file)
        return [
            lines[at] if 0 <= at < len(lines) else "" for at in range(span.line - 2, span.line + 1)
        ]

    def _of(self, file: str) -> Sequence[str]:
        if file not in self._lines:
            self._lines[file] = self._read(file)
        return self._lines[file]


def channel_components(
    configuration: ChannelConfiguration,
    axes: Mapping[str, AxisConfiguration],
    prefix: str,
    texts: ProgramTexts,
    latest: Callable[[], StepResult],
) -> Mapping[str, Shown | ShownPosition]:
    """Return the components of a channel; ``axes``: by their names there."""
    number = configuration.number
    speed = f"{prefix}PATH.SPEED"
    max_mm_min = 60.0 * max((axis.max_speed for axis in axes.values()), default=0.0)

    def feed(moment: ValueSnapshot) -> float:
        return state_of(moment, number).programmed_mm_s * 60.0

    return {
        "Id": fixed(number),
        "ActFeedrate": Shown(
            lambda moment: moment.number(speed) * 60.0,
            (speed,),
            False,
            "mm/min",
            0.0,
            max_mm_min,
            signal=speed,
            factor=60.0,
        ),
        "CmdFeedrate": Shown(feed, (), True, "mm/min", 0.0, max_mm_min),
        "DryRunFeed": Shown(_missing, unit="mm/min"),
        "ActJogIncrement": Shown(_missing, unit="mm"),
        "ActOperationMode": fixed(_AUTOMATIC),
        "CmdOperationMode": fixed(_AUTOMATIC),
        **_operation(prefix, configuration.parameters.max_override_pct),
        **_functions_in_force(number),
        **_program_places(number, texts, latest),
        **_tool_positions(axes, prefix),
    }


def _operation(prefix: str, max_pct: float) -> Mapping[str, Shown]:
    """Return the operator's commands of a channel, and whether it runs."""
    hli = {
        word: f"{prefix}HLI.{word}"
        for word in ("STATE", "PAUSED", "ARMED", "OVERRIDE", "FEED_HOLD", "SINGLE_BLOCK")
    }

    def status(moment: ValueSnapshot) -> int:
        state = moment.values[hli["STATE"]]
        if state == codes.CHANNEL_RESET:
            return _RESET
        stops = state == codes.CHANNEL_ERROR or moment.values[hli["PAUSED"]]
        return _INTERRUPTED if stops or moment.values[hli["FEED_HOLD"]] else _ACTIVE

    def program_status(moment: ValueSnapshot) -> int:
        state = moment.values[hli["STATE"]]
        if state == codes.CHANNEL_RUNNING:
            stops = moment.values[hli["PAUSED"]] or moment.values[hli["FEED_HOLD"]]
            return _PROGRAM_INTERRUPTED if stops else _RUNNING
        if state in (codes.CHANNEL_ERROR, codes.CHANNEL_RESET):
            return _CANCELED
        return _WAITING if moment.values[hli["ARMED"]] else _PROGRAM_STOPPED

    states = tuple(hli[word] for word in ("STATE", "PAUSED", "ARMED", "FEED_HOLD"))
    return {
        "ActOverride": signal(f"{prefix}OVERRIDE.VEL.TOTAL", "%", 0.0, max_pct),
        "CmdOverride": _written(signal(hli["OVERRIDE"], "%", 0.0, max_pct)),
        "FeedHold": _written(signal(hli["FEED_HOLD"])),
        "BlockMode": _written(signal(hli["SINGLE_BLOCK"])),
        "ActStatus": Shown(status, states),
        "ActProgramStatus": Shown(program_status, states),
    }


def _functions_in_force(number: int) -> Mapping[str, Shown]:
    """Return the functions, offset and tool that a channel has in force."""

    def technology(moment: ValueSnapshot) -> list[int]:
        if moment.state_view is None:
            raise NotSupported(int(ua.StatusCodes.BadWaitingForInitialData))
        return [
            entry.number
            for channel, entry in moment.state_view.waiting
            if channel == number and isinstance(entry, TechnologyEntry) and entry.letter == "M"
        ]

    def in_force(moment: ValueSnapshot) -> InForce:
        found = state_of(moment, number).in_force
        if found is None:
            raise NotSupported(int(ua.StatusCodes.BadNoData))
        return found

    return {
        "ActGFunctions": Shown(lambda moment: list(in_force(moment).functions), (), True),
        "ActMFunctions": Shown(technology, (), True),
        "ActModalOffsetFunction": Shown(lambda moment: in_force(moment).zero_offset, (), True),
        "ToolId": Shown(lambda moment: in_force(moment).tool, (), True),
    }


def _program_places(
    number: int, texts: ProgramTexts, latest: Callable[[], StepResult]
) -> Mapping[str, Shown]:
    """Return where a channel is in its main program and in the program it has called."""

    def span(moment: ValueSnapshot) -> Span:
        found = moment.blocks.get(number)
        if found is None:
            raise NotSupported(int(ua.StatusCodes.BadNoData))
        return found

    def main_span(moment: ValueSnapshot) -> Span:
        calls = latest().calls.get(number)
        called = calls[1].span if calls and len(calls) > 1 else None
        return span(moment) if called is None else called

    return {
        "ActMainProgramName": Shown(lambda moment: PurePath(main_span(moment).file).name),
        "ActMainProgramFile": Shown(lambda moment: main_span(moment).file),
        "ActMainProgramLine": Shown(lambda moment: str(main_span(moment).line)),
        "ActProgramName": Shown(lambda moment: PurePath(span(moment).file).name),
        "ActProgramFile": Shown(lambda moment: span(moment).file),
        "ActProgramLine": Shown(lambda moment: str(span(moment).line)),
        "ActProgramBlock": Shown(lambda moment: texts.around(span(moment))),
    }


def _tool_positions(
    axes: Mapping[str, AxisConfiguration], prefix: str
) -> Mapping[str, ShownPosition]:
    """Return the positions of the tool centre point, in the machine's and the program's system."""
    found = {}
    for letter in TCP_AXES:
        axis = axes.get(letter)
        for name, system in (("Bcs", "MCS"), ("Wcs", "PCS")):
            if axis is None:
                found[f"PosTcp{name}{letter}"] = ShownPosition("", "", "", "mm", 0.0, 0.0)
                continue
            low, high = axis.reachable
            found[f"PosTcp{name}{letter}"] = ShownPosition(
                f"{prefix}{letter}.{system}.CUR_POS",
                f"{prefix}{letter}.{system}.ACT_POS",
                f"{prefix}{letter}.{system}.DIST_TO_GO",
                "mm" if axis.is_linear else "°",
                low,
                high,
            )
    return found


def _written(shown: Shown) -> Shown:
    return Shown(
        shown.read,
        shown.names,
        shown.needs_state_view,
        shown.unit,
        shown.low,
        shown.high,
        shown.names[0],
        shown.signal,
    )
