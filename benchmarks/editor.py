# SPDX-License-Identifier: MIT
"""``python -m benchmarks.editor``: how long an editor waits for the language server.

- Start: from the start of the process to the answer of ``initialize``; at most 0.5 s.
- A keystroke in a program of 10,000 lines with realtime cycles: until its findings arrive; at most
  100 ms in the median, the pause before the check included. Explanation and completion in it: at
  most 20 ms.
- A keystroke in a PLC project of 20,000 lines, in a body and in a declaration: at most 100 ms.
- A keystroke in a CAM program of 1,000,000 lines: at most 500 ms, the server in at most 300 MB.
"""

from __future__ import annotations

import asyncio
import os
import random
import statistics
import sys
import tempfile
import time
from collections.abc import Awaitable, Callable
from pathlib import Path

from lsprotocol import types
from pygls.lsp.client import LanguageClient

from benchmarks.st import project

LINES, LONG_LINES = 10_000, 1_000_000
PLC_LINES = 20_000
KEYSTROKES, LONG_KEYSTROKES, REQUESTS, STARTS = 40, 8, 40, 5

_CYCLE = """\
#RT CYCLE [ID={number} SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > P1
    M100
  $ENDIF
#RT CYCLE END
P1 = {number}
"""


def program(lines: int) -> str:
    """A program of blocks with a realtime cycle for each hundred lines."""
    chance = random.Random(1)
    text: list[str] = []
    while len(text) < lines - 1:
        if len(text) % 100 < 1:
            text += _CYCLE.format(number=len(text) // 100 + 1).splitlines()
        x, y = chance.uniform(0, 300), chance.uniform(0, 200)
        text.append(f"N{10 * len(text)} G01 X{x:.3f} Y{y:.3f} F1000")
    return "\n".join([*text, "M30", ""])


def cam_program(lines: int) -> str:
    """A program of short blocks."""
    blocks = (f"N{n} X{n * 0.001 % 300:.3f} Y{n * 0.002 % 200:.3f}" for n in range(lines - 2))
    return "\n".join(["G01 F1000", *blocks, "M30", ""])


class Measured:
    """A client that knows which version of a document has findings."""

    def __init__(self) -> None:
        self.client = LanguageClient("benchmark", "1")
        self.arrived = asyncio.Event()
        self.version = -1

        @self.client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)  # type: ignore[untyped-decorator]
        def published(params: types.PublishDiagnosticsParams) -> None:
            if params.version is not None:
                self.version = params.version
                self.arrived.set()

    async def start(self) -> float:
        """Start a server; the seconds until it has answered."""
        begin = time.perf_counter()
        await self.client.start_io(sys.executable, "-m", "nctakt", "lsp")
        params = types.InitializeParams(types.ClientCapabilities(), process_id=os.getpid())
        await self.client.initialize_async(params)
        self.client.initialized(types.InitializedParams())
        return time.perf_counter() - begin

    async def stop(self) -> None:
        """End the server."""
        await self.client.shutdown_async(None)
        self.client.exit(None)
        await self.client.stop()  # type: ignore[no-untyped-call]

    async def findings_of(self, version: int) -> None:
        """Wait for the findings of a version."""
        while self.version < version:
            self.arrived.clear()
            await self.arrived.wait()

    async def open(self, uri: str, text: str) -> float:
        """Open a document; the seconds until its findings."""
        begin = time.perf_counter()
        item = types.TextDocumentItem(uri, "nctakt", 0, text)
        self.client.text_document_did_open(types.DidOpenTextDocumentParams(item))
        await self.findings_of(0)
        return time.perf_counter() - begin

    async def keystroke(self, uri: str, version: int, line: int) -> float:
        """Write a digit into a line; the seconds until its findings."""
        begin = time.perf_counter()
        position = types.Position(line, 3)
        change = types.TextDocumentContentChangePartial(types.Range(position, position), "1")
        self.client.text_document_did_change(
            types.DidChangeTextDocumentParams(
                types.VersionedTextDocumentIdentifier(version, uri), [change]
            )
        )
        await self.findings_of(version)
        return time.perf_counter() - begin

    def memory_mb(self) -> float:
        """The greatest memory of the server so far."""
        server = self.client._server
        assert server is not None
        status = Path(f"/proc/{server.pid}/status").read_text("ascii")
        line = next(line for line in status.splitlines() if line.startswith("VmHWM"))
        return int(line.split()[1]) / 1024


