# SPDX-License-Identifier: MIT
"""Paths of a PLC's variables that lead nowhere, and values that are given from outside."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.plc_rig import EACH_TICK

from nctakt import Controller, NcText
from nctakt.base.failure import Failure
from nctakt.plc.loading import load_plc, load_plcs
from nctakt.run.access.stimuli import parse_assignment
from nctakt.testing.expectations import read_script

PLC = (
    "TYPE E_Gate : (Closed, Open := 5); END_TYPE "
    "TYPE ST_Part : STRUCT nLife : INT; aWay : ARRAY[-1..1, 0..2] OF INT; END_STRUCT END_TYPE "
    "VAR_GLOBAL CONSTANT cMax : INT := 10; END_VAR "
    "PROGRAM MAIN VAR n : UINT; a : ARRAY[0..5] OF INT; stPart : ST_Part; sText : STRING; "
    "eGate : E_Gate; tWait : TIME; dtDay : DATE; fWay : LREAL; pNext : POINTER TO INT; "
    "nIndex : INT; END_VAR IF nIndex > 0 THEN n := INT_TO_UINT(a[nIndex]); END_IF "
    "END_PROGRAM" + EACH_TICK
)
NC = NcText("part.nc", "G04 0.01\nM30\n")


@pytest.fixture(name="cell")
def _cell(tmp_path: Path) -> Path:
    path = tmp_path / "cell.st"
    path.write_text(PLC, "utf-8")
    return path


@pytest.mark.parametrize(
    ("name", "part", "type_"),
    [
        ("MAIN.a[7]", "MAIN.a", "ARRAY[0..5] OF INT"),
        ("MAIN.stPart.aWay[2, 0]", "MAIN.stPart.aWay", "ARRAY[-1..1, 0..2] OF INT"),
        ("MAIN.stPart.aWay[0]", "MAIN.stPart.aWay", "ARRAY[-1..1, 0..2] OF INT"),
        ("MAIN.n.nOther", "MAIN.n", "UINT"),
        ("MAIN.n[1]", "MAIN.n", "UINT"),
    ],
)
def test_a_part_that_there_is_not_is_reported_with_the_type(
    cell: Path, name: str, part: str, type_: str
) -> None:
    """ST-311: as a signal, an input, and in one of several PLCs by its project."""
    shown = f"there is no {name}: {part} is {type_}"
    with pytest.raises(Failure, match="902962") as signal:
        Controller().run(NC, plc=load_plc(cell), signals=[name])
    with pytest.raises(Failure, match="902962") as value:
        Controller().run(NC, plc=load_plc(cell), at=[("1 ms", name, 1)])
    assert {signal.value.diagnostics[0].text(), value.value.diagnostics[0].text()} == {shown}
    with pytest.raises(Failure) as second:
        plcs = load_plcs([cell, cell])
        Controller().run(NC, plc=plcs, signals=[f"cell_2.{name}"])
    assert second.value.diagnostics[0].text() == shown


def test_what_is_no_signal_is_reported_with_its_type(cell: Path) -> None:
    for name, type_ in (("MAIN.a", "ARRAY[0..5] OF INT"), ("MAIN.sText", "STRING(80)")):
        with pytest.raises(Failure, match="902963") as failure:
            Controller().run(NC, plc=load_plc(cell), signals=[name])
        assert failure.value.diagnostics[0].text().startswith(f"{name} is {type_}, ")
    with pytest.raises(Failure, match=r"Did you mean MAIN\.stPart\.nLife"):
        Controller().run(NC, plc=load_plc(cell), signals=["MAIN.stPart.nLfe"])


def test_an_expectation_has_its_place(cell: Path, tmp_path: Path) -> None:
    script = read_script(tmp_path / "part.nc", "G04 0.01\nM30 ; expect: MAIN.a[6] = 1 at end\n")
    with pytest.raises(Failure, match="902962") as failure:
        Controller().run(NC, plc=load_plc(cell), signals=["MAIN.a[6]"])
    span = script.placed(failure.value).diagnostics[0].span
    assert span is not None and (span.line, span.column) == (2, 15)


def test_an_index_that_stops_the_plc_is_reported_with_the_bounds(cell: Path) -> None:
    """ST-311, ST-560."""
    done = Controller().run(NC, plc=load_plc(cell), at=[("1 ms", "MAIN.nIndex", 6)])
    (found,) = [one for one in done.diagnostics if one.message.id == 902266]
    assert "index 6 is outside of its array [0..5]" in found.text()


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("MAIN.tWait=T#2s", 2000),
        ("MAIN.dtDay=D#1970-01-02", 86_400),
        ("MAIN.n=16#FF", 255),
        ("MAIN.a[1]=INT#-5", -5),
        ("MAIN.fWay=2#101", 5),
        ("MAIN.eGate=E_Gate#Open", "E_Gate.Open"),
    ],
)
def test_values_are_literals_of_the_language(cell: Path, text: str, value: object) -> None:
    """ST-206, ST-207."""
    plc, (name, given) = load_plc(cell), parse_assignment(text)
    Controller().run(NC, plc=plc, at=[("1 ms", name, given)])
    assert plc.read(name) == value


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("MAIN.n", "T#2s"),  # a duration is no number (ST-306)
        ("MAIN.tWait", "LTIME#2s"),
        ("MAIN.n", "16#1FFFF"),
        ("MAIN.n", "INT#x"),
        ("MAIN.pNext", "16#1000"),
    ],
)
def test_literals_of_other_types_are_refused(cell: Path, name: str, text: str) -> None:
    with pytest.raises(Failure, match="902262"):
        Controller().run(NC, plc=load_plc(cell), at=[("1 ms", name, text)])


def test_constants_are_not_set(cell: Path) -> None:
    """ST-401."""
    with pytest.raises(Failure, match="902964"):
        Controller().run(NC, plc=load_plc(cell), at=[("1 ms", "cMax", 3)])


def test_a_var_in_out_has_no_path(tmp_path: Path) -> None:
    """ST-401: its eight bytes hold an address, which is neither shown nor overwritten."""
    text = (
        "FUNCTION_BLOCK FB VAR_IN_OUT r : INT; END_VAR VAR n : INT; END_VAR n := r; "
        "END_FUNCTION_BLOCK PROGRAM MAIN VAR fb : FB; k : INT := 7; END_VAR fb(r := k); END_PROGRAM"
    )
    (tmp_path / "cell.st").write_text(text + EACH_TICK, "utf-8")
    plc = load_plc(tmp_path / "cell.st")
    for words in ({"signals": ["MAIN.fb.r"]}, {"at": [("1 ms", "MAIN.fb.r", 1)]}):
        with pytest.raises(Failure, match=r"90054[04]"):
            Controller().run(NC, plc=plc, **words)
    run = Controller().run(NC, plc=plc, signals=["MAIN.fb.n"])
    assert int(run.trace["MAIN.fb.n"][-1]) == 7
