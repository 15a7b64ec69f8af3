# SPDX-License-Identifier: MIT
"""Oscillating axes of programs, OSC ON and OSC OFF: rules SA-11 … SA-17 in
docs/conformance/single-axes.md.

The demo machine: ticks of 1 ms, 4000 mm/s², X, Y, Z at most 500 mm/s, at rest at 0. At 100 mm/s
(FEED=6000) 5 mm take 75 ticks, 10 mm 125, 20 mm 225. So Z between -5 and 5 is at -5 at the end of
tick 74, at 5 at the end of 199, at -5 of 324, at 5 of 449.
"""

from __future__ import annotations

from random import Random

import pytest
from support.axis_plans import FASTEST, Plan
from support.decided import numbers, perform, reported
from support.random_seeds import each_seed

from nctakt.plc import MC_MoveAbsolute, Plc
from nctakt.results.run import Run
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.plcs.plc_view import PlcView

BETWEEN = "1ST_POS=-5 2ND_POS=5"
ON = f"Z[OSC ON {BETWEEN} FEED=6000]"


def run_of(*lines: str, **how: object) -> Run:
    """A program of these lines that ends without an error."""
    how.setdefault("signals", ["Z.ACS.ACT_POS"])
    run = perform("\n".join((*lines, "M30")), **how)
    assert run.state == "ended", run.diagnostics
    return run


def axes(run: Run) -> list[str]:
    """What the axes did."""
    return reported(run, "axis")


def places(run: Run) -> list[float]:
    """Where Z is at the end of each tick."""
    assert run.trace is not None
    return list(run.trace["Z.ACS.ACT_POS"])


def end(run: Run) -> int:
    """The tick of the program's end."""
    (event,) = (event for event in run.events if event.kind == "end")
    return event.tick


# --- SA-11: the motion ----------------------------------------------------------------------------


def test_an_axis_goes_to_its_first_position_and_then_to_and_fro() -> None:
    """The program goes on beside it: X 75 ticks, a dwell."""
    run = run_of(ON, "G01 X5 F6000", "G04 0.3")
    assert axes(run)[0] == "0 axis Z begun oscillating -5 5"
    place = places(run)
    assert [place[tick] for tick in (74, 199, 324)] == [-5.0, 5.0, -5.0]
    assert place[137] == pytest.approx(0.0, abs=0.06)
    assert end(run) == 375


def test_positions_by_centre_and_excursion() -> None:
    """Page 208621195: ZERO_POS=0 EXCUR=5 is from -5 to 5; the sign = is optional."""
    run = run_of("Z[OSC ON ZERO_POS 0 EXCUR 5 FEED 6000]", "G04 0.3")
    assert axes(run)[0] == "0 axis Z begun oscillating -5 5"


def test_an_axis_waits_at_its_positions() -> None:
    """1ST_DELT=0.05: 50 ticks at -5; 2ND_DELT=0.1: 100 at 5."""
    run = run_of(f"Z[OSC ON {BETWEEN} FEED=6000 1ST_DELT=0.05 2ND_DELT=0.1]", "G04 0.6")
    place = places(run)
    assert place[74] == place[124] == -5.0
    assert place[125] > -5.0
    assert place[249] == place[349] == 5.0
    assert place[350] < 5.0


def test_offsets_count_only_where_they_are_included() -> None:
    """As SA-3: G92 Z3 moves the positions of the path by 3."""
    assert axes(run_of("G92 Z3", ON, "G04 0.1"))[0].endswith("oscillating -5 5")
    included = run_of("G92 Z3", f"Z[OSC ON {BETWEEN} FEED=6000 INCL_OFFSETS]", "G04 0.1")
    assert axes(included)[0].endswith("oscillating -2 8")


