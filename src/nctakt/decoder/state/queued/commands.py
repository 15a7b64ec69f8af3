# SPDX-License-Identifier: MIT
"""The commands in the queue to the realtime part: plain data, no text, no names.

``packing.py`` turns them into rows of the queue, whose kinds and columns ``kernel/rows.py``
declares. A command that ``waits`` is answered through the decoder's ``yield``: with the value that
was read, or the axes' positions.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.queued.feed_modifiers import FeedModifiers
from nctakt.kernel import codes, rows
from nctakt.kernel.cycles.cycles import RealtimeCycle


@dataclass(frozen=True, slots=True)
class Command:
    """``source`` is the place (``base/source_ids.py``), ``number`` the N word of its block, 0
    without. ``packed_as``: the kind of its row, 0 of a command that has none."""

    packed_as = 0
    source: int
    number: int

    def arguments(self, _reference: int) -> Sequence[float]:
        """Return the arguments of its row, where they are not just the fields in their order.

        The parameter is the slot of a cycle, the number of a text or program, or a tick.
        """
        raise AssertionError(self)


class Tilt(NamedTuple):
    """Where a tilted plane is: positions in it times ``matrix``, row by row, are those of the axes.

    ``inside``: start and target of the programmed motion in the plane, ``outside``: of the axes.
    Turned there and back they would differ in the last bit.
    """

    matrix: tuple[float, ...]
    inside: tuple[tuple[float, ...], tuple[float, ...]]
    outside: tuple[tuple[float, ...], tuple[float, ...]]


@dataclass(frozen=True, slots=True)
class Segment(Command):
    """A motion of the path's axes, mm or degrees, not packed but prepared in the queue.

    ``motion``: ``rows.FEED_MOTION`` with ``feed`` mm/s, or ``rows.RAPID_MOTION``. ``deviation``:
    how far the path may pass the target, 0 not at all. ``limits_jerk``: its slope is an S-curve.
    ``arc``: first and second axis of its plane, centre, angle; ``None`` for a line. ``modifiers``:
    ``None`` where the feed is all. ``continues_block``: the next segment continues the block.
    ``curve``: the inner control points of a cubic, all axes of the first, then of the second.
    ``tilt``: the motion is in the plane of a tilted system, with start, target and arc.
    """

    packed_as = rows.SEGMENT

    start: tuple[float, ...]
    target: tuple[float, ...]
    motion: int
    feed: float
    exact_stop: bool
    deviation: float = 0.0
    limits_jerk: bool = False
    arc: tuple[float, ...] | None = None
    modifiers: FeedModifiers | None = None
    continues_block: bool = False
    curve: tuple[float, ...] | None = None
    tilt: Tilt | None = None

    @property
    def is_feed(self) -> bool:
        """Whether the motion is made with a path feed, not at rapid traverse."""
        return self.motion == rows.FEED_MOTION


@dataclass(frozen=True, slots=True)
class Dwell(Command):
    """A dwell of ``ticks`` ticks."""

    packed_as = rows.DWELL

    ticks: int


@dataclass(frozen=True, slots=True)
class LoadCycle(Command):
    """A realtime cycle, defined and, unless ``definition_only``, started when it is taken.

    ``identity`` is 0 without an ID; ``scope``: ``codes.BLOCK_SCOPE`` …. ``moves_on``: its motions
    continue when it ends (MOVE_CONT).
    """

    packed_as = rows.DEFINE_CYCLE

    cycle: RealtimeCycle
    identity: int
    scope: int
    definition_only: bool
    moves_on: bool = False

    def arguments(self, reference: int) -> Sequence[float]:
        return reference, not self.definition_only


#: Actions of ``CycleControl`` by the words of the language.
CONTROL_ACTIONS = {
    "START": codes.CONTROL_START,
    "HOLD": codes.CONTROL_HOLD,
    "CONTINUE": codes.CONTROL_CONTINUE,
    "ABORT ACTION": codes.CONTROL_ABORT,
    "DELETE": codes.CONTROL_DELETE,
}


@dataclass(frozen=True, slots=True)
class CycleControl(Command):
    """A management command for the cycle with this ID (RC-111)."""

    packed_as = rows.CONTROL_CYCLE

    action: int
    identity: int


@dataclass(frozen=True, slots=True)
class TechnologyOutput(Command):
    """A function for the PLC, by its code; ``ticks``: how long it takes.

    ``value``: the program's value for it (M110 = 130), ``None`` for none. ``lead``: how much before
    its place it is output, mm or s depending on ``lead_kind`` (``codes.LEAD_DISTANCE`` …).
    """

    packed_as = rows.TECHNOLOGY

    function: int
    ticks: int
    value: int | None = None
    lead: float = 0.0
    lead_kind: int = 0

    def arguments(self, _reference: int) -> Sequence[float]:
        has_value = self.value is not None
        value = self.value or 0
        return self.function, self.ticks, has_value, value, self.lead, self.lead_kind


@dataclass(frozen=True, slots=True)
class AwaitAcknowledge(Command):
    """Continues when the PLC has accepted this function."""

    packed_as = rows.AWAIT_ACKNOWLEDGE

    function: int


@dataclass(frozen=True, slots=True)
class WriteVariable(Command):
    """A synchronous variable gets a value when this is taken (RC-308).

    ``is_reported``: it is an event; that of a V.RT* variable, which changes the further run.
    """

    packed_as = rows.WRITE_VARIABLE

    cell: int
    value: float
    is_reported: bool


@dataclass(frozen=True, slots=True)
class WriteText(Command):
    """As ``WriteVariable``, for a part of a character string.

    The characters ``data`` go into the variable from byte ``first`` on, then come ``zeros``.
    """

    packed_as = rows.WRITE_TEXT

    cell: int
    first: int
    data: bytes
    zeros: int

    def arguments(self, _reference: int) -> Sequence[float]:
        return self.cell, self.first, len(self.data), self.zeros, *self.data


@dataclass(frozen=True, slots=True)
class UserMessage(Command):
    """A ``#MSG`` text, already formatted.

    For the message file: ``exclusive`` leaves out its time stamp, ``unbroken`` its line end.
    ``file``: the file that the program has named for it, empty without one.
    """

    packed_as = rows.MESSAGE

    text: str
    exclusive: bool = False
    unbroken: bool = False
    file: str = ""

    def arguments(self, reference: int) -> Sequence[float]:
        return (reference,)


@dataclass(frozen=True, slots=True)
class SetOffset(Command):
    """An offset of a machine axis changes from here on, in mm or degrees (MO-8).

    ``kind`` as in ``kernel/axes/coordinates.py``.
    """

    packed_as = rows.SET_OFFSET

    axis: int
    kind: int
    value: float


@dataclass(frozen=True, slots=True)
class SetOrigin(Command):
    """The program's coordinate system begins here on a machine axis, mm or degrees (MO-8)."""

    packed_as = rows.SET_ORIGIN

    axis: int
    value: float


