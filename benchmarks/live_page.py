# SPDX-License-Identifier: MIT
"""``python -m benchmarks.live_page``, and the page part of ``python -m benchmarks.live``.

Chromium in front of ``nctakt live``. By itself, with a program of a million lines:

- First paint, and until its lines are there: at most 1 s, server and browser warm.
- ``max`` beside ``Controller.run`` of the same program: at least 0.7 of its speed.
- A pause is drawn within 100 ms of the press, at "max" and after an hour of 1 ms ticks.
- Travel to any place of this hour is drawn within 0.5 s, and so is the answer to why a condition is
  as it is there, asked for the first time.

With ``benchmarks.live``:

- First paint: at most 1.5 s after the address is opened, server and browser warm.
- Frames: 20 a second with 12 signals while 1 ms ticks run on the wall clock.
- No late slice of 10 ms while the page is open, beside a thread that only sleeps.

A browser without a graphics card computes for its picture as much as two cores can, so it has one
of its own here: as if it ran on another machine.

- The memory of server and browser: flat over ten minutes.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from nctakt import Controller, NcText

#: V.E variables that the program names, so that the scope shows 12 signals with X, Y and speed.
_VARIABLES = [f"V.E.LIST[{index}]" for index in range(9)]

#: Ways through the program, which lasts longer than any measurement.
_BLOCKS = 20_000


#: Lines of a long program, and ticks of an hour of 1 ms.
_LINES, _HOUR = 1_000_000, 3_600_000


def _program(blocks: int = _BLOCKS) -> str:
    branches = "\n".join(
        f"  $IF EDGE V.RTA.ACS.ACT_POS.X > {10 * index + 5}\n    {name} += 1\n  $ENDIF"
        for index, name in enumerate(_VARIABLES)
    )
    lines = (f"G01 X{100 * (number % 2)} Y{number % 7} F6000" for number in range(blocks))
    return "\n".join(["#RT CYCLE [ID=1 SCOPE=PROG]", branches, "#RT CYCLE END", *lines, "M30", ""])


@contextlib.contextmanager
def _served(folder: Path, text: str) -> Iterator[tuple[str, int]]:
    """The page of a program in its own process: its address and its process."""
    path = folder / "part.nc"
    path.write_text(text, "utf-8")
    command = [sys.executable, "-m", "nctakt", "live", str(path), "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, encoding="utf-8") as process:
        try:
            assert process.stdout is not None
            yield process.stdout.readline().strip(), process.pid
        finally:
            process.send_signal(signal.SIGINT)
            process.wait(60)


def _family(pid: int) -> list[int]:
    """A process with all that it has started."""
    found = [pid]
    for folder in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            parent = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
            if parent == pid:
                found += _family(int(folder.name))
    return found


@contextlib.contextmanager
def _other_cores(server: int) -> Iterator[None]:
    """Leave the last core to the browser and this process, the others to the server."""
    cores = sorted(os.sched_getaffinity(0))
    if len(cores) > 1:
        for process in _family(server):
            for thread in Path(f"/proc/{process}/task").iterdir():
                os.sched_setaffinity(int(thread.name), cores[:-1])
        os.sched_setaffinity(0, cores[-1:])
    try:
        yield
    finally:
        os.sched_setaffinity(0, cores)


def _memory_mib(pid: int) -> float:
    """The memory of its own process, in MiB (that of its parked controllers is shared)."""
    for line in Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) / 1024
    return 0.0


def _heap_mib(page: Any) -> float:
    """What the page's scripts hold once their garbage is gone, in MiB."""
    link = page.context.new_cdp_session(page)
    link.send("HeapProfiler.collectGarbage")
    used = link.send("Runtime.getHeapUsage")["usedSize"]
    link.detach()
    return float(used) / 2**20


class _Sleeper(threading.Thread):
    """A thread that only sleeps: how late the machine itself is, in ms."""

    def __init__(self) -> None:
        super().__init__(daemon=True)
        self.late_ms: list[float] = []
        self.ends = False

    def run(self) -> None:
        """Sleep for 10 ms at a time, by absolute times."""
        due = time.monotonic()
        while not self.ends:
            due += 0.010
            time.sleep(max(0.0, due - time.monotonic()))
            self.late_ms.append(1000 * (time.monotonic() - due))


