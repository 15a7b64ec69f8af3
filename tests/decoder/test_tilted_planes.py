# SPDX-License-Identifier: MIT
"""Arcs, tool radius compensation, chamfers and roundings in tilted planes (MO-4, MO-8, MO-9).

A motion in a tilted system is that of the same program without it, turned and shifted.
``NCTAKT_SEEDS=1000`` makes as many programs.
"""

from __future__ import annotations

import math
import random
from pathlib import Path

import numpy as np
import pytest
from support.decided import numbers, perform
from support.random_seeds import seeds_in_parts

from nctakt import machines
from nctakt.lists.machine.machine import load_machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller

SIGNALS = [*(f"{axis}.ACS.ACT_POS" for axis in "XYZ"), "BLOCK", "PATH.SPEED"]
SYSTEM = (5.0, -3.0, 2.0, 25.0, -40.0, 70.0)
TOOL = "V.G.WZ[1].R=3\nV.G.WZ[1].L=0\n"
#: What the lists of the built-in machine allow X, Y and Z, mm/s².
ACCELERATION = 4000.0


def matrix(system: tuple[float, ...]) -> np.ndarray:
    """The third angle about Z, the second about the new Y, the first about the new X."""
    a, b, c = np.radians(system[3:])
    about_x = np.array([[1, 0, 0], [0, math.cos(a), -math.sin(a)], [0, math.sin(a), math.cos(a)]])
    about_y = np.array([[math.cos(b), 0, math.sin(b)], [0, 1, 0], [-math.sin(b), 0, math.cos(b)]])
    about_z = np.array([[math.cos(c), -math.sin(c), 0], [math.sin(c), math.cos(c), 0], [0, 0, 1]])
    return about_z @ about_y @ about_x


def inside(run: Run, system: tuple[float, ...] | None) -> np.ndarray:
    """The axes after each tick in the coordinates of the system."""
    assert run.trace is not None
    axes = np.array([run.trace[name] for name in SIGNALS[:3]]).T
    return axes if system is None else (axes - system[:3]) @ matrix(system)


def run_of(body: str, system: tuple[float, ...] | None, head: str = "") -> Run:
    """A run of these lines in a system, from its zero."""
    lines = ["G01 X0 Y0 Z0 F9000", body]
    if system is not None:
        lines = ["#CS ON [" + ",".join(map(str, system)) + "]", *lines, "#CS OFF"]
    return perform("\n".join([TOOL + head, *lines, "M30"]), signals=SIGNALS)


# --- arcs -----------------------------------------------------------------------------------------


@seeds_in_parts(compiled=40, plain=2, part=20)
def test_arcs_are_circles_in_their_plane(seeds: range) -> None:
    """Radius and plane within a millionth of a millimetre, helices evenly with the angle."""
    for seed in seeds:
        dice = random.Random(f"tilted {seed}")
        angles = [dice.uniform(-180.0, 180.0) for _ in range(3)]
        system = (*(dice.uniform(-20.0, 20.0) for _ in range(3)), *angles)
        plane = dice.choice((17, 18, 19))
        first, second = {17: (0, 1), 18: (2, 0), 19: (1, 2)}[plane]
        normal = 3 - first - second
        radius = dice.choice((0.05, 1.0, 12.0, 150.0))
        angle = math.radians(dice.uniform(1.0, 359.0))
        begin = dice.uniform(0.0, math.tau)
        sign = dice.choice((1, -1))
        rise = dice.choice((0.0, 0.3, 40.0))
        start, end = np.zeros(3), np.zeros(3)
        centre = -radius * np.array([math.cos(begin), math.sin(begin)])
        away = radius * np.array([math.cos(begin + sign * angle), math.sin(begin + sign * angle)])
        end[first], end[second], end[normal] = *(centre + away), rise
        words = " ".join(f"{name}{value:.9f}" for name, value in zip("XYZ", end, strict=True))
        centres = dict(zip((first, second), centre, strict=True))
        words += "".join(f" {'IJK'[axis]}{value:.9f}" for axis, value in centres.items())
        slope = dice.choice(("STEP", "TRAPEZ"))
        body = f"G{plane} G{3 if sign > 0 else 2} {words} F{dice.choice((500, 6000, 60000))}"
        run = run_of(f"N10 {body}", system, head=f"#SLOPE [TYPE={slope}]\n")
        assert numbers(run) == [], (seed, [str(one) for one in run.diagnostics])
        assert run.trace is not None
        ticks = np.flatnonzero(np.asarray(run.trace["BLOCK"]) == 10)[:-1]
        at = inside(run, system)[ticks]
        plane_at = at[:, [first, second]] - centre
        assert np.abs(np.linalg.norm(plane_at, axis=1) - radius).max() < 1.1e-6, seed
        turned = sign * (np.unwrap(np.arctan2(plane_at[:, 1], plane_at[:, 0])) - begin)
        turned = turned - math.tau * np.round(turned[0] / math.tau)
        off = np.abs(at[:, normal] - rise * turned / angle).max()
        off *= radius / math.hypot(radius, rise / angle)  # across a steep helix
        assert off < 1.2e-6, seed
        assert inside(run, system)[-1] == pytest.approx(end, abs=1e-8)
        axes = np.array([run.trace[name] for name in SIGNALS[:3]]).T
        changes = np.abs(np.diff(axes, 2, axis=0)).max() / 1e-6
        assert changes <= ACCELERATION * (1 + 1e-6), seed
        del start


