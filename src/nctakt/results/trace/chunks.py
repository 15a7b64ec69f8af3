# SPDX-License-Identifier: MIT
"""Events of some ticks, decoded when they are looked at, and not before.

In: event rows of the record. Out: all events as a sequence; those of some kinds; each event once,
with how often it was repeated. Long runs have millions of rows, which few listeners need one by
one.
"""

from __future__ import annotations

import bisect
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from types import MappingProxyType
from typing import cast, overload

from nctakt.kernel import rows
from nctakt.results.trace.events import ROW, Event, EventDecoder

_ROW_SIZE = 8 * rows.EVENT_WIDTH

#: Kinds of events of which a run may have many in each tick.
_FREQUENT = frozenset(
    (
        rows.EVENT_FIRED,
        rows.EVENT_WRITTEN,
        rows.EVENT_WRITTEN_TEXT,
        rows.EVENT_TECHNOLOGY_RT,
        rows.EVENT_TECHNOLOGY,
    )
)

#: Words of events, with the kind of row that alone gives them.
ROW_KINDS = MappingProxyType(
    {
        "H": rows.EVENT_TECHNOLOGY_RT,
        "M": rows.EVENT_TECHNOLOGY_RT,
        "fired": rows.EVENT_FIRED,
        "message": rows.EVENT_MESSAGE,
        "output": rows.EVENT_TECHNOLOGY,
    }
)

#: The columns that repeated events of these kinds have in common.
_KEY = (
    rows.EVENT_KIND,
    rows.EVENT_CHANNEL,
    rows.EVENT_SOURCE,
    rows.EVENT_SUBJECT,
    rows.EVENT_A,
)


class EventChunk(Sequence[Event]):
    """Events of some consecutive ticks, decoded when they are first read."""

    def __init__(self, decoder: EventDecoder, data: bytes) -> None:
        self._decoder = decoder
        self._data = data
        self._events: list[Event] | None = None
        self._kinds: list[float] | None = None
        self._present: set[float] = set()

    def __len__(self) -> int:
        return len(self._data) // _ROW_SIZE

    def __iter__(self) -> Iterator[Event]:
        return iter(self._decoded())

    @overload
    def __getitem__(self, index: int) -> Event: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[Event]: ...

    def __getitem__(self, index: int | slice) -> Event | Sequence[Event]:
        return self._decoded()[index]

    @property
    def data(self) -> bytes:
        """The rows as recorded."""
        return self._data

    def with_data(self, data: bytes) -> EventChunk:
        """Return a chunk of other rows of the same run, not decoded yet."""
        return EventChunk(self._decoder, data)

    def cells(self) -> Iterator[tuple[float, ...]]:
        """Return the columns of each row in turn (``rows.EVENT_TICK`` …)."""
        return ROW.iter_unpack(self._data)

    def column(self, number: int) -> list[float]:
        """Return one column of all rows (``rows.EVENT_KIND`` …)."""
        cells = memoryview(self._data).cast("d")
        return cast("list[float]", cells[number :: rows.EVENT_WIDTH].tolist())

    def after(self, count: int) -> EventChunk:
        """Return the rows without the first ones, not decoded yet."""
        return self if count <= 0 else self.with_data(self._data[_ROW_SIZE * count :])

    def select(self, indexes: Sequence[int]) -> EventChunk:
        """Return the rows at these indexes, not decoded yet."""
        pieces = (self._data[_ROW_SIZE * i : _ROW_SIZE * (i + 1)] for i in indexes)
        return EventChunk(self._decoder, b"".join(pieces))

    def joined(self, others: Sequence[EventChunk]) -> EventChunk | None:
        """Return it with the rows that follow, ``None`` if others decode some of them."""
        if any(other._decoder is not self._decoder for other in others):
            return None
        return self.with_data(b"".join([self._data, *(other.data for other in others)]))

    def kinds(self) -> list[float]:
        """Return the kind of each row (``rows.EVENT_FIRED`` …); several listeners ask for it."""
        if self._kinds is None:
            self._kinds = self.column(rows.EVENT_KIND)
            self._present = set(self._kinds)
        return self._kinds

    def has_any(self, kinds: Collection[int]) -> bool:
        """Return whether a row is of one of these kinds."""
        self.kinds()
        return not self._present.isdisjoint(kinds)

    def of_kinds(self, kinds: Collection[int]) -> EventChunk:
        """Return the rows of these kinds (``rows.EVENT_FIRED`` …), not decoded yet."""
        if not self.has_any(kinds):
            return self.with_data(b"")
        if self._present.issubset(kinds):
            return self
        return self.select([i for i, kind in enumerate(self.kinds()) if kind in kinds])

    def since(self, tick: int) -> EventChunk:
        """Return the rows from a tick on, not decoded yet."""
        first = bisect.bisect_left(self.column(rows.EVENT_TICK), tick)
        return self.after(first)

    def repetitions(self) -> list[tuple[Event, int, int]]:
        """Return each event once, with its number of occurrences and the tick of the last one.

        Firings, writes and functions count as the same if cycle, place and names are the same; each
        event of another kind counts once. They are in the order of their first occurrence.
        """
        if not self._data:
            return []
        keys = list(zip(*map(self.column, _KEY), strict=True))
        ticks = self.column(rows.EVENT_TICK)
        counts = Counter(keys)
        last_ticks = dict(zip(keys, ticks, strict=True))
        backward = range(len(keys) - 1, -1, -1)
        firsts = dict(zip(reversed(keys), backward, strict=True))
        indexes = {index for key, index in firsts.items() if key[0] in _FREQUENT}
        indexes.update(i for i, key in enumerate(keys) if key[0] not in _FREQUENT)
        ordered = sorted(indexes)
        repetitions: list[tuple[Event, int, int]] = []
        for index, event in zip(ordered, self.select(ordered), strict=True):
            is_frequent = keys[index][0] in _FREQUENT
            count = counts[keys[index]] if is_frequent else 1
            last = last_ticks[keys[index]] if is_frequent else ticks[index]
            repetitions.append((event, count, int(last)))
        return repetitions

    def _decoded(self) -> list[Event]:
        if self._events is None:
            self._events = self._decoder.decode(self._data)
        return self._events


