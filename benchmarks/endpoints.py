# SPDX-License-Identifier: MIT
"""``python -m benchmarks.endpoints [SECONDS]``: the performance of servers with a session of 1 ms.

Server and clients are processes of this machine, loopback between them; ``--pace tick``, so each
tick has its own time on the wall clock.

- ADS: at least 20,000 single reads a second, 1,000,000 values a second by sum reads; the 99th
  percentile of a read at most 2 ms.
- 100 connections with 1,000 notifications at 10 ms: none lost.
- A write -> the reaction of a realtime cycle -> the notification: at most 3 ticks + 5 ms.
- OPC UA: 200 monitored items at 50 ms for 20 clients: at most 20 % of a core more.
- A soak at 100 times the clock: memory stays flat.
"""

from __future__ import annotations

import selectors
import socket
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise
from pathlib import Path
from struct import pack, unpack_from

from benchmarks import endpoints_opcua
from benchmarks.ads_client import AdsClient, Served, count_answers
from nctakt.servers.ads.codes import Command, Group

CONNECTIONS = 100
EACH = 10
SUM_PARTS = 500
ROUND_TRIPS = 500


def percentile(values: Sequence[float], share: float) -> float:
    """Return the value below which a share of all values lies."""
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def measure_reads(span_s: float) -> None:
    """Print single reads, sum reads and the time of a read."""
    with Served("--pace=tick") as served:
        clients = [AdsClient(served, number) for number in range(1, 5)]
        request = clients[0].read("X.ACS.ACT_POS")
        clients[0].ask(request)
        done = count_answers(clients, request, 16, span_s)
        print(f"ADS single reads: {done / span_s:,.0f}/s (at least 20,000)")
    with Served("--pace=tick") as served:
        client = AdsClient(served)
        group, offset, _ = client.symbol("V.E.LIST")
        parts = [pack("<III", group, offset + 8 * (n % 10), 8) for n in range(SUM_PARTS)]
        asked = b"".join(parts)
        request = client.read_write(Group.SUM_READ, SUM_PARTS, 12 * SUM_PARTS, asked)
        client.ask(request)
        done = count_answers([client], request, 4, span_s)
        print(f"ADS sum reads: {done * SUM_PARTS / span_s:,.0f} values/s (at least 1,000,000)")
    for pace in ("tick", "slice"):
        with Served(f"--pace={pace}") as served:
            client = AdsClient(served)
            request = client.read("X.ACS.ACT_POS")
            client.ask(request)
            median, last = times_of(partial(client.ask, request), span_s)
            print(
                f"ADS one read, --pace {pace}: median {median:.3f} ms, "
                f"99 % within {last:.3f} ms (at most 2)"
            )
    with subprocess.Popen([sys.executable, "-c", _ECHO], stdout=subprocess.PIPE) as echo:
        assert echo.stdout is not None
        connection = socket.create_connection(("127.0.0.1", int(echo.stdout.readline())))

        def ask() -> None:
            connection.sendall(b"x" * 50)
            connection.recv(50)

        median, last = times_of(ask, span_s)
        print(f"  of a server that only echoes: {median:.3f} ms, {last:.3f} ms")
        echo.kill()


#: The measure of the machine: a server that does nothing.
_ECHO = """\
import asyncio
class Echo(asyncio.Protocol):
    def connection_made(self, transport): self.transport = transport
    def data_received(self, data): self.transport.write(data)
async def main():
    server = await asyncio.get_running_loop().create_server(Echo, "127.0.0.1", 0)
    print(server.sockets[0].getsockname()[1], flush=True)
    await server.serve_forever()
asyncio.run(main())
"""


def times_of(ask: Callable[[], object], span_s: float) -> tuple[float, float]:
    """Return the median and the 99th percentile of the time of a request, in ms."""
    times = []
    end = time.perf_counter() + span_s
    while (begin := time.perf_counter()) < end:
        ask()
        times.append((time.perf_counter() - begin) * 1000)
        time.sleep(0.0005)
    return statistics.median(times), percentile(times, 0.99)


