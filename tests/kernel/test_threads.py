# SPDX-License-Identifier: MIT
"""Threads against their closed form: G33, G63, G331 and G332 (language facts, section 3)."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from pathlib import Path

import pytest
from support.kernel_rig import ACCELERATION, DEMO, TICK_T
from support.random_operator import Operator
from support.random_seeds import all_seeds

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText

SIGNALS = ("X.ACS.ACT_POS", "Z.ACS.ACT_POS", "S.POSITION", "S.SPEED", "BLOCK", "PATH.SPEED")
#: The error that a thread may have, as a share of its pitch.
SHARE = 1e-6


def run(text: str, **options: object) -> Run:
    return Controller(DEMO).run(NcText("p.nc", text), signals=SIGNALS, **options)  # type: ignore[arg-type]


def rows_of(result: Run, block: int, *names: str) -> Iterator[tuple[float, ...]]:
    """The values of these signals in the ticks of a block."""
    trace = result.trace
    assert trace is not None
    for tick, number in enumerate(trace["BLOCK"]):
        if number == block:
            yield tuple(float(trace[name][tick]) for name in names)


def off(degrees: float) -> float:
    """The distance of an angle from the next whole revolution, in revolutions."""
    turns = degrees / 360.0
    return abs(turns - round(turns))


def errors(result: Run, block: int, start: float, pitch: float, speed: float) -> list[float]:
    """The thread errors in revolutions where the path has its speed, forward (M3)."""
    found = []
    for z, angle, path_v in rows_of(result, block, "Z.ACS.ACT_POS", "S.POSITION", "PATH.SPEED"):
        if abs(path_v - speed) < 1e-9 * speed:
            found.append(off(angle - 360.0 * (start - z) / pitch))
    return found


THREAD = """N10 G00 X20 Z5
N20 M03 S{speed}
N30 G33 Z-20 K{pitch} S.OFFSET={offset}
N40 G00 X30
N50 M30"""


def test_a_thread_passes_its_start_at_the_start_angle() -> None:
    """600 1/min and 2 mm are 20 mm/s: 100 ms for each turn, and no error while they last.

    The path starts v / 2a = 2.5 ms before the spindle is at 0, and has its speed 5 ms later.
    """
    result = run(THREAD.format(speed=600, pitch=2, offset=0))
    found = errors(result, 30, 5.0, 2.0, 20.0)
    assert max(found) < SHARE
    ticks = (25.0 - 20.0 * 20.0 / ACCELERATION) / 20.0 / TICK_T
    assert len(found) == pytest.approx(ticks, abs=2)


@pytest.mark.parametrize("offset", [90, 120, 359.5])
def test_a_start_angle_turns_the_thread(offset: float) -> None:
    """The thread with OFFSET is turned by it: several starts (G33)."""
    result = run(THREAD.format(speed=600, pitch=2, offset=offset))
    start = 5.0 + 2.0 * offset / 360.0
    assert max(errors(result, 30, start, 2.0, 20.0)) < SHARE


def test_passes_at_different_speeds_cut_one_thread() -> None:
    """The start point has the start angle at any speed, so passes repeat."""
    for speed in (60, 600, 1500, 3000):
        result = run(THREAD.format(speed=speed, pitch=1.5, offset=0))
        assert max(errors(result, 30, 5.0, 1.5, speed * 1.5 / 60.0)) < SHARE


def test_a_left_hand_thread_turns_backward() -> None:
    """With M4 the angle falls while Z does."""
    result = run(THREAD.format(speed=600, pitch=2, offset=0).replace("M03", "M04"))
    pairs = rows_of(result, 30, "Z.ACS.ACT_POS", "S.POSITION", "PATH.SPEED")
    found = [off(angle + 180.0 * (5.0 - z)) for z, angle, v in pairs if v == 20.0]
    assert len(found) > 1000
    assert max(found) < SHARE


def test_a_cone_has_the_pitch_of_its_longer_axis() -> None:
    """Below 45° to Z the pitch K counts along Z: 600 1/min and 2 mm are 20 mm/s in Z."""
    text = THREAD.format(speed=600, pitch=2, offset=0).replace("Z-20", "Z-20 X30")
    result = run(text)
    path_v = 20.0 * math.hypot(25, 10) / 25.0
    assert max(errors(result, 30, 5.0, 2.0, path_v)) < SHARE
    face = text.replace("Z-20 X30", "Z4 X50").replace("K2", "I2")
    pairs = rows_of(run(face), 30, "X.ACS.ACT_POS", "S.POSITION", "PATH.SPEED")
    path_v = 20.0 * math.hypot(30, 1) / 30.0
    found = [off(angle - 180.0 * (x - 20.0)) for x, angle, v in pairs if v == path_v]
    assert max(found) < SHARE


def test_a_chain_keeps_the_angle() -> None:
    """A block that goes on into the next thread neither stops nor waits for the spindle."""
    text = THREAD.format(speed=600, pitch=2, offset=0)
    text = text.replace("N40", "N35 Z-40\nN36 Z-60 K2\nN40")
    result = run(text)
    for block in (35, 36):
        assert max(errors(result, block, 5.0, 2.0, 20.0)) < SHARE
    speeds = [v for (v,) in rows_of(result, 35, "PATH.SPEED")]
    assert min(speeds) == max(speeds) == 20.0


def test_without_chain_each_thread_waits_for_its_angle() -> None:
    """#TURN [THREAD_CHAIN=0]: the next block starts at 0 again, wherever the last one ended."""
    text = "#TURN [THREAD_CHAIN=0]\n" + THREAD.format(speed=600, pitch=2, offset=0)
    result = run(text.replace("N40", "N35 Z-40.3\nN36 Z-60\nN40"))
    assert max(errors(result, 35, -20.0, 2.0, 20.0)) < SHARE
    assert max(errors(result, 36, -40.3, 2.0, 20.0)) < SHARE


