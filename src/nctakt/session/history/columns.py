# SPDX-License-Identifier: MIT
"""A session's compact record of signals and written variables, tick by tick.

In: the rows of the recorded signals and the events of writes, as the ticks are run for the first
time. Out: the ticks in which a signal can have met the condition of a stop; the last tick in which
a realtime cycle has written a variable. The lowest and the highest value of a signal in some
thousand ticks are kept, so that a search reruns only ticks in which the condition can have been
met. The condition follows from the text of a stop, as far as it compares a recorded signal.
"""

from __future__ import annotations

import bisect
import re
from array import array
from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, cast

import numpy as np
from numpy.typing import NDArray

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.kernel import rows
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.session.stops import EventFilter, StopAt

#: Ticks whose lowest and highest values are kept together; at most this many are recorded at once.
EXTENT_TICKS = 16_384

#: Signals that a session records at most by default.
MAX_SIGNALS = 64

#: Series of ticks with writes that a branch keeps at most.
MAX_SERIES = 2_000_000

#: The kinds of events of which there may be some in each tick: writes of variables.
WRITES = (rows.EVENT_WRITTEN, rows.EVENT_WRITTEN_TEXT)
WRITE_KINDS = sum(1 << kind for kind in WRITES)

#: The columns of an event that name the written variable.
_WRITTEN = (rows.EVENT_KIND, rows.EVENT_CHANNEL, rows.EVENT_A, rows.EVENT_TICK)

#: Rows of writes that wait to be joined at most.
_MAX_WAITING = 100_000


