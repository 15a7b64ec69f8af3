# SPDX-License-Identifier: MIT
"""The monitored items of all subscriptions, sampled at their paces.

In: requests of clients, moments of the session. Out: samples that wait in the items. Only monitored
values are requested from the session, once for all clients.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from typing import Any

from asyncua import ua

from nctakt.servers.opcua.clients.monitoring import Item, data_filter
from nctakt.servers.opcua.clients.subscription import Subscription
from nctakt.servers.opcua.limits import Limits
from nctakt.servers.opcua.live_space import LiveSpace
from nctakt.servers.opcua.values import ValueSnapshot

_DISABLED = ua.MonitoringMode.Disabled


class MonitoredItems:
    """The items of all subscriptions; ``count``: how many there are.

    ``make_room``: makes some for a number of items of a subscription, and returns whether it could.
    """

    def __init__(
        self,
        space: LiveSpace,
        limits: Limits,
        make_room: Callable[[Subscription, int], bool],
    ) -> None:
        self._space = space
        self._make_room = make_room
        self._limits = limits
        self._item_number = 0
        self._paces: dict[float, Pace] = {}
        self.count = 0

    async def create(
        self, subscription: Subscription, params: ua.CreateMonitoredItemsParameters
    ) -> list[ua.MonitoredItemCreateResult]:
        """Monitor values and events from now on."""
        requested = len(params.ItemsToCreate)
        while self.count + requested > self._limits.items:
            if not self._make_room(subscription, requested):
                break
        pairs = [self._create_item(subscription, request) for request in params.ItemsToCreate]
        items = [item for item, _ in pairs if item is not None]
        lives = [item.live for item in items if item.live is not None]
        moment = await self._space.watch(lives)
        for item in items:
            if item.mode != _DISABLED:
                self._look(item, moment)
        return [result for _, result in pairs]

    def _create_item(
        self, subscription: Subscription, request: ua.MonitoredItemCreateRequest
    ) -> tuple[Item | None, ua.MonitoredItemCreateResult]:
        result = ua.MonitoredItemCreateResult()
        node, attribute = request.ItemToMonitor.NodeId, int(request.ItemToMonitor.AttributeId)
        parameters = request.RequestedParameters
        status = self._space.check_attribute(node, attribute)
        if (
            len(subscription.items) >= self._limits.items_per_subscription
            or self.count >= self._limits.items
        ):
            status = int(ua.StatusCodes.BadTooManyMonitoredItems)
        if status == 0 and request.ItemToMonitor.IndexRange:
            status = int(ua.StatusCodes.BadIndexRangeInvalid)
        if status == 0:
            is_value = attribute == ua.AttributeIds.Value
            item = Item(
                self._item_number + 1,
                parameters.ClientHandle,
                node,
                attribute,
                int(request.MonitoringMode),
                self._queue_size(parameters.QueueSize),
                bool(parameters.DiscardOldest),
                self._sampling_ms(subscription, parameters.SamplingInterval),
                live=self._space.live.get(node) if is_value else None,
            )
            status = self._set_filter(item, parameters.Filter)
        if status:
            result.StatusCode = ua.StatusCode(status)
            return None, result
        self._item_number += 1
        self.count += 1
        subscription.items[item.id] = item
        if not item.is_event:
            self._pace(item.interval_ms).items[item.id] = item
        result.MonitoredItemId = item.id
        result.RevisedSamplingInterval = item.interval_ms
        result.RevisedQueueSize = item.queue_size
        return item, result

    def _set_filter(self, item: Item, request: Any) -> int:
        if item.attribute == ua.AttributeIds.EventNotifier:
            if not isinstance(request, ua.EventFilter) or not request.SelectClauses:
                return int(ua.StatusCodes.BadEventFilterInvalid)
            item.event_filter = request
            return 0
        return data_filter(item, request)

    def _queue_size(self, request: int) -> int:
        return min(max(1, request), self._limits.queue_size)

    def _sampling_ms(self, subscription: Subscription, request: float) -> float:
        """Return the sampling interval: below 0 that of publishing, 0 the shortest."""
        if request == 0.0:
            return self._limits.min_interval_ms
        if not request > 0.0:
            return float(subscription.data.RevisedPublishingInterval)
        return self._limits.interval_ms(request)

    def _pace(self, interval_ms: float) -> Pace:
        pace = self._paces.get(interval_ms)
        if pace is None:
            pace = self._paces[interval_ms] = Pace(self, interval_ms / 1000.0)
        return pace

    async def look_at(self, items: Sequence[Item]) -> None:
        """Take samples of items, all of the same moment."""
        lives = [item.live for item in items if item.live is not None]
        moment = await self._space.refresh(lives)
        for item in items:
            if item.mode != _DISABLED:
                self._look(item, moment)

    def _look(self, item: Item, moment: ValueSnapshot) -> None:
        if item.is_event:
            return
        if item.live is None:
            item.look(self._space.fixed_sample(item.node, item.attribute))
        else:
            item.look(self._space.sample(item.live, moment))

    def modify(
        self, subscription: Subscription, params: ua.ModifyMonitoredItemsParameters
    ) -> list[ua.MonitoredItemModifyResult]:
        """Give items other paces, queues and filters."""
        results = []
        for request in params.ItemsToModify:
            result = ua.MonitoredItemModifyResult()
            item = subscription.items.get(request.MonitoredItemId)
            parameters = request.RequestedParameters
            if item is None:
                result.StatusCode = ua.StatusCode(ua.StatusCodes.BadMonitoredItemIdInvalid)
                results.append(result)
                continue
            status = self._set_filter(item, parameters.Filter)
            if status:
                result.StatusCode = ua.StatusCode(status)
                results.append(result)
                continue
            item.handle = parameters.ClientHandle
            item.queue_size = self._queue_size(parameters.QueueSize)
            item.discards_oldest = bool(parameters.DiscardOldest)
            self._leave_pace(item)
            item.interval_ms = self._sampling_ms(subscription, parameters.SamplingInterval)
            if not item.is_event:
                self._pace(item.interval_ms).items[item.id] = item
            result.RevisedSamplingInterval = item.interval_ms
            result.RevisedQueueSize = item.queue_size
            results.append(result)
        return results

    def set_mode(
        self, subscription: Subscription, params: ua.SetMonitoringModeParameters
    ) -> list[ua.StatusCode]:
        """Let items be sampled and reported, only sampled, or neither."""
        results = []
        for number in params.MonitoredItemIds:
            item = subscription.items.get(number)
            if item is None:
                results.append(ua.StatusCode(ua.StatusCodes.BadMonitoredItemIdInvalid))
                continue
            item.mode = int(params.MonitoringMode)
            if item.mode == _DISABLED:
                item.waiting.clear()
                item.last = None
            results.append(ua.StatusCode())
        return results

    def delete(
        self, subscription: Subscription, params: ua.DeleteMonitoredItemsParameters
    ) -> list[ua.StatusCode]:
        """Monitor items no more."""
        return [
            ua.StatusCode()
            if self.delete_item(subscription, number)
            else ua.StatusCode(ua.StatusCodes.BadMonitoredItemIdInvalid)
            for number in params.MonitoredItemIds
        ]

    def delete_item(self, subscription: Subscription, number: int) -> bool:
        item = subscription.items.pop(number, None)
        if item is None:
            return False
        self.count -= 1
        self._leave_pace(item)
        if item.live is not None:
            self._space.unwatch(item.live)
        return True

    def _leave_pace(self, item: Item) -> None:
        pace = self._paces.get(item.interval_ms)
        if pace is not None and pace.items.pop(item.id, None) is not None and not pace.items:
            pace.stop()
            del self._paces[item.interval_ms]

    def report(self, error: Exception) -> None:
        """Log an error in sampling items."""
        self._space.report(error)

    def stop(self) -> None:
        """Sample no more."""
        for pace in self._paces.values():
            pace.stop()
        self._paces.clear()


class Pace:
    """The items that are sampled at one interval."""

    def __init__(self, service: MonitoredItems, interval_s: float) -> None:
        self.items: dict[int, Item] = {}
        self._service = service
        self._interval_s = interval_s
        self._task = asyncio.get_running_loop().create_task(self._run())

    async def _run(self) -> None:
        loop = asyncio.get_running_loop()
        due_s = loop.time()
        while True:
            due_s = max(due_s + self._interval_s, loop.time() - self._interval_s)
            await asyncio.sleep(due_s - loop.time())
            try:
                await self._service.look_at(list(self.items.values()))
            except Exception as error:  # noqa: BLE001 - the items of the other clients go on
                self._service.report(error)

    def stop(self) -> None:
        self._task.cancel()
