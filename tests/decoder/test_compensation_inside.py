# SPDX-License-Identifier: MIT
"""G238: a closed contour that begins in an inner corner (MO-9).

Tool 1 of the demo machine has the radius 5. Ways are written as they were worked out by hand.
"""

from __future__ import annotations

from math import asin, degrees, sqrt

import pytest
from support.compensated import decoded, way

from nctakt.run.controller import Controller, NcText

START = "D1 G01 F6000\nG00 X20 Y8\nG01\n"

#: Inside of a square, from its corner 0, 0 on.
SQUARE = "G41 X0 Y0\nX40\nY40\nX0\nY0\nG40 X20 Y8\nM30\n"


def ends(text: str, patch: pytest.MonkeyPatch) -> list[object]:
    """Ends of the ways in the plane, arcs with centre and angle, rounded."""
    segments, errors = decoded(START + text, patch)
    assert errors == []
    found: list[object] = []
    for segment in segments:
        _, end, centre, angle = way(segment)
        rounded = tuple(round(value, 6) + 0.0 for value in end)
        if centre is None:
            found.append(rounded)
        else:
            found.append((rounded, centre, round(angle, 6)))
    return found


def errors_of(text: str) -> tuple[list[tuple[int, int]], float]:
    """Numbers and lines of errors, and where X ends."""
    run = Controller().run(NcText("p.nc", START + text), signals=["X.ACS.ACT_POS"])
    assert run.trace is not None
    found = [(one.id, one.span.line) for one in run.diagnostics if one.span]
    return found, float(run.trace["X.ACS.ACT_POS"][-1])


def test_lines_begin_and_end_where_their_ways_meet(monkeypatch: pytest.MonkeyPatch) -> None:
    """Inside the square each corner is 5 mm off in both axes, the first one too."""
    around = [(35, 5), (35, 35), (5, 35), (5, 5)]
    assert ends("G238\n" + SQUARE, monkeypatch) == [(20, 8), (5, 5), *around, (20, 8)]


def test_nothing_is_damaged_then() -> None:
    """The warning that the square gets without G238 (90123) does not come."""
    assert errors_of("G238\n" + SQUARE) == ([], 20.0)
    assert errors_of(SQUARE)[0] == [(90123, 8)]


def test_the_contour_may_end_in_an_arc(monkeypatch: pytest.MonkeyPatch) -> None:
    """Half a circle of 20 mm about 20, 0 and its chord: 15 mm about it meet Y 5 at √200 mm."""
    low, high = (round(20 + sign * sqrt(200), 6) for sign in (-1, 1))
    turned = round(180 - 2 * degrees(asin(5 / 15)), 6)
    text = "G238 G41 X0 Y0\nX40\nG03 X0 Y0 I-20\nG01 G40 X20 Y8\n"
    assert ends(text, monkeypatch) == [
        (20, 8),
        (low, 5),
        (high, 5),
        ((low, 5), (20, 0), turned),
        (20, 8),
    ]


def test_blocks_in_between_keep_their_place_and_without_g40_it_ends_there(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The program's end closes the contour as G40 does; M100 and Z are passed on the way."""
    text = "G238\nG41 X0 Y0\nX40\nM100\nZ-3\nY40\nX0\nY0\n"
    around = [(35, 5), (35, 5), (35, 35), (5, 35), (5, 5)]
    assert ends(text, monkeypatch) == [(20, 8), (5, 5), *around]


def test_at_an_outer_corner_it_is_as_g138(monkeypatch: pytest.MonkeyPatch) -> None:
    """There is nothing to meet outside: the tool begins beside the first line."""
    text = "\nX-20 Y-20\nG42 X0 Y0\nX40\nY40\nX0\nY0\nG40 X-20 Y-20\n"
    found = ends("G238" + text, monkeypatch)
    assert found == ends("G138" + text, monkeypatch)
    assert found[2] == (0, -5)


@pytest.mark.parametrize(
    ("text", "number", "line"),
    [
        # not closed, with G40 and at the program's end
        ("G238\nG41 X0 Y0\nX40\nY40\nX0 Y1\nG40 X20 Y8\nM30\n", 90119, 8),
        ("G238\nG41 X0 Y0\nX40\nY40\nM30\n", 90119, 7),
        # other ways to a contour, another side or radius in mid-contour
        ("G41 X0 Y0\nX40\nG238\nY40\nM30\n", 21318, 6),
        ("G238\nG41 X0 Y0\nX40\nG139\nM30\n", 21318, 7),
        ("G238\nG41 X0 Y0\nX40\nG42 Y40\nM30\n", 90115, 7),
        ("G238\nG41 X0 Y0\nX40\nV.G.WZ_AKT.R = 4\nY40\nM30\n", 90127, 8),
        # the tool does not fit: 8 mm high
        ("G238\nG41 X0 Y0\nX40\nY8\nX0\nY0\nG40 X20\nM30\n", 90019, 7),
        # the first line is shorter than what the corner cuts off it
        ("G238\nG41 X0 Y0\nX4\nX40 Y20\nX0\nY0\nG40 X20\nM30\n", 90019, 6),
    ],
)
def test_what_cannot_be(text: str, number: int, line: int) -> None:
    """A mistake ends the program before the contour: where that begins is not known."""
    found, x = errors_of(text)
    assert found[-1] == (number, line)
    if "G238\nG41" in text:
        assert x == 20.0


def test_a_contour_that_is_too_long() -> None:
    """All of its motions are held, up to 200."""
    steps = "".join(f"X{number / 10}\n" for number in range(1, 202))
    assert errors_of(f"G238\nG41 X0 Y0\n{steps}M30\n")[0] == [(90114, 205)]