@dataclass(frozen=True, slots=True)
class SetTurn(Command):
    """The program's coordinate system is turned over three machine axes (MO-8).

    ``matrix``: row by row, from its coordinates to those of the axes; empty: it is not turned.
    """

    packed_as = rows.SET_TURN

    axes: tuple[int, int, int]
    matrix: tuple[float, ...]

    def arguments(self, _reference: int) -> Sequence[float]:
        first, second, third = self.axes
        if not self.matrix:
            return (first,)
        return first, second + 1, third + 1, *self.matrix


@dataclass(frozen=True, slots=True)
class SetTransformation(Command):
    """A map is active from here on, 0: none; ``of_segments``: that of the motions after it."""

    packed_as = rows.SET_TRANSFORMATION

    map_number: int
    of_segments: int


@dataclass(frozen=True, slots=True)
class Freeze(Command):
    """The cycle ``serial``, defined just before, has this variable as a constant (RC-302).

    A text is part of ``name``, and ``value`` is not a number.
    """

    packed_as = rows.FREEZE

    serial: int
    name: str
    value: float

    def arguments(self, reference: int) -> Sequence[float]:
        return self.serial, reference, self.value


@dataclass(frozen=True, slots=True)
class UserErrorReport(Command):
    """``#ERROR`` of the main program is reported (RC-402); its values follow."""

    packed_as = rows.USER_ERROR

    identity: int
    reaction: int


@dataclass(frozen=True, slots=True)
class UserErrorValue(Command):
    """A number of the ``#ERROR`` before it; ``code``: index of its keyword."""

    packed_as = rows.USER_VALUE

    code: int
    value: float