def test_override_hold_and_single_block_wait_for_the_end_of_a_thread() -> None:
    """What the operator does acts after the thread: a decision, reported by note 901516."""
    text = THREAD.format(speed=600, pitch=2, offset=0)
    at = [
        ("600 ms", "HLI.OVERRIDE", 50),
        ("700 ms", "HLI.FEED_HOLD", True),
        ("3 s", "HLI.FEED_HOLD", False),
    ]
    result = run(text, at=at)
    assert result.state == "ended"
    assert max(errors(result, 30, 5.0, 2.0, 20.0)) < SHARE
    assert [one.id for one in result.diagnostics] == [901516]


def test_the_path_follows_a_spindle_that_changes_its_speed() -> None:
    """A realtime cycle slows the spindle down and stops it: the thread stays what it was."""
    text = """#RT CYCLE [ID=1 SCOPE=GLOBAL]
$IF ONCE [V.E.COUNT == 1]
S[M3 REV=300]
$ENDIF
$IF ONCE [V.E.COUNT == 2]
S[M5]
$ENDIF
$IF ONCE [V.E.COUNT == 3]
S[M3 REV=900]
$ENDIF
#RT CYCLE END
"""
    at = [(f"{time} ms", "V.E.COUNT", n) for n, time in ((1, 600), (2, 900), (3, 1200))]
    result = run(text + THREAD.format(speed=600, pitch=2, offset=0), at=at)
    assert result.state == "ended", result.diagnostics
    pairs = list(rows_of(result, 30, "Z.ACS.ACT_POS", "S.POSITION", "S.SPEED", "PATH.SPEED"))
    assert {300.0, 0.0, 900.0} <= {speed for _, _, speed, _ in pairs}
    found = [
        off(angle - 180.0 * (5.0 - z)) for z, angle, speed, path_v in pairs if z > -19.0 and z < 4.9
    ]
    assert max(found) < SHARE


def test_tapping_walks_backward_on_the_thread() -> None:
    """Backward motion turns the spindle back with the path (MO-7)."""
    at = [("500 ms", "HLI.BACKWARD_MOTION", True), ("900 ms", "HLI.BACKWARD_MOTION", False)]
    result = run(TAP, at=at)
    check_taps(result)
    speeds = [v for (v,) in rows_of(result, 20, "S.SPEED")]
    assert min(speeds) < -299.0


def test_a_chain_with_a_step_in_its_pitch_is_an_error() -> None:
    """51103: from 2 to 3 mm the speed would jump by 10 mm/s; the axes can 4 mm/s in a tick."""
    text = THREAD.format(speed=600, pitch=2, offset=0).replace("N40", "N35 Z-40 K3\nN40")
    assert 51103 in [one.id for one in run(text).diagnostics]


