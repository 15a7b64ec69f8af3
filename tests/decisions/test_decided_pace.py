# SPDX-License-Identifier: MIT
"""Decisions on feeds by time and revolution, and on overrides of the program (MO-4, MO-5)."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.decided import numbers, perform
from support.run_folders import changed_machine

from nctakt.results.run import Run
from nctakt.run.controller import Controller

SIGNALS = ["X.ACS.ACT_POS", "PATH.SPEED", "OVERRIDE.VEL.TOTAL", "BLOCK"]


def moved(program: str, **settings: object) -> Run:
    """A run with position, speed and override."""
    run = perform(program + "\nM30", signals=SIGNALS, **settings)
    assert run.state == "ended", run.diagnostics
    return run


def at(run: Run, tick: int, signal: str) -> float:
    """A value after a tick."""
    assert run.trace is not None
    return run.trace.at(tick, signal)


@pytest.mark.parametrize("words", ["G93 X10", "G95 M3 S100 X10"])
def test_each_kind_of_feed_needs_its_own_f(words: str) -> None:
    """MO-17: that of G94, here from the channel list, counts under no other."""
    assert numbers(perform(f"G01 {words}\nM30")) == [20008]


def test_a_time_is_not_in_inches() -> None:
    """10 inch in 5.08 s are 50 mm/s, under G70 as well."""
    assert at(moved("G70 G93 G01 X10 F5.08"), 1000, "PATH.SPEED") == pytest.approx(50.0)


def test_the_time_of_a_helix_is_that_of_its_whole_way() -> None:
    """A full circle of 10 mm about Z with 20 mm of rise: the way is √((20π)² + 20²) mm."""
    run = moved("G93 F2 G17 G02 I10 Z20")
    way = ((20 * 3.141592653589793) ** 2 + 20**2) ** 0.5
    assert at(run, 1000, "PATH.SPEED") == pytest.approx(way / 2)


def test_more_feed_by_time_than_the_axes_can_do_is_limited() -> None:
    """MO-17: 400 mm in 1 ms are driven at 500 mm/s."""
    assert at(moved("G93 G01 X400 F0.001"), 400, "PATH.SPEED") == 500.0


def test_feed_per_revolution_is_in_inches_under_g70() -> None:
    """0.1 inch in a revolution, 600 of them in a minute: 25.4 mm/s."""
    run = moved("M3 S600\nG04 X1\nG70 G95 F0.1\nG01 X10")
    assert at(run, 1500, "PATH.SPEED") == pytest.approx(25.4)


@pytest.mark.parametrize("spindle", ["", "S500\n", "M3\n", "M3 S500\nM5\n", "M19 S100 S.POS90\n"])
def test_feed_per_revolution_needs_a_spindle_that_turns(spindle: str) -> None:
    """22044: a direction and a speed in the same program."""
    assert numbers(perform(f"{spindle}G95 F1 G01 X10\nM30")) == [22044]


def test_the_path_stops_while_the_spindle_does() -> None:
    """A realtime cycle stops the spindle after 5 mm; the path brakes with it."""
    run = perform(
        "M3 S600\nG04 X1\n"
        "#RT CYCLE [SCOPE=PROG]\n"
        "$IF ONCE V.RTA.ACS.ACT_POS.X > 5\nM5\n$ENDIF\n"
        "#RT CYCLE END\n"
        "G95 F1 G01 X20\nM30",
        signals=SIGNALS,
        ticks=4000,
    )
    assert run.state == "limit"
    assert at(run, 3999, "PATH.SPEED") == 0.0
    # 600/min take 0.1 s to a standstill: half a revolution, 0.5 mm.
    assert at(run, 3999, "X.ACS.ACT_POS") == pytest.approx(5.5, abs=0.03)


def test_a_spindle_of_the_plc_counts_with_what_is_programmed(tmp_path: Path) -> None:
    """Its speed is not known: 1 mm · 600/min are 10 mm/s from the begin on."""
    changes = ["spindel[0].plc_control 1", "spindel[0].m3_synch MOS"]
    machine = changed_machine({"sda_mds1.lis": changes}, tmp_path / "machine")
    run = perform("M3 S600\nG95 F1\nG01 X20\nM30", Controller(machine), signals=SIGNALS)
    assert at(run, 20, "PATH.SPEED") == pytest.approx(10.0)


def test_feed_per_revolution_needs_a_main_spindle(tmp_path: Path) -> None:
    """21980: the channel list names none."""
    lines = ["spdl_anzahl 0", "main_spindle_ax_nr 0"]
    machine = changed_machine({"sda_mds1.lis": lines}, tmp_path / "machine")
    run = perform("G95 F1 G01 X20\nM30", Controller(machine))
    assert numbers(run)[-1] == 21980


@pytest.mark.parametrize(
    ("word", "number"),
    [("FEED_FACT=0.05", 21987), ("RAPID_FACT=201", 21419), ("FEED_FACT=-5", 21826)],
)
def test_an_override_outside_its_range_is_refused(word: str, number: int) -> None:
    """0.1 … 200 %."""
    assert numbers(perform(f"#OVERRIDE [{word}]\nM30")) == [number]
    assert numbers(perform(f"X[OVERRIDE {word}]\nM30")) == [number]


def test_the_limit_of_the_override_leaves_the_program_its_own() -> None:
    """RC-305: P-CHAN-00056, here 100 %, bounds operator's and CYCLE part, not the program's 150 %.

    A feed with an override is as good as another feed.
    """
    run = moved("#OVERRIDE [FEED_FACT=150]\nG01 X50 F6000", set={"HLI.OVERRIDE": 200.0})
    assert at(run, 200, "OVERRIDE.VEL.TOTAL") == 150
    assert at(run, 200, "PATH.SPEED") == pytest.approx(150.0)


def test_more_programmed_override_than_the_axes_can_do_is_limited() -> None:
    """MO-17: 150 % of the rapid speed is more than the axis has."""
    run = moved("#OVERRIDE [RAPID_FACT=150]\nG00 X400")
    assert at(run, 400, "PATH.SPEED") == 500.0


def test_g166_leaves_the_part_of_realtime_cycles() -> None:
    """RC-305: operator's 20 % and programmed 30 % do not count, the cycle's 50 % does."""
    run = moved(
        "#OVERRIDE [FEED_FACT=30]\n"
        "#RT CYCLE [SCOPE=PROG]\nV.RTG.OVERRIDE.VEL.CYCLE = 50\n#RT CYCLE END\n"
        "N10 G60 G01 X10 F6000 G166\nN20 X11",
        set={"HLI.OVERRIDE": 20.0},
    )
    assert at(run, 100, "PATH.SPEED") == 50.0
    assert at(run, 100, "OVERRIDE.VEL.TOTAL") == 50
    assert at(run, 300, "BLOCK") == 20
    assert at(run, 300, "OVERRIDE.VEL.TOTAL") == 3


@pytest.mark.parametrize("slope", ["", "#SLOPE [TYPE=TRAPEZ]\n"])
@pytest.mark.parametrize(
    ("first", "second", "speed"),
    [
        ("X20 F6000 G166", "X40 F3000", 25.0),
        ("X20 F6000 G166", "X40", 50.0),
        ("X20 F6000", "X40 F3000 G166", 50.0),
    ],
)
def test_a_block_begins_with_its_own_override(
    slope: str, first: str, second: str, speed: float
) -> None:
    """RC-305, MO-5: the operator's 50 % before or after G166; the path has slowed down by then."""
    run = moved(f"{slope}G261 G01\nN10 {first}\nN20 {second}", set={"HLI.OVERRIDE": 50.0})
    assert run.trace is not None
    begin = list(run.trace["BLOCK"]).index(20)
    assert at(run, begin, "PATH.SPEED") == pytest.approx(speed, abs=1e-9)