@dataclass(frozen=True, slots=True)
class UserErrorText(Command):
    """A text of the ``#ERROR`` before it, by its number; ``code``: index of its keyword."""

    packed_as = rows.USER_TEXT

    code: int
    text: int


@dataclass(frozen=True, slots=True)
class UserErrorStop(Command):
    """The ``#ERROR`` before it stops the channel."""

    packed_as = rows.USER_STOP

    reaction: int


@dataclass(frozen=True, slots=True)
class Flush(Command):
    """The path comes to rest before the next command; ``waits``: the decoder, too (RC-005)."""

    packed_as = rows.FLUSH

    waits: bool
    reason: int = 0
    cell: int = 0

    def arguments(self, _reference: int) -> Sequence[float]:
        return (self.waits,)


@dataclass(frozen=True, slots=True)
class ReadRealtime(Command):
    """The decoder waits for the value of a cell when the path is at rest (RC-308)."""

    packed_as = rows.READ

    cell: int

    def arguments(self, _reference: int) -> Sequence[float]:
        return True, self.cell


@dataclass(frozen=True, slots=True)
class PositionRequest(Command):
    """The decoder waits for the path's positions when it is at rest, and ``axes``, too (RC-409).

    ``axes``: numbers in the machine.
    """

    packed_as = rows.POSITIONS

    axes: tuple[int, ...] = ()

    def arguments(self, _reference: int) -> Sequence[float]:
        return True, len(self.axes), *self.axes


@dataclass(frozen=True, slots=True)
class ProgramEnd(Command):
    """M30."""

    packed_as = rows.PROGRAM_END

    def arguments(self, reference: int) -> Sequence[float]:
        return (reference,)


@dataclass(frozen=True, slots=True)
class ProgramStop(Command):
    """M00, or with ``is_optional`` M01: waits for START."""

    packed_as = rows.PROGRAM_STOP

    is_optional: bool


@dataclass(frozen=True, slots=True)
class GiveUp(Command):
    """After the prepared commands the channel stops with an error of the decoder."""

    packed_as = rows.GIVE_UP

    message: int


@dataclass(frozen=True, slots=True)
class BlockMark(Command):
    """A block begins here: says when it was decoded and when it is carried out.

    ``calls``: the number of the open calls (``CallStack.path``), ``depth``: that of the open
    programs.
    """

    packed_as = rows.BLOCK_MARK

    calls: int
    depth: int

    def arguments(self, reference: int) -> Sequence[float]:
        return reference, self.calls, self.depth


#: Why the channel is emptied: ``#FLUSH``, a synchronous read, a position request, a V.RT* write.
WAIT_FLUSH, WAIT_READ, WAIT_POSITIONS, WAIT_WRITE = range(4)


@dataclass(frozen=True, slots=True)
class WaitMark(Command):
    """Why the command after it empties the channel; ``cell``: the variable, 0 for none."""

    packed_as = rows.WAIT_MARK

    reason: int
    cell: int


@dataclass(frozen=True, slots=True)
class ProgramTimer(Command):
    """``#TIMER … SYN`` of the main program: START 1, STOP 2, READ 3, CLEAR 4."""

    packed_as = rows.TIMER

    timer: int
    action: int


@dataclass(frozen=True, slots=True)
class LoopBegin(Command):
    """``#RT WHILE``: everything up to its end is the body of a realtime loop."""

    packed_as = rows.LOOP_BEGIN


@dataclass(frozen=True, slots=True)
class LoopPass(Command):
    """The end of each pass of a realtime loop: it is counted."""

    packed_as = rows.LOOP_PASS


@dataclass(frozen=True, slots=True)
class LoopEnd(Command):
    """``#RT ENDWHILE``: the decoder continues when the loop is left."""

    packed_as = rows.LOOP_END

    def arguments(self, _reference: int) -> Sequence[float]:
        return (True,)


@dataclass(frozen=True, slots=True)
class FixedStop(Command):
    """``X[FIXED_STOP ON|OFF …]`` for the axis at this place of the channel.

    ``limit``: mm or degrees between command and actual position, for this many ``ticks``.
    ``begin``, ``end``: shares of the distance. ``needed``: an axis that finds no stop is an error.
    """

    packed_as = rows.FIXED_STOP

    axis: int
    is_on: bool
    limit: float
    ticks: int
    begin: float
    end: float
    needed: bool


