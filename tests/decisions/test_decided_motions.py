# SPDX-License-Identifier: MIT
"""What becomes of the motions of realtime cycles: management commands, ends, faults, resets.

RC-007, RC-110, RC-111, RC-408, RC-505. Z has 500 mm/s and 4000 mm/s²: 125 ticks and 31.25 mm to
rest. In most tests Z sets off for 400 in tick 0 and what is tested happens in tick 200, when Z has
made 200 increments: 31.25 + 0.075 · 500 = 68.75 mm; it could stop at 100. The way to 400 takes 925
ticks.
"""

from __future__ import annotations

import pytest
from support.decided import numbers, perform, reported

from nctakt.results.run import Run
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText

SIGNALS = ["Z.ACS.ACT_POS", "X.ACS.ACT_POS"]

TO_400 = """
#RT CYCLE DEF [ID=1 SCOPE={scope} END_ACTION={end}]
  $IF ONCE 1
    Z[INDP G90 G00 POS=400]
  $ENDIF
  $IF ONCE V.E.TRIGGER
    {other}
  $ENDIF
#RT CYCLE END
#RT CYCLE START [ID=1]
"""


def sent(*lines: str, scope: str = "PROG", end: str = "MOVE_ABORT", other: str = "") -> str:
    """A program whose cycle sends Z to 400 in tick 0, and what follows."""
    start = TO_400.format(scope=scope, end=end, other=other or "V.E.COUNT = 1")
    return start + "\n".join([*lines, "M30"])


def run(program: str, **settings: object) -> Run:
    return perform(program, signals=SIGNALS, **settings)


def _trigger(tick: int) -> Stimulus:
    """V.E.TRIGGER becomes 1 at the start of a tick."""
    return Stimulus(f"{tick} ms", "V.E.TRIGGER", 1)


def z(found: Run, tick: int) -> float:
    """The position of Z after a tick."""
    assert found.trace is not None
    return float(found.trace.at(min(tick, found.ticks - 1), "Z.ACS.ACT_POS"))


def last(found: Run) -> float:
    """Where Z is after the last tick."""
    return z(found, 1 << 60)


# --- management commands while the axis moves, while it brakes, while it is -----------------


def test_hold_brakes_from_its_tick_on_and_keeps_the_target() -> None:
    """RC-111: HOLD in tick 200: the increment of this tick brakes already; at rest at 100."""
    found = run(sent("G04 0.2", "#RT CYCLE HOLD [ID=1]", "G04 0.5"))
    assert z(found, 199) == pytest.approx(68.75)
    assert z(found, 200) == pytest.approx(68.75 + 0.5 - 0.002)
    assert z(found, 324) == z(found, 699) == pytest.approx(100)


def test_continue_goes_on_to_the_kept_target_from_rest() -> None:
    """RC-111: 300 mm from rest take 0.725 s: from tick 700 to 1424."""
    found = run(
        sent("G04 0.2", "#RT CYCLE HOLD [ID=1]", "G04 0.5", "#RT CYCLE CONTINUE [ID=1]", "G04 1")
    )
    assert z(found, 700) == pytest.approx(100.002)
    assert z(found, 1423) < 400
    assert z(found, 1424) == 400


def test_continue_in_mid_braking_plans_from_the_present_speed() -> None:
    """RC-111: held for 50 ticks, Z has 300 mm/s at 68.75 + 20 mm; it speeds up again at once."""
    found = run(
        sent("G04 0.2", "#RT CYCLE HOLD [ID=1]", "G04 0.05", "#RT CYCLE CONTINUE [ID=1]", "G04 1")
    )
    assert z(found, 249) == pytest.approx(88.75)
    assert z(found, 250) == pytest.approx(88.75 + 0.3 + 0.002)
    assert last(found) == 400


def test_hold_of_a_standing_axis_changes_nothing() -> None:
    """RC-111: Z has arrived in tick 924; HOLD and CONTINUE find nothing to stop."""
    found = run(sent("G04 1", "#RT CYCLE HOLD [ID=1]", "G04 0.1", "#RT CYCLE CONTINUE [ID=1]"))
    assert z(found, 924) == 400
    assert last(found) == 400


def test_hold_while_the_axis_brakes_after_stop_lets_it_brake() -> None:
    """RC-111, RC-405: STOP gave the motion up in tick 200; HOLD and CONTINUE change nothing."""
    held = ("G04 0.25", "#RT CYCLE HOLD [ID=1]", "G04 0.01")
    lines = (*held, "#RT CYCLE CONTINUE [ID=1]", "G04 1")
    found = run(sent(*lines, other="Z[INDP STOP]"), at=[_trigger(200)])
    assert z(found, 324) == last(found) == pytest.approx(100)