def test_full_circles_modal_arcs_and_relative_ways() -> None:
    """As in the planes of the axes."""
    body = "G02 I10 F3000\nG91 G03 X10 Y10 R10\nX-10 Y10 I-10\nG90 G18 G02 X10 Z5 R20"
    tilted, plain = run_of(body, SYSTEM), run_of(body, None)
    assert (numbers(tilted), numbers(plain)) == ([], [])
    assert inside(tilted, SYSTEM)[-1] == pytest.approx(inside(plain, None)[-1], abs=1e-9)


def test_a_plane_of_two_axes_keeps_its_arcs() -> None:
    """A quarter turn about X: the arc is one of the path, as fast as without a system."""
    body = "G02 X20 I10 F60000"
    quarter = (0.0, 0.0, 0.0, 90.0, 0.0, 0.0)
    assert run_of(body, quarter).ticks == run_of(body, None).ticks


def test_limits_on_the_way() -> None:
    """Between its ends the arc goes beyond Y 10,000 mm of the machine."""
    run = run_of("G02 X20 I10 F3000", (0.0, 9995.0, 0.0, 30.0, 0.0, 0.0))
    (found,) = run.errors
    inner = run_of("X0", (0.0, 9995.0, 0.0, 30.0, 0.0, 0.0))
    assert numbers(inner) == []
    assert "Y" in found.text("en")
    assert found.span is not None
    assert found.span.column == 1


# --- contours -------------------------------------------------------------------------------------

CONTOURS = {
    "arcs and lines": "D1 G41 G01 X10 Y0 F1800\nY20\nG02 X30 Y20 I10\nG01 Y10\nX40\n"
    "G03 X30 Y0 R15\nG40 G01 X0 Y0",
    "the third axis moves along": "D1 G42 G01 X10 Y0 Z2 F1800\nX40 Z1\nY20\nZ3\nX10\nG01 Y0\n"
    "G40 G01 X0 Y-5",
    "directly": "D1 G239 G41 G01 X10 Y5 F1800\nY20\nX30\nG40\nG01 X50 Y50\nX1",
    "directly, and away at once": "G239 D1 G41 G01 Z-7.779 X28.337 F1800\nG40 G01 Z0.739 Y29.535",
    "with motions of its own": "D1 G237 G41 G01 X10 Y5 F1800\nY20\nX30\nG40 X50 Y50",
    "tangentially": "D1 G41 G05 G01 X10 Y5 F1800\nY20\nX30\nG05 G40\nG01 X50 Y50",
    "around a closed contour": "D1 G238 G41 G01 X10 Y10 F1800\nY30\nX30\nY10\nX10\nG40 X0 Y0",
    "in another plane": "G18 D1 G41 G01 Z10 X5 F1800\nX20\nG02 Z30 X20 K10\nG01 X3\nG40 Z50 X0",
    "mirrored": "G21 D1 G41 G01 X10 Y0 F1800\nY20\nG02 X30 Y20 I10\nG01 Y10\nG40 G01 X0 Y0",
    "around a corner by an arc": "D1 G140 G41 G01 X10 Y0 F1800\nY20\nX-5\nG40 G01 X0 Y0",
    "a piece that only rounding leaves": "D1 G42 G01 Y20.859 Z-3.314 F6000\nY-23.198\n"
    "G40 G01 X277.266\nX0",
    "chamfers and roundings": "G01 X20 F1800\nG302 I3\nY20\nG301 I2\nG02 X40 I10\nG302 I2\n"
    "G01 X50 Y-10",
    "away across the plane": "D1 G237 G42 G01 X-19.664 F1800\nG03 I-6.79 J-3.14\nG40 G01 Z5.701\n"
    "G02 I7.8 J-2.43",
    "there and back": "G01 X20.1 F1800\nG301 I1\nX5.3\nY7",
    "roundings of a compensated contour": "D1 G41 G01 X10 Y0 F1800\nY20\nG302 I5\nX30\nY0\nG40 X0",
}