def test_a_modulo_axis_goes_the_way_of_its_numbers_or_the_shorter_one() -> None:
    """A has the range from 0 to 360: from 350 to 10 it goes back 340°, with SHORT on 20°."""
    signals = ["A.ACS.ACT_POS"]
    on = "A[OSC ON 1ST_POS=350 2ND_POS=10 FEED=6000 {}]"
    seen = []
    for word in ("", "SHORT"):
        run = run_of("G00 A350", on.format(word), "G04 0.5", "A[OSC OFF INSTANT]", signals=signals)
        assert run.trace is not None
        places = list(run.trace["A.ACS.ACT_POS"])
        seen.append(any(20.0 < place < 340.0 for place in places[places.index(350.0) :]))
    assert seen == [True, False]


# --- SA-12: the speed -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "speed",
    [
        "FREQ=4",  # 0.125 s for 10 mm: 10/100 + 100/4000
        "TIME=0.25",
        "TIME=0.4 1ST_DELT=0.05 2ND_DELT=0.1",  # the waits are part of the period
    ],
)
def test_frequency_and_period_count_the_ramps(speed: str) -> None:
    """Page 222108427: they are kept exactly where the slope is a trapezoid."""
    run = run_of(f"Z[OSC ON {BETWEEN} {speed} NBR_OSC=2]", "G04 0.7")
    waits = 50 + 100 + 50 if "DELT" in speed else 0
    assert axes(run)[-1] == f"{449 + waits} axis Z done"


@pytest.mark.parametrize(
    ("positions", "speed", "reached", "period"),
    [
        # The speed: 1000/500 + 500/4000 s each way; the example of page 222114187 likewise needs
        # 2 · (1040/500 + 500/1000) = 5.16 s instead of 5.
        ("1ST_POS=-500 2ND_POS=500", "FREQ=0.25", "4.25", "4"),
        # The acceleration: 2 · √(10/4000) s each way; that of page 222111499: 4 · √(240/1000) s.
        (BETWEEN, "FREQ=10", "0.2", "0.1"),
        (BETWEEN, "TIME=0.1 1ST_DELT=0.2", "0.4", "0.1"),
    ],
)
def test_a_warning_where_the_axis_is_too_slow(
    positions: str, speed: str, reached: str, period: str
) -> None:
    """50487; the axis oscillates as fast as it can."""
    run = run_of(f"Z[OSC ON {positions} {speed}]", "Z[OSC OFF INSTANT]")
    (found,) = run.diagnostics
    assert found.id == 50487
    assert f"at least {reached} s instead of {period} s" in found.text()


# --- SA-13: how often -----------------------------------------------------------------------------


def test_the_number_of_oscillations() -> None:
    """NBR_OSC=2: Z stops when it comes to its second position for the second time."""
    run = run_of(f"Z[OSC ON {BETWEEN} FEED=6000 NBR_OSC=2]", "G04 0.6")
    assert axes(run) == ["0 axis Z begun oscillating -5 5", "449 axis Z done"]
    assert places(run)[-1] == 5.0


# --- SA-14: OSC OFF -------------------------------------------------------------------------------


def test_an_oscillation_ends_at_its_second_position() -> None:
    """OFF in tick 225, on the way to -5: it comes to 5 at the end of 449; X goes on meanwhile."""
    run = run_of(ON, "G01 X20 F6000", "Z[OSC OFF]", "X30")
    assert axes(run)[1:] == ["449 axis Z done"]
    assert end(run) == 225 + 125


def test_off_with_the_axis_at_its_second_position() -> None:
    """While it waits there (ticks 200 to 299) it is done at once."""
    on = f"Z[OSC ON {BETWEEN} FEED=6000 2ND_DELT=0.1]"
    assert axes(run_of(on, "G01 X20 F6000", "Z[OSC OFF]"))[1:] == ["225 axis Z done"]


def test_off_with_a_feed_goes_to_the_second_position_at_once() -> None:
    """In tick 225 Z is at 3.75 with -100 mm/s: 37.5 ms to 50 mm/s, 37.5 ms at it, 12.5 to rest."""
    run = run_of(ON, "G01 X20 F6000", "Z[OSC OFF FEED=3000]", "G04 0.1")
    assert axes(run)[1:] == ["225 axis Z aborted", "225 axis Z begun 5", "312 axis Z done"]


