# SPDX-License-Identifier: MIT
"""A dimension of a study: the varied quantity, and its values.

In: the entries of a plan. Out: values by their number or by a number between 0 and 1. A value of a
dimension of times is a whole number of microseconds, each other one a number or a text.
"""

from __future__ import annotations

import math
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.times import Time
from nctakt.studies.plans.distribution import Distribution

#: Quantities that a dimension varies: a variable's value, the time of a stimulus, the seed of a
#: noise, the file of a series, how a function is acknowledged, when the PLC dies and comes back, a
#: parameter of the lists, a variable of the program, an entry of the load of a schedule, the files
#: of a schedule and of its load.
Kind = Literal[
    "variable", "time_of", "noise", "series", "acknowledge", "plc_dies", "plc_returns",
    "parameter", "program_variable", "load_entry", "rtconf", "load",
]  # fmt: skip

#: The kinds whose values are times; that of an acknowledgement may be ``never`` or ``twice``.
TIME_KINDS: tuple[Kind, ...] = ("time_of", "acknowledge", "plc_dies", "plc_returns")

#: The kinds whose values are files.
FILE_KINDS: tuple[Kind, ...] = ("series", "rtconf", "load")

Value = float | int | str

#: The highest time of a dimension that extends to the end of the unchanged run, in microseconds.
END_OF_RUN = 1 << 60

#: The most values of a list that are checked before any run.
MAX_PROBES = 50

#: Steps of a dimension beyond which they are not counted.
MAX_STEPS = 1e18

_MASK = (1 << 64) - 1


@dataclass(frozen=True, slots=True)
class Dimension:
    """A varied quantity, and its values: ``values``, or from ``low`` to ``high`` in steps.

    ``target``: the variable, the assignment of ``time_of`` (its variable; ``amount`` is the value),
    the function, the parameter's ID; ``of``: the axis or channel whose parameter it is. ``at``:
    from which time on; ``duration``: how long, for ``time_of`` until the value goes back to
    ``rest``, for a ramp or a noise how long it lasts. A ramp begins with ``rest``; a noise keeps
    within ``amount`` of ``rest``. ``step`` 0: any value between ``low`` and ``high``.
    ``is_each_tick``: each tick of a run, from ``low`` up to the end of the unchanged run.
    ``nominal``: the value of the unchanged run; ``None``: the first one. ``is_whole``: it takes
    whole numbers only, so that values between two of them are rounded. ``tick_us``: the length of a
    tick, for times: those between two ticks would have the effect of the next tick.
    ``distribution``: how often each value is drawn by methods without a grid; ``None``: evenly.
    """

    name: str
    kind: Kind
    target: str
    of: str = ""
    values: tuple[Value, ...] = ()
    low: float = 0.0
    high: float = 0.0
    step: float = 0.0
    amount: float | str = 0.0
    rest: float | str = 0.0
    at: Time | None = None
    duration: Time | None = None
    is_ramp: bool = False
    is_each_tick: bool = False
    nominal: Value | None = None
    is_whole: bool = False
    tick_us: int = 1
    distribution: Distribution | None = None

    @property
    def is_time(self) -> bool:
        """Whether its values are times."""
        return self.kind in TIME_KINDS

    @property
    def has_files(self) -> bool:
        """Whether its values are files."""
        return self.kind in FILE_KINDS

    @property
    def count(self) -> int:
        """The number of its values on a grid; 0 if there are none, or if it has no step."""
        if self.values:
            return len(self.values)
        if self.step <= 0 or self.high < self.low:
            return 0
        return int(min((self.high - self.low) / self.step, MAX_STEPS) + 1e-9) + 1

    @property
    def is_empty(self) -> bool:
        """Whether it has no value at all: neither listed ones, nor between two bounds."""
        return not (self.values or self.low < self.high or self.count)

    def value(self, index: int) -> Value:
        """Return a value by its number on the grid, from 0."""
        if self.values:
            return self.values[index]
        return self._whole(self.low + index * self.step)

    @property
    def rest_value(self) -> Value:
        """The value of the unchanged run."""
        return self.between(0.0) if self.nominal is None else self.nominal

    def probes(self) -> tuple[Value, ...]:
        """Return the values that are checked before any run: the listed ones, or both ends."""
        return self.values[:MAX_PROBES] or (self.between(0.0), self.between(1.0))

    def between(self, share: float) -> Value:
        """Return the value at a share of the range, 0 … 1; on the grid if there is one."""
        count = self.count
        if count:
            return self.value(min(int(share * count), count - 1))
        value = self.low + share * (self.high - self.low)
        if self.is_time:  # drawn at random, or halved
            return self._tick_at(value)
        return self._whole(value)

    def drawn(self, share: float) -> Value:
        """Return the value below which this share, 0 … 1, of all drawn values is."""
        if self.distribution is None:
            return self.between(share)
        value = self.distribution.quantile(share, self.low, self.high)
        count = self.count
        if count:
            return self.value(min(max(round((value - self.low) / self.step), 0), count - 1))
        return self._tick_at(value) if self.is_time else self._whole(value)

    def _tick_at(self, value_us: float) -> int:
        """Return the nearest time between the bounds at which a tick begins, if there is one."""
        first, last = math.ceil(self.low / self.tick_us), math.floor(self.high / self.tick_us)
        if first > last:
            return round(value_us)
        return max(first, min(round(value_us / self.tick_us), last)) * self.tick_us

    def _whole(self, value: float) -> Value:
        """Return a time in whole microseconds; other values without the dust of the addition."""
        if self.is_time or self.is_whole:
            return round(value)
        rounded = round(value, 12)
        return int(rounded) if rounded == int(rounded) and self.step == int(self.step) else rounded

    def shown(self, value: Value) -> Value:
        """Return a value as results show it: times in seconds."""
        return int(value) / 1e6 if self.is_time and not isinstance(value, str) else value

    def of_shown(self, shown: Value) -> Value:
        """Return the value that results show in this way."""
        return round(shown * 1e6) if self.is_time and not isinstance(shown, str) else shown


def chance(seed: int, *numbers: int) -> float:
    """Return a number from 0 up to 1 that belongs to a seed and further numbers.

    The same on each machine and in each process: a run's inputs do not depend on which runs were
    made before it. The steps are those of SplitMix64.
    """
    state = seed & _MASK
    for number in (0, *numbers):
        state = (state ^ (number & _MASK)) + 0x9E3779B97F4A7C15 & _MASK
        state = (state ^ state >> 30) * 0xBF58476D1CE4E5B9 & _MASK
        state = (state ^ state >> 27) * 0x94D049BB133111EB & _MASK
        state ^= state >> 31
    return (state >> 11) / (1 << 53)