def measure_page(seconds: float, minutes: float) -> None:
    """Print what the page costs: ``seconds`` on the wall clock, ``minutes`` for the memory."""
    chromium = shutil.which("chromium")
    try:
        from playwright.sync_api import sync_playwright  # noqa: PLC0415 - it may be missing
    except ImportError:
        chromium = None
    if chromium is None:
        print("page: not measured, Chromium or Playwright is missing")
        return
    with (
        tempfile.TemporaryDirectory() as folder,
        _served(Path(folder), _program()) as (address, pid),
        _other_cores(pid),
        sync_playwright() as driver,
        contextlib.closing(
            driver.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        ) as browser,
    ):
        page = _second_page(browser, address)
        page.set_default_timeout(60_000)
        _measure_paint(page, address)
        page.get_by_test_id("control").click()
        page.get_by_test_id("toggle").click()
        page.wait_for_timeout(3000)
        _measure_frames(page, seconds)
        _measure_memory(page, pid, minutes)


def _second_page(browser: Any, address: str) -> Any:
    """Return a page of a browser that has shown this one before: its scripts are there."""
    context = browser.new_context(viewport={"width": 1280, "height": 800})
    first = context.new_page()
    first.goto(address)
    first.wait_for_function("globalThis.nctaktFrames?.count > 0")
    first.close()
    return context.new_page()


def _measure_paint(page: Any, address: str) -> None:
    begin = time.perf_counter()
    page.goto(address)
    page.wait_for_function("globalThis.nctaktFrames?.count > 0")
    shown_s = time.perf_counter() - begin
    paint_ms = page.evaluate(
        "performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? 0"
    )
    paint = f"{paint_ms / 1000:8.2f} s, live after {shown_s:.2f} s"
    print(f"page: first paint           {paint} (goal 1 s)")


def _measure_frames(page: Any, seconds: float) -> None:
    sleeper = _Sleeper()
    sleeper.start()
    begin = page.evaluate("[performance.now(), nctaktFrames.count, nctaktRun.run.tick]")
    late_before = _late_slices(page)
    page.wait_for_timeout(1000 * seconds)
    end = page.evaluate("[performance.now(), nctaktFrames.count, nctaktRun.run.tick]")
    sleeper.ends = True
    passed_s = (end[0] - begin[0]) / 1000
    signals = page.evaluate("nctaktRun.run.names.filter((name) => !name.startsWith('$')).length")
    rate = (end[1] - begin[1]) / passed_s
    print(f"page: frames with {signals} signals  {rate:8.1f} a second")
    own = sorted(sleeper.late_ms)
    late_slices = _late_slices(page) - late_before
    print(f"page: {end[2] - begin[2]} ticks in {passed_s:.1f} s, {late_slices} late slices")
    p99 = own[int(0.99 * len(own))]
    late = sum(1 for one in own if one > 10)
    print(f"      a thread that only sleeps: {late} late, p99 {p99:.1f}, worst {own[-1]:.1f} ms")


def _late_slices(page: Any) -> int:
    found = re.search(r"late slices: (\d+)", page.get_by_test_id("clock").inner_text())
    return 0 if found is None else int(found[1])


def _measure_memory(page: Any, pid: int, minutes: float) -> None:
    print("page: memory in MiB         server  worker  scripts")
    begin = time.monotonic()
    for part in range(6):
        page.wait_for_timeout(max(0.0, 1000 * (begin + 12 * minutes * part - time.monotonic())))
        worker = next((one for one in _family(pid)[1:]), pid)
        numbers = (_memory_mib(pid), _memory_mib(worker), _heap_mib(page))
        row = " ".join(f"{number:7.1f}" for number in numbers)
        print(f"      after {(time.monotonic() - begin) / 60:5.1f} min      {row}", flush=True)


def measure_long() -> None:
    """Print what the page costs with a program of a million lines."""
    from playwright.sync_api import sync_playwright  # noqa: PLC0415 - it may be missing

    text = _program(_LINES)
    begin = time.perf_counter()
    Controller().run(NcText("part.nc", text), ticks=_HOUR, memory_trace=False)
    run_speed = _HOUR / (time.perf_counter() - begin)
    with (
        tempfile.TemporaryDirectory() as folder,
        _served(Path(folder), text) as (address, pid),
        _other_cores(pid),
        sync_playwright() as driver,
        contextlib.closing(
            driver.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        ) as browser,
    ):
        page = _second_page(browser, address)
        page.set_default_timeout(120_000)
        _measure_paint(page, address)
        begin = time.perf_counter()
        page.goto(address)
        page.wait_for_function("document.querySelector('.cm-line .nc-t-macro')")
        print(f"page: lines and colours     {time.perf_counter() - begin:8.2f} s")
        page.get_by_test_id("control").click()
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="max").click()
        _measure_max(page, run_speed)