def test_abort_action_brakes_and_the_cycle_runs_on() -> None:
    """RC-111: the target is forgotten; the cycle's second condition still is evaluated."""
    lines = ("G04 0.2", "#RT CYCLE ABORT ACTION [ID=1]", "G04 1")
    found = run(sent(*lines, other="Z[INDP G90 POS=0]"), at=[_trigger(600)])
    assert z(found, 200) == pytest.approx(68.75 + 0.5 - 0.002)
    assert z(found, 599) == pytest.approx(100)
    assert z(found, 600) == pytest.approx(100 - 0.002)
    assert last(found) == 0


def test_abort_action_on_a_held_cycle_drops_the_held_motion() -> None:
    """RC-111: CONTINUE has nothing to continue."""
    held = ("G04 0.2", "#RT CYCLE HOLD [ID=1]", "G04 0.5", "#RT CYCLE ABORT ACTION [ID=1]")
    found = run(sent(*held, "#RT CYCLE CONTINUE [ID=1]", "G04 1"))
    assert last(found) == pytest.approx(100)


def test_abort_action_of_a_standing_axis_changes_nothing() -> None:
    """RC-111: there is nothing to abort."""
    found = run(sent("G04 1", "#RT CYCLE ABORT ACTION [ID=1]", "G04 0.1"))
    assert last(found) == 400


def test_start_lets_a_held_motion_go_on() -> None:
    """RC-111: START of a held cycle: its open motions go on; here ONCE sends Z to 400 anew."""
    held = ("G04 0.2", "#RT CYCLE HOLD [ID=1]", "G04 0.5", "#RT CYCLE START [ID=1]", "G04 1")
    found = run(sent(*held))
    assert z(found, 700) == pytest.approx(100.002)
    assert last(found) == 400


@pytest.mark.parametrize(("end", "place"), [("MOVE_ABORT", 100.0), ("MOVE_CONT", 400.0)])
def test_delete_ends_the_motion_as_end_action_says(end: str, place: float) -> None:
    """RC-110: MOVE_ABORT brakes in the tick of DELETE, MOVE_CONT lets the motion finish."""
    found = run(sent("G04 0.2", "#RT CYCLE DELETE [ID=1]", "G04 1", end=end))
    assert z(found, 200) == pytest.approx(69.25 if end == "MOVE_CONT" else 69.248)
    assert last(found) == pytest.approx(place)


@pytest.mark.parametrize(("end", "place"), [("MOVE_ABORT", 100.0), ("MOVE_CONT", 400.0)])
def test_the_end_of_a_block_ends_the_motion_as_end_action_says(end: str, place: float) -> None:
    """RC-110: the dwell is over after tick 199: the BLOCK cycle ends in tick 200."""
    found = run(sent("G04 0.2", "G04 1", scope="BLOCK", end=end))
    assert reported(found, "ended")[0] == "200 ended 1 scope"
    assert z(found, 200) == pytest.approx(69.25 if end == "MOVE_CONT" else 69.248)
    assert last(found) == pytest.approx(place)


@pytest.mark.parametrize(("end", "place"), [("MOVE_ABORT", 100.0), ("MOVE_CONT", 400.0)])
def test_the_run_continues_until_motions_that_have_an_end_stop(end: str, place: float) -> None:
    """RC-006: M30 in tick 200 waits for nothing; the run does, for 125 or for 725 ticks more."""
    found = run(sent("G04 0.2", end=end))
    assert reported(found, "end") == ["200 end part.nc"]
    assert found.ticks == (325 if end == "MOVE_ABORT" else 925)
    assert last(found) == pytest.approx(place)


@pytest.mark.parametrize(("end", "place"), [("MOVE_ABORT", 100.0), ("MOVE_CONT", 400.0)])
def test_a_held_motion_ends_with_its_cycle(end: str, place: float) -> None:
    """RC-110: held before the cycle is deleted: dropped, or let go on to its end."""
    held = ("G04 0.2", "#RT CYCLE HOLD [ID=1]", "G04 0.5", "#RT CYCLE DELETE [ID=1]", "G04 1")
    found = run(sent(*held, end=end))
    assert last(found) == pytest.approx(place)


def test_a_reset_aborts_the_motions_of_all_cycles_whatever_end_action_says() -> None:
    """RC-007: until all is at rest, even GLOBAL cycles with MOVE_CONT; the cycle stays."""
    controller = Controller()
    program = sent("G04 5", scope="GLOBAL", end="MOVE_CONT")
    controller.start(NcText("part.nc", program))
    while controller.read("V.RTA.ACS.ACT_POS.Z") < 68.75 - 1e-9:
        controller.step()
    tick = controller.tick
    controller.reset()
    assert controller.tick - tick == 125
    assert controller.read("V.RTA.ACS.ACT_POS.Z") == pytest.approx(100)
    controller.step(200)
    assert controller.read("V.RTA.ACS.ACT_POS.Z") == pytest.approx(100)
    controller.write("V.E.TRIGGER", 1)
    controller.step(2)
    assert controller.read("V.E.COUNT") == 1


