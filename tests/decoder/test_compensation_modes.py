# SPDX-License-Identifier: MIT
"""How the tool comes to a contour and from it, other radii, what it does not fit into (MO-9).

Tool 1 of the demo machine has the radius 5. Ways are written as they were worked out by hand.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import asin, degrees, dist

import pytest
from support.compensated import decoded, way

from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.run.controller import Controller, NcText

START = "D1 G01 F6000\n"

#: A pocket behind a neck of 8 mm, which the tool of 10 mm does not fit through, seen from above.
KEYHOLE = """\
G41 X10 Y0
X46
Y-20
X30
M100
Y-60
X70
Y-24
X54
Y0
X90
G40 Y20
"""


def ends(text: str, patch: pytest.MonkeyPatch, plane: tuple[int, int] = (0, 1)) -> list[object]:
    """Ends of the ways in the plane, arcs with centre and angle, rounded."""
    segments, errors = decoded(text, patch)
    assert errors == []
    found: list[object] = []
    for segment in segments:
        _, end, centre, angle = way(segment, plane)
        rounded = tuple(round(value, 6) + 0.0 for value in end)
        if centre is None:
            found.append(rounded)
        else:
            about = tuple(round(value, 6) + 0.0 for value in centre)
            found.append((rounded, about, round(angle, 6)))
    return found


def watching() -> Machine:
    """The demo machine with P-CHAN-00219."""
    demo = load_machine(None)
    (channel,) = demo.channels
    parameters = replace(channel.parameters, looks_for_damage=True)
    return replace(demo, channels=(replace(channel, parameters=parameters),))


# --- to the contour and from it ------------------------------------------------------------------


def test_across_the_contour_with_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    """G237: its own line to beside the start, and one back at G40."""
    text = f"{START}G237 G42\nX40\nY30\nG40\nX80\n"
    assert ends(text, monkeypatch) == [(0, -5), (45, -5), (45, 30), (40, 30), (80, 30)]


def test_across_the_contour_with_arcs(monkeypatch: pytest.MonkeyPatch) -> None:
    """G237: the contour may begin and end with arcs.

    Outside of the first arc the radius is 55. Beside X 65 the line meets the circle of 55 about
    60, 150 in an inner corner, 5 beside its lowest place.
    """
    text = (
        f"{START}X10 Y10\nG237 G42\nG03 X60 Y60 J50\nG01 Y100\nG03 X10 Y150 J50\nG40\nG01 X0 Y0\n"
    )
    high = round(150 - (55**2 - 5**2) ** 0.5, 6)
    angle = round(270 - degrees(asin(5 / 55)), 6)
    assert ends(text, monkeypatch) == [
        (10, 10),
        (10, 5),
        ((65, 60), (10, 60), 90),
        (65, high),
        ((5, 150), (60, 150), angle),
        (10, 150),
        (0, 0),
    ]


def test_across_the_contour_from_side_to_side(monkeypatch: pytest.MonkeyPatch) -> None:
    """G237, G42 after G41: as G40 and G42."""
    text = f"{START}G237 G41\nX40\nG42 Y30\nG40 X80\n"
    assert ends(text, monkeypatch) == [
        (0, 5),
        (40, 5),
        (40, 0),
        (45, 0),
        (45, 30),
        (40, 30),
        (80, 30),
    ]


def test_one_motion_alone_across_the_contour(monkeypatch: pytest.MonkeyPatch) -> None:
    """G237: compensation of a single motion, at its end the way back; M100 comes after it."""
    text = f"{START}G237 G41 X40\nG40 M100\nY20\n"
    assert ends(text, monkeypatch) == [(0, 5), (40, 5), (40, 0), (40, 20)]


@pytest.mark.parametrize(
    ("behind", "expected"),
    [
        ("G40\nG00 X150 Y0\n", [(150, 0)]),
        ("G40\nG00 X150\nX200\n", [(150, 30), (200, 30)]),
        ("G40\nG91 Y1\n", [(120, 31)]),
        ("G40 X150\n", [(150, 30)]),
        ("G40\nP1 = V.RTA.ACS.ACT_POS.Y\nX[100 + P1]\n", [(130, 30)]),
    ],
)
def test_the_contour_ends_without_a_motion(
    behind: str, expected: list[object], monkeypatch: pytest.MonkeyPatch
) -> None:
    """G239: to the contour as with G138; at G40 the program goes on from where the tool is."""
    text = f"{START}G239\nV.G.WZ_AKT.R = 10\nG41 X30 Y20\nX60\nX90\nX120\n{behind}"
    assert ends(text, monkeypatch) == [(30, 30), (60, 30), (90, 30), (120, 30), *expected]


# --- other radii ---------------------------------------------------------------------------------


@pytest.mark.parametrize("word", ["V.G.WZ_AKT.R = 3\n", "D4\n"])
def test_another_radius_on_the_way(word: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The next line leads from its corner at the old radius to its corner at the new one."""
    word = word.replace("D4", "V.G.WZ_AKT.R = 8\nV.G.WZ_AKT.R = 3")
    text = f"{START}G41 X10 Y0\nX50\n{word}Y40\nX20\nG40 Y0\n"
    assert ends(text, monkeypatch) == [(10, 5), (45, 5), (47, 37), (20, 37), (20, 0)]


