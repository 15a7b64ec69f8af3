# SPDX-License-Identifier: MIT
"""The subscriptions of all clients.

In: requests of their sessions. Out: subscriptions, as many as the limits allow.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from typing import Any

from asyncua import ua

from nctakt.base.diagnostics import Language
from nctakt.servers.opcua.clients.monitored_items import MonitoredItems
from nctakt.servers.opcua.clients.subscription import Subscription
from nctakt.servers.opcua.library import Buffer, ServiceError, struct_from_binary
from nctakt.servers.opcua.limits import Limits
from nctakt.servers.opcua.live_space import LiveSpace
from nctakt.servers.shares import greediest


class Subscriptions:
    """The subscriptions of all sessions, by their numbers.

    ``make_room``: ends a session whose connection is gone, and returns whether there was one;
    ``refuse``: logs a refusal for a session.
    """

    def __init__(
        self,
        space: LiveSpace,
        limits: Limits,
        make_room: Callable[[], bool],
        refuse: Callable[[ua.NodeId, str], None],
    ) -> None:
        self.limits = limits
        self.make_room = make_room
        self._refuse = refuse
        self.items = MonitoredItems(space, limits, self._make_room_for_items)
        self.subscriptions: dict[int, Subscription] = {}
        self._unreported: dict[int, Subscription] = {}
        self._number = 0
        self.languages: dict[ua.NodeId, Language] = {}

    def language_of(self, subscription: Subscription) -> Language:
        """Return the language of the client of a subscription."""
        return self.languages.get(subscription.session_id, "en")

    # --- subscriptions --------------------------------------------------------------------------

    async def create_subscription(
        self,
        params: ua.CreateSubscriptionParameters,
        callback: Callable[[bytes, Any], None],
        session_id: ua.NodeId,
        request_callback: Callable[[int], Any],
    ) -> ua.CreateSubscriptionResult:
        """Create a subscription of a session; raises ``ServiceError`` where there are too many."""
        while len(self.subscriptions) >= self.limits.subscriptions:
            counts = Counter(one.session_id for one in self.subscriptions.values())
            if not self.make_room() and not self._take_from(greediest(counts, session_id)):
                break
        own = sum(one.session_id == session_id for one in self.subscriptions.values())
        if (
            len(self.subscriptions) >= self.limits.subscriptions
            or own >= self.limits.subscriptions_per_session
        ):
            raise ServiceError(ua.StatusCodes.BadTooManySubscriptions)
        self._number += 1
        result = ua.CreateSubscriptionResult()
        result.SubscriptionId = self._number
        self._revise(result, params)
        subscription = Subscription(
            self.expire,
            self.limits.unacknowledged,
            result,
            session_id,
            request_callback,
            callback,
            is_publishing=params.PublishingEnabled,
            max_notifications=params.MaxNotificationsPerPublish,
        )
        self.subscriptions[self._number] = subscription
        subscription.start()
        return result

    def _make_room_for_items(self, subscription: Subscription, requested: int) -> bool:
        """Make room for items of a subscription; return whether there was any to be made."""
        counts: Counter[ua.NodeId] = Counter()
        for one in self.subscriptions.values():
            counts[one.session_id] += len(one.items)
        session_id = greediest(counts, subscription.session_id, requested)
        return self.make_room() or self._take_from(session_id)

    def _take_from(self, session_id: ua.NodeId | None) -> bool:
        """End the oldest subscription of a session, notifying it; return whether there is one."""
        found = (one for one in self.subscriptions.values() if one.session_id == session_id)
        oldest = next(found, None)
        if oldest is None:
            return False
        self._refuse(oldest.session_id, "its oldest subscription ends: others have less")
        oldest.status = int(ua.StatusCodes.BadTooManySubscriptions)
        is_reported = oldest.publish()
        self.expire(oldest)
        if not is_reported:
            self._unreported[oldest.data.SubscriptionId] = oldest
            if len(self._unreported) > self.limits.subscriptions:
                del self._unreported[next(iter(self._unreported))]
        return True

    def has_any(self, session_id: ua.NodeId) -> bool:
        """Return whether a session has a subscription, or one whose end it does not know yet."""
        known = (*self.subscriptions.values(), *self._unreported.values())
        return any(one.session_id == session_id for one in known)

    def waiting(self, number: int) -> Subscription | None:
        """Return the subscription that waits for a request; an ended one for the last time."""
        return self.subscriptions.get(number) or self._unreported.pop(number, None)

    def _revise(self, result: Any, params: Any) -> None:
        result.RevisedPublishingInterval = self.limits.interval_ms(
            params.RequestedPublishingInterval
        )
        keep_alive = min(max(1, params.RequestedMaxKeepAliveCount or 10), 5_000)
        result.RevisedMaxKeepAliveCount = keep_alive
        lifetime = min(params.RequestedLifetimeCount or 0, 15_000)
        result.RevisedLifetimeCount = max(3 * keep_alive, lifetime)

    def modify_subscription(
        self, params: ua.ModifySubscriptionParameters
    ) -> ua.ModifySubscriptionResult:
        """Give a subscription other times."""
        subscription = self.get(params.SubscriptionId)
        result = ua.ModifySubscriptionResult()
        self._revise(result, params)
        self._revise(subscription.data, params)
        subscription.max_notifications = params.MaxNotificationsPerPublish
        subscription.restart()
        return result

    def get(self, number: int) -> Subscription:
        """Return a subscription; raises ``ServiceError`` for an unknown one."""
        found = self.subscriptions.get(number)
        if found is None:
            raise ServiceError(ua.StatusCodes.BadSubscriptionIdInvalid)
        return found

    async def delete_subscriptions(self, numbers: Iterable[int]) -> list[ua.StatusCode]:
        """Delete subscriptions with all that they monitor."""
        results = []
        for number in numbers:
            subscription = self.subscriptions.pop(number, None)
            if subscription is None:
                results.append(ua.StatusCode(ua.StatusCodes.BadSubscriptionIdInvalid))
                continue
            self._forget(subscription)
            results.append(ua.StatusCode())
        return results

    def expire_all(self, session_id: ua.NodeId) -> None:
        """Delete the subscriptions of a session that ends."""
        for subscription in list(self.subscriptions.values()):
            if subscription.session_id == session_id:
                self.expire(subscription)
        unreported = self._unreported.items()
        self._unreported = {
            number: one for number, one in unreported if one.session_id != session_id
        }

    def expire(self, subscription: Subscription) -> None:
        """Delete a subscription whose client no longer makes requests."""
        self.subscriptions.pop(subscription.data.SubscriptionId, None)
        self._forget(subscription)

    def _forget(self, subscription: Subscription) -> None:
        subscription.stop()
        for number in list(subscription.items):
            self.items.delete_item(subscription, number)

    def publish(
        self, acknowledgements: Iterable[ua.SubscriptionAcknowledgement], session_id: ua.NodeId
    ) -> list[int]:
        """Forget messages that a client has got; return a status for each."""
        results = []
        for done in acknowledgements:
            subscription = self.subscriptions.get(done.SubscriptionId)
            if subscription is None or subscription.session_id != session_id:
                results.append(int(ua.StatusCodes.BadSubscriptionIdInvalid))
            elif subscription.unacknowledged.pop(done.SequenceNumber, None) is None:
                results.append(int(ua.StatusCodes.BadSequenceNumberUnknown))
            else:
                results.append(0)
        return results

    def republish(self, params: ua.RepublishParameters) -> ua.NotificationMessage:
        """Return a message once more; raises ``ServiceError`` where it is gone."""
        subscription = self.get(params.SubscriptionId)
        message = subscription.unacknowledged.get(params.RetransmitSequenceNumber)
        if message is None:
            raise ServiceError(ua.StatusCodes.BadMessageNotAvailable)
        return struct_from_binary(ua.NotificationMessage, Buffer(message))

    async def set_publishing_mode(
        self, params: ua.SetPublishingModeParameters
    ) -> list[ua.StatusCode]:
        """Let subscriptions publish, or only say that they are alive."""
        results = []
        for number in params.SubscriptionIds:
            subscription = self.subscriptions.get(number)
            if subscription is None:
                results.append(ua.StatusCode(ua.StatusCodes.BadSubscriptionIdInvalid))
            else:
                subscription.is_publishing = params.PublishingEnabled
                results.append(ua.StatusCode())
        return results

    async def transfer_subscriptions(
        self,
        params: ua.TransferSubscriptionsParameters,
        session_id: ua.NodeId,
        callback: Callable[[bytes, Any], None],
        request_callback: Callable[[int], Any],
    ) -> list[ua.TransferResult]:
        """Hand subscriptions over to another session."""
        results = []
        for number in params.SubscriptionIds:
            result = ua.TransferResult()
            subscription = self.subscriptions.get(number)
            if subscription is None:
                result.StatusCode = ua.StatusCode(ua.StatusCodes.BadSubscriptionIdInvalid)
            else:
                subscription.session_id = session_id
                subscription.pub_result_callback = callback
                subscription.pub_request_callback = request_callback
                result.AvailableSequenceNumbers = list(subscription.unacknowledged)
                if params.SendInitialValues:
                    self._notify_all(subscription)
            results.append(result)
        return results

    @staticmethod
    def _notify_all(subscription: Subscription) -> None:
        for item in subscription.items.values():
            item.last = None

    def stop(self) -> None:
        """Sample and publish no more."""
        for subscription in self.subscriptions.values():
            subscription.stop()
        self.items.stop()
