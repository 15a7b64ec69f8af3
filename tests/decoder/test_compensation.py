# SPDX-License-Identifier: MIT
"""Tool radius compensation: where the tool's centre goes (MO-9).

Tool 1 of the demo machine has the radius 5. Ways are written as they were worked out by hand: where
each one ends, for an arc its centre and angle.
"""

from __future__ import annotations

from itertools import pairwise
from math import asin, degrees, pi
from pathlib import Path

import pytest
from support.compensated import decoded, distance, way

from nctakt.cli import main
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText

START = "D1 G01 F9000\n"


def ends(text: str, patch: pytest.MonkeyPatch, plane: tuple[int, int] = (0, 1)) -> list[object]:
    """Ends of the ways in the plane, arcs with centre and angle, rounded."""
    segments, errors = decoded(START + text, patch)
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


def test_around_an_outer_corner_in_an_arc(monkeypatch: pytest.MonkeyPatch) -> None:
    """G26: about the corner, from beside the one line to beside the other."""
    text = "G26 G41 X10 Y0\nX50\nY-40\nX0\nG40 X-20\n"
    assert ends(text, monkeypatch) == [
        (10, 5),
        (50, 5),
        ((55, 0), (50, 0), -90),
        (55, -40),
        ((50, -45), (50, -40), -90),
        (0, -45),
        (-20, -40),
    ]


def test_around_an_outer_corner_in_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    """G25: up to 90° to where the lines beside both sides meet."""
    text = "G41 X10 Y0\nX50\nY-40\nX0\nG40 X-20\n"
    assert ends(text, monkeypatch) == [(10, 5), (55, 5), (55, -45), (0, -45), (-20, -40)]


def test_around_a_sharp_corner_in_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    """Above 90° each line goes on by the radius, then across; here the contour turns by 135°."""
    text = "G41 X10 Y0\nX50\nX10 Y-40\nG40 X0 Y-50\n"
    half = 5 * 2**-0.5
    beside = (50 + half, -half)
    assert ends(text, monkeypatch) == [
        (10, 5),
        (55, 5),
        (round(beside[0] + half, 6), round(beside[1] + half, 6)),
        (round(10 + half, 6), round(-40 - half, 6)),
        (0, -50),
    ]


def test_where_the_contour_goes_back(monkeypatch: pytest.MonkeyPatch) -> None:
    """A turn of 180° is an outer corner on either side."""
    text = "G26 G42 X10 Y0\nX50\nX20\nG40 X0\n"
    assert ends(text, monkeypatch) == [
        (10, -5),
        (50, -5),
        ((50, 5), (50, 0), 180),
        (20, 5),
        (0, 0),
    ]


def test_inner_corners_of_lines_and_arcs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the shifted ones cut each other: y = 5 and x = 25 with the circle of 15 about 20, 0."""
    text = "G41 X10 Y0\nX40\nG03 X20 Y20 I-20\nG01 Y10\nG40 X30\n"
    far = round(20 + 200**0.5, 6)
    high = round(200**0.5, 6)
    angle = round(90 - 2 * degrees(asin(5 / 15)), 6)
    assert ends(text, monkeypatch) == [
        (10, 5),
        (far, 5),
        ((25, high), (20, 0), angle),
        (25, 10),
        (30, 10),
    ]


def test_an_inner_corner_of_two_arcs(monkeypatch: pytest.MonkeyPatch) -> None:
    """The circles of radius 25 about 0, 0 and 0, 24 cut each other at y = 12."""
    text = "X20 Y-30\nG42 Y0\nG03 X16 Y12 I-20\nX20 Y24 I-16 J12\nG40 G01 Y40\n"
    far = (25**2 - 12**2) ** 0.5
    angle = round(degrees(asin(12 / 25)), 6)
    assert ends(text, monkeypatch) == [
        (20, -30),
        (25, 0),
        ((round(far, 6), 12), (0, 0), angle),
        ((25, 24), (0, 24), angle),
        (20, 40),
    ]


def test_arcs_are_shifted_about_their_centre(monkeypatch: pytest.MonkeyPatch) -> None:
    """Inside the radius is smaller, outside it is greater; the angle stays."""
    text = "G41 Y0 X20\nX40\nG03 X60 Y20 J20\nG01 Y40\nG02 X80 Y60 I20\nG01 X90\nG40 Y80\n"
    assert ends(text, monkeypatch) == [
        (20, 5),
        (40, 5),
        ((55, 20), (40, 20), 90),
        (55, 40),
        ((80, 65), (80, 40), -90),
        (90, 65),
        (90, 80),
    ]


def test_a_full_circle(monkeypatch: pytest.MonkeyPatch) -> None:
    """Reached and left in straight lines beside its begin."""
    text = "G138 G42 X20 Y0\nG02 I10\nG40 G01 X0\n"
    assert ends(text, monkeypatch) == [(25, 0), ((25, 0), (30, 0), -360), (0, 0)]


@pytest.mark.parametrize(
    ("mode", "expected"),
    [
        ("G139", [(20, 5), (25, 5), (25, -25), (20, -25), (0, -20)]),
        ("G139 G26", [(20, 5), ((25, 0), (20, 0), -90), (25, -20)]),
        ("G138", [(25, 0), (25, -20), (0, -20)]),
    ],
)
def test_to_and_from_the_contour_at_outer_corners(
    mode: str, expected: list[object], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Indirectly beside the end of the way and around the corner, or directly (G138)."""
    found = ends(f"{mode} G41 X20\nY-20\nG40 X0\n", monkeypatch)
    assert found[: len(expected)] == expected


