# SPDX-License-Identifier: MIT
"""What programs read and write by V.G and V.A: positions, offsets, feed (nc-programs, RC-308)."""

from __future__ import annotations

import pytest

from nctakt.nc.vocabulary.variables.system_names import ROWS, SystemRow
from nctakt.results.run import ProgramMessage, Run
from nctakt.run.controller import Controller, NcText


def said(text: str, controller: Controller | None = None) -> tuple[Run, list[str]]:
    """A program's run, and what it says."""
    found: list[ProgramMessage] = []
    run = (controller or Controller()).run(NcText("p.nc", text), on_message=found.append)
    assert not run.errors, run.errors
    return run, [one.text for one in found]


def shown(names: str) -> str:
    """A message with values."""
    count = names.count(",") + 1
    return f'#MSG ["{" ".join(["%g"] * count)}", {names}]\n'


def test_positions_of_the_block_before() -> None:
    """ABS with all offsets, PROG without; an index is the place in the channel."""
    text = (
        "G00 X10 Y20\n"
        + shown("V.A.ABS.X, V.A.PROG.X, V.A.MENT.X, V.A.ABS[1]")
        + "G92 X3\n"
        + shown("V.A.ABS.X, V.A.PROG.X, V.A.BZP.X")
        + "G00 X10\n"
        + shown("V.A.ABS.X, V.A.PROG.X")
        + "#CS ON [0, 5, 0, 0, 0, 90]\n"
        + shown("V.A.ABS.X, V.A.ABS.Y")
        + "#CS OFF\nG70\n"
        + shown("V.A.PROG.X * 25.4, V.G.MASS_MM")
        + "G71\n"
        + shown("V.G.MASS_MM, V.G.MASS_360, V.A.MODULO_VALUE.X")
    )
    run, reported = said(text + "M30")
    assert reported == ["10 10 10 20", "10 7 3", "13 10", "15 -10", "10 1", "0 0 0"]
    assert run.state == "ended"


def test_measured_positions_wait_until_the_path_stops() -> None:
    """RC-308: the decoder waits; 10 mm take 100 ms, and the answer is that of the tick at rest."""
    text = "G00 X10\nP1 = V.A.ACT_POS.X + V.A.ACS.ABS[0]\n" + shown("P1") + "M30"
    run, reported = said(text)
    assert reported == ["20"]
    assert run.ticks > 100
    run = Controller().run(
        NcText("p.nc", "D1 F6000 G01\nG41 X10\nX50\nP1 = V.A.ACT_POS.X\nG40 X60\nM30")
    )
    assert 20651 in [error.id for error in run.errors]


def test_a_measured_position_is_in_the_active_system_without_offsets() -> None:
    """V.A.ACT_POS as V.A.PROG, V.A.ACS.ABS that of the axis."""
    text = "G00 X10\nG92 X4\n" + shown("V.A.ACT_POS.X, V.A.ACS.ABS.X") + "M30"
    assert said(text)[1] == ["6 10"]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("F600", "600 94 1"),
        ("F600\nG70", "23.622 94 1"),
        ("G70 F10", "10 94 1"),
        ("G93 F3", "3 93 1"),
        ("F500\nG95 F0.5", "0.5 95 1"),
        ("F500\nG95 F0.5\nG94", "500 94 1"),
    ],
)
def test_the_feed_in_the_unit_of_its_kind(words: str, expected: str) -> None:
    """FEEDRATE is the last F of the kind that is active (G93, G94, G95)."""
    text = words + "\n" + shown("V.G.FEEDRATE, V.G.FEEDRATE_MODE, V.G.FEEDRATE_SCALE") + "M30"
    assert said(text)[1] == [expected]


def test_zero_offsets_are_read_and_written() -> None:
    """NP_AKT is the active one until the next is selected; NP is the list, also for later programs.

    The demo machine has 25 mm in Y for G55.
    """
    controller = Controller()
    text = (
        "V.G.NP[2].V.X = 7\nV.G.NP[1 + 1].V[1] += 2\n"
        + shown("V.G.NP[2].V.X, V.G.NP[2].V.Y, V.G.NP_AKT.V.X")
        + "G55\n"
        + shown("V.G.NP_AKT.V.X, V.G.NP_AKT.V[1]")
        + "V.G.NP_AKT.V.X = 10\nG00 X1\n"
        + shown("V.A.ABS.X, V.A.PROG.X, V.G.NP[2].V.X")
        + "G55 G00 X1\n"
        + shown("V.A.ABS.X")
        + "V.G.NP_DEFAULT = 2\nM30"
    )
    assert said(text, controller)[1] == ["7 27 0", "7 27", "11 1 7", "8"]
    behind = shown("V.G.NP_DEFAULT, V.G.NP_AKT.V.X, V.A.PROG.X") + "M30"
    assert said(behind, controller)[1] == ["2 7 1"]


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ("P1 = V.A.ABS[9]", 21928),
        ("P1 = V.G.NP[97].V.X", 21928),
        ("V.G.NP_AKT.V[P2 - 1] = 5", 21928),
        ("V.G.NP_DEFAULT = 97", 20149),
        ("P1 = V.A.ABS[1 / P2]", 20396),
        ("V.G.NP_AKT.V.X = V.P.T", 21461),
    ],
)
def test_an_index_outside_ends_the_program(line: str, error: int) -> None:
    """As for any array of the language (21928)."""
    run = Controller().run(NcText("p.nc", f'V.P.T = "t"\n{line}\nM30'))
    assert [found.id for found in run.errors] == [error]
    assert run.errors[0].render("de")