def test_a_larger_radius_around_outer_corners(monkeypatch: pytest.MonkeyPatch) -> None:
    """G26: the arc before the line has the old radius, the one after it the new one."""
    text = f"{START}G26 G42 X10 Y0\nX50\nV.G.WZ_AKT.R = 7\nY40\nX20\nG40 X0\n"
    assert ends(text, monkeypatch) == [
        (10, -5),
        (50, -5),
        ((55, 0), (50, 0), 90),
        (57, 40),
        ((50, 47), (50, 40), 90),
        (20, 47),
        (0, 40),
    ]


def test_a_radius_of_the_other_sign_changes_the_side(monkeypatch: pytest.MonkeyPatch) -> None:
    """As G42 after G41: its motion leads from beside the one to beside the other."""
    text = f"{START}G41 X10 Y0\nX40\nV.G.WZ_AKT.R = -5\nX50 Y20\nX80\nG40 X90\n"
    assert ends(text, monkeypatch) == [(10, 5), (40, 5), (50, 15), (80, 15), (90, 20)]


def test_the_feed_counts_at_the_contour(monkeypatch: pytest.MonkeyPatch) -> None:
    """G11: on an inner arc of 20 mm the centre goes at 15/20 of F, on an outer one at 25/20."""
    text = (
        f"{START}G11 G26 G41 X20 Y0\nX40\nG03 X60 Y20 J20\nG01 Y40\nG02 X80 Y60 I20\nG01 X90\n"
        "G10 G02 X110 Y40 J-20\nG40 G01 Y0\n"
    )
    segments, errors = decoded(text, monkeypatch)
    assert errors == []
    assert [round(one.feed, 9) for one in segments] == [100, 100, 75, 100, 125, 100, 100, 100]


# --- planes, small blocks, what is between ---------------------------------------------------


def test_a_helix_in_each_plane(monkeypatch: pytest.MonkeyPatch) -> None:
    """The third axis goes with the arc; G18 has Z before X, so that X is to the left of Z."""
    text = f"{START}D0\nV.G.WZ_AKT.R = 5\nG18 G41 Z10 X0\nZ50\n"
    text += "G03 Z70 X20 K0 I20 Y8\nG01 X40\nG40 Z60\n"
    segments, errors = decoded(text, monkeypatch)
    assert errors == []
    found = [tuple(round(value, 6) + 0.0 for value in one.target[:3]) for one in segments]
    assert found == [(5, 0, 10), (5, 0, 50), (20, 8, 65), (40, 8, 65), (40, 8, 60)]
    arc = segments[2].arc
    assert arc is not None
    assert arc[2:] == pytest.approx((50, 20, 90))


def test_very_small_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    """Steps of a micrometre around an outer corner: each is beside the contour."""
    steps = "".join(f"X{50 + n / 1000:.3f} Y{-n * n / 1e6:.6f}\n" for n in range(1, 20))
    found = ends(f"{START}G41 X10 Y0\nX50\n{steps}X80 Y-40\nG40 X90\n", monkeypatch)
    assert len(found) == 23
    assert found[:2] == [(10, 5), (50.0025, 5)] or found[1] == pytest.approx((50.0025, 5), abs=1e-3)


# --- what the tool does not fit into -------------------------------------------------------------


