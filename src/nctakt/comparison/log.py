# SPDX-License-Identifier: MIT
"""A machine's log as data: its columns, and the samples of those that are asked for.

A log has several time bases (LG-101): each signal has its own stamps, in microseconds since the
log's first one. ``notes`` holds what reading it left open.
"""

from __future__ import annotations

import abc
from collections.abc import Sequence
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.comparison import EQUAL_STAMPS, LOG_IS_EMPTY, TIME_RUNS_BACK

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    Numbers = NDArray[numpy.float64]


@dataclass(frozen=True, slots=True)
class LogColumn:
    """A column of values; ``unit`` is "" where the log names none."""

    name: str
    unit: str
    column: int
    time_column: int


@dataclass(frozen=True, slots=True)
class Samples:
    """The samples of a column: ``times`` in µs since the log's first stamp, ascending."""

    times: Numbers
    values: Numbers


class Log(abc.ABC):
    """A log that is open: its columns are known, its samples are read on request."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.columns: Sequence[LogColumn] = ()
        self.notes: list[Diagnostic] = []

    @abc.abstractmethod
    def read(self, columns: Sequence[LogColumn]) -> list[Samples]:
        """Return the samples of columns; raises ``Failure`` for a cell that is not a number."""

    def settled(self, name: str, times: Numbers, values: Numbers) -> Samples:
        """Return the samples of a column; those that share a stamp are spread.

        Raises ``Failure`` for a column without samples (902516) and times that run back (902517).
        """
        import numpy  # noqa: PLC0415 - opening a log does not need it

        if not len(times):
            raise Failure(diagnostic(LOG_IS_EMPTY, file=self.file, name=name))
        steps = numpy.diff(times)
        back = numpy.flatnonzero(steps < 0.0)
        if len(back):
            at = float(times[back[0]]) / 1e6
            raise Failure(diagnostic(TIME_RUNS_BACK, file=self.file, name=name, time=f"{at:.6f}"))
        is_new = numpy.append(True, (steps > 0.0) | (numpy.diff(values) != 0.0))
        times, values = times[is_new], values[is_new]  # exports that fill repeat both (LG-107)
        if len(times) > 1 and not numpy.diff(times).all():
            times = self._spread(times, name)
        return Samples(times, values)

    def _spread(self, times: Numbers, name: str) -> Numbers:
        """Spread samples that share a stamp over the time to the next one (LG-703)."""
        import numpy  # noqa: PLC0415 - as above

        stamps, first, counts = numpy.unique(times, return_index=True, return_counts=True)
        period = float(numpy.median(numpy.diff(stamps))) if len(stamps) > 1 else 0.0
        self.notes.append(
            diagnostic(EQUAL_STAMPS, name=name, count=int(counts.max()), time=f"{period / 1e3:g}")
        )
        rank = numpy.arange(len(times)) - numpy.repeat(first, counts)
        spread: Numbers = times + rank * (period / numpy.repeat(counts, counts))
        return spread
