# SPDX-License-Identifier: MIT
"""Connections of ADS, MTConnect and OPC UA: times for messages, places for those who come later."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Awaitable, Callable
from struct import pack
from typing import Any

import pytest
from support.ads_wire import bench, notification, read
from support.insides import timer_of

from nctakt.base.failure import Failure
from nctakt.lists.machine.machine import load_machine
from nctakt.run.program_loader import NcText
from nctakt.servers import connections, mtconnect
from nctakt.servers.ads import server as ads
from nctakt.servers.connections import NO_END, RESERVE, Deadline, provide_descriptors
from nctakt.servers.host import Host
from nctakt.servers.log import ServerLog
from nctakt.servers.mtconnect import MtconnectEndpoint
from nctakt.session.session import Session

VARIABLES = 0x4040


@pytest.mark.parametrize(
    ("looks", "late_s"),
    [
        ((), 5.0),  # nothing comes
        (((3, False), (7, False)), 5.0),  # a header that comes byte by byte has no more time
        (((20, False), (30, False)), 60.0),  # the rest of the message
        (((20, False), (0, True)), None),  # whole, and nothing of the next one
        (((0, True), (3, False), (4, False)), 5.0),
        (((0, True), (3, True)), 5.0),  # a message, and the begin of another one
    ],
)
def test_a_message_has_its_time(looks: tuple[tuple[int, bool], ...], late_s: float | None) -> None:
    """5 s for what says how long it is, 60 s for the rest; none between two messages."""

    async def act() -> None:
        begun: list[float] = []
        ended: list[str] = []
        loop = asyncio.get_running_loop()
        deadline = Deadline(loop, 10, ended.append)
        for pending, is_new in looks:
            deadline.look(pending, is_new=is_new)
        timer = timer_of(deadline)
        if timer is not None:
            begun.append(timer.when() - loop.time())
        deadline.stop()
        assert [pytest.approx(late_s, abs=1.0)] == begun if late_s is not None else begun == []

    asyncio.run(act())


def test_ads_ends_what_never_ends_and_makes_room(monkeypatch: pytest.MonkeyPatch) -> None:
    """A frame without an end; an idle connection when all places are taken, unless notified."""
    monkeypatch.setattr(connections, "HEADER_S", 0.05)
    monkeypatch.setattr(ads, "MAX_CONNECTIONS", 2)
    monkeypatch.setattr(ads, "IDLE_S", 0.0)

    async def act() -> None:
        async with bench() as found:
            late, wire = found.connect()
            late.data_received(pack("<HI", 0, 32)[:3])
            while not wire.is_closed:
                await asyncio.sleep(0.01)
            assert NO_END in "".join(found.log)
            heard, heard_wire = found.connect()
            await found.ask(heard, heard_wire, notification(VARIABLES, 0, 8))
            idle, idle_wire = found.connect()
            await found.ask(idle, idle_wire, read(VARIABLES, 0, 8))
            await asyncio.sleep(0.02)
            later, later_wire = found.connect()
            assert idle_wire.is_closed
            assert not heard_wire.is_closed
            await found.ask(later, later_wire, read(VARIABLES, 0, 8))
            await asyncio.sleep(0.1)  # between two frames there is all the time
            assert not later_wire.is_closed

    asyncio.run(act())


def with_agents(act: Callable[[str, int], Awaitable[None]]) -> list[dict[str, Any]]:
    """Let something happen to the endpoint of MTConnect; the log."""
    lines: list[str] = []

    async def live(session: Session) -> None:
        host = await Host(session, load_machine(), ServerLog(lines.append)).open()
        endpoint = MtconnectEndpoint(host, ("127.0.0.1", 0))
        await endpoint.prepare()
        host.clock.begin(0)
        name, _, port = (await endpoint.open()).rpartition(":")
        try:
            await act(name, int(port))
        finally:
            await endpoint.close()
            await host.close()

    with Session(NcText("part.nc", "M30"), stays=True) as session:
        asyncio.run(live(session))
    return list(map(json.loads, lines))


def test_mtconnect_ends_what_never_ends_and_makes_room(monkeypatch: pytest.MonkeyPatch) -> None:
    """A line without an end; of all places the oldest that sends no pings is given away."""
    monkeypatch.setattr(mtconnect, "HEADER_S", 0.05)
    monkeypatch.setattr(mtconnect, "MAX_CLIENTS", 2)
    monkeypatch.setattr(mtconnect, "_SILENT_S", 0.0)

    async def act(name: str, port: int) -> None:
        async def ends(reader: asyncio.StreamReader) -> None:
            await asyncio.wait_for(reader.read(), 30.0)

        late, writer = await asyncio.open_connection(name, port)
        writer.write(b"* PI")
        await ends(late)
        writer.close()
        agents = [await asyncio.open_connection(name, port) for _ in range(2)]
        for reader, writer in agents[:1]:
            writer.write(b"* PING\n")
            while b"PONG" not in await asyncio.wait_for(reader.readline(), 30.0):
                pass
        later, later_writer = await asyncio.open_connection(name, port)
        await ends(agents[1][0])
        assert await asyncio.wait_for(later.readline(), 30.0)
        agents[0][1].write(b"* PING\n")
        while b"PONG" not in await asyncio.wait_for(agents[0][0].readline(), 30.0):
            pass
        for _, writer in (*agents, (later, later_writer)):
            writer.close()

    reasons = [line.get("reason") for line in with_agents(act)]
    assert NO_END in reasons
    assert "no ping, and its place was needed" in reasons


def test_descriptors_are_provided_or_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """The soft limit is raised to what all endpoints may need; above the hard one it is 902041."""
    resource = pytest.importorskip("resource", reason="Windows has no such limit")
    given: list[tuple[int, int]] = []
    monkeypatch.setattr(resource, "getrlimit", lambda _: (256, 1000))
    monkeypatch.setattr(resource, "setrlimit", lambda _, limits: given.append(limits))
    provide_descriptors(50)
    assert given == []
    provide_descriptors(700)
    assert given == [(700 + RESERVE, 1000)]
    with pytest.raises(Failure, match="902041"):
        provide_descriptors(1000)
