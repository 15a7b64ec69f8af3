# SPDX-License-Identifier: MIT
"""Same inputs, same bytes of trace: run twice, with other hash seeds, cut into pieces, compiled or
plain, with other buffers, beside another controller."""

from __future__ import annotations

import functools
import json
import os
import random
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from support import trace_digests
from support.insides import machine_of
from support.program_generator import program
from support.trace_digests import DEMO, MAX_TICKS, SEEDS, random_trace

from nctakt.kernel.base.record import Record
from nctakt.results.trace.sinks import CsvSink
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime import realtime_part

pytestmark = pytest.mark.slow

HERE = Path(__file__).parent


def digests(hash_seed: str, plain: bool) -> dict[str, Any]:
    """The digests that another process finds."""
    environment = {
        name: value for name, value in os.environ.items() if not name.startswith("NCTAKT_")
    }
    environment["PYTHONHASHSEED"] = hash_seed
    if plain:
        environment["NCTAKT_PLAIN"] = "1"
    done = subprocess.run(
        [sys.executable, HERE / "support" / "trace_digests.py"],
        env=environment,
        check=True,
        capture_output=True,
        text=True,
    )
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def differences(left: dict[str, str], right: dict[str, str]) -> list[str]:
    """The programs whose traces differ."""
    assert list(left) == list(right)
    return [name for name in left if left[name] != right[name]]


def test_traces_depend_neither_on_the_hash_seed_nor_on_the_compiler() -> None:
    """Two orders of sets and plain Python give the same bytes; other programs give others."""
    first, second, plain = digests("1", False), digests("2", False), digests("0", True)
    assert plain["compiled"] is False
    assert differences(first["digests"], second["digests"]) == []
    assert differences(first["digests"], plain["digests"]) == []
    found = first["digests"]
    assert len({found[f"seed {seed}"] for seed in SEEDS}) == len(SEEDS)
    assert set(trace_digests.run_folders.FOLDERS) < set(found)


@pytest.mark.nightly
def test_a_run_can_be_repeated(tmp_path: Path) -> None:
    """The same program in two controllers of one process writes the same bytes."""
    for seed in SEEDS:
        assert random_trace(seed, tmp_path / "a.csv") == random_trace(seed, tmp_path / "b.csv")


def test_random_programs_do_something(tmp_path: Path) -> None:
    """The programs of these tests run, move, fire and end in different ways."""
    states, kinds = set(), set()
    for seed in SEEDS:
        run = Controller(DEMO).run(NcText("p.nc", program(seed)), ticks=MAX_TICKS)
        states.add(run.state)
        kinds |= {event.kind for event in run.events}
        assert run.ticks > 20, seed
    assert states >= {"ended", "error"}
    assert kinds >= {
        "created",
        "started",
        "held",
        "continued",
        "aborted",
        "ended",
        "fired",
        "written",
        "M",
        "output",
        "message",
        "notice",
        "error",
        "end",
    }


# --- cut into pieces ----------------------------------------------------------------------------


def pieces(seed: int, total: int, file: Path) -> list[str]:
    """The lines of the trace of a run that stops after random numbers of ticks and goes on."""
    chance = random.Random(seed)
    controller = Controller(DEMO)
    lines: list[str] = []
    first = chance.randint(1, 5)
    controller.run(
        NcText(f"p{seed}.nc", program(seed)), ticks=first, sinks=[CsvSink(file)], memory_trace=False
    )
    while True:
        text = file.read_text("utf-8").splitlines()
        lines += text if not lines else text[1:]
        if controller.tick >= total:
            return lines
        ticks = min(chance.choice((1, 1, 2, 3, 7, 50, 333)), total - controller.tick)
        # Without the limit a run goes on until what moves is (RC-006).
        controller.run(
            after=f"{ticks} ticks", ticks=ticks, sinks=[CsvSink(file)], memory_trace=False
        )


@pytest.mark.nightly
@pytest.mark.parametrize("seed", SEEDS)
def test_a_run_cut_into_pieces_is_the_same_run(seed: int, tmp_path: Path) -> None:
    """Whether 4,000 ticks run at once or in pieces of 1 to 333 changes no byte of the trace."""
    whole = random_trace(seed, tmp_path / "whole.csv").decode().splitlines()
    total = len(whole) - 1
    assert pieces(seed, total, tmp_path / "piece.csv") == whole


@pytest.mark.parametrize("seed", range(8))
def test_single_steps_end_in_the_same_state(seed: int) -> None:
    """``step(1)`` again and again leaves the memory that one ``step`` of all ticks leaves."""
    text = NcText("p.nc", program(seed))
    one, many = Controller(DEMO), Controller(DEMO)
    one.start(text)
    one.step(1500)
    many.start(text)
    for _ in range(1500):
        many.step()
    assert bytes(machine_of(one).memory) == bytes(machine_of(many).memory)
    assert one.diagnostics == many.diagnostics


@pytest.mark.nightly
@pytest.mark.parametrize("seed", range(0, 30, 3))
def test_the_size_of_the_record_changes_nothing(
    seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Buffers of a few rows, events and probes are emptied more often, with the same trace."""
    whole = random_trace(seed, tmp_path / "whole.csv")
    for rows, events, probes in ((1, 1, 1), (7, 3, 2), (100_000, 50_000, 50_000)):
        small = functools.partial(
            Record, row_capacity=rows, event_capacity=events, probe_capacity=probes
        )
        monkeypatch.setattr(realtime_part, "Record", small)
        assert random_trace(seed, tmp_path / "small.csv") == whole


@pytest.mark.parametrize("seed", range(0, 30, 5))
def test_two_controllers_do_not_know_of_each_other(seed: int) -> None:
    """Two machines that run in turns, tick by tick, end as each of them ends alone."""
    chance = random.Random(seed)
    texts = [NcText("p.nc", program(seed)), NcText("p.nc", program(seed + 1))]
    alone = [Controller(DEMO) for _ in texts]
    together = [Controller(DEMO) for _ in texts]
    for group in (alone, together):
        for controller, text in zip(group, texts, strict=True):
            controller.start(text)
    for controller in alone:
        controller.step(1200)
    while any(controller.tick < 1200 for controller in together):
        controller = chance.choice([one for one in together if one.tick < 1200])
        controller.step(min(chance.choice((1, 2, 11)), 1200 - controller.tick))
    for one, other in zip(alone, together, strict=True):
        assert bytes(machine_of(one).memory) == bytes(machine_of(other).memory)
        assert one.diagnostics == other.diagnostics