def _measure_max(page: Any, run_speed: float) -> None:
    page.get_by_test_id("toggle").click()
    page.wait_for_function("nctaktRun.run.tick > 100000")
    begin = page.evaluate("[performance.now(), nctaktRun.run.tick]")
    page.wait_for_function(f"nctaktRun.run.tick > {_HOUR}")
    end = page.evaluate("[performance.now(), nctaktRun.run.tick]")
    speed = 1000 * (end[1] - begin[1]) / (end[0] - begin[0])
    share = speed / run_speed
    print(
        f"page: max                   {speed:8.0f} ticks/s, {share:.2f} of {run_speed:.0f} of run "
        "(goal 0.7)"
    )
    _measure_pauses(page)
    _measure_past(page)


#: Notes when the button is pressed, and when a pause has been drawn, both by the browser's clock.
_WATCH_PRESS = """() => {
  globalThis.pressed = globalThis.paused = 0;
  document.addEventListener("pointerdown", ({ timeStamp }) => { globalThis.pressed = timeStamp; },
    { capture: true, once: true });
  const stop = nctaktRun.listen(() => {
    if (!globalThis.pressed || nctaktRun.run.isPlaying) return;
    globalThis.paused = performance.now();
    stop();
  });
}"""

#: Travels, or asks why in a line; resolves to how long it takes until that is drawn, in ms.
_TRAVEL = """(tick) => new Promise((resolve) => {
  const begin = performance.now(), scope = document.querySelector("[data-testid=scope]");
  const stop = nctaktRun.listen(() => {
    if (nctaktRun.run.tick !== tick) return;
    stop();
    resolve(performance.now() - begin);
  });
  getElement(Number(scope.id.slice(1))).$emit("travel", tick);
})"""
_WHY = """(tick) => new Promise((resolve) => {
  const begin = performance.now(), holder = document.querySelector("[data-testid=why]");
  const before = holder?.textContent;
  emitEvent("nctakt_line", { what: "why", line: 2 });
  const look = () => {
    const text = document.querySelector("[data-testid=why]")?.textContent ?? "";
    if (text !== before && text.includes(`${tick}`)) resolve(performance.now() - begin);
    else requestAnimationFrame(look);
  };
  look();
})"""

#: Pauses, and places of the past, that are measured.
_REPEATS = 6


def _measure_pauses(page: Any) -> None:
    """Press the button while the run is as fast as it can be; the first time after an hour."""
    box = page.get_by_test_id("toggle").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    passed = []
    for _ in range(_REPEATS):
        page.evaluate(_WATCH_PRESS)
        page.mouse.click(x, y)
        page.wait_for_function("globalThis.paused > 0")
        passed.append(page.evaluate("globalThis.paused - globalThis.pressed"))
        page.mouse.click(x, y)
        page.wait_for_function("nctaktRun.run.isPlaying")
        page.wait_for_timeout(1000)
    page.mouse.click(x, y)
    page.wait_for_function("!nctaktRun.run.isPlaying")
    _print_times("pause", passed, 100)


def _measure_past(page: Any) -> None:
    """Travel to places in each part of the hour, and ask why at each of them."""
    page.wait_for_timeout(5000)  # a person looks first
    travels, answers = [], []
    for part in (4, 1, 5, 2, 0, 3):
        tick = _HOUR * (2 * part + 1) // (2 * _REPEATS)
        travels.append(page.evaluate(_TRAVEL, tick))
        answers.append(page.evaluate(_WHY, tick))
    _print_times("travel", travels, 500)
    _print_times("why, the first time", answers, 500)


def _print_times(name: str, times_ms: list[float], goal_ms: float) -> None:
    middle, worst = statistics.median(times_ms), max(times_ms)
    print(f"page: {name:22}{middle:8.0f} ms, at most {worst:.0f} ms (goal {goal_ms:.0f} ms)")


if __name__ == "__main__":
    measure_long()