def latest_of_channels(events: Sequence[Event], column: int) -> list[tuple[Event, float]]:
    """Return the last event of each channel with one of its columns (``rows.EVENT_B`` …).

    The others are not decoded. Events that do not come as rows have no columns, and none are
    returned.
    """
    if not isinstance(events, EventChunk):
        return []
    channels = events.column(rows.EVENT_CHANNEL)
    last = {channel: index for index, channel in enumerate(channels)}
    latest = events.select(list(last.values()))
    return list(zip(latest, latest.column(column), strict=True))


def of_kinds(events: Sequence[Event], kinds: Collection[int]) -> Sequence[Event]:
    """Return the events of a chunk that are of these kinds of rows; other events unchanged."""
    return events.of_kinds(kinds) if isinstance(events, EventChunk) else events


def since_tick(events: Sequence[Event], tick: int) -> Sequence[Event]:
    """Return the rows of a chunk from a tick on; events that are not a chunk unchanged."""
    return events.since(tick) if isinstance(events, EventChunk) else events


def without_kinds(events: Sequence[Event], kinds: Collection[int]) -> Sequence[Event]:
    """Return the events of a chunk that are of none of these kinds; other events unchanged."""
    if not isinstance(events, EventChunk):
        return events
    if not events.has_any(kinds):
        return events
    return events.select([i for i, kind in enumerate(events.kinds()) if kind not in kinds])


def repetitions(events: Sequence[Event]) -> list[tuple[Event, int, int]]:
    """Return the repetitions of a chunk; of other sequences each event, once."""
    if isinstance(events, EventChunk):
        return events.repetitions()
    return [(event, 1, event.tick) for event in events]
