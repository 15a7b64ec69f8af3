# SPDX-License-Identifier: MIT
"""All that reaches inside the library for OPC UA; nothing else imports its modules.

Its public interface is a server with its own sessions, subscriptions and connections; nctakt
replaces these, for which its classes offer no other method. The names below are those of version
2.1; pyproject.toml limits the library to below 2.2, and ``tests/servers/opcua`` test their
behaviour.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Sequence
from typing import Any

from asyncua import Server
from asyncua.common.utils import Buffer, ServiceError
from asyncua.crypto import cert_gen
from asyncua.crypto.permission_rules import User, UserRole
from asyncua.server.address_space import AddressSpace, AttributeValue, NodeData
from asyncua.server.binary_server_asyncio import BinaryServer, OPCUAProtocol
from asyncua.server.internal_server import InternalServer
from asyncua.server.internal_session import InternalSession
from asyncua.server.uaprocessor import PublishRequestData, UaProcessor
from asyncua.ua import MessageSecurityMode, MessageType
from asyncua.ua.ua_binary import (
    header_from_binary,
    struct_from_binary,
    struct_to_binary,
    variant_to_binary,
)

__all__ = [
    "AddressSpace",
    "AttributeValue",
    "Buffer",
    "InternalSession",
    "LibraryConnection",
    "LibraryInternalServer",
    "LibraryListener",
    "LibraryProcessor",
    "LibraryServer",
    "NodeData",
    "PublishRequestData",
    "ServiceError",
    "User",
    "UserRole",
    "cert_gen",
    "header_from_binary",
    "struct_from_binary",
    "struct_to_binary",
    "variant_to_binary",
]


class LibraryProcessor(UaProcessor):
    """Answers the requests of a connection, each by ``handle``."""

    async def _process_message(self, typeid: Any, header: Any, sequence: Any, body: Any) -> Any:
        return await self.handle(typeid, header, sequence, body)

    async def handle(self, typeid: Any, header: Any, sequence: Any, body: Any) -> Any:
        """Answer a request as the library does; return whether the connection continues."""
        return await super()._process_message(typeid, header, sequence, body)

    @property
    def is_encrypted(self) -> bool:
        """Whether the client's messages come signed and encrypted.

        The library takes those without security at any server, before a channel is open, too.
        """
        return bool(self._connection.security_policy.Mode == MessageSecurityMode.SignAndEncrypt)

    @property
    def peer_certificate(self) -> bytes:
        """The certificate that the client's channel is encrypted with."""
        return bytes(self._connection.security_policy.peer_certificate or b"")

    @property
    def publish_requests(self) -> deque[PublishRequestData]:
        """The publish requests that wait for something to report, the oldest first."""
        requests: deque[PublishRequestData] = self._publish_requests
        return requests

    @property
    def waiting_results(self) -> dict[int, Any]:
        """The numbers of subscriptions that wait for a publish request, in their order."""
        waiting: dict[int, Any] = self._publish_results_subs
        return waiting

    def evict_publish_request(self) -> None:
        """Answer the oldest publish request, or one whose time is over, with a fault."""
        self._evict_publish_request()

    def send_body(self, body: bytes, request: PublishRequestData) -> None:
        """Answer a request with an encoded message."""
        data = self._connection.message_to_binary(
            body, message_type=MessageType.SecureMessage, request_id=request.seqhdr.RequestId
        )
        self._transport.write(data)


class LibraryConnection(OPCUAProtocol):
    """One connection, whose messages ``process`` takes in turn."""

    async def _process_one_msg(self, header: Any, buf: Any) -> bool:
        return await self.process(header, buf)

    async def process(self, header: Any, message: Any) -> bool:
        """Take a message as the library does; return whether the connection continues."""
        return bool(await super()._process_one_msg(header, message))


class LibraryListener(BinaryServer):
    """Takes connections, each made by ``make_protocol``."""

    def make_protocol(self, policies: Sequence[Any]) -> LibraryConnection:
        """Return the protocol of a new connection."""
        raise NotImplementedError

    async def bind(self) -> asyncio.Server:
        """Take the address, but no connection yet; raises ``OSError``."""
        loop = asyncio.get_running_loop()
        self._server = await loop.create_server(
            lambda: self.make_protocol(self._policies),
            self.hostname,
            self.port,
            start_serving=False,
        )
        self.cleanup_task = loop.create_task(self._close_task_loop())
        return self._server


class LibraryInternalServer(InternalServer):
    """Sessions and their services."""

    @property
    def client_sessions(self) -> list[Any]:
        """The sessions of clients, whether or not these are connected."""
        return list(self._external_sessions.values())


class LibraryServer(Server):
    """A server at one address."""

    def set_application_uri_quietly(self, uri: str) -> None:
        """Name the application, before there is an address space that has the name, too."""
        self._application_uri = uri

    async def begin(self, listener: LibraryListener, bound: asyncio.Server) -> None:
        """Let a listener, which has its address, take connections."""
        await self._setup_server_nodes()
        await self.iserver.start()
        listener.set_policies(self._policies)
        self.bserver = listener
        await bound.start_serving()