@pytest.mark.parametrize(
    ("program", "number"),
    [
        ("N10 G33 Z-10 K2", 50499),  # the spindle is at rest
        ("N10 M03 S600\nN20 G33 Z-10", 120173),  # no pitch
        ("N10 M03 S600\nN20 G33 X-10 K2", 120175),  # no pitch for the longer axis
        ("N10 M03 S600\nN20 G33 Z-10 K-2", 901518),
        ("N10 G01 F600\nN20 G63 Z-10", 20007),  # S = 0
        ("N10 G95 F2\nN20 G63 Z-10 S300", 20635),
        ("N10 M03 S600\nN20 G63 Z-10 F600", 901508),  # the spindle turns
        ("N10 G01 F600\nN20 G63 Z-10 S300 M03", 901513),
        ("N10 G331 Z-10 S300", 120173),
        ("N10 M03 S3000\nN20 G33 Z-10 K20", 901509),  # 1000 mm/s, the axes can 500
        ("#TURN [THREAD_CUT_IGNORE_OV=0]", 901520),
        ("#TURN [TAPPING_N_CYCLES=21]", 901519),
        ("N10 M03 S-5", 20991),
    ],
)
def test_each_mistake_has_its_number(program: str, number: int) -> None:
    """The numbers that the controller gives, or nctakt where it has none."""
    result = run(f"{program}\nM30")
    assert number in [one.id for one in result.diagnostics]


# --- tapping -------------------------------------------------------------------------------------

TAP = """N10 G00 X20 Z5
N20 G63 Z-10 F600 S300
N30 Z5 S-300
N40 G331 Z-10 K1.5 S400
N50 G332 Z5
N60 M30"""


def tap_error(result: Run, block: int, start: float, turn: float, first: float) -> float:
    """The highest error in revolutions: the spindle at ``first`` where Z is ``start``."""
    pairs = list(rows_of(result, block, "Z.ACS.ACT_POS", "S.POSITION"))
    assert len(pairs) > 100
    return max(off(angle - first - turn * (start - z)) for z, angle in pairs)


def check_taps(result: Run) -> None:
    """In each tick the spindle has the angle of the depth, into the hole and out of it."""
    assert result.state == "ended"
    assert tap_error(result, 20, 5.0, 180.0, 0.0) < SHARE
    assert tap_error(result, 30, 5.0, 180.0, 0.0) < SHARE
    assert tap_error(result, 40, 5.0, 240.0, 0.0) < SHARE
    assert tap_error(result, 50, 5.0, 240.0, 0.0) < SHARE


def test_the_spindle_follows_the_depth() -> None:
    """F 600 with S 300 are 2 mm for each turn, and 15 mm seven and a half turns."""
    result = run(TAP)
    check_taps(result)
    speeds = [v for (v,) in rows_of(result, 20, "S.SPEED")]
    assert max(speeds) == pytest.approx(300.0, abs=1e-9)
    assert min(v for (v,) in rows_of(result, 30, "S.SPEED")) == pytest.approx(-300.0, abs=1e-9)


def test_override_and_hold_act_on_path_and_spindle_together() -> None:
    """Half the override is half of both speeds; a feed hold stops both on the thread."""
    at = [
        ("300 ms", "HLI.OVERRIDE", 50),
        ("600 ms", "HLI.FEED_HOLD", True),
        ("900 ms", "HLI.FEED_HOLD", False),
    ]
    result = run(TAP, at=at)
    check_taps(result)
    speeds = [v for (v,) in rows_of(result, 20, "S.SPEED")]
    assert 0.0 in speeds[300:]
    assert any(v == pytest.approx(150.0, abs=1e-9) for v in speeds)


def test_backward_motion_leaves_a_tap_at_its_start_and_comes_back_to_it() -> None:
    """The path walks from the tap into the block before and on again: the spindle is with it."""
    at = [("150 ms", "HLI.BACKWARD_MOTION", True), ("600 ms", "HLI.BACKWARD_MOTION", False)]
    result = run(TAP.replace("X20 Z5", "Z5"), at=at)
    check_taps(result)
    assert min(z for (z,) in rows_of(result, 10, "Z.ACS.ACT_POS")) == 0.0
    assert [one.id for one in result.diagnostics if one.id == 901510] == []


@pytest.mark.parametrize("seed", all_seeds(3, 1))
def test_taps_under_an_operator_who_goes_back_and_forth(seed: int) -> None:
    """Whatever is commanded, in each tick the spindle has the angle of the depth (MO-7)."""
    result = run(TAP, plc=Operator(seed, "override hold back"), ticks=60_000)
    check_taps(result)


def test_backward_motion_into_a_tap_whose_spindle_turns_is_an_error() -> None:
    """901508, reported once, at the tap."""
    text = TAP.replace("N60 M30", "N60 G01 X5 F600 M03 S100\nN70 M30")
    result = run(text, at=[("7 s", "HLI.BACKWARD_MOTION", True)])
    found = [(one.id, one.span.line) for one in result.errors if one.span is not None]
    assert found == [(901508, 5)]


