# SPDX-License-Identifier: MIT
"""The ADS server: connections, their limits, their end (AD-1, AD-6).

In: bytes of connections. Out: answers and notifications. A connection holds many clients and many
requests in flight; each answer carries the number of its request. A client that sends anything but
frames, or does not read its answers, is disconnected, and that is logged.
"""

from __future__ import annotations

import asyncio
import contextlib
import socket
from collections.abc import Collection
from typing import cast

from nctakt.base.failure import Failure, error_text
from nctakt.servers.address import Network, is_within, listen_at, shown_address
from nctakt.servers.ads.access import ENDPOINT
from nctakt.servers.ads.clients import Client
from nctakt.servers.ads.codes import TCP_PORT, AdsError, Error
from nctakt.servers.ads.frames import (
    HEADER,
    Frame,
    FrameError,
    FrameReader,
    read_net_id,
    shown_net_id,
)
from nctakt.servers.ads.limits import (
    IDLE_S,
    MAX_CLIENTS,
    MAX_CONNECTIONS,
    MAX_IN_FLIGHT,
    MAX_UNREAD,
    MAX_UNREAD_ANSWERS,
)
from nctakt.servers.ads.notifications import Notifier
from nctakt.servers.ads.service import Later, Service
from nctakt.servers.connections import Deadline, watch
from nctakt.servers.host import Host
from nctakt.session.listening import Frame as SessionFrame

PORT = TCP_PORT

#: How often values that were not read meanwhile are released, in seconds.
RELEASE_S = 30.0

#: Where addresses that mean all interfaces of a machine can be reached from itself.
_EVERYWHERE = ("0.0.0.0", "::")


class AdsEndpoint:
    """The server at one address.

    ``net_id``: its own; by default that of its address, as routers make it. ``networks``: where
    clients may connect from, everywhere if it is empty. ``permitted``: NetIds that are served, all
    if it is empty; each client states its own.
    """

    max_connections = MAX_CONNECTIONS

    def __init__(
        self,
        host: Host,
        address: tuple[str, int],
        net_id: bytes | None = None,
        permitted: Collection[bytes] = (),
        networks: Collection[Network] = (),
    ) -> None:
        self.host = host
        self._address = address
        self.net_id = net_id or net_id_of(address[0])
        self.permitted = frozenset(permitted)
        self.networks = tuple(networks)
        self.connections: set[Connection] = set()
        self.tasks: set[asyncio.Task[None]] = set()
        self._server: asyncio.Server | None = None

    async def prepare(self) -> None:
        """Return a text with the reachable items."""
        self.service = Service(self.host, Notifier(self.host.clock))

    async def open(self) -> str:
        """Listen; return address and NetId. Raises ``Failure`` (901351)."""
        host = self.host
        self._end_listening = host.store.listen(self._take_frame)
        self._releasing = host.loop.create_task(self._release())
        loop = host.loop
        self._server, shown = await listen_at(
            "ADS",
            self._address,
            lambda name, port: loop.create_server(lambda: Connection(self), name, port),
        )
        return f"{shown}/{shown_net_id(self.net_id)}"

    def make_room(self) -> bool:
        """End the connection that has been idle longest; return whether there was one.

        Those that get notifications, or have asked lately, stay.
        """
        latest_s = self.host.loop.time() - IDLE_S
        idle = [one for one in self.connections if one.is_idle and one.asked_s < latest_s]
        if not idle:
            return False
        min(idle, key=lambda one: one.asked_s).end("its place was needed")
        return True

    def _take_frame(self, frame: SessionFrame) -> None:
        self.service.notifier.receive(frame.values, frame.tick)

    async def _release(self) -> None:
        """Release values that are no longer read."""
        while True:
            await asyncio.sleep(RELEASE_S)
            with contextlib.suppress(Failure):  # the session has ended
                await self.service.access.release()

    async def close(self) -> None:
        """Disconnect all clients."""
        if self._server is None:
            return
        self._server.close()
        self._releasing.cancel()
        self._end_listening()
        for connection in tuple(self.connections):
            connection.end("closing")
        if self.tasks:
            await asyncio.wait(self.tasks, timeout=1.0)
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(self._server.wait_closed(), 1.0)