@pytest.mark.parametrize("name", CONTOURS)
def test_contours_are_those_of_the_plane(name: str) -> None:
    """Each tick is on the contour that the program without a system makes."""
    tilted, plain = run_of(CONTOURS[name], SYSTEM), run_of(CONTOURS[name], None)
    assert (tilted.errors, plain.errors) == ((), ())
    found, expected = inside(tilted, SYSTEM), inside(plain, None)
    assert np.abs(np.diff(found, 2, axis=0)).max() / 1e-6 <= 3**0.5 * ACCELERATION * (1 + 1e-6)
    assert found[-1] == pytest.approx(expected[-1], abs=1e-9)
    begin = int(np.argmax(np.linalg.norm(found - found[0], axis=1) > 0.0))
    step = np.linalg.norm(np.diff(expected, axis=0), axis=1).max()
    settled = found[max(begin, 200) :]
    nearest = [np.linalg.norm(expected - one, axis=1).min() for one in settled]
    assert max(nearest) <= 0.51 * step + 1e-6


def test_a_realtime_loop_has_the_same_motions() -> None:
    """Three passes of a circle in the tilted plane, until a cycle ends the loop."""
    head = (
        "V.RTG.LOOP.ENABLED = TRUE\n#RT CYCLE [ID=1 SCOPE=PROG]\n$IF V.RTG.LOOP.COUNT >= 2\n"
        "V.RTG.LOOP.ENABLED = FALSE\n$ENDIF\n#RT CYCLE END\n"
    )
    run = run_of(
        "G01 F6000\n#RT WHILE\nN10 G02 X20 R10\nN20 G02 X0 R10\n#RT ENDWHILE", SYSTEM, head
    )
    assert run.errors == ()
    assert run.trace is not None
    blocks = np.asarray(run.trace["BLOCK"])
    at = inside(run, SYSTEM)[blocks >= 10]
    assert np.abs(np.linalg.norm(at[:, :2] - (10.0, 0.0), axis=1) - 10.0).max() < 1.1e-6
    assert len(at) == pytest.approx(3 * 20 * np.pi / 100 / 0.001, rel=0.2)


def test_a_spline_begins_as_an_arc_ends() -> None:
    """Its direction is that of the arc in the tilted plane: downward in Y."""
    body = (
        "#SPLINE TYPE AKIMA\n#AKIMA TRANS [START=TANGENTIAL]\nN10 G02 X10 I5 F1800\nG151\n"
        "N20 G01 X15 Y-10\nN30 X20 Y-3\nN40 X30 Y-8\nN50 X35 Y-2\nG150\nX40"
    )
    run = run_of(body, SYSTEM)
    assert (run.errors, run.trace is None) == ((), False)
    assert run.trace is not None
    blocks = np.asarray(run.trace["BLOCK"])
    at = inside(run, SYSTEM)
    arc, spline = at[blocks == 10], at[blocks == 20]
    for way in (arc[-1] - arc[-2], spline[5] - spline[4]):
        assert way / np.linalg.norm(way) == pytest.approx([0.0, -1.0, 0.0], abs=0.03)


def test_it_is_a_contour_under_a_transformation(tmp_path: Path) -> None:
    """#TRAFO, a tilted system and the tool along its Z: the tip is where the plane has it."""
    machine = load_machine(Path(machines.__path__[0]) / "demo5")
    body = "G01 X0 Y0 Z0 F3000\nN10 G02 X20 I10\nN20 G03 X0 R14\n"
    signals = [*(f"{axis}.MCS.ACT_POS" for axis in "XYZ"), "BLOCK"]
    system = (100.0, 50.0, -20.0, 30.0, 0.0, 0.0)
    text = "G00 A30\n#TRAFO ON\n#CS ON [" + ",".join(map(str, system)) + "]\n" + body + "M30"
    run = perform(text, Controller(machine), signals=signals)
    assert numbers(run) == []
    assert run.trace is not None
    blocks = np.asarray(run.trace["BLOCK"])
    at = np.array([run.trace[name] for name in signals[:3]]).T
    at = (at - system[:3]) @ matrix(system)
    for block, centre, radius in ((10, (10.0, 0.0), 10.0), (20, (10.0, -(96**0.5)), 14.0)):
        ticks = np.flatnonzero(blocks == block)[:-1]
        off = np.linalg.norm(at[ticks][:, :2] - centre, axis=1) - radius
        assert len(ticks) > 100
        assert np.abs(off).max() < 1.1e-6
        assert np.abs(at[ticks][:, 2]).max() < 1e-6
