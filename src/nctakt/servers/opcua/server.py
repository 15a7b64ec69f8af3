# SPDX-License-Identifier: MIT
"""The library's server with nctakt's services: sessions, subscriptions, connections.

In: the services of a machine, an address. Out: a server that listens there.
"""

from __future__ import annotations

import asyncio
import logging
from typing import Any

from asyncua import ua

from nctakt.base.version import __version__
from nctakt.servers.log import ServerLog
from nctakt.servers.opcua.clients.connection import Listener
from nctakt.servers.opcua.clients.security import (
    ANONYMOUS,
    NAMED,
    Anybody,
    Security,
    application_uri,
)
from nctakt.servers.opcua.clients.sessions import ENDPOINT, ClientSession
from nctakt.servers.opcua.library import LibraryInternalServer, LibraryServer, ServiceError
from nctakt.servers.opcua.limits import Limits
from nctakt.servers.opcua.machine_services import MachineServices

#: The name that clients see.
_NAME = "nctakt"

# Reports of the library about clients go to nctakt's log, at a limited rate.
logging.getLogger("asyncua").setLevel(logging.CRITICAL + 1)


class CncInternalServer(LibraryInternalServer):
    """Makes our sessions; ``services``: set before the first client comes.

    ``security``: ``None`` on this computer, where anybody may come in. ``asking``: the address of
    the client whose password is being checked.
    """

    def __init__(self, limits: Limits, security: Security | None) -> None:
        super().__init__(Anybody() if security is None else security)
        self.limits = limits
        self.security = security
        self.services: MachineServices | None = None
        self.asking = ""
        self._ending: set[asyncio.Task[None]] = set()
        self.max_connections = limits.connections
        self.max_pending_activation_seconds = limits.activation_s
        self.allow_remote_admin = False

    def create_session(self, name: Any, user: Any = None, external: bool = False) -> ClientSession:
        """Return a new session of a client; raises ``ServiceError`` where there are too many."""
        assert self.services is not None
        if external and len(self.client_sessions) >= self.limits.sessions and not self.make_room():
            raise ServiceError(ua.StatusCodes.BadTooManySessions)
        session = ClientSession(
            self.services, self, self.aspace, self.subscription_service, name, external=external
        )
        session.client = f"{name[0]}:{name[1]}" if isinstance(name, tuple) else str(name)
        return session

    def refuse(self, session_id: ua.NodeId, reason: str) -> None:
        """Log a refusal for a session."""
        assert self.services is not None
        for one in self.client_sessions:
            if one.session_id == session_id:
                self.services.host.log.refuse(ENDPOINT, one.client, reason)

    def make_room(self) -> bool:
        """End an unused session; return whether there was any."""
        assert self.services is not None
        found = self._unused()
        if found is None:
            return False
        unused, reason = found
        self.services.host.log.refuse(
            ENDPOINT, unused.client, f"{reason}, and its place was needed"
        )
        self.unregister_external_session(unused)
        self.subscription_service.expire_all(unused.session_id)
        task = asyncio.get_running_loop().create_task(unused.close_session(False))
        self._ending.add(task)
        task.add_done_callback(self._ending.discard)
        return True

    def _unused(self) -> tuple[ClientSession, str] | None:
        """Return a session that may go, and why.

        First the one that lost its connection first, then the oldest that no user has entered,
        then the one whose client has been silent longest.
        """
        now_s = asyncio.get_running_loop().time()
        left = [one for one in self.client_sessions if one.left_s is not None]
        if left:
            return min(left, key=lambda one: one.left_s), "its connection is gone"
        empty = [one for one in self.client_sessions if not one.is_activated()]
        oldest = min(empty, key=lambda one: one.begun_s, default=None)
        if oldest is not None and now_s - oldest.begun_s > self.limits.entering_s:
            return oldest, "no user has entered its session"
        silent = min(self.client_sessions, key=lambda one: one.heard_s, default=None)
        if silent is not None and now_s - silent.heard_s > self.limits.silence_s:
            return silent, "its client asks for nothing"
        return None