def measure_notifications(span_s: float) -> None:
    """Print how many notifications came, and how many were lost."""
    with Served("--pace=tick") as served:
        clients = [AdsClient(served, number) for number in range(1, CONNECTIONS + 1)]
        selector = selectors.DefaultSelector()
        for client in clients:
            for _ in range(EACH):
                client.notify("X.ACS.ACT_POS", 3, 100_000)
            selector.register(client.socket, selectors.EVENT_READ, client)
        moments: dict[AdsClient, dict[int, list[int]]] = {client: {} for client in clients}
        end = time.perf_counter() + span_s
        while time.perf_counter() < end:
            for key, _ in selector.select(0.1):
                client = key.data
                frame = client.next()
                while True:
                    note(frame.data, moments[client])
                    if not client.has_frame:
                        break
                    frame = client.next()
        came = lost = 0
        for own in moments.values():
            for times in own.values():
                came += len(times)
                distances = [b - a for a, b in pairwise(times[1:])]
                lost += sum(distance // 100_000 - 1 for distance in distances)
        closed = served.end()
        print(
            f"ADS notifications: {CONNECTIONS} connections, {CONNECTIONS * EACH} at 10 ms: "
            f"{came / span_s:,.0f}/s, {lost} lost, late slices: {closed['late_slices']} of "
            f"{closed['tick']}, at most {closed['worst_lateness_ms']} ms"
        )


def note(data: bytes, moments: dict[int, list[int]]) -> None:
    """Note the times of the samples of a notification by their handles."""
    _, _, moment, samples = unpack_from("<IIQI", data)
    at = 20
    for _ in range(samples):
        handle, size = unpack_from("<II", data, at)
        moments.setdefault(handle, []).append(moment)
        at += 8 + size


def measure_round_trip() -> None:
    """Print the time from a write to the notification of what a realtime cycle made of it."""
    with Served("--pace=tick") as served:
        writer, listener = AdsClient(served, 1), AdsClient(served, 2)
        address = pack("<II", *writer.symbol("V.E.TRIGGER")[:2]) + pack("<I", 4)
        writes = [writer.frame(Command.WRITE, address + pack("<i", value)) for value in (0, 1)]
        listener.notify("V.E.COUNT_POS", 4, 0)
        listener.next()
        times = []
        for _ in range(ROUND_TRIPS):
            writer.ask(writes[0])
            time.sleep(0.003)
            begin = time.perf_counter()
            writer.socket.sendall(writes[1])
            listener.next()
            times.append((time.perf_counter() - begin) * 1000)
            writer.next()
        print(
            f"write, reaction, notification: median {statistics.median(times):.2f} ms, 99 % within "
            f"{percentile(times, 0.99):.2f} ms (at most 3 ticks + 5 ms)"
        )


def memory_kb(process: int) -> int:
    """Return what a process and those that it has started hold alone, in kB."""
    own = 0
    for line in Path(f"/proc/{process}/smaps_rollup").read_text("ascii").splitlines():
        if line.startswith("Pss:"):
            own = int(line.split()[1])
    for child in Path(f"/proc/{process}/task/{process}/children").read_text("ascii").split():
        own += memory_kb(int(child))
    return own


def measure_soak(span_s: float) -> None:
    """Print the memory over a soak in virtual speed, with a client that reads and listens."""
    with Served("--speed=100") as served:
        client = AdsClient(served)
        client.notify("X.ACS.ACT_POS", 3, 100_000)
        sizes = []
        for _ in range(10):
            end = time.perf_counter() + span_s / 10
            while time.perf_counter() < end:
                client.next()
            sizes.append(memory_kb(served.process.pid) // 1024)
        hours = float(str(served.end()["tick"])) / 3_600_000
        print(f"soak: {hours:.1f} h of machine time, MB: {' '.join(map(str, sizes))}")


def main(span_s: float) -> None:
    """Measure all."""
    measure_reads(span_s)
    measure_notifications(span_s)
    measure_round_trip()
    endpoints_opcua.main()
    measure_soak(6 * span_s)


if __name__ == "__main__":
    main(float(sys.argv[1]) if len(sys.argv) > 1 else 10.0)