@pytest.mark.parametrize("slope", ["STEP", "TRAPEZ"])
def test_random_threads_and_taps(slope: str) -> None:
    """Random speeds, pitches, angles and lengths, with either slope."""
    for seed in all_seeds(3, 1):
        random_ = random.Random(f"{slope} {seed}")
        speed, pitch = random_.uniform(30, 3000), random_.uniform(0.2, 4.0)
        offset, length = random_.uniform(0, 360), random_.uniform(20, 60)
        turn = random_.choice(["M03", "M04"])
        result = run(
            f"#SLOPE [TYPE={slope}]\nN10 G00 Z0\nN20 {turn} S{speed:.6f}\n"
            f"N30 G33 Z-{length:.4f} K{pitch:.6f} S.OFFSET={offset:.5f}\n"
            f"N40 G00 X5\nN50 M05\nN60 G04 X3\nN70 G00 Z0\n"
            f"N80 G331 Z-10 K{pitch:.6f} S{speed:.6f}\nN90 G332 Z0\nM30"
        )
        assert result.state == "ended", (seed, result.diagnostics)
        speed, pitch, offset = round(speed, 6), round(pitch, 6), round(offset, 5)
        path_v = speed * pitch / 60.0
        sign = 1.0 if turn == "M03" else -1.0
        found = [
            off(angle - offset - sign * 360.0 * (0.0 - z) / pitch)
            for z, angle, v in rows_of(result, 30, "Z.ACS.ACT_POS", "S.POSITION", "PATH.SPEED")
            if abs(v - path_v) < 1e-9 * path_v
        ]
        assert len(found) > 5, (seed, speed, pitch)
        assert max(found) < SHARE, seed
        taps = list(rows_of(result, 80, "Z.ACS.ACT_POS", "S.POSITION"))
        first = taps[0][1] - 360.0 * (0.0 - taps[0][0]) / pitch
        both = taps + list(rows_of(result, 90, "Z.ACS.ACT_POS", "S.POSITION"))
        assert max(off(angle - first + 360.0 * z / pitch) for z, angle in both) < SHARE, seed


def test_the_example_cuts_one_thread_in_three_passes() -> None:
    """The passes at 600, 900 and 1200 1/min have one line; its own expectations hold, too."""
    text = (Path(__file__).parents[2] / "examples" / "thread.nc").read_text("utf-8")
    result = run(text)
    assert result.state == "ended"
    for block, speed in ((40, 600), (90, 900), (140, 1200)):
        assert max(errors(result, block, 5.0, 2.0, speed / 30.0)) < SHARE
    assert tap_error(result, 190, 2.0, 240.0, 0.0) < SHARE
    assert tap_error(result, 200, 2.0, 240.0, 0.0) < SHARE


def test_a_reset_frees_the_spindle_of_a_thread() -> None:
    """The channel stops on the thread, the spindle turns on; the next program cuts anew."""
    controller = Controller(DEMO)
    text = THREAD.format(speed=600, pitch=2, offset=0)
    reset = [("800 ms", "HLI.RESET", True)]
    stopped = controller.run(NcText("p.nc", text), signals=SIGNALS, at=reset)
    assert stopped.state == "reset"
    result = controller.run(NcText("p.nc", text), signals=SIGNALS)
    assert max(errors(result, 30, 5.0, 2.0, 20.0)) < SHARE


def test_a_spindle_that_reverses_or_a_thread_without_speed_is_reported() -> None:
    """901511: the thread ends there; 901512: its way is shorter than both ramps."""
    cycle = "#RT CYCLE [ID=1 SCOPE=GLOBAL]\n$IF ONCE [V.E.COUNT == 1]\nS[M4 REV=300]\n$ENDIF\n"
    text = f"{cycle}#RT CYCLE END\n" + THREAD.format(speed=600, pitch=2, offset=0)
    result = run(text, at=[("700 ms", "V.E.COUNT", 1)])
    assert 901511 in [found.id for found in result.diagnostics]
    short = run("N10 M03 S600\nN20 G33 Z-0.01 K2\nM30")
    assert 901512 in [found.id for found in short.diagnostics]


@pytest.mark.parametrize(("coupling", "speed"), [(0, 10.0), (1, 5.0)])
def test_feed_per_revolution_follows_the_spindle_as_commanded(coupling: int, speed: float) -> None:
    """#TURN [ROT_FEED_CPL=0]: F x S at once; 1: the spindle is at half its speed after 51 ms."""
    text = f"#TURN [ROT_FEED_CPL={coupling}]\nN10 G95 F1 M3 S600\nN20 G01 X10\nM30"
    speeds = [v for (v,) in rows_of(run(text), 20, "PATH.SPEED")]
    assert speeds[50] == pytest.approx(speed, abs=1e-9)
    assert max(speeds) == pytest.approx(10.0, abs=1e-9)
