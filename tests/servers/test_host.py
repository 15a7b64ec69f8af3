# SPDX-License-Identifier: MIT
"""The host of all endpoints: values without asking the session, writes of clients, notices."""

from __future__ import annotations

import asyncio
import json
import os
import signal
import time
from collections.abc import Awaitable, Callable, Sequence
from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.lists.machine.machine import load_machine
from nctakt.run.program_loader import NcText
from nctakt.servers.address import read_address, shown_address
from nctakt.servers.host import Host
from nctakt.servers.log import ServerLog
from nctakt.servers.notices import Notices, ServerNotice
from nctakt.servers.serving import EndSignal, serve
from nctakt.servers.store import Store
from nctakt.session.session import Session

pytestmark = pytest.mark.slow

PROGRAM = NcText("part.nc", "G01 X100 F6000\nM30")


def in_host(act: Callable[[Host], Awaitable[None]]) -> list[dict[str, object]]:
    """Let something happen in a host; the lines of its log."""
    lines: list[str] = []

    async def live(session: Session) -> None:
        host = await Host(session, load_machine(), ServerLog(lines.append)).open()
        try:
            await act(host)
        finally:
            await host.close()

    with Session(PROGRAM, stays=True) as session:
        asyncio.run(live(session))
    return [json.loads(line) for line in lines]


async def until(host: Host, holds: Callable[[], bool]) -> None:
    """Wait for a frame after which something holds."""
    happened = asyncio.Event()
    end = host.store.listen(lambda _: happened.set() if holds() else None)
    try:
        if not holds():
            await asyncio.wait_for(happened.wait(), 30.0)
    finally:
        end()


def test_values_come_with_each_frame_once_somebody_has_asked_for_them() -> None:
    """A name is subscribed by its first reader; then reading asks nobody."""

    async def act(host: Host) -> None:
        name = host.catalogue.find("x.acs.act_pos").name
        assert not host.store.has([name])
        assert await host.store.read(name) == [0.0]
        await host.ask(host.session.run, "100 ms")
        await until(host, lambda: host.store.tick == 100)
        assert host.store.values[name] == host.session.read(name)[0] != 0.0

    in_host(act)


def test_an_unknown_name_is_refused_with_the_nearest() -> None:
    """Whoever asks for a value that is none learns of the one that was meant."""

    async def act(host: Host) -> None:
        with pytest.raises(Failure, match=r"HLI\.OVERRIDE"):
            host.catalogue.find("HLI.OVERIDE")
        with pytest.raises(Failure):
            await host.store.read("nothing")

    in_host(act)


def test_writes_of_all_clients_act_in_the_order_of_their_endpoints() -> None:
    """Of two endpoints that write a value in one tick the later one wins; both are on the tape."""

    async def act(host: Host) -> None:
        await host.store.subscribe(["V.E.COUNT"])
        answers = await asyncio.gather(
            host.write({"V.E.COUNT": 5}, "opcua", "hmi"),
            host.write({"V.E.COUNT": 7}, "ads", "plc"),
            host.write({"V.E.COUNT": "text"}, "ads", "other"),
            return_exceptions=True,
        )
        assert [type(answer) for answer in answers] == [int, int, Failure]
        await host.ask(host.session.step)
        await until(host, lambda: host.store.tick == 1)
        assert host.store.values["V.E.COUNT"] == 5
        tape = [(one.tick, one.source, one.values) for one in host.session.tape()]
        assert tape == [
            (0, "ads plc", ("V.E.COUNT", 7.0)),
            (0, "opcua hmi", ("V.E.COUNT", 5.0)),
        ]

    refused = [line for line in in_host(act) if line["event"] == "refused"]
    assert [(line["endpoint"], line["client"]) for line in refused] == [("ads", "other")]


def test_what_a_frame_listener_breaks_reaches_no_other_endpoint() -> None:
    """An exception in one endpoint's listener is in the log; the others hear on."""

    async def act(host: Host) -> None:
        heard: list[int] = []

        def fail(_: object) -> None:
            raise KeyError("endpoint")

        host.store.listen(fail)
        host.store.listen(lambda frame: heard.append(frame.tick))
        await host.ask(host.session.step)
        await until(host, lambda: 1 in heard)

    assert "frame" in [line["event"] for line in in_host(act)]


