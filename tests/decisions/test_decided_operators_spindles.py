# SPDX-License-Identifier: MIT
"""Decisions on the operator's override of spindles, and G167.

Public manuals: pages 287497867, 208171531, 208227851, 208269707. ``docs/conformance/spindles.md``
says what is decided. The spindle S of the demo machine gains 1000 1/min in 167 ms.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
from support.decided import numbers, perform, reported
from support.run_folders import changed_machine

from nctakt.lists.machine.machine import load_machine
from nctakt.messages.axes.spindles import NOT_A_SPINDLE_WORD, SPINDLE_WORD_COUNT
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.results.run import Run
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller


def run_of(*lines: str, at: Mapping[int, float] | None = None, spindle: str = "S") -> Run:
    """A run with the override of a spindle at these ticks, % (50 % from the start on)."""
    stimuli = [
        Stimulus(f"{tick} ticks", f"HLI.{spindle}.OVERRIDE", value)
        for tick, value in (at or {0: 50.0}).items()
    ]
    signals = [f"{spindle}.SPEED", f"{spindle}.POSITION", f"{spindle}.OVERRIDE", "PATH.SPEED"]
    return perform("\n".join([*lines, "M30"]), at=stimuli, signals=signals)


def speed_at(run: Run, tick: int, spindle: str = "S") -> float:
    assert run.trace is not None
    return float(run.trace[f"{spindle}.SPEED"][tick])


def test_the_example_of_the_manual() -> None:
    """208171531: 500 1/min at 50 %, 1000 with G167, 1500 with the next S."""
    run = run_of("M3 S1000", "G04 1", "G167 S1000", "G04 1", "S3000", "G04 1")
    assert numbers(run) == []
    assert [speed_at(run, tick) for tick in (999, 1999, 2999)] == [500.0, 1000.0, 1500.0]


def test_a_spindle_in_brackets() -> None:
    """208227851; G167 alone begins no job of its own, a speed beside it counts."""
    run = run_of(
        "S2[M3 REV1000]", "G04 1", "S2[G167]", "G04 1", "S2[G167 REV800]", "G04 1", "S2[REV3000]",
        "G04 1", spindle="S2",
    )  # fmt: skip
    assert numbers(run) == []
    found = [speed_at(run, tick, "S2") for tick in (999, 1999, 2999, 3999)]
    assert found == [500.0, 1000.0, 800.0, 1500.0]
    assert numbers(run_of("S[G167]", "G04 0.1")) == []


def test_the_value_of_g167_has_no_significance() -> None:
    """208171531: the speed stays; with M3 or M4 S is the speed of the job."""
    run = run_of("M3 S1000", "G04 1", "G167 S1", "G04 1", "G167 M3 S600", "G04 1")
    assert [speed_at(run, tick) for tick in (1999, 2999)] == [1000.0, 600.0]


def test_both_overrides_multiply() -> None:
    """208269707: that of the program goes on after G167."""
    run = run_of("M3 S1000", "S[OVERRIDE SPEED_FACT=40]", "G04 1", "G167 S1", "G04 1")
    assert [speed_at(run, tick) for tick in (999, 1999)] == [200.0, 400.0]


def test_a_change_acts_at_once_within_the_acceleration() -> None:
    """From the tick in which the PLC writes it."""
    run = run_of("M3 S1000", "G04 2", at={500: 20.0, 1000: 90.0})
    assert run.trace is not None
    speed = np.asarray(run.trace["S.SPEED"])
    assert np.flatnonzero(np.diff(speed[:1000]) < 0.0)[0] == 499
    assert [speed[tick] for tick in (499, 999, 1999)] == [1000.0, 200.0, 900.0]
    assert np.abs(np.diff(speed)).max() == pytest.approx(6.0)


@pytest.mark.parametrize(("highest", "speed"), [(1000, 600.0), (1500, 900.0)])
def test_the_list_bounds_it(tmp_path: Path, highest: int, speed: float) -> None:
    """P-AXIS-00109, 100 % by default."""
    entries = {"achs_mds5.lis": [f"kenngr.max_vb_override {highest}"]}
    machine = load_machine(changed_machine(entries, tmp_path / "machine"))
    at = [Stimulus("0 s", "HLI.S.OVERRIDE", 200.0)]
    run = perform("M3 S600\nG04 1\nM30", Controller(machine), at=at, signals=["S.SPEED"])
    assert speed_at(run, 900) == speed


def test_at_zero_a_job_waits() -> None:
    """It stays open, also a positioning; M5 does not wait."""
    run = run_of("M3 S600", "G04 1", "M5", at={0: 0.0, 400: 100.0})
    assert speed_at(run, 399) == 0.0
    assert reported(run, "spindle_reached") == ["499 spindle_reached S", "1099 spindle_reached S"]
    run = run_of("M3 S600", "G04 1", "M19 S.POS=90", "G04 1", at={1100: 0.0, 1500: 100.0})
    assert run.trace is not None
    position = np.asarray(run.trace["S.POSITION"])
    assert position[-1] == 90.0
    assert len(set(position[1300:1500])) == 1


def test_a_positioning_is_slower() -> None:
    """287497867: the speed of endless jobs and of positioning."""
    ends = [
        int(reported(run_of("M19 S.POS=180 S60", at={0: pct}), "spindle_reached")[0].split()[0])
        for pct in (100.0, 50.0)
    ]
    assert 1.8 * ends[0] < ends[1] < 2.2 * ends[0]


def test_the_feed_per_revolution_follows() -> None:
    """G95: the path is half as fast."""
    run = run_of("M3 S1000", "G95 G01 X20 F1")
    assert run.trace is not None
    assert np.asarray(run.trace["PATH.SPEED"]).max() == pytest.approx(500.0 / 60.0)


def test_a_thread_keeps_its_override() -> None:
    """The change counts after G33."""
    run = run_of("M3 S300", "G04 1", "G33 Z-10 K1", "G04 1", at={1200: 50.0})
    assert run.state == "ended", run.diagnostics
    assert speed_at(run, 2500) == 300.0
    assert speed_at(run, run.ticks - 1) == 150.0


@pytest.mark.parametrize(
    ("line", "number"),
    [
        ("G167", INVALID_COMMAND_FORM.id),
        ("G167 X1", INVALID_COMMAND_FORM.id),
        ("S2[G166]", NOT_A_SPINDLE_WORD.id),
        ("#RT CYCLE [ID=1 SCOPE=PROG]\nS2[G167 M3 S100]\n#RT CYCLE END", SPINDLE_WORD_COUNT.id),
    ],
)
def test_mistakes(line: str, number: int) -> None:
    """G167 is beside a spindle; cycles have no such word."""
    assert number in numbers(perform(f"{line}\nM30"))