def net_id_of(host: str) -> bytes:
    """Return the NetId that belongs to an address: ``192.168.0.7`` gives 192.168.0.7.1.1."""
    if host in _EVERYWHERE:
        with contextlib.suppress(OSError):
            host = socket.gethostbyname(socket.gethostname())
    return read_net_id(f"{host}.1.1") or bytes((127, 0, 0, 1, 1, 1))


class Connection(asyncio.Protocol):
    """One connection with its clients; ``asked_s``: when its last frame came, by the loop."""

    def __init__(self, endpoint: AdsEndpoint) -> None:
        self._endpoint = endpoint
        self._service = endpoint.service
        self._log = endpoint.host.log
        self._reader = FrameReader()
        self._clients: dict[tuple[bytes, int], Client] = {}
        self._tasks: set[asyncio.Task[None]] = set()
        self._is_reading = True
        self._can_take = True
        self.asked_s = 0.0
        self._deadline: Deadline | None = None
        self._transport: asyncio.Transport | None = None
        self.peer = self._address = ""

    # --- the connection -------------------------------------------------------------------------

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Begin; a connection from elsewhere or beyond the limit ends at once."""
        self._transport = cast("asyncio.Transport", transport)
        address = transport.get_extra_info("peername") or ("", 0)
        self._address = str(address[0])
        self.peer = shown_address(str(address[0]), address[1])
        networks, reason = self._endpoint.networks, ""
        if networks and not is_within(self._address, networks):
            reason = "the address is not one of --ads-from"
        elif len(self._endpoint.connections) >= MAX_CONNECTIONS and not self._endpoint.make_room():
            reason = "too many connections"
        if reason:
            self._log.refuse(ENDPOINT, self._address, reason)
            self._transport.abort()
            self._transport = None
            return
        self._endpoint.connections.add(self)
        self._transport.set_write_buffer_limits(MAX_UNREAD_ANSWERS)
        watch(transport)
        self.asked_s = self._endpoint.host.loop.time()
        self._deadline = Deadline(self._endpoint.host.loop, HEADER.size, self._end_late)
        self._log.visit("connected", ENDPOINT, self._address, peer=self.peer)

    def connection_lost(self, exc: Exception | None) -> None:
        """End: handles and notifications end with it; a write that is whole is still done."""
        self._forget()
        if self._transport is not None:
            self._transport = None
            self._log.visit("disconnected", ENDPOINT, self._address, peer=self.peer)

    @property
    def is_idle(self) -> bool:
        """Whether it waits for nothing: no answer, no notification."""
        return not self._tasks and not any(one.notifications for one in self._clients.values())

    @property
    def handle_count(self) -> int:
        """The handles of all its clients."""
        return sum(len(one.handles) for one in self._clients.values())

    def _end_late(self, reason: str) -> None:
        self._log.refuse(ENDPOINT, self._address, reason)
        self.end(reason)

    def _forget(self) -> None:
        if self._deadline is not None:
            self._deadline.stop()
        for client in self._clients.values():
            self._service.forget(client)
        self._clients.clear()
        self._endpoint.connections.discard(self)

    def end(self, reason: str) -> None:
        """Disconnect; ``reason`` for the log."""
        transport, self._transport = self._transport, None
        self._forget()
        if transport is not None:
            self._log.visit("disconnected", ENDPOINT, self._address, peer=self.peer, reason=reason)
            transport.close()
            if transport.get_write_buffer_size():
                transport.abort()

    # --- requests -------------------------------------------------------------------------------

    def data_received(self, data: bytes) -> None:
        """Answer all requests that are whole with these bytes, unless the connection has ended."""
        if self._transport is None:
            return
        answers: list[bytes] = []
        begins: list[Client] = []
        is_new = False
        try:
            for frame in self._reader.feed(data):
                is_new = True
                if not frame.is_request:
                    continue
                client = self._client(frame)
                if client is None:
                    answers.append(frame.answer(b"", Error.BUSY))
                    continue
                answer = self._answer(client, frame)
                if answer is not None:
                    answers.append(answer)
                    if client.begins:
                        begins.append(client)
        except FrameError as error:
            self._log.refuse(ENDPOINT, self._address, "not a frame of AMS", detail=str(error))
            self._write(b"".join(answers))
            self.end("not a frame of AMS")
            return
        if is_new:
            self.asked_s = self._endpoint.host.loop.time()
        if self._deadline is not None:
            self._deadline.look(self._reader.pending, is_new=is_new)
        if answers:
            self._write(b"".join(answers))
        for client in begins:
            self._service.begin_notifications(client)

    def _client(self, frame: Frame) -> Client | None:
        """Return the client of a frame; ``None`` for one too many."""
        key = frame.source_id, frame.source_port
        client = self._clients.get(key)
        if client is None:
            if len(self._clients) >= MAX_CLIENTS:
                self._log.refuse(ENDPOINT, self.peer, "too many clients")
                return None
            client = self._clients[key] = Client(*key, self._notify, self)
        return client

    def _answer(self, client: Client, frame: Frame) -> bytes | None:
        """Return the answer to a request, ``None`` if it comes later."""
        permitted = self._endpoint.permitted
        if permitted and client.net_id not in permitted:
            self._log.refuse(ENDPOINT, client.name, "the NetId is not permitted")
            return frame.answer(b"", Error.SYMBOL)
        if frame.target_id != self._endpoint.net_id:
            detail = shown_net_id(frame.target_id)
            self._log.refuse(ENDPOINT, client.name, "for another NetId", detail=detail)
            return frame.answer(b"", Error.MACHINE_UNKNOWN)
        try:
            answer = self._service.answer(client, frame)
        except AdsError as error:
            self._service.access.log_refusal(client, error)
            return frame.answer(b"", error.code)
        except Exception as error:  # noqa: BLE001 - no request ends the connection of its client
            return self._broken(client, frame, error)
        if isinstance(answer, bytes):
            return frame.answer(answer)
        task = self._endpoint.host.loop.create_task(self._answer_later(client, frame, answer))
        for tasks in (self._tasks, self._endpoint.tasks):
            tasks.add(task)
            task.add_done_callback(tasks.discard)
        self._pace()
        return None

    async def _answer_later(self, client: Client, frame: Frame, answer: Later) -> None:
        try:
            data = frame.answer(await answer)
        except AdsError as error:
            self._service.access.log_refusal(client, error)
            data = frame.answer(b"", error.code)
        except Exception as error:  # noqa: BLE001 - whoever waits for an answer gets one
            data = self._broken(client, frame, error)
        self._write(data)
        if self._transport is None:
            self._service.forget(client)
        self._service.begin_notifications(client)
        self._endpoint.host.loop.call_soon(self._pace)

    def _broken(self, client: Client, frame: Frame, error: Exception) -> bytes:
        """Return the answer to a request that hit an internal error of nctakt."""
        self._log.error("request", endpoint=ENDPOINT, client=client.name, reason=error_text(error))
        return frame.answer(b"", Error.INTERNAL)

    # --- what the client takes ------------------------------------------------------------------

    def _write(self, data: bytes) -> None:
        if self._transport is not None:
            self._transport.write(data)

    def _notify(self, data: bytes) -> None:
        """Send a notification; a client that does not take them is disconnected."""
        if self._transport is None:
            return
        if self._transport.get_write_buffer_size() > MAX_UNREAD:
            self._log.refuse(ENDPOINT, self.peer, "does not take its notifications")
            self._transport.abort()
            self.end("does not take its notifications")
            return
        self._transport.write(data)

    def pause_writing(self) -> None:
        """Read nothing more from a client that does not take its answers."""
        self._can_take = False
        self._pace()

    def resume_writing(self) -> None:
        """Read on."""
        self._can_take = True
        self._pace()

    def _pace(self) -> None:
        """Read from the connection only as long as it takes answers, and not too many wait."""
        may_read = self._can_take and len(self._tasks) < MAX_IN_FLIGHT
        if self._transport is None or may_read == self._is_reading:
            return
        self._is_reading = may_read
        if may_read:
            self._transport.resume_reading()
        else:
            self._transport.pause_reading()
