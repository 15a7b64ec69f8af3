# SPDX-License-Identifier: MIT
"""A whole cell: PLC by ADS, HMI by OPC UA, operator at the page; one tape, repeated to the byte."""

from __future__ import annotations

import asyncio
import csv
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

pytest.importorskip("asyncua", reason="needs the extra [opcua]")
pytest.importorskip("pyads", reason="pyads needs a compiler, which is missing here")

from support.opcua_client import patient_client
from support.page_driving import BROWSER, chromium, opened

from nctakt.files.access import FileAccess
from nctakt.run.access.tape import read_tape

pytestmark = BROWSER

FOLDER = Path(__file__).parent
LIMIT_S = 60.0

PROGRAM = """#RT CYCLE [ID=1 SCOPE=GLOBAL]
  $IF EDGE V.E.VALUE > 0.5
    V.E.OUTPUT = 7
  $ENDIF
  $IF EDGE V.E.INPUT > 0.5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
G01 X50 F6000
$WHILE V.E.INPUT < 1
G04 X0.05
$ENDWHILE
G01 X80 F300
M30
"""


async def until(condition):
    """Return what a condition gives once it is true."""
    end = time.monotonic() + LIMIT_S
    while not (found := await condition()):
        assert time.monotonic() < end
        await asyncio.sleep(0.02)
    return found


class Hmi:
    """An HMI of the cell."""

    def __init__(self, client):
        self.client = client

    async def read(self, name):
        """Return a value of the channel."""
        node = self.client.get_node(f"ns=3;s=CncChannelList.1.{name}")
        shown = await node.read_data_value(raise_on_bad_status=False)
        return None if shown.Value is None else shown.Value.Value

    async def is_at(self, name, value):
        """Wait until a value is this one."""

        async def holds():
            return await self.read(name) == value

        await until(holds)

    async def write(self, name, value):
        """Write a value of the channel."""
        await self.client.get_node(f"ns=3;s=CncChannelList.1.{name}").write_value(value)

    async def call(self, name):
        """Call a method of the channel."""
        channel = self.client.get_node("ns=3;s=CncChannelList.1")
        await channel.call_method(f"3:{name}")


async def lead(url, page):
    """START and the wish by OPC UA, feed hold by the page; return the counted reactions."""
    async with patient_client(url) as client:
        hmi = Hmi(client)
        await hmi.call("Start")
        await hmi.is_at("ActProgramStatus", 1)
        await hmi.write("V.E.VALUE", 1.0)
        await hmi.is_at("V.E.INPUT", 1.0)  # the PLC's answer
        await hmi.write("CmdOverride", 50.0)
        await hmi.is_at("ActProgramLine", "13")
        await asyncio.to_thread(page, "hold")
        await hmi.is_at("FeedHold", True)
        await hmi.is_at("ActFeedrate", 0.0)
        await asyncio.to_thread(page, "hold")
        await hmi.is_at("FeedHold", False)
        await hmi.write("CmdOverride", 150.0)
        await hmi.is_at("ActProgramStatus", 0)
        return await hmi.read("V.E.COUNT")


def replayed(tape: Path, trace: Path) -> bytes:
    """Return the trace of a repeated run."""
    signals = "V.E.COUNT,V.E.OUTPUT,HLI.OVERRIDE,X.ACS.ACT_POS,PATH.SPEED"
    words = ["replay", str(tape), "--trace", str(trace), "--signals", signals, "--quiet"]
    done = subprocess.run(
        [sys.executable, "-m", "nctakt", *words], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return trace.read_bytes()


@pytest.mark.nightly
def test_plc_hmi_and_operator_share_a_controller_and_its_tape(tmp_path: Path) -> None:
    """All three act, the tape says who did what, and repeating it gives the same bytes."""
    program, ready, tape = (tmp_path / name for name in ("part.nc", "ready.json", "cell.tape"))
    program.write_text(PROGRAM, "utf-8")
    doors = ["--ads=127.0.0.1:0", "--opcua=127.0.0.1:0", "--live=127.0.0.1:0"]
    words = [*doors, "--wait-for-start", f"--ready-file={ready}", f"--record={tape}", "--quiet"]
    environment = {name: value for name, value in os.environ.items() if "PYTEST" not in name}
    command = [sys.executable, "-m", "nctakt", "serve", str(program), *words]
    with subprocess.Popen(
        command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL
    ) as process:
        try:
            end = time.monotonic() + LIMIT_S
            while not ready.exists():
                assert time.monotonic() < end
                assert process.poll() is None
                time.sleep(0.02)
            addresses = json.loads(ready.read_text("utf-8"))["addresses"]
            plc = subprocess.Popen(
                [sys.executable, str(FOLDER / "cell_plc.py"), *addresses["ads"].split("/")]
            )
            with plc:
                count = asyncio.run(operate(addresses))
                assert plc.wait(LIMIT_S) == 0
            process.send_signal(signal.SIGTERM)
            assert process.wait(LIMIT_S) == 0
        finally:
            process.kill()
    assert count == 1
    sources = {one.source.split()[0] for one in read_tape(tape, FileAccess([])).inputs}
    assert {"ads", "opcua", "page"} <= sources
    first = replayed(tape, tmp_path / "first.csv")
    assert replayed(tape, tmp_path / "second.csv") == first
    rows = list(csv.DictReader(first.decode().splitlines()))
    assert float(rows[-1]["V.E.COUNT"]) == 1.0
    assert {"50", "100", "150"} <= {row["HLI.OVERRIDE"].removesuffix(".0") for row in rows}


async def operate(addresses):
    """Let the HMI lead while a browser in its own thread has the page."""
    loop = asyncio.get_running_loop()
    clicks: asyncio.Queue = asyncio.Queue()

    def watch(is_open):
        from playwright.sync_api import expect  # noqa: PLC0415 - where there is a browser only

        with chromium() as browser:
            page = opened(browser, addresses["live"])
            loop.call_soon_threadsafe(is_open.set)
            while True:
                word, done = asyncio.run_coroutine_threadsafe(clicks.get(), loop).result()
                if word is None:
                    return
                switch = page.get_by_test_id(word)
                turned = "false" if switch.get_attribute("aria-checked") == "true" else "true"
                switch.click()
                expect(switch).to_have_attribute("aria-checked", turned)
                loop.call_soon_threadsafe(done.set)

    is_open = asyncio.Event()
    browsing = asyncio.create_task(asyncio.to_thread(watch, is_open))
    await is_open.wait()

    def click(word):
        async def ask():
            done = asyncio.Event()
            await clicks.put((word, done))
            await done.wait()

        asyncio.run_coroutine_threadsafe(ask(), loop).result(LIMIT_S)

    try:
        return await lead(addresses["opcua"], click)
    finally:
        await clicks.put((None, None))
        await browsing