def test_off_at_once() -> None:
    """It brakes for 25 ticks from 3.75 to 2.5; the next block of Z begins from there."""
    run = run_of(ON, "G01 X20 F6000", "Z[OSC OFF INSTANT]", "Z7.5")
    assert axes(run)[1:] == ["225 axis Z aborted", "249 axis Z stopped"]
    assert places(run)[249] == pytest.approx(2.5)
    assert end(run) == 250 + 75


def test_off_without_an_oscillation() -> None:
    """Nothing happens, also after NBR_OSC has been reached."""
    once = f"Z[OSC ON {BETWEEN} FEED=6000 NBR_OSC=1]"
    run = run_of("Z[OSC OFF]", once, "G04 0.3", "Z[OSC OFF]", "Z[OSC OFF FEED=100]", "X0")
    assert axes(run) == ["1 axis Z begun oscillating -5 5", "200 axis Z done"]


# --- SA-15: what ends it besides ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "ticks"),
    [
        ("G01 Z15 F6000", 200 + 125),
        ("#WAIT INDP [Z]", 200),
        ("#WAIT INDP ALL", 200),
        ("Z[INDP_SYN G90 G01 FEED=6000 POS=15]", 200 + 125),
        (f"Z[OSC ON {BETWEEN} FEED=6000]\n#WAIT INDP [Z]", 200 + 125 + 125),
    ],
)
def test_a_command_that_needs_the_position_ends_it(line: str, ticks: int) -> None:
    """Page 208621195: a motion of the path, or a request of positions; at the second position."""
    run = run_of(ON, "G01 X5 F6000", line)
    assert axes(run)[1] == "199 axis Z done"
    assert end(run) == ticks


def test_the_end_of_the_program_ends_it() -> None:
    """The program is over, the run waits for the axis (RC-006)."""
    run = run_of(ON, "G01 X5 F6000")
    assert end(run) == 75
    assert axes(run)[-1] == "199 axis Z done"


def test_a_transformation_ends_it() -> None:
    """Page 15557297803: the oscillation is to be over before a transformation; here it is ended."""
    run = run_of(ON, "G01 X5 F6000", "#CS ON [0, 0, 0, 0, 0, 45]", "G00 X0 Y0", "#CS OFF")
    assert axes(run)[1] == "199 axis Z done"


# --- SA-16: cycles, the PLC, override, feed hold, reset -------------------------------------------


def test_a_realtime_cycle_takes_the_axis_over() -> None:
    """ABORTING: at -3 on the way to -5; the oscillation is over. BUFFERED: after it has come to its
    second position; a tick later than otherwise, since the program asks where the cycle has Z.
    """
    cycle = (
        "#RT CYCLE [ID=1 SCOPE=PROG]\n$IF ONCE V.RTA.ACS.ACT_POS.Z < -3\n"
        "Z[INDP {} G90 G01 FEED=6000 POS=20]\n$ENDIF\n#RT CYCLE END"
    )
    run = run_of(cycle.format(""), ON, "G04 0.5")
    words = [text.partition(" ")[2] for text in axes(run)]
    assert words[1:] == ["axis Z aborted", "axis Z begun 20", "axis Z done"]
    buffered = run_of(cycle.format("BUFFERED"), ON, "G04 0.5")
    assert axes(buffered)[1:3] == ["200 axis Z done", "200 axis Z begun 20"]


class _Mover(Plc):
    """Sends Z to 20 from tick 100 on."""

    def __init__(self) -> None:
        self.block = MC_MoveAbsolute("Z")

    def each_tick(self, hli: PlcView) -> None:
        self.block(hli, execute=hli.tick + 1 >= 100, position=20, velocity=100)


def test_the_plc_takes_the_axis_over() -> None:
    """In tick 100; OSC OFF changes nothing then."""
    run = run_of(ON, "G04 0.2", "Z[OSC OFF]", "#WAIT INDP [Z]", plc=_Mover())
    assert axes(run)[1:3] == ["100 axis Z aborted", "100 axis Z begun 20"]
    assert places(run)[-1] == 20.0


