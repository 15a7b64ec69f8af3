# SPDX-License-Identifier: MIT
"""The endpoint for MTConnect: lines of the adapter's protocol, as an agent reads them.

The words and types are compared with ``pymtconnect``, which is generated from the standard's model.
"""

from __future__ import annotations

import asyncio
import json
import re
from collections.abc import Awaitable, Callable
from dataclasses import replace
from xml.etree import ElementTree

import pytest
from support.insides import queue_line

from nctakt.lists.machine.machine import load_machine
from nctakt.results.run import ProgramMessage
from nctakt.run.access.machine_names import names_of_machine
from nctakt.run.program_loader import NcText
from nctakt.servers.catalogue import Catalogue
from nctakt.servers.host import Host
from nctakt.servers.log import ServerLog
from nctakt.servers.mtconnect import HEARTBEAT_MS, MtconnectEndpoint, escaped
from nctakt.servers.mtconnect_device import data_items, describe_device
from nctakt.servers.notices import ServerNotice
from nctakt.session.session import Session

pytestmark = pytest.mark.slow

PROGRAM = NcText("part.nc", '#MSG ["a | b"]\nG01 X10 F6000\nG01 X20 A5\nM30')
STAMP = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{6}Z")


class Agent:
    """An agent as it is in the adapter's specification: one value of each key, all texts."""

    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self.reader = reader
        self.writer = writer
        self.values: dict[str, str] = {}
        self.commands: list[str] = []
        self.device = self.stamp = ""

    async def line(self) -> str:
        """The next line, without its end; empty at the end of the connection."""
        return (await asyncio.wait_for(self.reader.readline(), 30.0)).decode().rstrip("\n")

    async def take(self) -> None:
        """Read one line."""
        line = await self.line()
        assert line
        if line.startswith("* deviceModel: "):
            mark = line.split()[-1]
            parts = []
            while (part := await self.line()) != mark:
                parts.append(part)
            self.device = "\n".join(parts)
        elif line.startswith("* "):
            self.commands.append(line)
        else:
            self.stamp, *fields = line.split("|")
            assert STAMP.fullmatch(self.stamp), line
            if fields[0] in ("message", "p1_logic"):
                self.values[fields[0]] = "|".join(fields[1:])
            else:
                self.values.update(zip(fields[::2], fields[1::2], strict=True))

    async def until(self, holds: Callable[[], bool]) -> None:
        """Read until something holds."""
        while not holds():
            await self.take()


def at_the_endpoint(act: Callable[[Host, MtconnectEndpoint, Agent], Awaitable[None]]) -> list[str]:
    """Let an agent connect; the reasons of what was refused."""
    lines: list[str] = []

    async def live(session: Session) -> None:
        host = await Host(session, load_machine(), ServerLog(lines.append)).open()
        endpoint = MtconnectEndpoint(host, ("127.0.0.1", 0))
        await endpoint.prepare()
        name, _, port = (await endpoint.open()).rpartition(":")
        try:
            agent = Agent(*await asyncio.open_connection(name, int(port)))
            await act(host, endpoint, agent)
            agent.writer.close()
        finally:
            await endpoint.close()
            await host.close()

    with Session(PROGRAM, stays=True) as session:
        asyncio.run(live(session))
    return [line["reason"] for line in map(json.loads, lines) if line["event"] == "refused"]


def test_an_agent_gets_all_values_and_then_what_changes() -> None:
    """Commands and the device first; positions, line and state follow the ticks; pings are
    answered; a text with the divider is one field.
    """

    async def act(host: Host, endpoint: MtconnectEndpoint, agent: Agent) -> None:
        await agent.until(lambda: agent.values.get("avail") == "AVAILABLE")
        assert "* shdrVersion: 2.0" in agent.commands
        ids = [item.get("id") for item in ElementTree.fromstring(agent.device).iter("DataItem")]
        assert sorted(map(str, ids)) == sorted(agent.values)
        assert agent.values["p1_execution"] == "READY"
        assert agent.values["p1_S3_speed"] == "UNAVAILABLE"  # the PLC turns it
        agent.writer.write(b"* PING\n")
        await agent.until(lambda: f"* PONG {HEARTBEAT_MS}" in agent.commands)
        await host.ask(host.session.run, "100 ms")
        await agent.until(lambda: agent.values["p1_execution"] == "ACTIVE")
        assert agent.values["p1_program"] == "part.nc"
        assert agent.values["p1_line"] == "2"
        position = host.session.read("X.ACS.ACT_POS")[0]
        assert float(agent.values["p1_X_command"]) == pytest.approx(position, rel=1e-9)
        await agent.until(lambda: agent.values["message"] == '|"a \\| b"')
        await host.ask(host.session.write, {"HLI.FEED_HOLD": 1})
        await host.ask(host.session.run, "110 ms")
        await agent.until(lambda: agent.values["p1_execution"] == "FEED_HOLD")
        assert agent.stamp == host.clock.text(110)
        await endpoint.close()
        await agent.until(lambda: agent.values["avail"] == "UNAVAILABLE")
        assert await agent.line() == ""

    at_the_endpoint(act)


