# SPDX-License-Identifier: MIT
"""The connections of clients: bounded in what they may send at once and leave unread.

In: bytes of clients. Out: requests to their session, responses. A client that breaks a limit is
disconnected, and that is logged; others do not notice.
"""

from __future__ import annotations

import asyncio
import struct
from collections.abc import Sequence
from typing import Any

from asyncua import ua

from nctakt.servers.address import shown_address
from nctakt.servers.connections import Deadline, watch
from nctakt.servers.log import ServerLog
from nctakt.servers.opcua.clients.certificates import ANOTHER_CERTIFICATE, refusal_of
from nctakt.servers.opcua.library import (
    Buffer,
    LibraryConnection,
    LibraryListener,
    LibraryProcessor,
    PublishRequestData,
    ServiceError,
    header_from_binary,
    struct_from_binary,
)
from nctakt.servers.opcua.limits import Limits

_PUBLISH = ua.NodeId(ua.ObjectIds.PublishRequest_Encoding_DefaultBinary)
_TRANSFER = ua.NodeId(ua.ObjectIds.TransferSubscriptionsRequest_Encoding_DefaultBinary)
_ACTIVATE = ua.NodeId(ua.ObjectIds.ActivateSessionRequest_Encoding_DefaultBinary)
_CREATE = ua.NodeId(ua.ObjectIds.CreateSessionRequest_Encoding_DefaultBinary)
_REGISTER = (
    ua.NodeId(ua.ObjectIds.RegisterServerRequest_Encoding_DefaultBinary),
    ua.NodeId(ua.ObjectIds.RegisterServer2Request_Encoding_DefaultBinary),
)

#: Requests that a client may make without security: how to get it.
_DISCOVERY = (
    ua.NodeId(ua.ObjectIds.GetEndpointsRequest_Encoding_DefaultBinary),
    ua.NodeId(ua.ObjectIds.FindServersRequest_Encoding_DefaultBinary),
    ua.NodeId(ua.ObjectIds.CloseSecureChannelRequest_Encoding_DefaultBinary),
)

#: The length of the header of a chunk, in bytes: three letters, one, and the length of it all.
_HEADER = 8


class Processor(LibraryProcessor):
    """Answers the requests of one connection."""

    def __init__(
        self,
        server: Any,
        transport: Any,
        limits: Any,
        own: Limits,
        client: str,
        log: ServerLog,
    ) -> None:
        super().__init__(server, transport, limits)
        self._own = own
        self._log = log
        self.client = client

    async def handle(self, typeid: ua.NodeId, header: Any, sequence: Any, body: Any) -> Any:
        """Answer a request; return whether the connection continues."""
        if typeid in _REGISTER:
            raise ServiceError(ua.StatusCodes.BadServiceUnsupported)
        self._check_security(typeid, body)
        if typeid not in (_PUBLISH, _TRANSFER) or self.session is None:
            done = await super().handle(typeid, header, sequence, body)
            if self.session is not None:
                self.session.join(self, self.client)
            return done
        if not self.session.is_activated():
            raise ServiceError(ua.StatusCodes.BadSessionNotActivated)
        self.session_last_activity = asyncio.get_running_loop().time()
        self.session.touch()
        if typeid == _TRANSFER:
            params = struct_from_binary(ua.TransferSubscriptionsParameters, body)
            response = ua.TransferSubscriptionsResponse()
            response.Parameters.Results = await self.session.transfer(
                params, self.forward_publish_response, self.get_publish_request
            )
            self.send_response(header.RequestHandle, sequence, response)
            return True
        params = struct_from_binary(ua.PublishParameters, body)
        results = self.session.acknowledge(params.SubscriptionAcknowledgements)
        self._take_request(PublishRequestData(header, sequence, results))
        return True

    def _check_security(self, typeid: ua.NodeId, body: Any) -> None:
        """Raise ``ServiceError`` for a request that this client may not send in this manner."""
        security = self.iserver.security
        if security is None or typeid in _DISCOVERY:
            return
        if not self.is_encrypted:
            self._refuse("its messages are not encrypted")
            raise ServiceError(ua.StatusCodes.BadSecurityModeInsufficient)
        if typeid == _CREATE:
            params = struct_from_binary(ua.CreateSessionParameters, body.copy())
            uri = params.ClientDescription.ApplicationUri
            refusal = refusal_of(self.peer_certificate, uri, security.trusted())
            if params.ClientCertificate != self.peer_certificate:
                refusal = ANOTHER_CERTIFICATE
            if refusal is not None:
                self._refuse(refusal.reason)
                raise ServiceError(refusal.status)

    def _refuse(self, reason: str) -> None:
        self._log.refuse("opcua", self.client.rpartition(":")[0], reason)

    def _take_request(self, request: PublishRequestData) -> None:
        """Answer a publish request at once if something waits for it; else keep it."""
        service = self.iserver.subscription_service
        waiting = self.waiting_results
        while waiting:
            number = next(iter(waiting))
            del waiting[number]
            subscription = service.waiting(number)
            if subscription is not None and subscription.publish(request):
                return
        if len(self.publish_requests) >= self._own.publish_requests:
            self.evict_publish_request()
        self.publish_requests.append(request)

    def forward_publish_response(self, body: bytes, request: PublishRequestData) -> None:
        """Answer a publish request with an encoded message."""
        self.send_body(body, request)

    def send_response(
        self, requesthandle: int, seqhdr: Any, response: Any, msgtype: Any = None
    ) -> None:
        """Answer a request; a client that reads nothing for too long is disconnected."""
        super().send_response(
            requesthandle, seqhdr, response, msgtype or ua.MessageType.SecureMessage
        )