def extent_end(tick: int) -> int:
    """Return the limit up to which ticks from this one on are recorded together."""
    return (tick // EXTENT_TICKS + 1) * EXTENT_TICKS


@dataclass(frozen=True, slots=True)
class Extent:
    """The lowest and highest values of the signals after some ticks, and before the first one."""

    first_tick: int
    count: int
    lowest: NDArray[np.float64]
    highest: NDArray[np.float64]

    @property
    def end(self) -> int:
        """The tick after its last one."""
        return self.first_tick + self.count

    def with_next(self, other: Extent) -> Extent:
        """Return it with the ticks that follow."""
        lowest = np.minimum(self.lowest, other.lowest)
        highest = np.maximum(self.highest, other.highest)
        return Extent(self.first_tick, self.count + other.count, lowest, highest)


@dataclass(frozen=True, slots=True)
class Necessary:
    """A condition necessary for a stop: a signal changes, or passes a number.

    ``column``: that of the signal; ``operator``: of the comparison that becomes true.
    """

    column: int
    operator: Literal["changes", "<", "<=", ">", ">=", "==", "!="]
    number: float = 0.0

    def is_possible(self, extent: Extent) -> bool:
        """Return whether the stop may hold after one of some ticks."""
        low, high = float(extent.lowest[self.column]), float(extent.highest[self.column])
        if not low < high:
            return low != high  # neither is a number: nothing is known
        match self.operator:
            case ">":
                return low <= self.number < high
            case ">=":
                return low < self.number <= high
            case "<":
                return low < self.number <= high
            case "<=":
                return low <= self.number < high
            case "changes":
                return True
        return low <= self.number <= high


class ColumnTrail:
    """Gathers the signals and writes of a controller's ticks, until they are taken."""

    def __init__(self) -> None:
        self._extents: list[Extent] = []
        self._first_tick = self._end = 0
        self._values: list[memoryview[float]] = []
        self._writes: list[NDArray[np.float64]] = []
        self._waiting = 0

    def extent(self, first_tick: int, count: int, values: memoryview[float]) -> None:
        """Gather the lowest values of the signals in some ticks, and the highest ones."""
        is_next = self._end == first_tick and extent_end(first_tick) == extent_end(self._first_tick)
        if not is_next or (self._values and len(values) != len(self._values[0])):
            self._close_extent()
        if not self._values:
            self._first_tick = first_tick
        self._values.append(values)
        self._end = first_tick + count

    def _close_extent(self) -> None:
        """Merge consecutive values into one extent."""
        if not self._values:
            return
        whole = np.array(self._values).reshape(len(self._values), 2, -1)
        lowest, highest = whole[:, 0].min(axis=0), whole[:, 1].max(axis=0)
        count = self._end - self._first_tick
        self._extents.append(Extent(self._first_tick, count, lowest, highest))
        self._values = []

    def rest(self, data: bytes) -> bytes:
        """Gather the writes among rows of events; return the other rows."""
        found = np.frombuffer(data, np.float64).reshape(-1, rows.EVENT_WIDTH)
        kinds = found[:, rows.EVENT_KIND]
        is_write: NDArray[np.bool_] = np.logical_or.reduce([kinds == kind for kind in WRITES])
        self.writes(found[is_write])
        return found[~is_write].tobytes()

    def writes(self, events: NDArray[np.float64]) -> None:
        """Gather writes, but for those of the decoder."""
        found = events[events[:, rows.EVENT_SUBJECT] >= 1.0][:, _WRITTEN]
        if len(found):
            self._writes.append(found)
            self._waiting += len(found)
        if self._waiting > _MAX_WAITING:
            self._join()

    def _join(self) -> NDArray[np.float64]:
        """Return the writes so far as series: kind, channel, written variable, first, last tick."""
        parts = [one if one.shape[1] == 5 else one[:, (0, 1, 2, 3, 3)] for one in self._writes]
        whole = np.concatenate(parts) if parts else np.empty((0, 5))
        whole = whole[np.lexsort((whole[:, 3], whole[:, 2], whole[:, 1], whole[:, 0]))]
        is_same = (whole[1:, :3] == whole[:-1, :3]).all(axis=1)
        is_first = np.append(True, ~(is_same & (whole[1:, 3] <= whole[:-1, 4] + 1)))[: len(whole)]
        joined: NDArray[np.float64] = whole[is_first]
        is_last = np.append(is_first[1:], True)[: len(whole)]
        joined[:, 4] = whole[is_last][:, 4]
        self._writes, self._waiting = [joined], 0
        return joined

    def take(self) -> tuple[tuple[Extent, ...], bytes]:
        """Return the signals and writes gathered since the last call."""
        self._close_extent()
        extents, self._extents = tuple(self._extents), []
        written = self._join().tobytes() if self._writes else b""
        self._writes = []
        return extents, written


def _append(extents: list[Extent], extent: Extent) -> None:
    """Append an extent, or merge it with the last one if they share ticks."""
    number = extent.first_tick // EXTENT_TICKS
    if extents and extents[-1].end == extent.first_tick:
        if extents[-1].first_tick // EXTENT_TICKS == number:
            extents[-1] = extents[-1].with_next(extent)
            return
    extents.append(extent)


class ColumnRecord:
    """The signals and writes of one branch, from its first tick on.

    ``writes_from``: the first tick whose writes are all kept.
    """

    def __init__(self) -> None:
        self._extents: list[Extent] = []
        self._series: dict[tuple[float, float, float], array[int]] = {}
        self._count = 0
        self.writes_from = 0

    def add(self, extents: Sequence[Extent], written: bytes) -> None:
        """Add the record of ticks that were run for the first time."""
        for extent in extents:
            _append(self._extents, extent)
        for kind, channel, cell, first, last in np.frombuffer(written).reshape(-1, 5).tolist():
            series = self._series.setdefault((kind, channel, cell), array("q"))
            if series and series[-1] + 1 >= first:
                series[-1] = max(series[-1], int(last))
            else:
                series.extend((int(first), int(last)))
                self._count += 1
        if self._count > MAX_SERIES:
            self._forget()

    def _forget(self) -> None:
        """Forget the older half of the writes."""
        ends = sorted(last for series in self._series.values() for last in series[1::2])
        self.writes_from = ends[len(ends) // 2] + 1
        for series in self._series.values():
            del series[: 2 * bisect.bisect_left(series[1::2], self.writes_from)]
        self._count = sum(len(series) // 2 for series in self._series.values())

    def last_write(self, requested: EventFilter, before: float) -> int | None:
        """Return the last kept tick before another that has such a write, ``None`` without."""
        found: list[int] = []
        for (kind, channel, cell), series in self._series.items():
            if not requested.takes_write(kind, channel, cell):
                continue
            index = bisect.bisect_left(series[0::2], before) - 1
            if index >= 0:
                found.append(min(series[2 * index + 1], int(before) - 1))
        return max(found, default=None)

    def possible_end(self, needed: Necessary, first_tick: int, before: int) -> int | None:
        """Return the end of the last ticks before ``before`` in which a stop may hold.

        ``None``: in none since ``first_tick``. Ticks that are not recorded count as possible.
        """
        unknown = before
        for extent in self._backward(before):
            if extent.end < unknown:
                return unknown
            if needed.is_possible(extent):
                return min(before, extent.end)
            unknown = extent.first_tick
        return unknown if unknown > first_tick else None

    def _backward(self, before: int) -> Iterator[Extent]:
        end = bisect.bisect_left(self._extents, before, key=lambda extent: extent.first_tick)
        return (self._extents[index] for index in range(end - 1, -1, -1))


# --- evidence about a stop ------------------------------------------------------------------------


_NAME = r"\s*(?P<name>V\.[\w.\[\]]+?)\s*"
_VARIABLE = re.compile(_NAME)
_COMPARISON = re.compile(_NAME + r"(?P<operator><=|>=|==|!=|<|>)\s*(?P<number>-?\d+(?:\.\d+)?)\s*")

_Operator = Literal["<", "<=", ">", ">=", "==", "!="]


def necessary(
    stop: StopAt, machine: AssembledMachine, columns: Mapping[int, int]
) -> Necessary | None:
    """Return a signal's necessary condition for a stop; ``None`` if none is known.

    ``columns``: cell of a recorded signal -> its column.
    """
    pattern = {"condition": _COMPARISON, "changes": _VARIABLE}.get(stop.kind)
    match = None if pattern is None else pattern.fullmatch(stop.text)
    if match is None:
        return None
    prefix = f"CH{stop.channel}." if stop.channel > 1 else ""
    try:
        cell, is_text = machine.access.cell_of(f"{prefix}{match['name']}")
    except Failure:
        return None
    if is_text or cell not in columns:
        return None
    if stop.kind == "changes":
        return Necessary(columns[cell], "changes")
    return Necessary(columns[cell], cast("_Operator", match["operator"]), float(match["number"]))