def test_keys_are_values_of_the_hli() -> None:
    """START, RESET and feed hold are what an operator would write."""

    async def act(host: Host) -> None:
        await host.press("hold", 1, "ads", "plc")
        await host.store.subscribe(["HLI.FEED_HOLD"])
        await host.ask(host.session.step)
        await until(host, lambda: host.store.tick == 1)
        assert host.store.values["HLI.FEED_HOLD"] == 1

    in_host(act)


def test_who_does_not_take_notices_is_dropped() -> None:
    """Notices are never left out: a full queue disconnects its client, and no other one."""

    async def act() -> None:
        dropped: list[str] = []
        notices = Notices(ServerLog(None))
        slow = notices.subscribe(lambda: dropped.append("slow"), limit=2)
        quick = notices.subscribe(lambda: dropped.append("quick"), limit=3)
        for tick in range(3):
            notices.notify(ServerNotice("ended", tick, ""))
        assert dropped == ["slow"]
        assert slow.is_dropped
        assert [(await quick.next()).tick for _ in range(3)] == [0, 1, 2]

    asyncio.run(act())


def test_notices_by_the_thousand_at_once_do_not_end_the_servers() -> None:
    """Only a controller that has stopped does; a broken listener is in the log."""

    async def act(host: Host) -> None:
        def fail(_: object) -> None:
            raise KeyError("endpoint")

        host.notices.listen(fail)
        end = EndSignal(host)
        for tick in range(2000):
            host.notices.notify(ServerNotice("ended", tick, ""))
        with pytest.raises(TimeoutError):
            await asyncio.wait_for(end.wait(), 0.01)
        host.notices.notify(ServerNotice("refused", 2000, "a slice has failed"))
        with pytest.raises(Failure, match="a slice has failed"):
            await asyncio.wait_for(end.wait(), 30.0)

    assert "notice" in [line["event"] for line in in_host(act)]


def test_a_value_that_goes_while_somebody_asks_for_it_comes_again() -> None:
    """Letting values go takes a while: whoever needs one meanwhile gets it with later frames."""

    async def act() -> None:
        attached: list[list[str]] = []
        used: list[str] = []

        async def attach(names: Sequence[str]) -> None:
            await asyncio.sleep(0)
            attached.append(sorted(names))

        store = Store(attach, ServerLog(None))
        await store.subscribe("abc", is_borrowing=True)
        store.values = dict.fromkeys("abc", 0.0)
        going = asyncio.create_task(store.keep_borrowed(lambda: used))
        await asyncio.sleep(0)
        used.append("b")  # a notification of a value that was still here
        asking = asyncio.create_task(store.subscribe("a"))
        await asyncio.gather(going, asking)
        assert attached[-1] == ["a", "b"]

    asyncio.run(act())


def test_whoever_writes_while_the_session_breaks_gets_an_answer() -> None:
    """An error of nctakt's own reaches all that wait, and later writes are done."""

    async def act(host: Host) -> None:
        write_each = host.session.write_each

        def fail(_: object) -> list[Failure | int]:
            raise RuntimeError("broken")

        host.session.write_each = fail  # type: ignore[method-assign]
        writes = [host.write({"V.E.COUNT": number}, "ads", "plc") for number in range(2)]
        found = await asyncio.wait_for(asyncio.gather(*writes, return_exceptions=True), 30.0)
        assert [str(error) for error in found] == ["broken", "broken"]
        host.session.write_each = write_each  # type: ignore[method-assign]
        assert await host.write({"V.E.COUNT": 1}, "ads", "plc") == 0

    in_host(act)