class CncServer(LibraryServer):
    """A server on one address; ``security``: ``None`` for this computer's own one."""

    def __init__(self, limits: Limits, log: ServerLog, security: Security | None) -> None:
        internal = CncInternalServer(limits, security)
        super().__init__(iserver=internal)
        self._own = limits
        self._log = log
        self.name = _NAME
        self.product_uri = "urn:nctakt:product"
        self.manufacturer_name = _NAME
        self.set_application_uri_quietly(application_uri())
        self.limits.max_message_size = limits.message_bytes
        if security is None:
            self.set_security_policy([ua.SecurityPolicyType.NoSecurity])
            self.set_identity_tokens(ANONYMOUS)
        else:
            internal.certificate, internal.private_key = security.certificate, security.key
            self.set_security_policy([ua.SecurityPolicyType.Basic256Sha256_SignAndEncrypt])
            self.set_identity_tokens(NAMED)

    async def publish_limits(self) -> None:
        """Write the server's description and its limits into the address space."""
        capabilities = "Server_ServerCapabilities_"
        operations = f"{capabilities}OperationLimits_"
        calls = self._own.nodes_per_call
        for name, value, kind in (
            *(
                (f"{operations}{word}", calls, ua.VariantType.UInt32)
                for word in (
                    "MaxNodesPerRead",
                    "MaxNodesPerWrite",
                    "MaxNodesPerMethodCall",
                    "MaxMonitoredItemsPerCall",
                )
            ),
            (
                f"{operations}MaxNodesPerHistoryReadData",
                self._own.history_nodes,
                ua.VariantType.UInt32,
            ),
            (f"{capabilities}LocaleIdArray", ["en", "de"], ua.VariantType.String),
            (f"{capabilities}MinSupportedSampleRate", self._own.min_interval_ms, None),
            (f"{capabilities}MaxSessions", self._own.sessions, ua.VariantType.UInt32),
            (f"{capabilities}MaxSubscriptions", self._own.subscriptions, ua.VariantType.UInt32),
            (f"{capabilities}MaxMonitoredItems", self._own.items, ua.VariantType.UInt32),
            (
                f"{capabilities}MaxSubscriptionsPerSession",
                self._own.subscriptions_per_session,
                ua.VariantType.UInt32,
            ),
            (
                f"{capabilities}MaxMonitoredItemsPerSubscription",
                self._own.items_per_subscription,
                ua.VariantType.UInt32,
            ),
            (
                f"{capabilities}MaxMonitoredItemsQueueSize",
                self._own.queue_size,
                ua.VariantType.UInt32,
            ),
            (
                "HistoryServerCapabilities_AccessHistoryDataCapability",
                True,
                ua.VariantType.Boolean,
            ),
            (
                "HistoryServerCapabilities_MaxReturnDataValues",
                self._own.history_rows,
                ua.VariantType.UInt32,
            ),
        ):
            number = getattr(ua.ObjectIds, name, None)
            node = None if number is None else ua.NodeId(number)
            if node is not None and node in self.iserver.aspace:
                shown = ua.DataValue(ua.Variant(value, kind or ua.VariantType.Double))
                await self.iserver.aspace.write_attribute_value(node, ua.AttributeIds.Value, shown)
        build = self.get_node(ua.NodeId(ua.ObjectIds.Server_ServerStatus_BuildInfo_SoftwareVersion))
        await build.write_value(__version__)

    async def listen(self, host: str, port: int) -> asyncio.Server:
        """Listen at an address; raises ``OSError``."""
        listener = Listener(
            self._own,
            self._log,
            internal_server=self.iserver,
            hostname=host,
            port=port,
            limits=self.limits,
        )
        bound = await listener.bind()
        host, port = bound.sockets[0].getsockname()[:2]
        shown = f"[{host}]" if ":" in host else host
        self.set_endpoint(f"opc.tcp://{shown}:{port}/")
        await self.begin(listener, bound)
        return bound
