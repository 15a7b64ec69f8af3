# SPDX-License-Identifier: MIT
"""One subscription of a client: its monitored items, published on request.

In: notifications that wait in its items, publish requests. Out: publish responses. A client that
does not ask loses the oldest notifications, and in the end its subscription.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from typing import Any

from asyncua import ua

from nctakt.servers.opcua.clients import publishing
from nctakt.servers.opcua.clients.monitoring import EventSource, Item
from nctakt.servers.opcua.library import struct_to_binary

_REPORTING, _DISABLED = ua.MonitoringMode.Reporting, ua.MonitoringMode.Disabled


class Subscription:
    """A subscription of a client; ``session_id`` and the two callbacks are those of its connection.

    ``pub_request_callback`` returns a request of the client that can be answered now, if there is
    one; ``pub_result_callback`` answers it.
    """

    def __init__(
        self,
        expire: Callable[[Subscription], None],
        max_unacknowledged: int,
        data: ua.CreateSubscriptionResult,
        session_id: ua.NodeId,
        request_callback: Callable[[int], Any],
        result_callback: Callable[[bytes, Any], None],
        *,
        is_publishing: bool,
        max_notifications: int,
    ) -> None:
        self._expire = expire
        self._max_unacknowledged = max_unacknowledged
        self.data = data
        self.session_id = session_id
        self.pub_request_callback = request_callback
        self.pub_result_callback = result_callback
        self.is_publishing = is_publishing
        self.max_notifications = max_notifications
        self.items: dict[int, Item] = {}
        self.unacknowledged: dict[int, bytes] = {}
        self.status = 0
        self._sequence = 1
        self._is_first = True
        self._idle_count = self._lost_count = 0
        self._timer: asyncio.TimerHandle | None = None
        self._due_s = 0.0

    @property
    def interval_s(self) -> float:
        """The publishing interval in seconds."""
        return float(self.data.RevisedPublishingInterval) / 1000.0

    # --- time -----------------------------------------------------------------------------------

    def start(self) -> None:
        """Publish from now on."""
        loop = asyncio.get_running_loop()
        self._due_s = loop.time() + self.interval_s
        self._timer = loop.call_at(self._due_s, self._tick)

    def stop(self) -> None:
        """Publish no more."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def restart(self) -> None:
        """Publish at another interval."""
        self.stop()
        self.start()

    def _tick(self) -> None:
        loop = asyncio.get_running_loop()
        self._due_s = max(self._due_s + self.interval_s, loop.time() - self.interval_s)
        self._timer = loop.call_at(self._due_s, self._tick)
        self.publish()

    # --- publishing -----------------------------------------------------------------------------

    def _has_something(self) -> bool:
        if self._is_first or self.status:
            return True
        return self.is_publishing and any(
            item.waiting and item.mode == _REPORTING for item in self.items.values()
        )

    def publish(self, request: Any = None) -> bool:
        """Answer a request of the client if there is something to report; return whether it did."""
        if not self._has_something():
            if request is None:
                self._idle_count += 1
            if self._idle_count < self.data.RevisedMaxKeepAliveCount:
                return False
        if request is None:
            request = self.pub_request_callback(self.data.SubscriptionId)
            if request is None:
                self._lost_count += 1
                if self._lost_count >= self.data.RevisedLifetimeCount:
                    self._expire(self)
                return False
        self._answer(request)
        return True

    def _answer(self, request: Any) -> None:
        self._idle_count = self._lost_count = 0
        self._is_first = False
        parts, is_more = self._parts() if self.is_publishing else ([], False)
        if self.status:
            parts.append(publishing.status_notification(self.status))
        message = publishing.notification_message(self._sequence, parts)
        if parts:
            self.unacknowledged[self._sequence] = message
            while len(self.unacknowledged) > self._max_unacknowledged:
                del self.unacknowledged[next(iter(self.unacknowledged))]
            self._sequence = self._sequence % 0xFFFFFFFF + 1
        body = publishing.publish_response(
            request.requesthdr.RequestHandle,
            self.data.SubscriptionId,
            list(self.unacknowledged),
            message,
            request.results,
            is_more=is_more,
        )
        self.pub_result_callback(body, request)

    def _parts(self) -> tuple[list[bytes], bool]:
        """Return the waiting notifications, and whether there are more than fit."""
        values: list[bytes] = []
        events: list[bytes] = []
        limit = self.max_notifications or 1 << 30
        for item in self.items.values():
            if item.waiting:
                if len(values) + len(events) + len(item.waiting) > limit and (values or events):
                    return self._written(values, events), True
                item.take(events if item.is_event else values)
        return self._written(values, events), False

    @staticmethod
    def _written(values: list[bytes], events: list[bytes]) -> list[bytes]:
        parts = [publishing.data_notification(values)] if values else []
        return parts + ([publishing.event_notification(events)] if events else [])

    # --- events ---------------------------------------------------------------------------------

    def notify_event(self, event: EventSource, notifiers: Sequence[ua.NodeId]) -> None:
        """Let an event wait for those items that monitor one of its notifiers and want it."""
        for item in self.items.values():
            if item.is_event and item.node in notifiers and item.mode != _DISABLED:
                self.notify_item(event, item)

    @staticmethod
    def notify_item(event: EventSource, item: Item) -> None:
        """Let an event wait for an item, unless its filter is against it."""
        if event.passes(item.event_filter.WhereClause):
            fields = event.fields(item.event_filter.SelectClauses)
            content = struct_to_binary(ua.EventFieldList(item.handle, fields))
            item.put(bytes(content[4:]))  # the handle is put before it with all others
