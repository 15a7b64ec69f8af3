# SPDX-License-Identifier: MIT
"""G05: to a compensated contour and from it in an arc that touches it (207837451, MO-9)."""

from __future__ import annotations

from math import atan2, dist, hypot, pi

import pytest
from support.compensated import Way, decoded, way

from nctakt.run.controller import Controller, NcText

START = "V.G.WZ_AKT.R = 5\nG01 F6000\n"


def ways(text: str, monkeypatch: pytest.MonkeyPatch) -> list[Way]:
    """Where the tool goes."""
    segments, errors = decoded(START + text, monkeypatch)
    assert errors == []
    return [way(segment) for segment in segments]


def direction(one: Way, *, at_end: bool) -> float:
    """The direction at an end of a way, in radians."""
    start, end, centre, angle = one
    if centre is None:
        return atan2(end[1] - start[1], end[0] - start[0])
    x, y = end if at_end else start
    return atan2(y - centre[1], x - centre[0]) + (pi / 2 if angle > 0 else -pi / 2)


def touches(before: Way, behind: Way) -> bool:
    """Whether one way goes on into the other one without a corner."""
    turn = direction(behind, at_end=False) - direction(before, at_end=True)
    return before[1] == pytest.approx(behind[0]) and abs((turn + pi) % (2 * pi) - pi) < 1e-9


@pytest.mark.parametrize("side", ["G41", "G42"])
@pytest.mark.parametrize("begin", ["X10 Y20", "X10 Y-20", "X40 Y3"])
@pytest.mark.parametrize(
    ("contour", "end"), [("X60\nY50", "X30 Y70"), ("G03 X50 Y30 J30\nG01 Y60", "X70 Y55")]
)
@pytest.mark.parametrize("mode", ["", "G237", "G239"])
def test_arcs_touch_the_contour(
    mode: str, begin: str, contour: str, end: str, side: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The centre is on the bisector of both ends and on the line across the contour."""
    text = f"G26 {mode}\n{begin}\n{side} G05 X20 Y0\n{contour}\nG40 G05 {end}\nX0\n"
    found = ways(text, monkeypatch)
    arcs = [found[1], found[-2]]
    for one in arcs:
        start, stop, centre, _ = one
        assert centre is not None
        assert dist(start, centre) == pytest.approx(dist(stop, centre))
    assert touches(found[1], found[2])
    assert touches(found[-3], found[-2])
    assert dist(arcs[0][1], (20.0, 0.0)) == pytest.approx(5.0)
    assert arcs[0][2] is not None
    across = (arcs[0][2][0] - 20.0, arcs[0][2][1])
    assert abs(across[0]) < 1e-9 * hypot(*across) + 1e-9


def test_numbers_of_an_arc(monkeypatch: pytest.MonkeyPatch) -> None:
    """From (10, 20) to (20, 5): x = 20, and (y - 5)² = 10² + (20 - y)² gives y = 15.833."""
    found = ways("X10 Y20\nG41 G05 X20 Y0\nX60\nG40 G05 X80 Y5\n", monkeypatch)
    assert found[1][2] == pytest.approx((20.0, 5.0 + 325.0 / 30.0))
    assert found[1][3] == pytest.approx(112.61986, abs=1e-5)
    assert found[3] == ((60.0, 5.0), (80.0, 5.0), None, 0.0)  # along the tangent


def test_it_acts_once_and_with_the_next_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    """Not modal; a block without a motion leaves it to the next one in the plane."""
    found = ways("G41 G05\nX20 Y20 Z-99\nX60\nG40\nX80 Y60\n", monkeypatch)
    assert [one[2] is not None for one in found] == [True, False, False]


def test_plain_blocks_take_it_over(monkeypatch: pytest.MonkeyPatch) -> None:
    """The motions after it may come the fast way."""
    lines = "".join(f"X{20 + 30 * number} Y{number % 2}\n" for number in range(40))
    found = ways(f"G41 G05 X10 Y20\n{lines}G40 G05\nX2000 Y60\n", monkeypatch)
    assert touches(found[0], found[1])
    assert touches(found[-2], found[-1])


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("G05 X1 F100", 901874),
        ("G238\nV.G.WZ_AKT.R = 5\nG41 G05\nG01 F1000 X10\nY20\nX0\nX10 Y0\nG40 X0", 21316),
        ("V.G.WZ_AKT.R = 5\nG41 G05 G02 X10 I5 F100\nG01 X20\nG40 X0", 90008),
    ],
)
def test_mistakes(text: str, number: int) -> None:
    """G05 alone, with G238, with an arc of the program."""
    done = Controller().run(NcText("p.nc", text + "\nM30"), signals=[])
    assert number in [found.id for found in done.diagnostics]