def test_a_neck_beyond_neighbours_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without G141 the contour is passed as it is programmed, and the damage is a warning."""
    run = Controller().run(NcText("p.nc", f"{START}{KEYHOLE}M30\n"), signals=[])
    assert [(one.id, one.span.line) for one in run.diagnostics if one.span] == [(900950, 11)]
    assert run.diagnostics[0].values == {"line": 5}
    assert run.state == "ended"
    assert ends(START + KEYHOLE, monkeypatch) == [
        (10, 5),
        (51, 5),
        (51, -25),
        (35, -25),
        (35, -55),
        (65, -55),
        (65, -29),
        (49, -29),
        (49, 5),
        (90, 5),
        (90, 20),
    ]


def test_a_neck_is_an_error_where_the_channel_wants_it() -> None:
    """P-CHAN-00219: the path stops before the motion whose way is crossed."""
    signals = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS"]
    run = Controller(watching()).run(NcText("p.nc", f"{START}{KEYHOLE}M30\n"), signals=signals)
    assert [(one.id, one.span.line) for one in run.errors if one.span] == [(900951, 11)]
    assert run.trace is not None
    assert [run.trace[name][-1] for name in signals] == [51, -25]


#: A hook: 0, 0 to 100, 0 to 100, 40 to 0, 41; the tool goes in from 50, 60 and away to 50, -30.
HOOK = "G00 X50 Y60\nG41 G01 X0 Y0\nX100\nY40\nX0 Y41\nG40 X50 Y-30\n"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        # in across the last side; away across the first one
        (HOOK, [(901964, 3), (901964, 7)]),
        # at rapid traverse it may pass above; so it may where Z moves between
        (HOOK.replace("G41 G01 X0 Y0", "G41 X0 Y0\nG01"), [(901964, 8)]),
        (HOOK.replace("G40 X50", "Z10\nG40 X50"), [(901964, 3)]),
        (HOOK.replace("Y0\nX100", "Y0\nZ-1\nX100"), [(901964, 8)]),
        # from outside and to outside, past the ends
        ("G00 X-20 Y-20\nG42 G01 X0 Y0\nX100\nY40\nX0 Y41\nG40 X-20 Y60\n", []),
        # a closed square, begun and left at its corner, from outside and from inside
        ("G00 X-20 Y-30\nG42 G01 X0 Y0\nX60\nY60\nX0\nY0\nG40 X-30 Y-20\n", []),
        ("G00 X30 Y30\nG41 G01 X30 Y0\nX60\nY60\nX0\nY0\nX30\nG40 Y30\n", []),
        # a full circle, begun and left where it closes
        ("G00 X50 Y0\nG42 G01 X20 Y0\nG03 I-20 J0\nG40 G01 X50\n", []),
    ],
)
def test_a_way_that_cuts_the_contour_is_reported(
    text: str, expected: list[tuple[int, int]]
) -> None:
    """Across the path beside another motion: after it the tool is nearer than its radius."""
    run = Controller().run(NcText("p.nc", f"{START}{text}M30\n"), signals=[])
    assert [(one.id, one.span.line) for one in run.diagnostics if one.span] == expected


def test_a_way_that_cuts_the_contour_is_an_error_where_the_channel_wants_it() -> None:
    """P-CHAN-00219: the way to the contour is not begun."""
    signals = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS"]
    run = Controller(watching()).run(NcText("p.nc", f"{START}{HOOK}M30\n"), signals=signals)
    assert [one.id for one in run.errors] == [901965]
    assert run.trace is not None
    assert [run.trace[name][-1] for name in signals] == [50, 60]


def test_a_neck_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """G141: the loop behind the neck is left out; M100 in it comes where the tool is."""
    text = f"{START}G141\n{KEYHOLE}"
    assert ends(text, monkeypatch) == [(10, 5), (51, 5), (90, 5), (90, 20)]
    run = Controller().run(NcText("p.nc", f"{text}M30\n"), signals=[])
    assert run.diagnostics == ()


def test_what_is_swallowed_whole_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """Small steps in an inner corner, a groove of 4 mm, an arc smaller than the tool."""
    steps = "G41 X10 Y0\nX50\nX51 Y0.5\nX51.5 Y1.5\nY40\nG40 X30\n"
    found = ends(f"{START}G141 {steps}", monkeypatch)
    assert found == [(10, 5), (46.5, 5), (46.5, 40), (30, 40)]
    groove = "G41 X10 Y0\nX50\nY-20\nX54\nY0\nX80\nG40 Y20\n"
    assert ends(f"{START}G141 {groove}", monkeypatch) == [(10, 5), (55, 5), (80, 5), (80, 20)]
    arc = "G41 X10 Y0\nX50\nG03 X53 Y3 J3\nG01 Y40\nG40 X30\n"
    assert ends(f"{START}G141 {arc}", monkeypatch) == [(10, 5), (48, 5), (48, 40), (30, 40)]


def test_what_cannot_be_left_out_is_an_error() -> None:
    """G141: where the tool finds no way past it, the motion is reported as without G141."""
    text = f"{START}G141 G41 X10\nX50\nY4\nX10\nG40 Y0\nM30\n"
    run = Controller().run(NcText("p.nc", text), signals=[])
    assert [(one.id, one.span.line) for one in run.errors if one.span] == [(90019, 4)]


def test_masking_stays_over_g40_and_ends_with_g140(monkeypatch: pytest.MonkeyPatch) -> None:
    """G141 is modal, whether compensation is on or not."""
    groove = "G41 X10 Y0\nX50\nY-20\nX54\nY0\nX80\nG40 Y20\nX0\n"
    _, errors = decoded(f"{START}G141 {groove}{groove}", monkeypatch)
    assert errors == []
    _, errors = decoded(f"{START}G141 {groove}G140 {groove}", monkeypatch)
    assert errors == [90019]


def test_what_lies_above_is_not_compared() -> None:
    """A motion of Z, or in rapid, parts the contour: what is at another height does not collide."""
    over = "G41 X10 Y0\nX60\nZ20\nY20\nX30\nY-20\nG40 X0\n"
    run = Controller().run(NcText("p.nc", f"{START}{over}M30\n"), signals=[])
    assert run.diagnostics == ()
    run = Controller().run(NcText("p.nc", START + over.replace("Z20\n", "") + "M30\n"), signals=[])
    assert [one.id for one in run.diagnostics] == [900950]


def test_a_damage_is_reported_however_much_waits_after_it() -> None:
    """G141: Y-9 goes down at X 5, across the way at Y 5; 60 more motions are under way by then.

    Nothing that the tool does not fit into closes a loop there, so that it is the warning.
    """
    steps = "".join(f"X{number}\n" for number in range(1, 41))
    down = "".join(f"Y{-number}\n" for number in range(10, 70))
    begin = f"{START}G00 X20 Y20\nG01 G41 G141 X0 Y0\n"
    text = f"{begin}{steps}Y40\nX0\nY-9\n{down}G40 X20\nM30\n"
    run = Controller().run(NcText("p.nc", text), signals=[])
    found = [(one.id, one.span.line, one.values["line"]) for one in run.diagnostics if one.span]
    assert found == [(900950, 46, 9)]


#: Inside of a square, from its corner 0, 0 on.
POCKET = "G00 X20 Y20\nG01 G41 X0 Y0\nX40\nY40\nX0\nY0\nG40 X20 Y20\nM30\n"


def test_a_closed_contour_that_begins_in_an_inner_corner_is_reported_so() -> None:
    """At 0, 5, beside the first line, the tool of radius 5 cuts 5 mm into X 0, the last line."""
    run = Controller().run(NcText("p.nc", START + POCKET), signals=[])
    found = [(one.id, one.span.line, one.values["line"]) for one in run.diagnostics if one.span]
    assert found == [(90123, 7, 4)]
    run = Controller(watching()).run(NcText("p.nc", START + POCKET), signals=[])
    assert [(one.id, one.span.line) for one in run.errors if one.span] == [(90123, 7)]


def test_a_closed_contour_that_begins_elsewhere_is_reported_nothing() -> None:
    """Within a line, and at the outer corner of the square seen from outside."""
    within = POCKET.replace("X0 Y0", "X20 Y0").replace("\nG40", "\nX20\nG40")
    outside = POCKET.replace("G41", "G42").replace("X20 Y20", "X-20 Y-20")
    for text in (within, outside):
        run = Controller(watching()).run(NcText("p.nc", START + text), signals=[])
        assert run.diagnostics == ()


@pytest.mark.parametrize(
    "text",
    [
        "G41 X10 Y0\nG237\nG40 X-10 Y20\nX-30 Y-28",  # nothing is left of the way to the contour
        "G42 X20 Z-3\nY-23\nG40 X200",
    ],
)
def test_pieces_have_a_length(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """One without a length has no direction: the path would pass its corner at full speed."""
    segments, errors = decoded(START + text + "\nM30", monkeypatch)
    assert errors == []
    assert all(dist(segment.start, segment.target) > 1e-9 for segment in segments)
    for before, behind in pairwise(segments):
        assert before.target == behind.start


@pytest.mark.parametrize("lines", ["G239\nG40 Y20", "G40\nG239\nY20", "G40 Z3\nG239\nG02 I5"])
def test_a_contour_that_is_left_directly_after_all(lines: str) -> None:
    """G239 after the last motion, also after G40: the next one begins where the tool is."""
    run = Controller().run(NcText("p.nc", START + f"G41 X10 Y0\nX30\n{lines}\nM30"))
    assert run.errors == ()
    assert run.state == "ended"
