# SPDX-License-Identifier: MIT
"""Notifications: values sent to clients cyclically or when they change, with the time of the tick.

In: frames of the session. Out: AMS frames to the clients, one for all of a client's notifications
that are due with the same distance. Times are FILETIMEs.
"""

from __future__ import annotations

import heapq
from collections import Counter
from collections.abc import Iterator, Mapping
from itertools import count
from struct import Struct

from nctakt.servers.ads.clients import Client
from nctakt.servers.ads.codes import AdsError, Command, Error
from nctakt.servers.ads.data import Readable
from nctakt.servers.ads.frames import REQUEST, Frame
from nctakt.servers.ads.limits import (
    MAX_ALL_NOTIFICATIONS,
    MAX_NOTIFICATIONS,
    MAX_PERIOD,
    MIN_PERIOD,
)
from nctakt.servers.clock import MachineClock
from nctakt.servers.shares import greediest
from nctakt.servers.store import Scalar

#: 100 ns of ADS in a microsecond.
_UNITS_PER_US = 10

_STREAM = Struct("<IIQI")
_SAMPLE = Struct("<II")


class _Notification:
    __slots__ = ("handle", "item", "last", "sends_changes", "series")

    def __init__(
        self, handle: int, item: Readable, series: _Series, *, sends_changes: bool
    ) -> None:
        self.handle = handle
        self.item = item
        self.series = series
        self.sends_changes = sends_changes
        self.last: bytes | None = None


class _Series:
    """The notifications of a client with the same distance; ``due``: at which tick they are."""

    __slots__ = ("client", "due", "members", "own_id", "own_port", "period")

    def __init__(self, client: Client, period: int, own: tuple[bytes, int]) -> None:
        self.client = client
        self.period = period
        self.own_id, self.own_port = own
        self.due = 0
        self.members: dict[int, _Notification] = {}


class Notifier:
    """All notifications."""

    def __init__(self, clock: MachineClock) -> None:
        self._clock = clock
        self._cycle_units = clock.cycle_time_us * _UNITS_PER_US
        self._series: dict[tuple[Client, int, int], _Series] = {}
        self._queue: list[tuple[int, int, _Series]] = []
        self._order = count()
        self._all: dict[int, _Notification] = {}
        self._counts: Counter[object] = Counter()
        self._tick = 0

    def add(
        self,
        client: Client,
        item: Readable,
        own: tuple[bytes, int],
        *,
        cycle_units: int,
        sends_changes: bool,
    ) -> int:
        """Return the handle of a new notification; ``own``: the address it comes from.

        ``cycle_units``: the distance in 100 ns, at least a tick. Raises ``AdsError``.
        """
        if len(client.notifications) >= MAX_NOTIFICATIONS:
            raise AdsError(Error.NO_HANDLES, f"{MAX_NOTIFICATIONS} notifications are open")
        if len(self._all) >= MAX_ALL_NOTIFICATIONS:
            self._make_room(client)
        period = min(max(MIN_PERIOD, cycle_units // self._cycle_units), MAX_PERIOD)
        key = client, period, own[1]
        series = self._series.get(key)
        if series is None:
            series = self._series[key] = _Series(client, period, own)
            self._plan(series, self._tick + period)
        handle = client.next_number()
        added = _Notification(handle, item, series, sends_changes=sends_changes)
        series.members[handle] = self._all[handle] = added
        client.notifications.add(handle)
        self._counts[client.connection] += 1
        return handle

    def _make_room(self, client: Client) -> None:
        """End the oldest notification of the connection with most; raises ``AdsError``.

        As the protocol has it, its client is notified by a sample without data.
        """
        connection = greediest(self._counts, client.connection)
        if connection is None:
            raise AdsError(Error.NO_HANDLES, f"{MAX_ALL_NOTIFICATIONS} notifications are open")
        oldest = next(
            one for one in self._all.values() if one.series.client.connection == connection
        )
        self._send(oldest.series, [(oldest.handle, b"")], self._tick)
        if oldest.handle in self._all:  # else it has been disconnected for taking nothing
            self.delete(oldest.series.client, oldest.handle)

    def items(self) -> Iterator[Readable]:
        """Yield the frames to send."""
        for one in self._all.values():
            yield one.item

    def begin(self, client: Client, handle: int, values: Mapping[str, Scalar], tick: int) -> None:
        """Send the first value of a notification; the others follow."""
        added = self._all.get(handle)
        if added is not None:
            try:
                added.last = added.item.read(values)
            except KeyError:  # its values come again soon, and then it is sent
                added.last = b""
            else:
                self._send(added.series, [(handle, added.last)], tick)

    def delete(self, client: Client, handle: int) -> None:
        """End a notification; raises ``AdsError`` for one that the client does not have."""
        if handle not in client.notifications:
            raise AdsError(Error.NOTIFICATION_HANDLE, "an unknown notification")
        client.notifications.remove(handle)
        series = self._all.pop(handle).series
        del series.members[handle]
        self._counts[client.connection] -= 1
        if not self._counts[client.connection]:
            del self._counts[client.connection]

    def forget(self, client: Client) -> None:
        """End all notifications of a client."""
        for handle in tuple(client.notifications):
            self.delete(client, handle)

    def receive(self, values: Mapping[str, Scalar], tick: int) -> None:
        """Send notifications due before a tick."""
        queue = self._queue
        if tick < self._tick:  # the session has gone back
            for series in self._series.values():
                series.due = tick
            queue[:] = [(tick, next(self._order), series) for _, _, series in queue]
            heapq.heapify(queue)
        self._tick = tick
        while queue and queue[0][0] <= tick:
            _, _, series = heapq.heappop(queue)
            if not series.members:
                del self._series[series.client, series.period, series.own_port]
                continue
            late = (tick - series.due) // series.period
            self._plan(series, series.due + (late + 1) * series.period)
            samples = []
            for handle, one in series.members.items():
                if one.last is None:
                    continue  # its client does not know its handle yet
                try:
                    data = one.item.read(values)
                except KeyError:
                    continue  # its values come again soon
                if not one.sends_changes or data != one.last:
                    one.last = data
                    samples.append((handle, data))
            if samples:
                self._send(series, samples, tick)

    def _plan(self, series: _Series, due: int) -> None:
        series.due = due
        heapq.heappush(self._queue, (due, next(self._order), series))

    def _send(self, series: _Series, samples: list[tuple[int, bytes]], tick: int) -> None:
        parts = [b""]
        for handle, data in samples:
            parts.append(_SAMPLE.pack(handle, len(data)))
            parts.append(data)
        size = sum(map(len, parts)) + _STREAM.size - 4
        moment = self._clock.filetime(tick)
        parts[0] = _STREAM.pack(size, 1, moment, len(samples))
        client = series.client
        frame = Frame(
            client.net_id,
            client.port,
            series.own_id,
            series.own_port,
            Command.NOTIFICATION,
            REQUEST,
            0,
            0,
            b"".join(parts),
        )
        client.send(frame.encode())

    def __len__(self) -> int:
        return len(self._all)
