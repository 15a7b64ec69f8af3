# SPDX-License-Identifier: MIT
"""The cost of OPC UA in addition to a session: 200 monitored items at 50 ms, 20 clients.

The server and the session have their own processes, the clients another one. Counted is the
processor time of the server's process, less that without any client.
"""

from __future__ import annotations

import asyncio
import json
import logging
import multiprocessing
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

#: Clients, items of them all, their interval, and how long is measured.
CLIENTS, ITEMS, INTERVAL_MS, SECONDS = 20, 200, 50.0, 10.0

_PROGRAM = """S1000 M3
$WHILE 1
G01 X100 Y50 Z20 A30 F6000
G01 X0 Y0 Z0 A0
$ENDWHILE
M30
"""


def processor_s(process: int) -> float:
    """Return the processor time of a process in seconds."""
    fields = Path(f"/proc/{process}/stat").read_text("ascii").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def _names(count: int) -> list[str]:
    """Return as many nodes as there are items; all of them change all the time."""
    parts = [
        f"CncAxisList.{axis}.PosDirect{part}"
        for axis in "XYZA"
        for part in ("", ".ActPos", ".CmdPos", ".RemDist")
    ]
    parts += ["CncSpindleList.S.AnglePos.ActPos", "CncChannelList.1.Signals.PATH.DIST_TO_GO"]
    return [parts[index % len(parts)] for index in range(count)]


async def _client(url: str, names: list[str], counts: list[int], end: asyncio.Event) -> None:
    from asyncua import Client  # noqa: PLC0415 - the process of the clients alone needs it

    logging.getLogger("asyncua").setLevel(logging.ERROR)

    class Counter:
        """Counts values."""

        def datachange_notification(self, node: Any, value: Any, data: Any) -> None:
            """Count one."""
            counts[0] += 1

    async with Client(url) as client:
        subscription = await client.create_subscription(INTERVAL_MS, Counter())
        nodes = [client.get_node(f"ns=3;s={name}") for name in names]
        await subscription.subscribe_data_change(nodes)
        await end.wait()


def _clients(url: str, ready: Any, done: Any, result: Any) -> None:
    async def run() -> None:
        counts, end = [0], asyncio.Event()
        each = ITEMS // CLIENTS
        names = _names(ITEMS)
        tasks = [
            asyncio.create_task(_client(url, names[index * each : (index + 1) * each], counts, end))
            for index in range(CLIENTS)
        ]
        await asyncio.sleep(3.0)
        ready.set()
        counts[0] = 0
        begin_s = time.monotonic()
        await asyncio.to_thread(done.wait)
        result.put(counts[0] / (time.monotonic() - begin_s))
        end.set()
        await asyncio.gather(*tasks)

    asyncio.run(run())


def measure() -> dict[str, float]:
    """Return the shares of one core, the values reported each second, and the time of the start."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "part.nc"
        program.write_text(_PROGRAM, encoding="utf-8")
        ready_file = Path(folder) / "ready.json"
        begin_s = time.monotonic()
        command = [sys.executable, "-m", "nctakt", "serve", str(program)]
        words = ["--machine", "demo", "--opcua=127.0.0.1:0", "--ready-file", str(ready_file)]
        server = subprocess.Popen([*command, *words], stdout=subprocess.DEVNULL)
        try:
            while not ready_file.exists():
                time.sleep(0.01)
            start_s = time.monotonic() - begin_s
            url = json.loads(ready_file.read_text("utf-8"))["addresses"]["opcua"]
            alone = _share(server.pid)
            context = multiprocessing.get_context("spawn")
            ready, done, result = context.Event(), context.Event(), context.Queue()
            clients = context.Process(target=_clients, args=(url, ready, done, result))
            clients.start()
            ready.wait()
            served = _share(server.pid)
            done.set()
            rate = result.get()
            clients.join()
        finally:
            server.terminate()
            server.wait()
    return {"alone": alone, "served": served, "values/s": rate, "start s": start_s}


def _share(process: int) -> float:
    """Return the share of a core that a process takes."""
    before, begin_s = processor_s(process), time.monotonic()
    time.sleep(SECONDS)
    return (processor_s(process) - before) / (time.monotonic() - begin_s)


def main() -> None:
    """Print the measurements."""
    found = measure()
    own = found["served"] - found["alone"]
    print(
        f"OPC UA, {CLIENTS} clients, {ITEMS} items at {INTERVAL_MS:.0f} ms: "
        f"{own:.1%} of a core beside the session ({found['alone']:.1%} without clients), "
        f"{found['values/s']:,.0f} values/s; start {found['start s']:.1f} s"
    )


if __name__ == "__main__":
    main()
