# SPDX-License-Identifier: MIT
"""The endpoint for MQTT at a broker that others wrote: mosquitto if it is installed, else amqtt."""

from __future__ import annotations

import asyncio
import contextlib
import json
import shutil
import socket
import subprocess
import sys
from collections.abc import Awaitable, Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.lists.machine.machine import load_machine
from nctakt.plc.structured_text import structured_programs
from nctakt.run.program_loader import NcText
from nctakt.servers.host import Host
from nctakt.servers.log import ServerLog
from nctakt.servers.mqtt import MqttEndpoint
from nctakt.servers.mqtt_requests import MAX_WAITING, Broker, read_broker
from nctakt.servers.serving import CLOSING_S
from nctakt.session.session import Session

pytestmark = pytest.mark.slow

PROGRAM = NcText("part.nc", '#MSG ["hello"]\nG01 X10 F6000\nM30')


@pytest.fixture(scope="module")
def port(tmp_path_factory: pytest.TempPathFactory) -> Iterator[int]:
    """The port of a broker on this computer."""
    pytest.importorskip("aiomqtt", reason="the extra mqtt")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        number = free.getsockname()[1]
    folder = tmp_path_factory.mktemp("broker")
    with subprocess.Popen(
        broker_command(number, folder), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as broker:
        asyncio.run(asyncio.wait_for(listening(number), 60.0))
        yield number
        broker.terminate()


def broker_command(port: int, folder: Path) -> list[str]:
    """The command that starts a broker."""
    mosquitto = shutil.which("mosquitto")
    if mosquitto is not None:
        return [mosquitto, "-p", str(port)]
    pytest.importorskip("amqtt", reason="neither mosquitto nor amqtt is installed")
    settings = folder / "broker.json"
    listeners = {"default": {"type": "tcp", "bind": f"127.0.0.1:{port}"}}
    settings.write_text(json.dumps({"listeners": listeners}))
    return [sys.executable, "-m", "amqtt.scripts.broker_script", "-c", str(settings)]


async def listening(port: int) -> None:
    """Wait until somebody listens."""
    while True:
        try:
            _, writer = await asyncio.open_connection("127.0.0.1", port)
        except OSError:
            await asyncio.sleep(0.05)
        else:
            writer.close()
            return


class Client:
    """A client that keeps the latest message of each topic, and all answers."""

    def __init__(self, client: Any) -> None:
        self.client = client
        self.latest: dict[str, dict[str, Any]] = {}
        self.answers: list[dict[str, Any]] = []

    async def take(self) -> None:
        """Take one message."""
        message = await asyncio.wait_for(anext(self.client.messages), 30.0)
        _, _, topic = str(message.topic).partition("/")
        words = json.loads(message.payload) if topic not in ("write", "press", "select") else {}
        self.latest[topic] = words
        if topic == "answer":
            self.answers.append(words)

    async def until(self, holds: Callable[[], bool]) -> None:
        """Take messages until something holds."""
        while not holds():
            await self.take()


def at_the_broker(
    port: int,
    act: Callable[[Host, MqttEndpoint, Client], Awaitable[None]],
    plc: Path | None = None,
) -> list[dict[str, Any]]:
    """Let a client see what the endpoint publishes; the log."""
    aiomqtt = pytest.importorskip("aiomqtt", reason="the extra mqtt")
    lines: list[str] = []

    async def live(session: Session) -> None:
        programs = [] if plc is None else structured_programs(plc)
        host = await Host(session, load_machine(), ServerLog(lines.append), programs).open()
        endpoint = MqttEndpoint(host, read_broker(f"mqtt://127.0.0.1:{port}/cell"))
        async with aiomqtt.Client("127.0.0.1", port, timeout=60) as client:
            await client.subscribe("cell/#", 1)
            await endpoint.prepare()
            await endpoint.open()
            try:
                await act(host, endpoint, Client(client))
            finally:
                await endpoint.close()
                await host.close()

    with Session(PROGRAM, stays=True, plc=plc) as session:
        asyncio.run(live(session))
        tape = [{"source": one.source, "values": one.values} for one in session.tape()]
    return [*map(json.loads, lines), *tape]


def test_a_client_sees_the_machine_and_writes(port: int) -> None:
    """Values by topic with their types; writes and keys are inputs of a tick, and are answered."""

    async def act(host: Host, endpoint: MqttEndpoint, client: Client) -> None:
        await client.until(lambda: "axis/X" in client.latest and "channel/1" in client.latest)
        assert client.latest["status"] == {"online": True}
        assert client.latest["channel/1"]["state"] == 0
        await host.ask(host.session.run, "100 ms")
        await client.until(lambda: client.latest["axis/X"]["tick"] == 100)
        assert client.latest["axis/X"]["time"] == host.clock.text(100)
        assert client.latest["axis/X"]["command"] == host.session.read("X.ACS.ACT_POS")[0]
        await client.until(lambda: client.latest.get("notice", {}).get("text") == "hello")
        requests = (
            ("write", '{"id": 7, "values": {"V.E.VALUE": 5, "V.E.TRIGGER": 3}}'),
            ("press", '{"id": 8, "key": "hold"}'),
            ("write", '{"id": 9, "values": {"V.E.VALU": 5}}'),
            ("write", '{"values": {"V.E.VALUE": [1]}}'),
            ("press", '{"key": "sneeze"}'),
            ("select", '{"program": "nowhere.nc"}'),
            ("select", '{"program": "part.nc", "channel": 2}'),
            ("press", "[" * 100_000),
            ("write", "\x00{"),
        )
        for topic, text in requests:
            await client.client.publish(f"cell/{topic}", text, 1)
        await client.until(lambda: len(client.answers) == len(requests))
        assert [answer["ok"] for answer in client.answers] == [True, True, *[False] * 7]
        assert [answer.get("id") for answer in client.answers[:3]] == [7, 8, 9]
        assert client.answers[2]["number"] == 900541
        await host.ask(host.session.run, "200 ms")
        await client.until(lambda: client.latest["variable/V.E.VALUE"]["value"] == 5.0)
        await client.until(lambda: client.latest["channel/1"]["feed_hold"] is True)
        await endpoint.close()
        await client.until(lambda: client.latest["status"] == {"online": False})

    log = at_the_broker(port, act)
    assert [line["values"] for line in log if "values" in line] == [
        ("V.E.VALUE", 5.0),
        ("V.E.TRIGGER", 3.0),
        ("HLI.FEED_HOLD", 1.0),
    ]
    assert {line["source"] for line in log if "values" in line} == {"mqtt 127.0.0.1"}
    assert len([line for line in log if line.get("event") == "refused"]) >= 4


def test_what_a_plc_marks_has_a_topic(port: int, tmp_path: Path) -> None:
    """Numbers, truths and items of marked variables come by their paths, and can be written."""
    (tmp_path / "cell.st").write_text(
        "TYPE E_Gate : (Closed := 0, Open := 5); END_TYPE\nPROGRAM MAIN\nVAR\n"
        "    {attribute 'OPC.UA.DA' := '1'} bOpen : BOOL;\n"
        "    {attribute 'OPC.UA.DA' := '1'} eGate : E_Gate;\n    nOwn : INT;\nEND_VAR\n"
        "eGate := SEL(bOpen, E_Gate.Closed, E_Gate.Open);\nEND_PROGRAM\n",
        "utf-8",
    )

    async def act(host: Host, endpoint: MqttEndpoint, client: Client) -> None:
        await client.until(lambda: "plc/MAIN.eGate" in client.latest)
        assert client.latest["plc/MAIN.bOpen"]["value"] is False
        text = '{"id": 1, "values": {"MAIN.bOpen": true}}'
        await client.client.publish("cell/write", text, 1)
        await client.until(lambda: bool(client.answers))
        await host.ask(host.session.run, "50 ms")
        await client.until(lambda: client.latest["plc/MAIN.eGate"]["value"] == "E_Gate.Open")
        assert client.latest["plc/MAIN.bOpen"]["value"] is True
        assert [one for one in client.latest if one.startswith("plc/")] == [
            "plc/MAIN.bOpen",
            "plc/MAIN.eGate",
        ]

    at_the_broker(port, act, tmp_path / "cell.st")


def test_a_retained_request_is_refused(port: int) -> None:
    """It would act again at each connection."""
    aiomqtt = pytest.importorskip("aiomqtt", reason="the extra mqtt")

    async def leave(text: str) -> None:
        async with aiomqtt.Client("127.0.0.1", port, timeout=60) as client:
            await client.publish("cell/press", text, 1, retain=True)

    async def act(host: Host, endpoint: MqttEndpoint, client: Client) -> None:
        await client.until(lambda: "axis/X" in client.latest)
        await client.client.publish("cell/press", '{"id": 1, "key": "go_on"}', 1)
        await client.until(lambda: bool(client.answers))

    asyncio.run(leave('{"key": "reset"}'))
    log = at_the_broker(port, act)
    asyncio.run(leave(""))
    assert [line["values"] for line in log if "values" in line] == [("HLI.FEED_HOLD", 0.0)]
    assert "a retained press" in [line.get("reason") for line in log]


def test_a_broker_that_is_not_there_is_reported(port: int) -> None:
    """901451 with the reason, before anything is served."""

    async def live(session: Session) -> None:
        host = await Host(session, load_machine(), ServerLog(None)).open()
        try:
            with pytest.raises(Failure) as caught:
                await MqttEndpoint(host, Broker("127.0.0.1", 1, False, "x")).open()
            assert caught.value.diagnostics[0].id == 901451
        finally:
            await host.close()

    with Session(PROGRAM, stays=True) as session:
        asyncio.run(live(session))


def test_no_request_ends_the_endpoint(port: int) -> None:
    """A number beyond all types, and a text without UTF-8, have an answer as any other request."""

    async def act(host: Host, endpoint: MqttEndpoint, client: Client) -> None:
        await client.until(lambda: "status" in client.latest)
        huge = '{"values": {"V.E.COUNT": 1' + "0" * 400 + "}}"
        for request in (huge, '{"values": {"V.E.\\udc80": 1}, "id": "\\udc81"}', "{}"):
            await client.client.publish("cell/write", request, 1)
        await client.until(lambda: len(client.answers) == 3)
        assert [answer["ok"] for answer in client.answers] == [False, False, False]
        assert "too large" in client.answers[0]["text"]
        assert client.answers[1]["id"] == "\udc81"

    at_the_broker(port, act)


@pytest.mark.parametrize(
    ("url", "broker"),
    [
        ("mqtt://localhost", Broker("localhost", 1883, False, "nctakt")),
        ("mqtts://[::1]:1/a/b/", Broker("::1", 1, True, "a/b")),
    ],
)
def test_the_address_of_a_broker(url: str, broker: Broker) -> None:
    """Ports and topics have defaults."""
    assert read_broker(url) == broker


@pytest.mark.parametrize(
    "url",
    [
        "localhost",
        "http://localhost",
        "mqtt://",
        "mqtt://h:99999",
        "mqtt://h/a/#",
        "mqtt://u:secret@h",
        "mqtt://h?x",
        "mqtt://[",
    ],
)
def test_another_text_is_refused_without_its_secrets(url: str) -> None:
    """A password in a URL is in lists of processes: it is refused, and not repeated."""
    with pytest.raises(Failure) as caught:
        read_broker(url)
    assert caught.value.diagnostics[0].id == 901450
    assert "secret" not in str(caught.value)


Packets = Callable[[asyncio.StreamWriter], Awaitable[None]]


def packet(kind: int, body: bytes) -> bytes:
    """A packet of MQTT of any length."""
    size, rest = b"", len(body)
    while rest > 127:
        size, rest = size + bytes((rest % 128 + 128,)), rest // 128
    return bytes((kind,)) + size + bytes((rest,)) + body


def message(topic: bytes, text: bytes) -> bytes:
    """A message that wants no acknowledgement."""
    return packet(0x30, len(topic).to_bytes(2, "big") + topic + text)


async def be_a_broker(
    reader: asyncio.StreamReader, writer: asyncio.StreamWriter, then: Packets
) -> None:
    """Accept, acknowledge all; once three subscriptions are granted do ``then``."""
    granted = 0
    while head := await reader.read(1):
        kind, size = head[0], (await reader.readexactly(1))[0]
        if size > 127:  # the properties of longer packets do not matter
            size += 128 * (await reader.readexactly(1))[0] - 128
        body = await reader.readexactly(size)
        if kind >> 4 == 1:
            writer.write(packet(0x20, b"\0\0"))
        elif kind >> 4 == 3:
            end = 2 + int.from_bytes(body[:2], "big")
            writer.write(packet(0x40, body[end : end + 2]))
        elif kind >> 4 == 8:
            granted += 1
            writer.write(packet(0x90, body[:2] + b"\1"))
            if granted == 3:
                await then(writer)
    writer.close()


def with_a_broker(
    then: Packets, until: Callable[[Session, list[str]], bool]
) -> tuple[list[tuple[Any, ...]], list[Any]]:
    """Serve a session at such a broker until something holds; its inputs, reasons of the log."""
    pytest.importorskip("aiomqtt")
    lines: list[str] = []

    async def live(session: Session) -> None:
        server = await asyncio.start_server(
            lambda *streams: be_a_broker(*streams, then), "127.0.0.1", 0
        )
        port = server.sockets[0].getsockname()[1]
        host = await Host(session, load_machine(), ServerLog(lines.append)).open()
        endpoint = MqttEndpoint(host, Broker("127.0.0.1", port, False, "cell"))
        await endpoint.prepare()
        host.clock.begin(0)
        await endpoint.open()
        while not until(session, lines):
            await asyncio.sleep(0.05)
        await asyncio.wait_for(endpoint.close(), CLOSING_S)
        await host.close()
        server.close()

    with Session(PROGRAM, stays=True) as session:
        asyncio.run(asyncio.wait_for(live(session), 60.0))
        inputs = [one.values for one in session.tape()]
    return inputs, [json.loads(one).get("reason") for one in lines]


def test_a_topic_that_nobody_can_read_is_dropped() -> None:
    """A broker that sends bytes without UTF-8 as a topic: it is reported, the next request acts."""

    async def then(writer: asyncio.StreamWriter) -> None:
        writer.write(message(b"\xff\xfe", b"{}") + message(b"cell/press", b'{"key": "hold"}'))

    inputs, reasons = with_a_broker(then, lambda session, _: bool(session.tape()))
    assert inputs == [("HLI.FEED_HOLD", 1.0)]
    assert "a message that cannot be read" in reasons


def test_a_broker_that_comes_back_is_served_again() -> None:
    """It goes away twice; at its third connection a request acts."""
    connections = []

    async def then(writer: asyncio.StreamWriter) -> None:
        connections.append(writer)
        if len(connections) < 3:
            await asyncio.sleep(0.2)  # until what is published flows
            writer.transport.abort()
        else:
            writer.write(message(b"cell/press", b'{"key": "hold"}'))

    inputs, _ = with_a_broker(then, lambda session, _: bool(session.tape()))
    assert inputs == [("HLI.FEED_HOLD", 1.0)]
    assert len(connections) == 3


def test_requests_beyond_a_number_are_dropped_and_reported() -> None:
    """1,000 at once, each longer than a request may be: none fills the memory."""

    async def then(writer: asyncio.StreamWriter) -> None:
        for _ in range(1000):
            writer.write(message(b"cell/write", b"[" * 70_000))
        await writer.drain()

    def is_told(_: Session, lines: list[str]) -> bool:
        return any("requests wait" in one for one in lines)

    inputs, reasons = with_a_broker(then, is_told)
    assert inputs == []
    assert f"more than {MAX_WAITING} requests wait" in reasons


@pytest.mark.parametrize("kind", ["held", "long"])
def test_a_broker_cannot_fill_the_memory(kind: str) -> None:
    """Messages that it never releases, a packet of 256 MB: the connection ends; then one acts.

    Before, each of 65,535 messages was kept, and the long packet took a gigabyte.
    """
    connections: list[int] = []
    topic = len(b"cell/write").to_bytes(2, "big") + b"cell/write"

    async def then(writer: asyncio.StreamWriter) -> None:
        connections.append(0)
        if len(connections) > 1:
            writer.write(message(b"cell/press", b'{"key": "hold"}'))
            return
        if kind == "long":
            writer.write(b"\x30\xff\xff\xff\x7f" + topic)
        with contextlib.suppress(OSError):
            for number in range(1, 4000):
                text = number.to_bytes(2, "big") + bytes(60_000)
                writer.write(packet(0x34, topic + text) if kind == "held" else bytes(60_000))
                await writer.drain()
                connections[0] += 60_000

    inputs, _ = with_a_broker(then, lambda session, _: bool(session.tape()))
    assert inputs == [("HLI.FEED_HOLD", 1.0)]
    assert len(connections) == 2
    assert connections[0] < 64 << 20  # what the system holds between both


def test_a_broker_that_hangs_is_left_in_time() -> None:
    """It takes nothing any more: the endpoint closes before its time is over, without it."""

    async def then(writer: asyncio.StreamWriter) -> None:
        writer.write(message(b"cell/press", b'{"key": "hold"}'))
        try:
            await asyncio.sleep(60.0)
        finally:
            writer.close()

    inputs, reasons = with_a_broker(then, lambda session, _: bool(session.tape()))
    assert inputs == [("HLI.FEED_HOLD", 1.0)]
    assert not [one for one in reasons if one and "internal" in one]
