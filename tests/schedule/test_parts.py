# SPDX-License-Identifier: MIT
"""The parts of the interpolation in the order of ``schedule`` (P-RTCF-00018), and the dead time."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.schedule_examples import EXAMPLE_1, TIGHT, load_text, make, with_line

from nctakt.cli import main
from nctakt.schedule.model import PARTS, Model
from nctakt.schedule.simulation.interpolation_steps import dead_times, parts_of
from nctakt.schedule.simulation.simulate import simulate

Capture = pytest.CaptureFixture[str]
GIVEN = "task_int = { input = 50, interpolation = 310, output = 40 }"
LOAD = load_text(TIGHT).replace("task_int = 400", GIVEN)
ORDERS = {
    "STANDARD": [("output", 0, 40), ("input", 40, 90), ("interpolation", 90, 400)],
    "COMPLETE": [("input", 0, 50), ("interpolation", 50, 360), ("output", 360, 400)],
    "SWITCHED": [("input", 0, 50), ("interpolation", 50, 360), ("output", 360, 400)],
}


def model_of(schedule: str, *lines: str, load: str = LOAD) -> Model:
    """The first example with parts and another order."""
    model, found = make(with_line(EXAMPLE_1, f"schedule {schedule}", *lines), load)
    assert [number for number in found if number != 900600] == []
    return model


@pytest.mark.parametrize("schedule", ORDERS)
def test_order(schedule: str) -> None:
    """STANDARD: output of the cycle before, input, interpolation; the others: output last."""
    model = model_of(schedule)
    found = parts_of(model, simulate(model, 2, record=2).record)
    expected = [
        (name, 2000 * cycle + begin, 2000 * cycle + end)
        for cycle in range(2)
        for name, begin, end in ORDERS[schedule]
    ]
    shown = [(PARTS[one.part], one.begin // 1000, one.end // 1000) for one in found]
    assert shown == expected
    assert {one.task for one in found} == {0}


def test_dead_time() -> None:
    """STANDARD puts out one cycle after it has read; the others at the end of the call."""
    assert dead_times(model_of("STANDARD")) == [("GEO", 2_000_000)]
    assert dead_times(model_of("SWITCHED")) == [("GEO", 400_000)]
    assert dead_times(model_of("STANDARD", load=load_text(TIGHT))) == []


def test_threads_run_as_without_parts() -> None:
    """No effect on the timing of threads."""
    for schedule in ORDERS:
        one = simulate(model_of(schedule), 60)
        assert one.tasks == simulate(model_of("STANDARD", load=load_text(TIGHT)), 60).tasks


def test_interrupted_parts() -> None:
    """What a more urgent external thread interrupts goes on after it."""
    model = model_of("SWITCHED", load=LOAD.replace("priority = 110", "priority = 120"))
    found = parts_of(model, simulate(model, 1, record=1).record)
    assert [(one.begin // 1000, one.end // 1000) for one in found] == [
        (200, 250),
        (250, 560),
        (560, 600),
    ]
    load = LOAD.replace("310", "2500").replace("priority = 110", "priority = 120")
    overload = model_of("SWITCHED", load=load)
    pieces = parts_of(overload, simulate(overload, 2, record=2).record)
    assert [(PARTS[one.part], one.begin // 1000, one.end // 1000) for one in pieces] == [
        ("input", 200, 250),
        ("interpolation", 250, 2000),
        ("interpolation", 2200, 2950),
        ("output", 2950, 2990),
    ]


def test_report_picture_and_trace(tmp_path: Path, capsys: Capture) -> None:
    """The report shows the dead time; picture and Perfetto trace show the parts."""
    (tmp_path / "rtconf.lis").write_text(EXAMPLE_1, "utf-8")
    (tmp_path / "load.toml").write_text(LOAD, "utf-8")
    words = [str(tmp_path / "rtconf.lis"), "--load", str(tmp_path / "load.toml")]
    files = ["--plot", str(tmp_path / "a.svg"), "--perfetto", str(tmp_path / "a.json")]
    assert main(["schedule", "simulate", *words, *files, "--convention", "table"]) == 0
    assert (
        "schedule STANDARD: GEO outputs 2000 µs after it starts reading" in capsys.readouterr().out
    )
    assert "interpolation: 90 … 400 µs" in (tmp_path / "a.svg").read_text("utf-8")
    events = json.loads((tmp_path / "a.json").read_text("utf-8"))["traceEvents"]
    output = next(one for one in events if one["name"] == "output")
    assert (output["ts"], output["dur"], output["tid"]) == (0, 40, 1)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (GIVEN, "task_int = { input = 50, output = 40 }"),
        (GIVEN, "task_int = { input = 50, interpolation = -1, output = 40 }"),
        ("task_rnd = 700", GIVEN.replace("task_int", "task_rnd")),
        ("time = 200", GIVEN.replace("task_int", "time")),
    ],
)
def test_parts_that_cannot_be(before: str, after: str) -> None:
    """900623: a part is missing or negative, or it is no interpolation."""
    load = LOAD.replace(before, after)
    assert load != LOAD
    assert 900623 in make(EXAMPLE_1, load)[1]
