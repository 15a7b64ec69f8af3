# SPDX-License-Identifier: MIT
"""State kept by an editor's check of a program, so that a change costs only what it changes.

In: a program's text again and again. Out: for each a complete reading, equal to a fresh one. A text
is a chain of sections: at checkpoints between two statements the state of the reading is kept.
After a change the reading continues from the last state before it, and ends at the first checkpoint
after it whose state is unchanged; findings and states after that only get new line numbers.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Sequence
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.line_shift import LineShift, ReplacedLine, shift_between
from nctakt.checking.program_pass import PassState, ProgramChannel, ProgramPass, shifters
from nctakt.checking.suppression import is_marked
from nctakt.nc.plain_shapes import PlainShapes
from nctakt.nc.source import Source
from nctakt.testing.expectations import is_script

#: Maximum number of lines of a section, and the length below which no new section begins before the
#: next checkpoint of the previous reading.
SECTION_LINES = 4096
_MIN_LINES = 50

Poll = Callable[[], None]


class LastShift:
    """Compares texts; the same two again at no cost."""

    def __init__(self) -> None:
        self._texts: tuple[Sequence[str], Sequence[str]] = ([], [])
        self._shift: LineShift | None = None

    def between(self, old: Sequence[str], new: Sequence[str]) -> LineShift | None:
        """Return which lines of ``old`` differ in ``new``, ``None`` if all are equal."""
        if old is not self._texts[0] or new is not self._texts[1]:
            self._shift = shift_between(old, new)
            self._texts = old, new
        return self._shift


class MarkedLines:
    """The numbers of the lines of one text that ``is_marked`` selects, kept through changes."""

    def __init__(self, is_marked: Callable[[str], object], shifts: LastShift) -> None:
        self._is_marked = is_marked
        self._shifts = shifts
        self._lines: Sequence[str] | None = None
        self._numbers: list[int] = []

    def of(self, lines: Sequence[str]) -> list[int]:
        """Return the numbers in a text; only changed lines are looked at."""
        numbers = self._numbers
        if self._lines is None:
            self._numbers = self._marked(lines, 1)
        elif (shift := self._shifts.between(self._lines, lines)) is not None:
            first, end = bisect_left(numbers, shift.first), bisect_left(numbers, shift.end)
            changed = lines[shift.first - 1 : shift.new_end - 1]
            self._numbers = [
                *numbers[:first],
                *self._marked(changed, shift.first),
                *(number + shift.by for number in numbers[end:]),
            ]
        self._lines = lines
        return self._numbers

    def _marked(self, lines: Sequence[str], first: int) -> list[int]:
        is_marked = self._is_marked
        return [number for number, line in enumerate(lines, first) if is_marked(line)]


@dataclass(frozen=True, slots=True)
class _Checkpoint:
    """A point between two statements, before ``line``: its state, the lengths of results."""

    line: int
    state: PassState
    counts: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class _Reading:
    """A complete reading: its text, its checkpoints, the state at its end, its results."""

    lines: Sequence[str]
    is_followed: bool
    checkpoints: list[_Checkpoint]
    end: PassState
    results: tuple[list[Any], ...]


class ProgramMemory:
    """The last reading of one program for one channel."""

    def __init__(self, channel: ProgramChannel, shifts: LastShift) -> None:
        self.channel = channel
        self._shifts = shifts
        self._shapes = PlainShapes()
        self._reading: _Reading | None = None

    def read(self, source: Source, poll: Poll | None) -> ProgramPass:
        """Return a complete reading of a text; ``poll`` may end it by an exception."""
        reading = ProgramPass(source, self.channel, self._shapes)
        before = self._reading
        if before is not None and before.is_followed != reading.is_followed:
            before = None
        shift = None if before is None else self._shifts.between(before.lines, source.lines)
        if before is None:
            checkpoints = _Rereading(reading, None, LineShift(1, 1, 0), [], poll).run()
        elif shift is None:
            _add(reading, before.results)
            reading.resume(before.end, len(source.lines) + 1)
            checkpoints = before.checkpoints
        else:
            checkpoints = _Rereading(reading, before, shift, before.checkpoints, poll).run()
        self._reading = _Reading(
            source.lines, reading.is_followed, checkpoints, reading.state, reading.results
        )
        return reading


def _add(reading: ProgramPass, results: Sequence[Sequence[Any]]) -> None:
    for items, more in zip(reading.results, results, strict=True):
        items.extend(more)


class _Rereading:
    """A reading of the changed sections of a text, with the results of all others."""

    def __init__(
        self,
        reading: ProgramPass,
        before: _Reading | None,
        shift: LineShift,
        checkpoints: Sequence[_Checkpoint],
        poll: Poll | None,
    ) -> None:
        self._reading = reading
        self._before = before
        self._shift = shift
        self._poll = poll
        lines = [checkpoint.line for checkpoint in checkpoints]
        self._checkpoints = list(checkpoints[: bisect_right(lines, shift.first)])
        #: The checkpoints after the change, in the text before it.
        self._later = list(checkpoints[bisect_left(lines, shift.end) :])
        self._next = 0
        self._is_joined = False

    def run(self) -> list[_Checkpoint]:
        """Read; return the checkpoints of the new text."""
        if self._before is not None and self._checkpoints:
            last = self._checkpoints[-1]
            results = zip(self._before.results, last.counts, strict=True)
            _add(self._reading, [items[:count] for items, count in results])
            self._reading.resume(last.state, last.line)
        self._reading.inspection.read(self._pause)
        return self._checkpoints

    def _pause(self, line: int) -> int:
        """Keep the state before a line; return the next line to do so, 0 where it joins."""
        if self._poll is not None:
            self._poll()
        later, by = self._later, self._shift.by
        while self._next < len(later) and later[self._next].line + by < line:
            self._next += 1
        following = later[self._next].line + by if self._next < len(later) else 0
        if following == line:
            if self._joins(later[self._next]):
                return 0
            if not self._checkpoints or self._checkpoints[-1].line < line:
                self._keep(line)
            self._next += 1
            following = later[self._next].line + by if self._next < len(later) else 0
        elif not following or following - line > _MIN_LINES:
            last = self._checkpoints[-1] if self._checkpoints else None
            if last is None or line - last.line > last.state.size:
                self._keep(line)
        own = line + SECTION_LINES
        return min(own, following) if following else own

    def _keep(self, line: int) -> None:
        counts = tuple(map(len, self._reading.results))
        self._checkpoints.append(_Checkpoint(line, self._reading.state, counts))

    def _joins(self, checkpoint: _Checkpoint) -> bool:
        """Take over everything after a checkpoint, if the state before it is unchanged."""
        before, shift = self._before, self._shift
        assert before is not None
        try:
            if checkpoint.state.shifted(shift) != self._reading.state:
                return False
            end = before.end.shifted(shift)
            rest = [
                [shifted(item) for item in items[count:]] if shift.by else items[count:]
                for items, count, shifted in zip(
                    before.results, checkpoint.counts, shifters(shift), strict=True
                )
            ]
        except ReplacedLine:
            return False
        counts = tuple(map(len, self._reading.results))
        if self._checkpoints and self._checkpoints[-1].line == checkpoint.line + shift.by:
            self._checkpoints.pop()
        for later in self._later[self._next :]:
            try:
                state = later.state.shifted(shift)
            except ReplacedLine:
                continue
            lengths = zip(counts, later.counts, checkpoint.counts, strict=True)
            moved = tuple(now + then - joined for now, then, joined in lengths)
            self._checkpoints.append(_Checkpoint(later.line + shift.by, state, moved))
        _add(self._reading, rest)
        self._reading.resume(end, len(self._reading.source.lines) + 1)
        return True


class FileMemory:
    """The memory of one file: readings by channel and role, and which comments matter."""

    def __init__(self) -> None:
        self._shifts = LastShift()
        self._readings: dict[tuple[int, str], ProgramMemory] = {}
        self.suppressions = MarkedLines(is_marked, self._shifts)
        self.scripts = MarkedLines(is_script, self._shifts)

    def of_channel(self, channel: ProgramChannel) -> ProgramMemory:
        """Return the memory for a channel; an empty one if the machine was reloaded."""
        key = (channel.number, channel.role)
        known = self._readings.get(key)
        if known is None or not known.channel.is_same(channel):
            known = self._readings[key] = ProgramMemory(channel, self._shifts)
        return known


class CheckMemory:
    """The memory of all files of an editor, by name."""

    def __init__(self) -> None:
        self._files: dict[str, FileMemory] = {}

    def of_file(self, name: str) -> FileMemory:
        """Return the memory of a file."""
        return self._files.setdefault(name, FileMemory())

    def forget(self, name: str) -> None:
        """Forget a file."""
        self._files.pop(name, None)