def test_the_override_of_the_channel_counts() -> None:
    """50 %: 10/50 + 50/4000 s for 10 mm, 5/50 + 50/4000 s for 5."""
    run = run_of(f"Z[OSC ON {BETWEEN} FEED=6000 NBR_OSC=1]", set={"HLI.OVERRIDE": 50.0})
    assert axes(run)[-1] == f"{113 + 213 - 1} axis Z done"


def test_feed_hold_stops_it_and_it_goes_on() -> None:
    """From tick 100 on: 25 ticks of braking; from tick 200 on it goes on to 5."""
    hold = [Stimulus("100 ms", "HLI.FEED_HOLD", 1.0), Stimulus("200 ms", "HLI.FEED_HOLD", 0.0)]
    run = run_of(f"Z[OSC ON {BETWEEN} FEED=6000 NBR_OSC=1]", "G04 0.4", at=hold)
    place = places(run)
    assert place[130] == place[199] == pytest.approx(-2.5)
    # In tick 100 it was at -3.75 with 100 mm/s; 7.5 mm from rest to rest take 100 ticks.
    assert axes(run)[-1] == "299 axis Z done"


def test_a_reset_brakes_it() -> None:
    """RC-007: in tick 100 at 100 mm/s, 25 ticks."""
    run = perform(f"{ON}\nG04 1\nM30", at=[Stimulus("100 ms", "HLI.RESET", 1.0)])
    assert axes(run)[1:] == ["100 axis Z aborted", "124 axis Z stopped"]


def test_block_search_lets_it_oscillate_again() -> None:
    """The state at the block is that of a whole run; an oscillation that is over is not begun."""
    lines = (ON, "G00 X5", "Y[OSC ON ZERO_POS=0 EXCUR=5 FEED=6000]", "Y[OSC OFF]", "G04 0.3")
    run = run_of(*lines, from_line=5)
    begun = [text.partition(" ")[2] for text in axes(run) if "begun" in text]
    assert begun == ["axis Z begun oscillating -5 5"]


def test_the_summary_counts_it() -> None:
    """Begun once, done once, by the program."""
    (count,) = run_of(ON, "G01 X5 F6000").motions
    assert (count.axis, count.count, count.done, count.is_of_program) == ("Z", 1, 1, True)


def modelled(
    ends: tuple[float, float], pauses: tuple[int, int], speed: float, off: int, back: float
) -> list[float]:
    """Where Z is at the end of each tick until it is at rest.

    OSC OFF comes in tick ``off``; ``back``: with this speed to the second position, 0: it finishes.
    """
    place, now, is_ending = [0.0], 0.0, False
    tick, target = 0, 0
    while True:
        plan = Plan(tick, now, 0.0, ends[target], speed)
        for _ in range(plan.ticks()):
            if tick == off and back:
                plan = Plan(tick, *plan.after(tick - 1), ends[1], back)
                return [*place[1:], *(plan.after(tick + i)[0] for i in range(plan.ticks()))]
            is_there = target == 0 and now == ends[1] and tick == plan.first and tick > 0
            if tick == off and is_there:
                return place[1:]
            is_ending |= tick == off
            place.append(plan.after(tick)[0])
            tick += 1
        now = ends[target]
        if target and is_ending:
            return place[1:]
        for _ in range(pauses[target]):
            if tick == off and back:
                plan = Plan(tick, now, 0.0, ends[1], back)
                rest = range(plan.ticks()) if now != ends[1] else range(1)
                return [*place[1:], *(plan.after(tick + i)[0] for i in rest)]
            if tick == off and target:
                return place[1:]
            is_ending |= tick == off
            place.append(now)
            tick += 1
        target = 1 - target


