# SPDX-License-Identifier: MIT
"""A machine's log as data: its columns, and the samples of those that are asked for.

A log has several time bases (LG-101): each signal has its own stamps, in microseconds since the
log's first one. ``notes`` has the questions left open by reading it.
"""

from __future__ import annotations

import abc
from collections.abc import Iterator, Sequence

import numpy
from numpy.typing import NDArray

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.comparison.columns import Column, Numbers, NumberTable, Part, range_of, stretches
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import (
    CELLS_LEFT_OUT,
    EQUAL_STAMPS,
    GAP_IN_LOG,
    LOG_IS_EMPTY,
    TIME_RUNS_BACK,
)

#: A step between two samples of more than this many usual steps is a gap.
_GAP_PERIODS = 20


@dataclass(frozen=True, slots=True)
class LogColumn:
    """A column of values; ``unit`` is "" where the log names none."""

    name: str
    unit: str
    column: int
    time_column: int


@dataclass(frozen=True, slots=True)
class Samples:
    """The samples of a column: ``times`` in µs since the log's first stamp, ascending.

    A value is ``factor`` · the number in ``values`` + ``offset``.
    """

    times: Column
    values: Column
    factor: float = 1.0
    offset: float = 0.0

    def __len__(self) -> int:
        return len(self.times)

    def stretches(self, stride: int = 1) -> Iterator[tuple[Numbers, Numbers]]:
        """Yield times and values, stretch by stretch; of every ``stride``-th sample."""
        for one in stretches(len(self)):
            kept = slice(-one.start % stride, None, stride)
            times, values = self.times[one], self.values[one]
            if stride > 1:  # a view would keep the whole stretch in memory
                times, values = times[kept].copy(), values[kept].copy()
            if (self.factor, self.offset) != (1.0, 0.0):
                values = values * self.factor + self.offset
            yield times, values

    @property
    def first_us(self) -> float:
        """The first stamp."""
        return float(self.times[:1][0])

    @property
    def last_us(self) -> float:
        """The last stamp."""
        return float(self.times[len(self) - 1 :][0])

    def scaled(self, factor: float, offset: float) -> Samples:
        """Return them with another factor and offset."""
        return Samples(self.times, self.values, factor, offset)

    def part(self, begin: int, end: int) -> Samples:
        """Return those from the number ``begin`` to before ``end``."""
        times, values = Part(self.times, begin, end), Part(self.values, begin, end)
        return Samples(times, values, self.factor, self.offset)

    @property
    def span(self) -> float:
        """The difference between the greatest and the least value."""
        return abs(self.factor) * range_of(self.values)


