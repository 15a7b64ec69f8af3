# SPDX-License-Identifier: MIT
"""The endpoint for MTConnect: an adapter to which agents connect and which sends them changes.

In: frames and notices of the host. Out: lines of the adapter's protocol (SHDR) on a socket:
commands about the device, then its data items, each line with the UTC of its tick. An agent's
``* PING`` is answered; who stops sending it is disconnected. A slow reader gets the latest values
and all texts.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections import deque
from collections.abc import Callable, Iterator, Mapping

from nctakt.base.version import __version__
from nctakt.servers.address import listen_at, shown_address
from nctakt.servers.connections import HEADER_S, NO_END, watch
from nctakt.servers.host import Host
from nctakt.servers.mtconnect_device import data_items, describe_device
from nctakt.servers.notices import ServerNotice
from nctakt.session.listening import Frame

#: The default port of agents.
PORT = 7878

#: The distance of an agent's pings in milliseconds; after two of them without one it has gone.
HEARTBEAT_MS = 10_000

#: Clients at the same time; bytes of one line of theirs; lines about conditions that wait for one.
MAX_CLIENTS = 64
_MAX_LINE = 1024
_MAX_WAITING = 1000

#: How long an agent that has never sent a ping keeps its place if another needs it.
_SILENT_S = 30.0

#: How long an agent may take for its last line when the endpoint closes, in seconds.
_LEAVING_S = 1.0

#: The version of the protocol, and of the standard whose data items are sent.
_SHDR_VERSION, _MTCONNECT_VERSION = "2.0", "2.0"

_ENDPOINT = "mtconnect"


class MtconnectEndpoint:
    """Sends agents the state of the machine; nothing can be written through it."""

    max_connections = MAX_CLIENTS

    def __init__(self, host: Host, address: tuple[str, int]) -> None:
        self._host = host
        self._address = address
        self._items = data_items(host.machine, host.catalogue)
        self._device = describe_device(host.machine, self._items)
        self.clients: dict[_Client, asyncio.Task[None]] = {}
        self._server: asyncio.Server | None = None
        self._stop_listening: Callable[[], None] = _nothing
        self._stop_hearing: Callable[[], None] = _nothing

    async def prepare(self) -> None:
        """Ask for the values of the data items."""
        await self._host.store.subscribe(name for item in self._items for name in item.needs)

    async def open(self) -> str:
        """Let agents connect; return the address. Raises ``Failure``."""
        host = self._host
        self._server, shown = await listen_at(
            "MTConnect",
            self._address,
            lambda name, port: asyncio.start_server(self._serve, name, port, limit=_MAX_LINE),
        )
        self._stop_listening = host.store.listen(self._take)
        self._stop_hearing = host.notices.listen(self._send_notice)
        return shown

    async def close(self) -> None:
        """Inform the agents that the device is no longer available."""
        self._stop_listening()
        self._stop_hearing()
        self._stop_listening = self._stop_hearing = _nothing
        if self._server is not None:
            self._server.close()
        served = dict(self.clients)
        for client in served:
            client.leave()
        if served:
            await asyncio.wait(served.values(), timeout=_LEAVING_S)
        for client in served:
            client.abort()
        await asyncio.gather(*served.values(), return_exceptions=True)

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """Serve one agent until it leaves."""
        client = _Client(self._host, writer)
        watch(writer.transport)
        if len(self.clients) >= MAX_CLIENTS and not self._make_room():
            self._host.log.refuse(_ENDPOINT, client.name, "too many clients")
            writer.close()
            return
        task = asyncio.current_task()
        assert task is not None
        self.clients[client] = task
        self._host.log.visit("connected", _ENDPOINT, client.address, client=client.name)
        try:
            client.greet(self._device)
            client.receive(self._host.store.tick, self._shown())
            await client.converse(reader)
        except (OSError, asyncio.IncompleteReadError):
            pass  # it has gone
        finally:
            self.clients.pop(client)
            client.abort()
            self._host.log.visit("disconnected", _ENDPOINT, client.address, client=client.name)

    def _make_room(self) -> bool:
        """End the oldest client that has never sent a ping, as agents do, if there is one."""
        latest_s = self._host.loop.time() - _SILENT_S
        silent = (one for one in self.clients if one.is_silent and one.begun_s < latest_s)
        oldest = min(silent, key=lambda one: one.begun_s, default=None)
        if oldest is None:
            return False
        self._host.log.refuse(_ENDPOINT, oldest.name, "no ping, and its place was needed")
        oldest.abort()
        return True

    def _take(self, frame: Frame) -> None:
        """Send all agents the changes of a frame."""
        if self.clients:
            shown = self._shown()
            for client in self.clients:
                client.receive(frame.tick, shown)

    def _shown(self) -> dict[str, str]:
        """Return the latest values as sent, by the keys of the data items."""
        store = self._host.store
        return {item.key: item.show(store.values, store.frame) for item in self._items}

    def _send_notice(self, notice: ServerNotice) -> None:
        """Send messages of programs and diagnostics to all agents."""
        for line in _lines_of(notice):
            for client in tuple(self.clients):
                client.put(notice.tick, line)


class _Client:
    """One agent: the values sent to it, and those waiting."""

    def __init__(self, host: Host, writer: asyncio.StreamWriter) -> None:
        peer = writer.get_extra_info("peername") or ("?", 0)
        self.address = str(peer[0])
        self.name = shown_address(self.address, peer[1])
        self._host = host
        self._writer = writer
        self._sent: dict[str, str] = {}
        self._tick = 0
        self._shown: Mapping[str, str] = {}
        self._lines: deque[str] = deque()
        self._changed = asyncio.Event()
        self._pinged = False
        self.begun_s = host.loop.time()

    @property
    def is_silent(self) -> bool:
        """Whether it has never sent a ping."""
        return not self._pinged

    def greet(self, device: str) -> None:
        """Queue the commands about the adapter and its device."""
        mark = "--multiline--NCTAKTDEVICE"
        self._lines += [
            f"* shdrVersion: {_SHDR_VERSION}",
            f"* adapterVersion: nctakt {__version__}",
            f"* mtconnectVersion: {_MTCONNECT_VERSION}",
            f"* deviceModel: {mark}\n{device}\n{mark}",
        ]

    def receive(self, tick: int, shown: Mapping[str, str]) -> None:
        """Let the values before a tick be sent as soon as the agent reads."""
        self._tick, self._shown = tick, shown
        self._changed.set()

    def put(self, tick: int, line: str) -> None:
        """Let a line be sent; an agent that leaves too many unread is disconnected."""
        self._queue(f"{self._host.clock.text(tick)}|{line}")

    def _queue(self, line: str) -> None:
        if len(self._lines) >= _MAX_WAITING:
            self._host.log.refuse(_ENDPOINT, self.name, "reads too slowly")
            self.abort()
            return
        self._lines.append(line)
        self._changed.set()

    async def converse(self, reader: asyncio.StreamReader) -> None:
        """Send and answer until either side ends."""
        tasks = [asyncio.create_task(self._send()), asyncio.create_task(self._answer(reader))]
        try:
            done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
            for task in done:
                task.result()
        finally:
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)

    async def _send(self) -> None:
        while True:
            await self._changed.wait()
            self._changed.clear()
            while self._lines:
                self._writer.write(f"{self._lines.popleft()}\n".encode(errors="replace"))
                await self._writer.drain()
            for line in self._changes():
                self._writer.write(line.encode(errors="replace"))
            await self._writer.drain()

    def _changes(self) -> Iterator[str]:
        """Yield lines with the values that differ from those sent; a condition has its own line."""
        fields: list[str] = []
        time = self._host.clock.text(self._tick)
        for key, text in self._shown.items():
            if self._sent.get(key) == text:
                continue
            self._sent[key] = text
            if "|" in text:
                yield f"{time}|{key}|{text}\n"
            else:
                fields += [key, text]
        if fields:
            yield f"{time}|{'|'.join(fields)}\n"

    async def _answer(self, reader: asyncio.StreamReader) -> None:
        """Answer pings; an agent that has sent one continues to do so, or is gone."""
        while not self._writer.is_closing():
            seconds = 2.0 * HEARTBEAT_MS / 1000.0 if self._pinged else None
            late = "no ping"
            try:
                line = await asyncio.wait_for(reader.read(1), seconds)
                if line not in (b"", b"\n"):
                    late = NO_END
                    line += await asyncio.wait_for(reader.readline(), HEADER_S)
            except TimeoutError:
                self._host.log.refuse(_ENDPOINT, self.name, late)
                return
            except ValueError:
                self._host.log.refuse(_ENDPOINT, self.name, "a line is too long")
                return
            if not line:
                return
            words = line.split()
            if words[:2] == [b"*", b"PING"]:
                self._pinged = True
                self._queue(f"* PONG {HEARTBEAT_MS}")
            elif words:
                self._host.log.refuse(_ENDPOINT, self.name, "an unknown command")
                await asyncio.sleep(0)  # the lines of one client do not hold up the others

    def leave(self) -> None:
        """Inform the agent that the device is not available, and end the connection."""
        with contextlib.suppress(OSError, RuntimeError):
            time = self._host.clock.text(self._host.store.tick)
            self._writer.write(f"{time}|avail|UNAVAILABLE\n".encode())
        self._writer.close()

    def abort(self) -> None:
        """End the connection at once, even with unread data."""
        self._writer.transport.abort()


def _lines_of(notice: ServerNotice) -> Iterator[str]:
    """Yield the lines for a notice, without its time: texts for the operator."""
    if notice.message is not None:
        yield f"message||{escaped(notice.message.text)}"
    elif notice.diagnostic is not None:
        yield f"message|{notice.diagnostic.id}|{escaped(notice.diagnostic.text('en'))}"


def escaped(text: str) -> str:
    """Return a text as one field: on one line, in quotes if it contains the divider."""
    line = " ".join(text.split())
    if "|" not in line:
        return line
    return '"' + line.replace('"', '\\"').replace("|", "\\|") + '"'


def _nothing() -> None:
    """Do nothing: there is no listener yet."""
