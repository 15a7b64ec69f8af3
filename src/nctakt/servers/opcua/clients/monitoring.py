# SPDX-License-Identifier: MIT
"""Monitored items of a client: values and events waiting for its next publish response.

In: samples of nodes at the pace of the client, events. Out: encoded notifications. An item keeps
the latest ones; a dropped one is marked in its neighbour.
"""

from __future__ import annotations

import math
import struct
from collections import deque
from typing import Any, Protocol

from asyncua import ua

from nctakt.base.dataclass import dataclass, field
from nctakt.servers.opcua.values import Live, Sample

#: Bits of a status: it is a value's, and notifications before or after it were left out.
OVERFLOW = 0x480

_STATUS, _STATUS_VALUE, _STATUS_VALUE_TIME = range(3)
_ABSOLUTE, _PERCENT = 1, 2


class EventSource(Protocol):
    """An event that can be asked for its fields."""

    def fields(self, clauses: list[Any]) -> list[ua.Variant]:
        """Return the values that a client has selected."""

    def passes(self, clause: Any) -> bool:
        """Return whether the event is one of those that a client wants."""


@dataclass(slots=True, eq=False)
class Item:
    """A monitored item of a subscription; ``live`` is ``None`` for events and fixed values."""

    id: int
    handle: int
    node: ua.NodeId
    attribute: int
    mode: int
    queue_size: int
    discards_oldest: bool
    interval_ms: float
    live: Live | None = None
    trigger: int = _STATUS_VALUE
    deadband: float = 0.0
    event_filter: Any = None
    waiting: deque[bytes] = field(default_factory=deque)
    last: Sample | None = None

    @property
    def is_event(self) -> bool:
        """Whether it is for events."""
        return self.event_filter is not None

    def look(self, sample: Sample) -> bool:
        """Take a sample; return whether it goes out."""
        last = self.last
        if last is not None and not self._differs(last, sample):
            return False
        self.last = sample
        self.put(sample.wire)
        return True

    def _differs(self, last: Sample, sample: Sample) -> bool:
        if sample.status != last.status:
            return True
        if self.trigger == _STATUS:
            return False
        if self.trigger == _STATUS_VALUE_TIME and sample.wire[-16:-8] != last.wire[-16:-8]:
            return True
        if sample.content == last.content:
            return False
        if self.deadband > 0.0 and isinstance(sample.value, float):
            # also from and to a value that is no number
            return not abs(sample.value - last.value) <= self.deadband
        return True

    def put(self, content: bytes) -> None:
        """Let a notification wait; a full queue loses the oldest, or the one before."""
        waiting = self.waiting
        if len(waiting) >= self.queue_size:
            if self.discards_oldest:
                waiting.popleft()
                if self.queue_size > 1 and not self.is_event:
                    waiting[0] = overflown(waiting[0])
            else:
                waiting.pop()
                content = content if self.is_event else overflown(content)
        waiting.append(content)

    def take(self, found: list[bytes]) -> None:
        """Add the waiting notifications to ``found``, encoded."""
        if self.waiting and self.mode == ua.MonitoringMode.Reporting:
            head = struct.pack("<I", self.handle)
            found += [head + content for content in self.waiting]
            self.waiting.clear()


def overflown(wire: bytes) -> bytes:
    """Return a data value whose status says that neighbouring ones were left out."""
    at = len(wire) - 20
    (status,) = struct.unpack_from("<I", wire, at)
    return wire[:at] + struct.pack("<I", status | OVERFLOW) + wire[at + 4 :]


def data_filter(item: Item, requested: Any) -> int:
    """Set the filter of an item for values; return the status of the request."""
    codes = ua.StatusCodes
    if requested is None or is_null(requested):
        item.trigger, item.deadband = _STATUS_VALUE, 0.0
        return 0
    if not isinstance(requested, ua.uaprotocol_auto.DataChangeFilter):
        return int(codes.BadMonitoredItemFilterUnsupported)
    deadband = float(requested.DeadbandValue)
    kind = int(requested.DeadbandType)
    if kind:
        numeric = item.live is not None and item.live.kind == ua.VariantType.Double
        if not numeric or item.live is None:
            return int(codes.BadFilterNotAllowed)
        if not 0.0 <= deadband < math.inf:
            return int(codes.BadDeadbandFilterInvalid)
        if kind == _PERCENT:
            if item.live.range is None or deadband > 100.0:
                return int(codes.BadDeadbandFilterInvalid)
            low, high = item.live.range
            deadband *= (high - low) / 100.0
        elif kind != _ABSOLUTE:
            return int(codes.BadDeadbandFilterInvalid)
    item.trigger = int(requested.Trigger)
    item.deadband = deadband if kind else 0.0
    return 0


def is_null(requested: Any) -> bool:
    """Return whether a structure of a request is the null one."""
    return isinstance(requested, ua.ExtensionObject) and bool(requested.TypeId == ua.NodeId())