def test_from_one_side_to_the_other(monkeypatch: pytest.MonkeyPatch) -> None:
    """G42 after G41: its motion leads from beside the one to beside the other."""
    text = "G41 X10 Y0\nX40\nG42 X50 Y20\nX80\nG40 X90\n"
    assert ends(text, monkeypatch) == [(10, 5), (40, 5), (50, 15), (80, 15), (90, 20)]


def test_commands_between_two_motions_keep_their_place(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Z moves where the corner is; several motions without the plane do not part the contour."""
    segments, errors = decoded(
        START + "G41 X10 Y0\nX50\nZ-95\nM100\nZ-90\nY40\nG40 X20\n", monkeypatch
    )
    assert errors == []
    assert [one.target[:3] for one in segments] == [
        (10, 5, 0),
        (45, 5, 0),
        (45, 5, 5),
        (45, 5, 10),
        (45, 40, 10),
        (20, 40, 10),
    ]


def test_a_way_in_space_keeps_its_height(monkeypatch: pytest.MonkeyPatch) -> None:
    """The third axis goes from its start to its target on the shortened way."""
    segments, errors = decoded(START + "G41 X10 Y0\nX50 Z-96\nY40\nG40 X60\n", monkeypatch)
    assert errors == []
    assert segments[1].target[:3] == (45, 5, 4)


def test_the_plane_y_z(monkeypatch: pytest.MonkeyPatch) -> None:
    """G19: from Y to Z is a turn to the left; the length is that of X."""
    text = "G19 G41 Y10 Z0\nY50\nZ40\nG40 Y20\n"
    assert ends(text, monkeypatch, (1, 2)) == [(10, 5), (45, 5), (45, 40), (20, 40)]


def test_a_negative_radius_changes_the_side(monkeypatch: pytest.MonkeyPatch) -> None:
    """G41 is as G42 then."""
    text = "V.G.WZ_AKT.R = -5\nG41 X10 Y0\nX50\nY40\nG40 X60\n"
    assert ends(text, monkeypatch) == [(10, -5), (55, -5), (55, 40), (60, 40)]


def test_a_tangent_that_is_rounded_is_no_corner(monkeypatch: pytest.MonkeyPatch) -> None:
    """Programs give ends with three digits: below 0.01° there is no further piece."""
    text = "X-10\nG26 G42 X0 Y0\nX50\nG03 X64.142 Y5.858 I0 J20\nG01 X80 Y21.716\nG40 X90\n"
    found = ends(text, monkeypatch)
    assert len(found) == 6


def test_each_piece_belongs_to_its_block(monkeypatch: pytest.MonkeyPatch) -> None:
    """What goes around a corner belongs to the block before it; its last piece stops exactly."""
    segments, _ = decoded(
        START + "G26 G360\nN1 G41 X10 Y0\nN2 X50\nN3 Y-40\nN4 G40 X60\n", monkeypatch
    )
    found = [(one.number, one.exact_stop, one.arc is not None) for one in segments]
    assert found == [
        (1, True, False),
        (2, False, False),
        (2, True, True),
        (3, True, False),
        (4, True, False),
    ]


def test_after_g40_the_channel_may_be_emptied(monkeypatch: pytest.MonkeyPatch) -> None:
    """The contour ends beside its last place; the next motion leaves it from there."""
    text = "G41 X10 Y0\nX50\nG40\nP1 = V.RTA.ACS.ACT_POS.Y\nZ[P1 - 100]\nX60 Y-20\n"
    segments, errors = decoded(START + text, monkeypatch)
    assert errors == []
    assert [one.target[:3] for one in segments] == [
        (10, 5, 0),
        (50, 5, 0),
        (50, 5, 5),
        (60, -20, 5),
    ]


def test_at_the_end_of_the_program_the_contour_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without G40 there is no way from it."""
    segments, errors = decoded(START + "G41 X10 Y0\nX50\n", monkeypatch)
    assert errors == []
    assert segments[-1].target[:2] == (50, 5)


@pytest.mark.parametrize(
    ("text", "line", "number"),
    [
        ("F100\nG01 G41 X1\n", 2, 900869),
        ("D3\nG41\n", 2, 900869),
        ("D1 F100\nG41\nG02 X10 Y10 I10\nX20\n", 3, 90008),
        ("D1 F100 G01\nG41 X10\nX20\nG40\nG02 X30 Y10 I10\n", 5, 90013),
        ("D1 F100 G01\nG41 X10\nX20\nG42 G02 X30 Y10 J10\n", 4, 90016),
        ("D1 F100 G01\nG41 X10\nX20\nG03 X20 Y8 J4\n", 4, 90017),
        ("D1 F100 G01\nG41 X10\nX20\nG03 X20 Y10 J5\n", 4, 90017),
        ("D1 F100 G01\nG41 X10\nX20\nG18 X30\n", 4, 20133),
        ("D1 F100 G01\nG41 X10\nX20\nG40\nG19\n", 5, 20133),
        ("D1 F100 G01\nG41 X10\nX20\nD3\n", 4, 900874),
        ("D1 F100 G01\nG41 X10\nX20\nD0\n", 4, 900874),
        ("D1 F100 G01\nG41 X10\nV.G.WZ_AKT.R = 0\n", 3, 900874),
        ("D1 F100 G01\nG41 X10\nX20\nD2 G03 X30 Y10 J10\n", 4, 900952),
        ("D1 F100 G01\nG41 X10\nX50\nY4\nX10\nG40 Y0\n", 4, 90019),
        ("D1 F100 G01 Y40\nG41 X20\nY0\nG03 X22 R20\nG01 Y40\n", 4, 90038),
        ("D1 F99999 G01\nG41 X9996\nX9998\nY-40\nX0\n", 3, 120002),
        ("D1 F100 G01\nG41 X10\nX20\n#FLUSH\n", 4, 20651),
        ("D1 F100 G01\nG41\n#FLUSH CONTINUE\n", 3, 20651),
        ("D1 F100 G01\nG41\n#CHANNEL INIT [CMDPOS]\n", 3, 20651),
        ("D1 F100 G01\nG41\n#RT CYCLE DELETE [ID=1]\n", 3, 20651),
        ("D1 F100 G01\nG41\n#TIMER READ SYN [ID=1]\n", 3, 20651),
        ("D1 F100 G01\nG41\nV.RTG.LOOP.COUNT = 1\n", 3, 20651),
        ("D1 F100 G01\nG41\nP1 = V.E.VALUE\n", 3, 20651),
        (
            "#RT CYCLE [SCOPE=PROG]\nX[INDP G00 G90 POS=5]\n#RT CYCLE END\nD1 F9 G01\nG41\nX9\n",
            6,
            20651,
        ),
    ],
)
def test_what_cannot_be_compensated(text: str, line: int, number: int) -> None:
    """Each mistake has its number, and its place is that of its block or word."""
    run = Controller().run(NcText("p.nc", text + "M30\n"), signals=[])
    (found,) = run.errors
    assert found.id == number
    assert found.span is not None
    assert found.span.line == line
    assert found.render("de")


@pytest.mark.parametrize(
    ("command", "advice"),
    [
        ("#RT CYCLE DELETE [ID=1]", ""),
        ("#FLUSH", ""),
        ("P1 = V.E.VALUE", " A realtime cycle may use V.E.VALUE."),
        ("V.RTG.LOOP.COUNT = 1", " A realtime cycle may use V.RTG.LOOP.COUNT."),
    ],
)
def test_only_a_variable_is_sent_to_a_realtime_cycle(
    command: str, advice: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """20651: the remedy is one for what is there, in the check and in the run."""
    file = tmp_path / "part.nc"
    file.write_text(f"D1 F100 G01\nG41 X10\nX20\n{command}\nG40 X0\nM30\n", "utf-8")
    (found,) = Controller().run(file, signals=[]).errors
    assert found.remedy() == f"Move it before G41 or after its end.{advice}"
    assert main(["check", str(file)]) == 1
    assert f"remedy: {found.remedy()}\n" in capsys.readouterr().out


def test_too_much_between_two_motions() -> None:
    """What waits is bounded: 90109."""
    text = "D1 F100 G01\nG41 X10\n$WHILE 1\nV.E.VALUE = P1\nP1 += 1\n$ENDWHILE\nM30\n"
    run = Controller().run(NcText("p.nc", text), signals=[])
    assert [one.id for one in run.errors] == [90109]


def test_d_and_g41_may_be_in_one_block_and_d0_with_g40(monkeypatch: pytest.MonkeyPatch) -> None:
    """The radius is that of the block's own D."""
    segments, errors = decoded("F100 G01 D2\nG41 D1 X10 Y0\nX50\nG40 D0 Y20\n", monkeypatch)
    assert errors == []
    assert [one.target[:2] for one in segments] == [(10, 5), (50, 5), (50, 20)]


def test_a_motion_that_is_only_rounding_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    """0.1 + 0.2 is not 0.3: the way between both has no direction that a tool could go beside."""
    text = "X0.1\nG41\nG91 X0.2\nG90 X0.3\nX50\nG91 Y10.1\nY10.2\nG90 Y20.3\nZ-95\nG40 X20\n"
    found = ends(text, monkeypatch)
    assert found == [(0.1, 0), (0.3, 5), (45, 5), (45, 10.1), (45, 20.3), (45, 20.3), (20, 20.3)]


@pytest.mark.parametrize("corners", ["G25", "G26"])
def test_the_way_around_a_corner_is_part_of_its_block(corners: str) -> None:
    """A BLOCK cycle runs until the last piece is over (RC-105), and with the next block no more."""
    text = (
        f"{START}G360 {corners} G41 X10 Y0\n#RT CYCLE [ID=1 SCOPE=BLOCK]\nV.E.COUNT += 1\n"
        "#RT CYCLE END\nX50\nX20\nG40 X0\nM30\n"
    )
    controller = Controller()
    signals = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS"]
    run = controller.run(NcText("p.nc", text), signals=signals)
    assert run.errors == ()
    assert run.trace is not None
    places = list(zip(*(run.trace[name].tolist() for name in signals), strict=True))
    begun, over = places.index((10, 5)), next(n for n, (_, y) in enumerate(places) if y == -5)
    assert places[over][0] == (55 if corners == "G25" else 50)
    ended = [event.tick for event in run.events if event.kind == "ended"]
    assert ended == [over + 1]
    assert controller.read("V.E.COUNT") == over - begun


def test_a_compensated_contour_is_walked_back_on_its_curve(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Ways around corners are part of the history (MO-7)."""
    text = f"{START}F60000 G26 G41 X10 Y0\nX60\nY-60\nG03 X90 Y-60 I15\nG01 X120\nG40 Y0\n"
    segments, _ = decoded(text, monkeypatch)
    signals = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS"]
    back = [
        Stimulus("400 ms", "HLI.BACKWARD_MOTION", 1),
        Stimulus("750 ms", "HLI.BACKWARD_MOTION", 0),
    ]
    run = Controller().run(NcText("p.nc", text + "M30\n"), signals=signals, at=back)
    assert run.errors == ()
    assert run.trace is not None
    places = list(zip(*(run.trace[name].tolist() for name in signals), strict=True))
    assert len(places) > 1000
    ways = [way(one) for one in segments]
    assert max(min(distance(place, one) for one in ways) for place in places) < 1e-9
    assert places[-1] == (120, 0)
    assert min(x for x, _ in places[600:900]) < 60


@pytest.mark.parametrize(
    ("block", "number"),
    [("G03 X50 Y8 J4", 90017), ("G03 X50 Y10 J5", 90017), ("G40 G02 X60 Y10 I10", 90013)],
)
def test_before_a_block_that_cannot_be_compensated_all_is_run(block: str, number: int) -> None:
    """The program ends with the error where the contour before it ends, as with any other."""
    run = Controller().run(
        NcText("p.nc", f"{START}G41 X10 Y0\nX50\n{block}\nM30\n"),
        signals=["X.ACS.ACT_POS", "Y.ACS.ACT_POS"],
    )
    assert [one.id for one in run.errors] == [number]
    assert run.trace is not None
    assert (run.trace["X.ACS.ACT_POS"][-1], run.trace["Y.ACS.ACT_POS"][-1]) == (50, 5)


@pytest.mark.parametrize(
    ("blocks", "number", "line", "end"),
    [
        # a mistake of the decoder itself, and those that compensation finds
        ("X[1/0]", 20396, 5, (45, 20)),
        ("M100\nX[1/0]", 20396, 6, (45, 20)),
        ("G03 X50 Y28 J4", 90017, 5, (45, 20)),
        ("M100\nG03 X50 Y28 J4", 90017, 6, (45, 20)),
        ("G40 G02 X60 Y20 I5", 90013, 5, (45, 20)),
        # where the block before it meets the one that does not fit the next one shows
        ("X48\nY0", 90019, 5, (45, 15)),
    ],
)
def test_the_program_ends_before_the_block_with_the_mistake(
    blocks: str, number: int, line: int, end: tuple[float, float]
) -> None:
    """Whoever finds the mistake, the block before it is run to its end (MO-9)."""
    run = Controller().run(
        NcText("p.nc", f"{START}G41 X10 Y0\nX50\nY20\n{blocks}\nM30\n"),
        signals=["X.ACS.ACT_POS", "Y.ACS.ACT_POS"],
    )
    assert [(one.id, one.span.line) for one in run.errors if one.span] == [(number, line)]
    assert run.trace is not None
    assert (run.trace["X.ACS.ACT_POS"][-1], run.trace["Y.ACS.ACT_POS"][-1]) == end


@pytest.mark.parametrize(
    ("corners", "ways"),
    [("G26", (40 + 2.5 * pi, 40 + 2.5 * pi, 40)), ("G25", (45, 50, 45))],
)
def test_the_time_of_g93_is_that_of_the_block_with_its_corner(
    corners: str, ways: tuple[float, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """G93: the tool's centre takes 2 s for all pieces of a block, whatever their way is."""
    text = f"D1 G01 {corners} G93 F2\nG41 X10 Y0\nX50\nY-40\nX10\nG40 X0\n"
    segments, errors = decoded(text, monkeypatch)
    assert errors == []
    for line, expected in enumerate(ways, start=3):
        pieces = [one for one in segments if one.source >> 20 & 0xFFFF == line]
        assert sorted({one.feed for one in pieces}) == [pytest.approx(expected / 2)]


@pytest.mark.parametrize("slope", ["", "#SLOPE [TYPE=STEP]\n", "#SLOPE [TYPE=TRAPEZ]\n"])
def test_single_block_stops_after_the_way_around_the_corner(slope: str) -> None:
    """MO-6: a block ends with its last piece; at 50 mm/s the path continues into the arc.

    X from 10 to 50 beside Y 0, then the arc of 5 mm; N30 has one as well, since N40 leaves the
    contour around a corner. The only is are those of the blocks.
    """
    text = f"{START}F3000 G26\n{slope}N10 G41 X10 Y0\nN20 X50\nN30 Y-40\nN40 G40 X20\nM30\n"
    single = [Stimulus(0, "HLI.SINGLE_BLOCK", 1)]
    single += [Stimulus(time, "HLI.START", 1) for time in range(1, 9)]
    signals = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "HLI.PAUSED"]
    run = Controller().run(NcText("p.nc", text), signals=signals, at=single)
    assert run.errors == ()
    assert run.trace is not None
    rows = list(zip(*(run.trace[name].tolist() for name in signals), strict=True))
    stands = {one[:2] for before, one in pairwise(rows) if before[:2] == one[:2]}
    assert stands == {(0, 0), (10, 5), (55, 0), (50, -45), (20, -40)}
    paused = {one[:2] for one in rows if one[2]}
    assert (55, 0) in paused
    assert (50, 5) not in paused
