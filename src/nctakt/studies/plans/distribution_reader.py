# SPDX-License-Identifier: MIT
"""The entries of ``[[vary]]`` about a distribution -> ``Distribution``, checked.

In: the table of a dimension. Out: its distribution and the bounds of its values.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nctakt.base.diagnostics import Text
from nctakt.lists.format.times import read_time
from nctakt.studies.plans.dimension import FILE_KINDS, TIME_KINDS, Kind
from nctakt.studies.plans.distribution import (
    NORMAL_SPAN,
    Distribution,
    Normal,
    Samples,
    Triangular,
    read_samples,
)
from nctakt.studies.plans.plan_reader import PlanReader, one_of

#: The distributions, each with its entries and those that it requires.
_WORDS = {
    "normal": (("mean", "deviation", "from", "to"), ("mean", "deviation")),
    "triangular": (("peak", "from", "to"), ("peak", "from", "to")),
    "samples": (("file", "column"), ("file",)),
}
#: The entries that only distributions have.
OF_DISTRIBUTION = ("mean", "deviation", "peak", "file", "column")

_POSITIVE = Text("above 0", "größer als 0")
_BETWEEN = Text("between from and to", "zwischen from und to")
_BELOW = Text("above from", "größer als from")


class DistributionReader:
    """Reads the distribution of an entry; ``bound`` returns the number or the time of a key."""

    def __init__(
        self,
        reader: PlanReader,
        entry: dict[str, Any],
        number: int,
        bound: Callable[[str], float],
    ) -> None:
        self._reader = reader
        self._entry = entry
        self._number = number
        self._bound = bound

    def distribution(
        self, kind: Kind, low: float, high: float
    ) -> tuple[Distribution | None, float, float]:
        """Return the distribution with the bounds of its values; ``None`` without any."""
        name = self._entry.get("distribution")
        if not isinstance(name, str) or name not in _WORDS or kind in FILE_KINDS:
            self._refuse(OF_DISTRIBUTION if name is None else ("distribution",))
            return None, low, high
        words, needed = _WORDS[name]
        other = (*OF_DISTRIBUTION, "values", "from", "to")
        self._refuse(tuple(key for key in other if key not in words))
        lacking = [key for key in needed if key not in self._entry]
        for key in lacking:
            header = f"vary {self._number + 1}"
            self._reader.missing(key, header, self._number, "vary")
        if lacking:
            return None, low, high
        if name == "samples":
            return self._samples(kind, low, high)
        if name == "triangular":
            return self._triangular(low, high)
        found, low, high = self._normal(low, high)
        return found, max(low, 0.0) if kind in TIME_KINDS else low, high

    def _normal(self, low: float, high: float) -> tuple[Distribution | None, float, float]:
        mean, deviation = self._bound("mean"), self._bound("deviation")
        if deviation <= 0.0:
            self._wrong("deviation", _POSITIVE)
            return None, low, high
        low = low if "from" in self._entry else mean - NORMAL_SPAN * deviation
        high = high if "to" in self._entry else mean + NORMAL_SPAN * deviation
        if not low < high:
            self._wrong("to" if "to" in self._entry else "from", _BELOW)
            return None, low, high
        return Normal(mean, deviation), low, high

    def _triangular(self, low: float, high: float) -> tuple[Distribution | None, float, float]:
        peak = self._bound("peak")
        if not low <= peak <= high:
            self._wrong("peak", _BETWEEN)
            return None, low, high
        return Triangular(peak), low, high

    def _samples(
        self, kind: Kind, low: float, high: float
    ) -> tuple[Distribution | None, float, float]:
        path = self._reader.existing(self._entry["file"], "file", "vary", self._number)
        if path is None:
            return None, low, high
        column = self._reader.text(self._entry, "column", "", "vary", self._number)
        number_of = _microseconds if kind in TIME_KINDS else float
        samples: Samples | None = self._reader.tried(
            "file", "vary", self._number, read_samples, path, column, number_of
        )
        if samples is None:
            return None, low, high
        return samples, samples.values[0], samples.values[-1]

    def _refuse(self, keys: tuple[str, ...]) -> None:
        """Note entries that have no meaning in this dimension."""
        for key in keys:
            if key in self._entry:
                self._wrong(key, _ALONE if key != "distribution" else one_of(list(_WORDS)))

    def _wrong(self, key: str, expected: Text) -> None:
        self._reader.wrong(key, self._entry[key], expected, "vary", self._number)


_ALONE = Text("left out with this distribution", "bei dieser Verteilung weggelassen")


def _microseconds(cell: str) -> float:
    """Return the time of a cell; raises ``Failure``, or ``ValueError`` for ticks."""
    time = read_time(cell)
    if time.is_in_ticks:
        raise ValueError(cell)
    return float(time.us(1))
