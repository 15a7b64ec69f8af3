# SPDX-License-Identifier: MIT
"""The session of a client: its reads, writes, calls and history requests.

In: requests. Out: answers. A write of a client is an input of the controller: it is answered once a
tick has latched it and all can read it, or at once if the session is not playing.
"""

from __future__ import annotations

import asyncio
import secrets
from collections.abc import Callable, Sequence
from typing import Any

from asyncua import ua

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.servers.host import Busy
from nctakt.servers.opcua.clients.subscription import Subscription
from nctakt.servers.opcua.library import InternalSession, ServiceError
from nctakt.servers.opcua.machine_services import MachineServices
from nctakt.servers.opcua.values import Live

#: The endpoint's name in the log and in the sources of inputs.
ENDPOINT = "opcua"


class ClientSession(InternalSession):
    """One session; ``client``: the address of its connection; ``language``: of its texts.

    ``left_s``: when it lost its connection, by the loop's clock; ``None`` while it has one. It
    stays for its client to come back, until its time is over or another client needs its place.
    ``heard_s``: when its client made its last request.
    """

    def __init__(self, services: MachineServices, *words: Any, **keywords: Any) -> None:
        self.services = services
        self.client = ""
        self.left_s: float | None = None
        self.begun_s = asyncio.get_running_loop().time() if keywords.get("external") else 0.0
        self.heard_s = self.begun_s
        self._link: object = None
        self.language: Language = "en"
        super().__init__(*words, **keywords)
        if self.external:
            self.iserver.unregister_external_session(self)
            self.auth_token = ua.NodeId(secrets.token_bytes(32), 0)
            self.iserver.register_external_session(self)

    def join(self, connection: object, client: str) -> None:
        """Belong to a connection from now on, whose client has this address."""
        self._link, self.client, self.left_s = connection, client, None

    def touch(self) -> None:
        """Remember that its client has asked for something."""
        super().touch()
        self.heard_s = asyncio.get_running_loop().time()

    def leave(self, connection: object) -> None:
        """Be without a connection, unless it is another one by now."""
        if self._link is connection:
            self._link, self.left_s = None, asyncio.get_running_loop().time()

    async def create_session(self, params: Any, sockname: Any = None) -> Any:
        """Begin; raises ``ServiceError`` where there are too many sessions."""
        result = await super().create_session(params, sockname)
        result.MaxRequestMessageSize = self.services.limits.message_bytes
        return result

    def activate_session(self, params: Any, peer_certificate: bytes | None) -> Any:
        """Let the user in; the client's first language that is known is that of texts."""
        self.iserver.asking = self.client.rpartition(":")[0]
        result = super().activate_session(params, peer_certificate)
        for locale in params.LocaleIds or ():
            word = str(locale).lower()[:2]
            if word in ("en", "de"):
                self.language = "de" if word == "de" else "en"
                break
        self.subscription_service.languages[self.session_id] = self.language
        return result

    # --- reading --------------------------------------------------------------------------------

    async def read(self, params: ua.ReadParameters) -> list[ua.DataValue]:
        """Return values, those of the session all of the same tick."""
        request = params.NodesToRead or []
        if len(request) > self.services.limits.nodes_per_call:
            raise ServiceError(ua.StatusCodes.BadTooManyOperations)
        space = self.services.space
        lives = [self._live(one) for one in request]
        moment = await space.read([live for live in lives if live is not None])
        return [
            self._attribute(one) if live is None else live.data_value(moment, space.clock)
            for one, live in zip(request, lives, strict=True)
        ]

    def _live(self, one: ua.ReadValueId) -> Live | None:
        if one.AttributeId != ua.AttributeIds.Value or one.IndexRange:
            return None
        return self.services.space.live.get(one.NodeId)

    def _attribute(self, one: ua.ReadValueId) -> ua.DataValue:
        if one.IndexRange:
            return ua.DataValue(StatusCode=ua.StatusCode(ua.StatusCodes.BadIndexRangeInvalid))
        return self.aspace.read_attribute_value(one.NodeId, one.AttributeId)

    # --- writing --------------------------------------------------------------------------------

    async def write(self, params: ua.WriteParameters) -> list[ua.StatusCode]:
        """Write values of the session from the next tick on; nothing else can be written.

        It returns once that tick is over, as far as ``Host.latched`` waits for it.
        """
        request = params.NodesToWrite or []
        if len(request) > self.services.limits.nodes_per_call:
            raise ServiceError(ua.StatusCodes.BadTooManyOperations)
        # all at once, so that they come into one tick
        done = await asyncio.gather(*(self._write_one(one) for one in request))
        ticks = [tick for _, tick in done if tick is not None]
        if ticks:
            await self.services.host.latched(max(ticks))
        return [ua.StatusCode(status) for status, _ in done]

    async def _write_one(self, one: ua.WriteValue) -> tuple[int, int | None]:
        """Write a value; return the status, and the tick from which on it acts."""
        codes = ua.StatusCodes
        live = self.services.space.live.get(one.NodeId)
        if one.NodeId not in self.aspace:
            return self._refused(one, "unknown node", codes.BadNodeIdUnknown)
        if live is None or one.AttributeId != ua.AttributeIds.Value or not live.write_name:
            return self._refused(one, "not writable", codes.BadNotWritable)
        if one.IndexRange:
            return self._refused(one, "an index range", codes.BadWriteNotSupported)
        variant = one.Value.Value
        if (
            variant is None
            or variant.VariantType != live.kind
            or variant.is_array != live.is_array
            or variant.Value is None
        ):
            return self._refused(one, "wrong type", codes.BadTypeMismatch)
        value = variant.Value if live.to_session is None else live.to_session(variant.Value)
        try:
            return 0, await self.services.host.write(
                {live.write_name: value}, ENDPOINT, self.client
            )
        except Failure:
            return int(codes.BadOutOfRange), None
        except Busy:
            return int(codes.BadTooManyOperations), None

    def _refused(self, one: ua.WriteValue, reason: str, status: int) -> tuple[int, None]:
        self.services.host.log.refuse(ENDPOINT, self.client, f"write to {one.NodeId}: {reason}")
        return int(status), None

    # --- methods and the past -------------------------------------------------------------------

    async def call(self, params: list[ua.CallMethodRequest]) -> list[ua.CallMethodResult]:
        """Call methods."""
        if len(params or ()) > self.services.limits.nodes_per_call:
            raise ServiceError(ua.StatusCodes.BadTooManyOperations)
        return [await self.services.methods.call(self, one) for one in params or ()]

    async def history_read(self, params: ua.HistoryReadParameters) -> list[ua.HistoryReadResult]:
        """Return the past of values."""
        return await self.services.history.read(params)

    async def history_update(self, params: Any) -> list[Any]:
        """Refuse: the past cannot be written."""
        raise ServiceError(ua.StatusCodes.BadServiceUnsupported)

    async def browse_next(self, parameters: Any) -> list[Any]:
        """Refuse: each answer of Browse is complete."""
        results = []
        for _ in parameters.ContinuationPoints or ():
            result = ua.BrowseResult()
            result.StatusCode = ua.StatusCode(ua.StatusCodes.BadContinuationPointInvalid)
            results.append(result)
        return results

    async def add_nodes(self, params: Any) -> list[Any]:
        """Refuse: clients add nothing."""
        raise ServiceError(ua.StatusCodes.BadServiceUnsupported)

    async def delete_nodes(self, params: Any) -> list[Any]:
        """Refuse: clients delete nothing."""
        raise ServiceError(ua.StatusCodes.BadServiceUnsupported)

    async def add_references(self, params: Any) -> list[Any]:
        """Refuse: clients add nothing."""
        raise ServiceError(ua.StatusCodes.BadServiceUnsupported)

    async def delete_references(self, params: Any) -> list[Any]:
        """Refuse: clients delete nothing."""
        raise ServiceError(ua.StatusCodes.BadServiceUnsupported)

    # --- subscriptions --------------------------------------------------------------------------

    def acknowledge(self, done: Sequence[Any]) -> list[int]:
        """Forget messages that the client has got; raises ``ServiceError`` without any."""
        service = self.subscription_service
        if not service.has_any(self.session_id):
            raise ServiceError(ua.StatusCodes.BadNoSubscription)
        return list(service.publish(done or (), self.session_id))

    async def transfer(
        self,
        params: Any,
        result_callback: Callable[..., Any],
        request_callback: Callable[..., Any],
    ) -> list[Any]:
        """Take subscriptions over from another session."""
        return list(
            await self.subscription_service.transfer_subscriptions(
                params, self.session_id, result_callback, request_callback
            )
        )

    def _own(self, number: int) -> Subscription:
        """Return a subscription of this session; raises ``ServiceError`` for another one."""
        found: Subscription = self.subscription_service.get(number)
        if found.session_id != self.session_id:
            raise ServiceError(ua.StatusCodes.BadSubscriptionIdInvalid)
        return found

    async def delete_subscriptions(self, ids: list[int]) -> list[ua.StatusCode]:
        """Delete subscriptions of this session."""
        service, results = self.subscription_service, []
        for number in ids:
            known = service.subscriptions.get(number)
            is_own = known is not None and known.session_id == self.session_id
            results += await service.delete_subscriptions([number if is_own else -1])
        return results

    def modify_subscription(self, params: Any) -> Any:
        """Give a subscription other times."""
        self._own(params.SubscriptionId)
        return self.subscription_service.modify_subscription(params)

    def republish(self, params: Any) -> Any:
        """Return a message once more."""
        self._own(params.SubscriptionId)
        return self.subscription_service.republish(params)

    async def create_monitored_items(self, params: Any) -> list[Any]:
        """Monitor values and events."""
        items = self.subscription_service.items
        return list(await items.create(self._own(params.SubscriptionId), params))

    async def modify_monitored_items(self, params: Any) -> list[Any]:
        """Give items other paces, queues and filters."""
        items = self.subscription_service.items
        return list(items.modify(self._own(params.SubscriptionId), params))

    async def set_monitoring_mode(self, params: Any) -> list[Any]:
        """Let items be sampled and reported, only sampled, or neither."""
        items = self.subscription_service.items
        return list(items.set_mode(self._own(params.SubscriptionId), params))

    async def delete_monitored_items(self, params: Any) -> list[Any]:
        """Monitor items no more."""
        items = self.subscription_service.items
        return list(items.delete(self._own(params.SubscriptionId), params))

    async def close_session(self, delete_subs: bool = True) -> None:
        """End; its subscriptions with it, unless others shall take them over."""
        await super().close_session(delete_subs)
        self.subscription_service.languages.pop(self.session_id, None)