def test_a_fault_aborts_the_motions_of_its_cycle_and_no_others() -> None:
    """RC-505: END_ACTION does not count; the other cycle's motion goes on."""
    other = """
#RT CYCLE [ID=2 SCOPE=PROG]
  $IF ONCE 1
    Y[INDP G90 G00 POS=400]
  $ENDIF
#RT CYCLE END
"""
    program = other + sent("G04 5", end="MOVE_CONT", other="V.E.VALUE = 1 / V.E.COUNT")
    controller = Controller()
    found = perform(program, controller, signals=SIGNALS, at=[_trigger(200)])
    assert numbers(found) == [50879]
    assert last(found) == pytest.approx(100)
    controller.step(1000)
    assert controller.read("V.RTA.ACS.ACT_POS.Y") == 400


@pytest.mark.parametrize(
    "program",
    [
        "M3 S99999\n#TIME 0.1\nM30",
        "#RT CYCLE\n$IF ONCE 1 == 1\nM3 S99999\n$ENDIF\n#RT CYCLE END\n#TIME 0.1\nM30",
    ],
)
def test_a_speed_beyond_the_axis_list_is_limited_and_reported(program: str) -> None:
    """P-AXIS-00212 of the demo machine's spindle: 36000 degrees per second, 6000 1/min."""
    run = perform(program)
    assert run.state == "ended"
    (found,) = run.diagnostics
    assert (found.id, found.severity.name) == (900905, "WARNING")
    assert found.text() == "spindle S: the speed 99999 is limited to 6000 1/min"
    assert numbers(perform(program.replace("99999", "6000"))) == []


# --- keywords without effect ----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("plain", "with_idle_word"),
    [
        ("Z[INDP G90 G00 POS=100]", "Z[INDP G90 G00 FEED=60 POS=100]"),
        ("Z[INDP G90 G00 POS=100]", "Z[INDP G90 G00 POS=100 DIR=NEG]"),
        ("Z[INDP G01 FEED=600]", "Z[INDP G00 FEED=600]"),
    ],
)
def test_keywords_without_effect_change_no_motion(plain: str, with_idle_word: str) -> None:
    """Manual 4.5.1: the syntax line allows them; G00 with POS is at rapid speed, FEED alone not."""
    ways = []
    for command in (plain, with_idle_word):
        cycle = f"#RT CYCLE [ID=1 SCOPE=PROG]\n$IF ONCE 1\n{command}\n$ENDIF\n#RT CYCLE END"
        found = run(f"{cycle}\nG04 0.2\nM30")
        assert not found.errors
        ways.append([z(found, tick) for tick in range(200)])
    assert ways[0] == ways[1]


@pytest.mark.parametrize(("value", "speed"), [(1, 1.0), (-1, -1.0), (0, 1.0)])
def test_an_expression_of_dir_results_in_one_of_the_three_values(value: int, speed: float) -> None:
    """RC-405, manual 4.5.1: 1 as POS, -1 as NEG, 0 as CUR, which is positive at first."""
    cycle = "#RT CYCLE [ID=1 SCOPE=PROG]\n$IF ONCE 1\nZ[INDP FEED=60 DIR={}]\n$ENDIF\n"
    found = run(cycle.format("V.E.VALUE") + "#RT CYCLE END\n#TIME 1\nM30", set={"V.E.VALUE": value})
    assert found.errors == ()
    assert z(found, 900) - z(found, 800) == pytest.approx(0.1 * speed)


@pytest.mark.parametrize("command", ["Z[INDP FEED=60 DIR={}]", "A[INDP G90 G00 POS=10 DIR={}]"])
@pytest.mark.parametrize("value", [2, 0.5, -1.5, 1e-12])
def test_another_value_of_dir_is_a_fault(command: str, value: float) -> None:
    """RC-405, manual 4.5.1: 50967 in the tick of the command, and nothing moves."""
    body = command.format("V.E.VALUE")
    found = run(
        f"#RT CYCLE [ID=1 SCOPE=PROG]\n{body}\n#RT CYCLE END\n#TIME 0.1\nM30",
        set={"V.E.VALUE": value},
    )
    (error,) = found.errors
    assert (error.id, error.span and error.span.line) == (50967, 2)
    assert "DIR must be POS (1), CUR (0) or NEG (-1)" in error.text("en")
    assert reported(found, "axis") == []