def test_time_begins_when_the_endpoints_open_however_long_they_take_to_be_built() -> None:
    """A tick has the time at which it begins, not that at which the first endpoint was built."""
    times: list[int] = []

    class SlowEndpoint:
        max_connections = 0

        def __init__(self, host: Host) -> None:
            self._host = host

        async def prepare(self) -> None:
            await asyncio.sleep(0.05)
            times.append(time.time_ns() // 1000)

        async def open(self) -> str:
            times.append(self._host.clock.unix_us(self._host.session.tick))
            return ""

        async def close(self) -> None:
            """Nobody is connected."""

    def end(_: object) -> None:
        os.kill(os.getpid(), signal.SIGTERM)

    with Session(PROGRAM, stays=True) as session:
        session.run("5 ms")
        endpoints = {"first": SlowEndpoint, "second": SlowEndpoint}
        asyncio.run(
            serve(session, load_machine(), ServerLog(None), endpoints, speed=1.0, ready=end)
        )
    _, built, *begun = times
    assert begun[0] == begun[1] >= built - 1000  # whole milliseconds


def test_a_log_outlives_a_text_that_cannot_be_encoded(tmp_path: Path) -> None:
    """A lone surrogate in a name of a client is written as its escape; the next line follows."""
    file = tmp_path / "log.jsonl"
    with file.open("w", encoding="utf-8") as stream:
        log = ServerLog(stream.write)
        log.refuse("mqtt", "broker", "no V.E.\udc80")
        log.refuse("mqtt", "broker", "größer")
    reasons = [json.loads(line)["reason"] for line in file.read_text("utf-8").splitlines()]
    assert reasons == ["no V.E.\udc80", "größer"]


def test_a_refusal_that_comes_again_is_reported_with_its_number() -> None:
    """The log holds one line in ten seconds for the same refusal of the same client."""
    now = 0.0
    lines: list[str] = []
    log = ServerLog(lines.append, lambda: now)
    for _ in range(1000):
        log.refuse("ads", "1.2.3.4.1.1", "unknown group")
    now = 11.0
    log.refuse("ads", "1.2.3.4.1.1", "unknown group")
    assert [json.loads(line).get("repeated") for line in lines] == [None, 999]


def test_a_client_that_comes_from_each_port_has_a_line_and_then_a_count() -> None:
    """A router or a storm of connections fills no log; the count comes with the next line."""
    now = 0.0
    lines: list[str] = []
    log = ServerLog(lines.append, lambda: now)
    for port in range(1000):
        log.refuse("ads", f"1.2.3.4.1.1:{port}", "the NetId is not permitted")
        log.refuse("ads", f"[fe80::{port % 2}]:{port}", "too many clients")
    assert len(lines) == 3
    now = 10.0
    log.refuse("ads", "9.9.9.9.1.1:5", "the NetId is not permitted")
    log.report_counts()
    reported = [(line["client"], line.get("repeated")) for line in map(json.loads, lines[3:])]
    assert reported[:3] == [("1.2.3.4.1.1:0", 999), ("[fe80::0]:0", 499), ("[fe80::1]:1", 499)]
    assert reported[3:] == [("9.9.9.9.1.1:5", None)]


def test_a_client_that_calls_itself_otherwise_each_time_does_not_fill_the_log() -> None:
    """A hundred lines of an endpoint in ten seconds, then their number; others are not silenced."""
    now = 0.0
    lines: list[str] = []
    log = ServerLog(lines.append, lambda: now)
    for number in range(10_000):
        log.refuse("ads", f"1.2.{number // 256}.{number % 256}.1.1:1", f"reason {number}")
    log.refuse("mqtt", "broker", "no")
    assert len(lines) == 101
    now = 10.0
    log.refuse("ads", "1.1.1.1.1.1:1", "no")
    assert json.loads(lines[-2])["lines"] == 9900
    assert len(lines) == 103


@pytest.mark.parametrize(
    ("text", "address"),
    [
        ("127.0.0.1:5", ("127.0.0.1", 5)),
        ("localhost:0", ("localhost", 0)),
        ("[::1]:48898", ("::1", 48898)),
        ("0.0.0.0", ("0.0.0.0", 7)),
    ],
)
def test_addresses_are_host_and_port(text: str, address: tuple[str, int]) -> None:
    """An endpoint's address is a host with a port, or a host alone."""
    assert read_address("--ads", text, 7) == address
    assert shown_address(*address).startswith(text)


@pytest.mark.parametrize(
    "text", ["part.nc", "part.nc:", "dir/part.nc", "part", ":5", "h:70000", ""]
)
def test_what_is_no_address_is_refused(text: str) -> None:
    """A program after the option of an endpoint is reported from an address (901352)."""
    with pytest.raises(Failure) as caught:
        read_address("--ads", text, 7)
    assert caught.value.diagnostics[0].id == 901352