def test_an_error_is_a_fault_until_it_is_cleared() -> None:
    """The condition of the path has the number of the error."""

    async def act(host: Host, _: MtconnectEndpoint, agent: Agent) -> None:
        await agent.until(lambda: agent.values.get("p1_logic") == "NORMAL||||")
        await host.ask(host.session.write, {"HLI.RESET": 1})
        await host.ask(host.session.run, "10 ms")
        assert host.store.frame is not None
        values = {**host.store.values, "HLI.ERROR": 20847.0}
        host.store.receive(replace(host.store.frame, values=values))
        await agent.until(lambda: agent.values["p1_logic"] == "FAULT|20847|||error 20847")

    at_the_endpoint(act)


def test_what_an_agent_must_not_send_is_refused() -> None:
    """An unknown command is reported; a line without end closes the connection, and no other's."""

    async def act(host: Host, endpoint: MtconnectEndpoint, agent: Agent) -> None:
        agent.writer.write(b"x|y\n" + b"z" * 5000)
        while await agent.reader.read(65536):
            pass
        assert host.session.tick == 0
        assert endpoint is not None

    assert at_the_endpoint(act) == ["an unknown command", "a line is too long"]


def test_an_agent_that_asks_and_never_reads_is_disconnected() -> None:
    """Neither texts nor answers to its pings wait without a limit."""

    async def act(host: Host, endpoint: MtconnectEndpoint, agent: Agent) -> None:
        await agent.until(lambda: agent.values.get("avail") == "AVAILABLE")
        (client,) = endpoint.clients
        for _ in range(1001):  # nothing is sent meanwhile
            queue_line(client, "* PONG 10000")
        async with asyncio.timeout(30.0):
            while endpoint.clients:
                await asyncio.sleep(0.01)

    assert at_the_endpoint(act) == ["reads too slowly"]


def test_many_texts_at_once_do_not_end_what_an_agent_hears() -> None:
    """The endpoint hears the notices of a thousand ticks at once, and those after them."""

    async def act(host: Host, endpoint: MtconnectEndpoint, agent: Agent) -> None:
        await agent.until(lambda: agent.values.get("avail") == "AVAILABLE")
        message = ProgramMessage(0, "last")
        for tick in range(1001):
            host.notices.notify(ServerNotice("ended", tick, ""))
        host.notices.notify(ServerNotice("message", 1001, "last", message=message))
        await agent.until(lambda: agent.values["message"] == "|last")

    at_the_endpoint(act)


@pytest.mark.parametrize(
    ("text", "field"), [("a\nb", "a b"), ("a|b", '"a\\|b"'), ('"a"|', '"\\"a\\"\\|"')]
)
def test_a_text_is_one_field(text: str, field: str) -> None:
    """A line break would be another line, a divider another field."""
    assert escaped(text) == field


def test_types_units_and_words_are_those_of_the_standard() -> None:
    """Each is one of the model from which ``pymtconnect`` is generated."""
    condition, event, execution, sample, sub_type, unit = (
        getattr(
            pytest.importorskip(
                f"pymtconnect.Enums.DataTypes.{name}", reason="the words of the standard, by others"
            ),
            name,
        ).__members__
        for name in (
            "ConditionEnum",
            "EventEnum",
            "ExecutionEnum",
            "SampleEnum",
            "DataItemSubTypeEnum",
            "UnitEnum",
        )
    )
    types = {"EVENT": event, "SAMPLE": sample, "CONDITION": condition}
    machine = load_machine()
    items = data_items(machine, Catalogue(names_of_machine(machine)))
    device = ElementTree.fromstring(describe_device(machine, items))
    for item in device.iter("DataItem"):
        assert item.get("type") in types[str(item.get("category"))]
        assert item.get("subType", "ACTUAL") in sub_type
        assert item.get("units", "DEGREE").replace("/", "_PER_") in unit
    state_item = next(item for item in items if item.type == "EXECUTION")
    for state in range(4):
        for lamp in ("HLI.PAUSED", "HLI.ARMED", "HLI.FEED_HOLD"):
            shown = state_item.show({"HLI.STATE": float(state), lamp: 1.0}, None)
            assert shown in execution