async def _median(request: Callable[[int], Awaitable[object]], count: int) -> float:
    times = []
    for number in range(count):
        begin = time.perf_counter()
        await request(number)
        times.append(time.perf_counter() - begin)
    return statistics.median(times)


async def measure_start() -> None:
    """Print the time of a start."""
    times = []
    for _ in range(STARTS):
        measured = Measured()
        times.append(await measured.start())
        await measured.stop()
    print(f"start: {statistics.median(times):.2f} s (at most 0.5), best {min(times):.2f} s")


async def measure_keystrokes(folder: Path) -> None:
    """Print what a program of 10,000 lines costs."""
    path = folder / "part.nc"
    path.write_text(program(LINES))
    uri = path.as_uri()
    measured = Measured()
    await measured.start()
    await measured.open(uri, path.read_text())
    lines = random.Random(2)
    times = [
        await measured.keystroke(uri, number, 50 + lines.randrange(LINES - 200) // 100 * 100)
        for number in range(1, KEYSTROKES + 1)
    ]
    print(f"findings in {LINES} lines: {1000 * statistics.median(times):.0f} ms (at most 100)")
    document = types.TextDocumentIdentifier(uri)

    async def hover(number: int) -> object:
        position = types.Position(100 * number + 2, 15)
        return await measured.client.text_document_hover_async(
            types.HoverParams(document, position)
        )

    async def complete(number: int) -> object:
        position = types.Position(100 * number + 3, 4)
        return await measured.client.text_document_completion_async(
            types.CompletionParams(document, position)
        )

    print(f"explanation: {1000 * await _median(hover, REQUESTS):.1f} ms (at most 20)")
    print(f"completion: {1000 * await _median(complete, REQUESTS):.1f} ms (at most 20)")
    await measured.stop()


async def measure_structured(folder: Path) -> None:
    """Print what a PLC project of many files costs: a keystroke in a body, in a declaration."""
    texts = project(PLC_LINES)
    for name, text in texts.items():
        (folder / name).write_bytes(text)
    path = folder / "FB_Station7.st"
    lines = path.read_text("utf-8").splitlines()
    measured = Measured()
    await measured.start()
    first = await measured.open(path.as_uri(), path.read_text("utf-8"))
    print(f"{PLC_LINES} lines of Structured Text: opened in {first:.2f} s")
    version = 0
    for what, begin in (("a body", "rtStart(CLK"), ("a declaration", "    rtStart")):
        line = next(index for index, one in enumerate(lines) if one.startswith(begin))
        times = []
        for _ in range(KEYSTROKES):
            version += 1
            times.append(await measured.keystroke(path.as_uri(), version, line))
            await asyncio.sleep(0.1)  # nobody types faster
        median, worst = 1000 * statistics.median(times), 1000 * max(times)
        print(f"findings, typing in {what}: {median:.0f} ms (at most 100), worst {worst:.0f} ms")
    await measured.stop()


async def measure_long(folder: Path) -> None:
    """Print what a program of a million lines costs."""
    path = folder / "long.nc"
    path.write_text(cam_program(LONG_LINES))
    measured = Measured()
    await measured.start()
    first = await measured.open(path.as_uri(), path.read_text())
    times = [
        await measured.keystroke(path.as_uri(), number, 100_000 * number)
        for number in range(1, LONG_KEYSTROKES + 1)
    ]
    print(f"{LONG_LINES} lines: opened in {first:.1f} s")
    print(f"findings in them: {1000 * statistics.median(times):.0f} ms (at most 500)")
    print(f"memory of the server: {measured.memory_mb():.0f} MB (at most 300)")
    await measured.stop()


async def main() -> None:
    """Measure all of it."""
    with tempfile.TemporaryDirectory() as name:
        await measure_start()
        await measure_keystrokes(Path(name))
        await measure_structured(Path(name))
        await measure_long(Path(name))


if __name__ == "__main__":
    asyncio.run(main())
