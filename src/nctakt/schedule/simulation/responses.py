# SPDX-License-Identifier: MIT
"""How often a task had which response.

In: counts by response. Out: percentiles and the bars of a histogram; times in ns.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass

#: The shares of jobs, in per mille, for which reports show the response.
PERCENTILES_PER_MILLE = (500, 900, 990, 999)


@dataclass(frozen=True, slots=True)
class ResponseCounts:
    """Responses from the least on, each with the number of jobs.

    ``resolution``: a response represents all from it up to the next multiple of this; 1 if each is
    kept separately.
    """

    resolution: int = 1
    counts: tuple[tuple[int, int], ...] = ()

    @property
    def total(self) -> int:
        """The number of jobs."""
        return sum(count for _, count in self.counts)

    def percentile(self, per_mille: int) -> int | None:
        """Return the response that at least ``per_mille`` of all jobs do not exceed."""
        needed = -(-self.total * per_mille // 1000)
        reached = 0
        for response, count in self.counts:
            reached += count
            if reached >= needed:
                return response + self.resolution - 1
        return None

    def bars(self, maximum: int) -> list[tuple[int, int, int]]:
        """Return at most this many bars of equal width: from, below, how many jobs.

        Widths are 1, 2 or 5 times a power of ten; empty bars between others are included.
        """
        if not self.counts:
            return []
        first, last = self.counts[0][0], self.counts[-1][0]
        width = _round_width(max(1, self.resolution, -(-(last - first + 1) // maximum)))
        while last // width - first // width >= maximum:
            width = _round_width(width + 1)
        low = first // width
        bars = [0] * (last // width - low + 1)
        for response, count in self.counts:
            bars[response // width - low] += count
        return [((low + i) * width, (low + i + 1) * width, count) for i, count in enumerate(bars)]


def _round_width(width: int) -> int:
    """Return the least of 1, 2, 5, 10, 20, … that is not below ``width``."""
    power = 1
    while True:
        for factor in (1, 2, 5):
            if factor * power >= width:
                return factor * power
        power *= 10