def test_a_cycle_gets_the_value_of_its_definition() -> None:
    """RC-302: only the decoder knows these values, so they are constants."""
    text = (
        "G00 X5\n#RT CYCLE [ID=1 SCOPE=PROG]\nV.E.VALUE = V.A.ABS.X + V.G.FEEDRATE_MODE\n"
        "#RT CYCLE END\nG00 X9\nM30"
    )
    controller = Controller()
    run, _ = said(text, controller)
    assert controller.read("V.E.VALUE") == 99.0
    assert any(event.kind == "frozen" and event.text == "V.A.ABS.X 5" for event in run.events)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.name)
def test_each_row_of_the_table_can_be_read(row: SystemRow) -> None:
    """What the documentation names programs can use, and write where it says so."""
    assert len(said(shown(row.name) + "M30")[1]) == 1
    other = Controller().run(NcText("p.nc", f"{row.name} = 1\nM30"))
    assert (not other.errors) == row.is_writable


def test_the_last_arc_and_block() -> None:
    """V.G.I, J, K, R, MERR, BLOCK_NR, PROG_NR: what the program has said last."""
    text = (
        "N10 G01 X10 F6000\nN20 G03 X20 Y10 I0 J10\n"
        + shown("V.G.I, V.G.J, V.G.K, V.G.R, V.G.MERR[0], V.G.BLOCK_NR")
        + "G91\nG02 X10 Y0 I5.004\n"
        + shown("V.G.I, V.G.J, V.G.R, V.G.MERR[0], V.G.MERR[1], V.G.SATZ_NR")
        + "G02 X10 Y0 R13\n"
        + shown("V.G.I, V.G.R, V.G.MERR[0], V.G.PROG_NR")
        + "M30"
    )
    reported = said(text)[1]
    assert reported[0] == "0 10 0 10 0 20"
    assert reported[1] == "5.004 0 5 -0.004 0 20"
    assert reported[2] == "0 13 0 0"


def test_the_last_block_of_plain_lines() -> None:
    """V.G.BLOCK_NR after many lines that need no tree."""
    lines = [f"N{10 * i} X{i}" for i in range(1, 40)]
    text = "\n".join(["G01 F6000", *lines, "X1", "X2"]) + "\n" + shown("V.G.BLOCK_NR") + "M30"
    assert said(text)[1] == ["390"]


def test_offsets_of_all_axes_are_copied() -> None:
    """V.G.NP[1].ALL, V.G.NP_AKT.ALL: from the list into what is active, and back."""
    text = (
        "V.G.NP[2].V.X = 7\nV.G.NP[2].V.Y = 8\nV.G.NP[12].ALL = V.G.NP[2].ALL\n"
        + shown("V.G.NP[12].V.X, V.G.NP[12].V.Y, V.G.NP[12].V.Z, V.G.NP_AKT.V.X")
        + "V.G.NP_AKT.ALL = V.G.NP[12].ALL\nG00 X1\n"
        + shown("V.A.ABS.X, V.A.PROG.X")
        + "V.G.NP_AKT.V.X = 3\nV.G.NP[2].ALL = V.G.NP_AKT.ALL\n"
        + shown("V.G.NP[2].V.X, V.G.NP[2].V.Y, V.G.NP[12].V.X")
        + "M30"
    )
    assert said(text)[1] == ["7 8 0 0", "8 1", "3 8 7"]


def test_modes_shifts_and_manual_ways() -> None:
    """V.A.MODE is P-AXIS-00015; the shift of a system is that of its zero; nobody moves by hand."""
    text = (
        shown("V.A.MODE.X, V.A.SOFFS.X, V.G.SELECTED_CS.TRANS.X")
        + "G92 X1\n#CS ON [2, 3, 4]\n"
        + shown("V.G.SELECTED_CS.TRANS.X, V.G.SELECTED_CS.TRANS.Y, V.G.SELECTED_CS.TRANS.Z")
        + "M30"
    )
    assert said(text)[1] == ["1 0 0", "3 3 4"]


@pytest.mark.parametrize(
    ("line", "number", "text"),
    [
        ("P1 = V.G.VOLCOMP[0].ACTIVE", 900200, "volumetric compensation"),
        ("P1 = V.G.RW", 900200, "edge banding"),
        ("P1 = V.G.NP_AKT.ALL", 900200, "copied"),
        ("V.G.NP_AKT.ALL = 5", 900200, "copied"),
        ("V.G.BLOCK_NR = 5", 20100, "V.G.BLOCK_NR"),
        ("V.A.ABS.X = 5", 20100, "V.A.ABS.X"),
        ("P1 = V.G.MERR[2]", 21928, "V.G.MERR"),
        ("V.G.NP[97].ALL = V.G.NP[1].ALL", 21928, "V.G.NP"),
    ],
)
def test_what_is_refused_says_why(line: str, number: int, text: str) -> None:
    """Each with the reason of its own."""
    (found,) = Controller().run(NcText("p.nc", f"{line}\nM30")).diagnostics
    assert found.id == number
    assert text in found.text("en")