class Settling:
    """Goes from the cells of a column to its samples (LG-107, LG-703): numbers, each once.

    ``samples``: how many there are; ``back_us``: the stamp before the first one that runs back,
    ``None`` for none; ``largest_group``: the largest number of samples that share a stamp;
    ``period_us``: the median time between two stamps, of the first stretch that has two;
    ``left_out``: how many times have no number; ``gap_us``, ``gap_at_us``: the longest time between
    two samples, and where it begins.
    """

    def __init__(self, times: Column, values: Column) -> None:
        self._times, self._values = times, values
        self.samples = 0
        self.back_us: float | None = None
        self.largest_group = 1
        self.period_us = 0.0
        self.left_out = 0
        self.gap_us = self.gap_at_us = 0.0
        before = numpy.empty(0)
        for stamps, _ in self._distinct():
            self.samples += len(stamps)
            self._note_gap(numpy.concatenate((before, stamps)))
            before = stamps[-1:]
            if self.back_us is not None:
                break
            if not self.period_us or (numpy.diff(stamps) == 0.0).any():
                first, counts = _groups(stamps)
                self.largest_group = max(self.largest_group, int(counts.max()))
                if not self.period_us and len(first) > 1:
                    self.period_us = float(numpy.median(numpy.diff(stamps[first])))

    def settled(self) -> tuple[Column, Column]:
        """Return stamps and values of the samples; those of the log if nothing is to be done."""
        if self.samples == len(self._times) and self.largest_group == 1:
            return self._times, self._values
        table = NumberTable(2)
        for stamps, values in self._distinct():
            first, counts = _groups(stamps)
            rank = numpy.arange(len(stamps)) - numpy.repeat(first, counts)
            spread = stamps + rank * (self.period_us / numpy.repeat(counts, counts))
            table.add(numpy.stack([spread, values]).T)
        return table.column(0), table.column(1)

    def _distinct(self) -> Iterator[tuple[Numbers, Numbers]]:
        """Yield samples without repetitions; those that share a stamp come together."""
        held_times, held_values = numpy.empty(0), numpy.empty(0)
        self.left_out = 0
        for one in stretches(len(self._times)):
            times, values = self._times[one], self._values[one]
            has_time = numpy.isfinite(times)
            is_number = has_time & numpy.isfinite(values)
            if not is_number.all():
                self.left_out += int(numpy.count_nonzero(has_time & ~is_number))
                times, values = times[is_number], values[is_number]
            times = numpy.concatenate((held_times, times))
            values = numpy.concatenate((held_values, values))
            steps = numpy.diff(times)
            self._note_back(times, steps)
            is_same = (steps == 0.0) & (numpy.diff(values) == 0.0)  # exports that fill repeat both
            if is_same.any():
                is_new = numpy.append(True, ~is_same)
                times, values = times[is_new], values[is_new]
            if not len(times):
                continue
            end = int(numpy.searchsorted(times, times[-1]))
            held_times, held_values = times[end:], values[end:]
            if end:
                yield times[:end], values[:end]
        if len(held_times):
            yield held_times, held_values

    def _note_gap(self, stamps: Numbers) -> None:
        steps = numpy.diff(stamps)
        if len(steps) and steps.max() > self.gap_us:
            at = int(steps.argmax())
            self.gap_us, self.gap_at_us = float(steps[at]), float(stamps[at])

    def _note_back(self, times: Numbers, steps: Numbers) -> None:
        is_back = steps < 0.0
        if self.back_us is None and is_back.any():
            self.back_us = float(times[int(is_back.argmax())])


def _groups(stamps: Numbers) -> tuple[NDArray[numpy.int64], NDArray[numpy.int64]]:
    """Return where samples with a common stamp begin, and how many they are."""
    first = numpy.flatnonzero(numpy.append(True, numpy.diff(stamps) != 0.0))
    return first, numpy.diff(numpy.append(first, len(stamps)))


class Log(abc.ABC):
    """A log that is open: its columns are known, its samples are read on request."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.columns: Sequence[LogColumn] = ()
        self.notes: list[Diagnostic] = []

    @abc.abstractmethod
    def read(self, columns: Sequence[LogColumn]) -> list[Samples]:
        """Return the samples of columns; raises ``Failure`` for a cell that is not a number."""

    def settled(self, name: str, times: Column, values: Column) -> Samples:
        """Return the samples of a column; those that share a stamp are spread.

        Cells without a number are no samples. Raises ``Failure`` for a column without samples
        (902516) and times that run back (902517).
        """
        settling = Settling(times, values)
        if settling.back_us is not None:
            at = f"{settling.back_us / 1e6:.6f}"
            raise Failure(diagnostic(TIME_RUNS_BACK, file=self.file, name=name, time=at))
        if not settling.samples:
            raise Failure(diagnostic(LOG_IS_EMPTY, file=self.file, name=name))
        period = f"{settling.period_us / 1e3:g}"
        if settling.largest_group > 1:
            self.notes.append(
                diagnostic(EQUAL_STAMPS, name=name, count=settling.largest_group, time=period)
            )
        if settling.left_out:
            self.notes.append(diagnostic(CELLS_LEFT_OUT, name=name, count=settling.left_out))
        if settling.gap_us > _GAP_PERIODS * settling.period_us > 0.0:
            length, at = f"{settling.gap_us / 1e3:g}", f"{settling.gap_at_us / 1e6:g}"
            self.notes.append(
                diagnostic(GAP_IN_LOG, name=name, length=length, time=at, period=period)
            )
        return Samples(*settling.settled())