@dataclass(frozen=True, slots=True)
class FixedStopEnd(Command):
    """The block that moves to a fixed stop is over."""

    packed_as = rows.FIXED_STOP_END


@dataclass(frozen=True, slots=True)
class Measure(Command):
    """The next motion looks for an edge; ``function`` goes out ``residual`` mm after that."""

    packed_as = rows.MEASURE

    function: int
    ticks: int
    residual: float
    value: int | None = None

    def arguments(self, _reference: int) -> Sequence[float]:
        has_value = self.value is not None
        return self.function, self.ticks, self.residual, has_value, self.value or 0


@dataclass(frozen=True, slots=True)
class MeasureEnd(Command):
    """The motion that looks for an edge is over; its function is waited for."""

    packed_as = rows.MEASURE_END


@dataclass(frozen=True, slots=True)
class ClearHistory(Command):
    """Nothing before this is walked back (``#BACKWARD STORAGE CLEAR``)."""

    packed_as = rows.CLEAR_HISTORY


@dataclass(frozen=True, slots=True)
class EmptyBlock(Command):
    """A motion of length 0 or a dwell of no tick, which an armed BLOCK cycle passes over."""

    packed_as = rows.EMPTY_BLOCK


@dataclass(frozen=True, slots=True)
class Pause(Command):
    """The decoder is between two statements of the main program; nothing is queued for it."""


#: The pause, of no place.
PAUSE = Pause(0, 0)


@dataclass(frozen=True, slots=True)
class SendSignal(Command):
    """``#SIGNAL SYN`` with this number to the channels of a mask, 0: to all.

    ``count``: how often it is taken, ``codes.ENDLESS_SIGNAL``. ``mask``: which of the values are
    given.
    """

    packed_as = rows.SIGNAL

    signal: int
    receivers: int
    count: int
    mask: int
    values: tuple[float, ...]

    def arguments(self, _reference: int) -> Sequence[float]:
        return self.signal, self.receivers, self.count, self.mask, *self.values


@dataclass(frozen=True, slots=True)
class AwaitSignal(Command):
    """``#WAIT SYN`` for a signal from the channels of a mask, 0: a broadcast.

    ``overtakes``: also a signal that its sender has sent after others.
    """

    packed_as = rows.AWAIT_SIGNAL

    signal: int
    senders: int
    overtakes: bool


@dataclass(frozen=True, slots=True)
class RemoveSignals(Command):
    """``#SIGNAL REMOVE SYN``: the oldest signal ``low``, or all of a range of numbers."""

    packed_as = rows.REMOVE_SIGNAL

    low: int
    high: int
    receivers: int
    is_range: bool


@dataclass(frozen=True, slots=True)
class DecoderWait(Command):
    """The decoder waits; the queue holds no command for it."""


@dataclass(frozen=True, slots=True)
class DecoderSignal(DecoderWait):
    """``#WAIT``, as ``AwaitSignal``; the answer is a mask of values, and the values."""

    signal: int
    senders: int
    overtakes: bool


@dataclass(frozen=True, slots=True)
class NextTick(DecoderWait):
    """The decoder continues when another tick has begun."""


@dataclass(frozen=True, slots=True)
class AwaitTools(NextTick):
    """As ``NextTick``, for the answer of the tool manager of the PLC."""


#: The decoder's answer to a command that waits.
Answer = float | tuple[float, ...] | None


def wait_mark(command: Command) -> WaitMark | None:
    """The mark of a command that empties the channel."""
    match command:
        case ReadRealtime():
            return WaitMark(command.source, command.number, WAIT_READ, command.cell)
        case PositionRequest():
            return WaitMark(command.source, command.number, WAIT_POSITIONS, 0)
        case Flush():
            return WaitMark(command.source, command.number, command.reason, command.cell)
    return None


def is_block(command: Command) -> bool:
    """Whether it is a motion or dwell, which BLOCK cycles run with."""
    return isinstance(command, Segment | Dwell)


def waits(command: Command) -> bool:
    """Whether the decoder continues only with an answer."""
    return isinstance(command, ReadRealtime | PositionRequest | LoopEnd | DecoderWait) or (
        isinstance(command, Flush) and command.waits
    )
