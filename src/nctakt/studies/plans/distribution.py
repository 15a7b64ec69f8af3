# SPDX-License-Identifier: MIT
"""How often each value of a dimension is drawn: normal, triangular, or as in measured samples.

Out: the value below which a share of all drawn values lie, within the bounds of the dimension. A
dimension without a distribution is drawn evenly.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Callable
from pathlib import Path
from statistics import NormalDist

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import INVALID_SAMPLE, SAMPLE_COLUMN_MISSING

#: Bounds of a normal distribution without others, in deviations: two of 10^9 values are outside.
NORMAL_SPAN = 6.0


@dataclass(frozen=True, slots=True)
class Normal:
    """The normal distribution; values outside the bounds are not drawn."""

    mean: float
    deviation: float

    @property
    def center(self) -> float:
        """The value of the unchanged run."""
        return self.mean

    def quantile(self, share: float, low: float, high: float) -> float:
        """Return the value below which this share is."""
        curve = NormalDist(self.mean, self.deviation)
        begin, end = curve.cdf(low), curve.cdf(high)
        inner = begin + share * (end - begin)
        if not 0.0 < inner < 1.0:
            return low if inner <= 0.0 else high
        return min(max(curve.inv_cdf(inner), low), high)


@dataclass(frozen=True, slots=True)
class Triangular:
    """Between the bounds, most often at ``peak``."""

    peak: float

    @property
    def center(self) -> float:
        """The value of the unchanged run."""
        return self.peak

    def quantile(self, share: float, low: float, high: float) -> float:
        """Return the value below which this share is."""
        width, rise = high - low, self.peak - low
        if width <= 0.0:
            return low
        if share * width < rise:
            return low + math.sqrt(share * width * rise)
        return high - math.sqrt((1.0 - share) * width * (high - self.peak))


@dataclass(frozen=True, slots=True)
class Samples:
    """The values of a column of a CSV file in ascending order, each drawn as often as it occurs.

    ``file`` is where they are from; the values read are part of the plan.
    """

    values: tuple[float, ...] = field(repr=False)
    file: Path

    @property
    def center(self) -> float:
        """The value of the unchanged run: the median."""
        return self.values[(len(self.values) - 1) // 2]

    def quantile(self, share: float, low: float, high: float) -> float:
        """Return the value below which this share is."""
        return self.values[min(int(share * len(self.values)), len(self.values) - 1)]


Distribution = Normal | Triangular | Samples


def read_samples(path: Path, column: str, number_of: Callable[[str], float]) -> Samples:
    """Return the samples of a CSV file; ``number_of`` reads a cell and raises ``ValueError``.

    ``column``: its name in the first row; may be empty if there is only one. Empty cells and lines,
    and lines that begin with ``#``, are skipped. Raises ``Failure`` for a file that cannot be read,
    that has no such column (902533) or no value, and for each cell that is not a number (902532).
    """
    lines = FileAccess().read_lines(path)
    rows = [
        (number, line, next(csv.reader([line])))
        for number, line in enumerate(lines, 1)
        if line.strip() and not line.startswith("#")
    ]
    head = [cell.strip() for cell in rows[0][2]] if rows else []
    has_head = bool(head) and not _is_number(head[0], number_of)
    if column in head and has_head:
        index = head.index(column)
    elif not column and len(head) == 1:
        index = 0
    else:
        shown = ", ".join(head) if has_head else "–"
        raise Failure(diagnostic(SAMPLE_COLUMN_MISSING, file=str(path), name=column, names=shown))
    values: list[float] = []
    found: list[Diagnostic] = []
    for number, line, cells in rows[has_head:]:
        cell = cells[index].strip() if index < len(cells) else ""
        if cell and _is_number(cell, number_of):
            values.append(number_of(cell))
        elif cell:
            begin = line.find(cell) + 1
            span = Span(str(path), number, begin, begin + len(cell))
            found.append(diagnostic(INVALID_SAMPLE, span, line, value=cell))
    if not values and not found:
        found = [diagnostic(SAMPLE_COLUMN_MISSING, file=str(path), name=column, names="–")]
    if found:
        raise Failure(*found)
    return Samples(tuple(sorted(values)), path)


def _is_number(cell: str, number_of: Callable[[str], float]) -> bool:
    try:
        return math.isfinite(number_of(cell))
    except (ValueError, Failure):
        return False