class Connection(LibraryConnection):
    """One connection; ``client``: its address as logged."""

    def __init__(self, own: Limits, log: ServerLog, **words: Any) -> None:
        super().__init__(**words)
        self._own = own
        self._log = log
        self.client = ""
        self._received = bytearray()
        self._begun_s = 0.0
        self._deadline: Deadline | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Take a connection, unless there are too many."""
        peer = transport.get_extra_info("peername") or ("", 0)
        self.client = shown_address(str(peer[0]), peer[1])
        if len(self.clients) >= self._own.connections and not self._make_room():
            self._log.refuse("opcua", peer[0], f"more than {self._own.connections} connections")
            transport.close()
            return
        super().connection_made(transport)
        watch(transport)
        loop = asyncio.get_running_loop()
        self._begun_s = loop.time()
        self._deadline = Deadline(loop, _HEADER, self._break)
        self.processor = Processor(
            self.iserver, self.transport, self.limits, self._own, self.client, self._log
        )
        self.processor.set_policies(self.policies)

    @property
    def is_waiting(self) -> bool:
        """Whether it has no session any more, although it had time to open one."""
        session = None if self.processor is None else self.processor.session
        age_s = asyncio.get_running_loop().time() - self._begun_s
        return age_s > self._own.activation_s and (session is None or not session.is_activated())

    def _make_room(self) -> bool:
        """End the oldest connection without a session; return whether there was one."""
        oldest = next((one for one in self.clients if one.is_waiting), None)
        if oldest is None:
            return False
        oldest._break("it has no session, and its place was needed")
        self.clients.remove(oldest)
        return True

    def connection_lost(self, ex: BaseException | None) -> None:
        """Forget a connection."""
        if self._deadline is not None:
            self._deadline.stop()
        if self.transport is not None:
            if self.processor is not None and self.processor.session is not None:
                self.processor.session.leave(self.processor)
            super().connection_lost(ex)

    def data_received(self, data: bytes) -> None:
        """Take bytes; whole messages go to the processor."""
        if self.transport is None or self.transport.is_closing():
            return
        if self.transport.get_write_buffer_size() > self._own.unsent_bytes:
            self._break("it does not read its responses")
            return
        self._received += data
        count = 0
        while len(self._received) >= _HEADER:
            kind, _, size = struct.unpack_from("<3scI", self._received)
            if kind not in (b"HEL", b"OPN", b"MSG", b"CLO", b"ERR"):
                self._break("its messages are none of OPC UA")
                return
            if not _HEADER <= size <= self._own.message_bytes:
                self._break(f"a message of {size} bytes")
                return
            if len(self._received) < size:
                break
            whole = bytes(self._received[:size])
            del self._received[:size]
            if not self._queue(whole):
                return
            count += 1
        if self._deadline is not None:
            self._deadline.look(len(self._received), is_new=count > 0)

    def _queue(self, whole: bytes) -> bool:
        buffer = Buffer(whole)
        try:
            self.messages.put_nowait((header_from_binary(buffer), buffer))
        except asyncio.QueueFull:
            self._break("too many requests wait")
            return False
        except Exception:  # noqa: BLE001 - the library reads what a client has sent
            self._break("its messages are none of OPC UA")
            return False
        return True

    async def process(self, header: Any, message: Any) -> bool:
        """Take a message; an unreadable one ends the connection."""
        try:
            return await super().process(header, message)
        except Exception as error:  # noqa: BLE001 - whatever the library does not expect of a client
            self._break(f"its message cannot be read ({type(error).__name__})")
            return False

    def _break(self, reason: str) -> None:
        self._log.refuse("opcua", self.client.rpartition(":")[0], reason)
        if self.transport is not None:
            self.transport.abort()


class Listener(LibraryListener):
    """Takes connections."""

    def __init__(self, own: Limits, log: ServerLog, **words: Any) -> None:
        super().__init__(**words)
        self._own = own
        self._log = log

    def make_protocol(self, policies: Sequence[Any]) -> Connection:
        """Return the protocol of a new connection."""
        return Connection(
            self._own,
            self._log,
            iserver=self.iserver,
            policies=policies,
            clients=self.clients,
            closing_tasks=self.closing_tasks,
            limits=self.limits,
        )