def test_overrides_of_a_program_end_with_it() -> None:
    """The next program begins with 100 %."""
    controller = Controller()
    perform("#OVERRIDE [FEED_FACT=10]\nM30", controller)
    run = perform("G01 X10 F6000\nM30", controller, signals=SIGNALS)
    assert run.trace is not None
    assert run.trace.at(run.ticks - 60, "PATH.SPEED") == 100.0


@pytest.mark.parametrize(
    ("words", "tick", "speed"),
    [
        ("X400", 1000, 250.0),
        ("X400 Y300", 700, 312.5),
        ("Y300 X400 A45", 700, 312.5),
        ("A180", 700, 180.0),
        ("G02 I50", 700, 250.0),
        (
            "G02 I50 Z100",
            700,
            250.0 * ((100 * 3.141592653589793) ** 2 + 100**2) ** 0.5 / (100 * 3.141592653589793),
        ),
    ],
)
def test_a_share_of_the_highest_feed_leads_one_axis_to_its_share(
    words: str, tick: int, speed: float
) -> None:
    """G194 F50: X and Y can do 500 mm/s (P-AXIS-00212), A 360 °/s; none goes above its half."""
    run = moved(f"G01 F100\nG194 F50 {words}")
    assert at(run, tick, "PATH.SPEED") == pytest.approx(speed)


def test_after_g194_the_feed_of_before_counts_again() -> None:
    """Each kind of F has its own value (MO-17)."""
    run = moved("G94 F6000\nG194 F20\nG94 G01 X200")
    assert at(run, 1000, "PATH.SPEED") == pytest.approx(100.0)


@pytest.mark.parametrize(
    ("words", "number"),
    [("G194 X1", 20008), ("G194 F101 X1", 900925), ("G194 F-1 X1", 20176), ("F-5 X1", 20176)],
)
def test_a_share_and_a_feed_have_limits(words: str, number: int) -> None:
    """A negative F is reported as such, and a share above 100 %."""
    assert numbers(perform(f"G01 {words}\nM30")) == [number]