@each_seed(compiled=12, plain=4)
def test_random_oscillations_are_those_of_a_slow_model(seed: int) -> None:
    """SA-11 … SA-14: each place in each tick."""
    chance = Random(seed)
    first, second = (float(place) for place in chance.sample([-9, -5, -2, 1, 4, 8], 2))
    pauses = chance.choice((0, 7, 60)), chance.choice((0, 11, 90))
    speed, off = chance.choice((40.0, 100.0, 700.0)), chance.randrange(1, 700)
    back = chance.choice((0.0, 0.0, 50.0))
    run = run_of(
        f"Z[OSC ON 1ST_POS={first} 2ND_POS={second} FEED={speed * 60} 1ST_DELT={pauses[0] / 1000} "
        f"2ND_DELT={pauses[1] / 1000}]",
        f"G04 {off / 1000}",
        f"Z[OSC OFF FEED={back * 60}]" if back else "Z[OSC OFF]",
        "G04 1.5",
    )
    expected = modelled((first, second), pauses, min(speed, FASTEST), off, back)
    expected += [expected[-1]] * (len(places(run)) - len(expected))
    assert places(run) == pytest.approx(expected, abs=1e-6)
    assert places(run)[-1] == second


# --- SA-17: what is refused -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lines", "number"),
    [
        ("Z[OSC 1ST_POS=-5 2ND_POS=5 FEED=1]", 902580),
        (f"Z[OSC ON OFF {BETWEEN} FEED=1]", 902580),
        ("Z[OSC ON FEED=1]", 902580),
        ("Z[OSC ON 1ST_POS=1 FEED=1]", 902580),
        (f"Z[OSC ON {BETWEEN} ZERO_POS=1 EXCUR=1 FEED=1]", 902580),
        ("Z[OSC ON 1ST_POS=1 EXCUR=1 FEED=1]", 902580),
        (f"Z[OSC ON {BETWEEN} FEED=1 FREQ=1]", 902580),
        (f"Z[OSC ON {BETWEEN} FEED=1 INSTANT]", 902580),
        (f"Z[OSC ON {BETWEEN} FEED=1 FOO=1]", 902580),
        (f"Z[OSC ON {BETWEEN} FEED=1 SHORT=1]", 902580),
        ("Z[OSC OFF NBR_OSC=1]", 902580),
        ("Z[OSC OFF FEED=1 INSTANT]", 902580),
        (f"Z[{BETWEEN} OSC ON FEED=1]", 21301),
        (f"Z[OSC ON {BETWEEN} 1ST_POS=2 FEED=1]", 21373),
        (f"Z[OSC ON {BETWEEN}]", 50593),
        (f"Z[OSC ON {BETWEEN} FEED=0]", 50593),
        (f"P1 = 0\nZ[OSC ON {BETWEEN} FEED=P1]", 50593),
        (f"Z[OSC ON {BETWEEN} FREQ=0]", 21375),
        (f"P1 = -1\nZ[OSC ON {BETWEEN} TIME=P1]", 21375),
        (f"Z[OSC ON {BETWEEN} FEED=1 1ST_DELT=-1]", 21375),
        ("Z[OSC ON ZERO_POS=0 EXCUR=-5 FEED=1]", 21375),
        (f"Z[OSC ON {BETWEEN} FEED=1 NBR_OSC=0]", 21237),
        (f"P1 = 1.5\nZ[OSC ON {BETWEEN} FEED=1 NBR_OSC=P1]", 21237),
        ("Z[OSC ON 1ST_POS=50 2ND_POS=50 FEED=1000]", 120470),  # the example of page 264767883
        ("P1 = 50\nZ[OSC ON 1ST_POS=P1 2ND_POS=50 FEED=1000]", 120470),
        ("A[OSC ON 1ST_POS=-10 2ND_POS=10 FEED=1]", 22277),
        (f"Z[OSC ON {BETWEEN} FEED]", 900208),
        ("Z[OSC ON 1ST_POS=0 2ND_POS=20000 FEED=1]", 60158),
        (f"G99 Z4\n{ON}", 60158),
        (f"{ON} Z1", 21072),
        (f"G41 D1 G01 X10 F500\n{ON}\nX20", 20651),
        (f"#RT CYCLE [ID=1 SCOPE=PROG]\n{ON}\n#RT CYCLE END", 22002),
    ],
)
def test_wrong_forms(lines: str, number: int) -> None:
    """Diagnosis pages 258261643, 264767883, 253887883, 1155604875, 254122891."""
    assert numbers(perform(f"{lines}\nM30"))[-1:] == [number]
