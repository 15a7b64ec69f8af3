# SPDX-License-Identifier: MIT
"""Sources of libraries, and stubs for them, as ``[plc] libraries`` names them (ST-107, ST-724)."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner
from support.plc_rig import run
from support.plc_text import pou_file

from nctakt.cli.check import command
from nctakt.plc.structured_text import load_structured

PROJECT = """<Project xmlns="http://schemas.microsoft.com/developer/msbuild/2003"><ItemGroup>
<Compile Include="MAIN.TcPOU"/><PlaceholderReference Include="Tc2_Standard"/>
<PlaceholderReference Include="Vendor_Valves"/></ItemGroup></Project>
"""
VALVES = """FUNCTION_BLOCK FB_Valve
VAR_INPUT bOpen : BOOL; END_VAR
VAR_OUTPUT eState : E_Valve; END_VAR
VAR t : TON := (PT := T#2MS); END_VAR
t(IN := bOpen);
eState := SEL(t.Q, E_Valve.Shut, E_Valve.Open);
END_FUNCTION_BLOCK
TYPE E_Valve : (Shut, Open := 7); END_TYPE
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A project that uses a library whose sources lie in ``libraries``."""
    (tmp_path / "libraries" / "Vendor_Valves").mkdir(parents=True)
    body = "fb(bOpen := TRUE); n := fb.eState; m := Vendor_Valves.E_Valve.Open;"
    declared = "PROGRAM MAIN\nVAR fb : FB_Valve; n, m : INT; END_VAR"
    files = {
        "Cell.plcproj": PROJECT,
        "MAIN.TcPOU": pou_file("MAIN", declared, body),
        "libraries/Vendor_Valves/valves.st": VALVES,
        "nctakt.toml": '[plc]\nfile = "Cell.plcproj"\nlibraries = ["libraries"]\n',
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text, "utf-8")
    return tmp_path


def checked(path: Path) -> list[tuple[int, str]]:
    """The numbers of what ``nctakt check`` reports, and the files."""
    done = CliRunner().invoke(command, [str(path), "--format", "json"])
    findings = json.loads(done.stdout)["diagnostics"]
    return [(one["id"], Path(one["file"]).name) for one in findings if one["severity"] == "error"]


def test_a_library_with_sources_is_checked_and_runs(folder: Path) -> None:
    """Names with and without the library's name; blocks of it run as they are written."""
    assert checked(folder / "Cell.plcproj") == []
    plc = load_structured(folder / "Cell.plcproj")
    assert not run(plc, 31).errors
    assert [plc.read(f"MAIN.{name}") for name in ("n", "m")] == [7, 7]


def test_what_reaches_outside_is_refused_without_a_stub(folder: Path) -> None:
    """ST-724: FB_FileOpen is refused by name; with a stub of the user it runs."""
    declared = "PROGRAM MAIN\nVAR fb : FB_FileOpen; n : INT; END_VAR"
    (folder / "MAIN.TcPOU").write_text(pou_file("MAIN", declared, "fb(); n := fb.nOf;"), "utf-8")
    assert [file for _, file in checked(folder / "Cell.plcproj")] == ["MAIN.TcPOU"]
    stub = "FUNCTION_BLOCK FB_FileOpen VAR_OUTPUT nOf : INT := 3; END_VAR END_FUNCTION_BLOCK"
    (folder / "libraries" / "stubs").mkdir()
    (folder / "libraries" / "stubs" / "files.st").write_text(stub, "utf-8")
    plc = load_structured(folder / "Cell.plcproj")
    assert not run(plc, 11).errors
    assert plc.read("MAIN.n") == 3


def test_without_sources_the_library_is_named(folder: Path) -> None:
    """The unknown type says of which library it may be."""
    (folder / "nctakt.toml").write_text('plc = "Cell.plcproj"\n', "utf-8")
    done = CliRunner().invoke(command, [str(folder / "Cell.plcproj")])
    assert "FB_Valve" in done.output
    assert "Vendor_Valves" in done.output


def test_mistakes_of_a_library_have_its_place(folder: Path) -> None:
    """What its own text lacks is reported there."""
    text = VALVES.replace("t(IN := bOpen);", "t(IN := bOpe);")
    (folder / "libraries" / "Vendor_Valves" / "valves.st").write_text(text, "utf-8")
    assert checked(folder / "Cell.plcproj") == [(902190, "valves.st")]


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ('[plc]\nlibraries = ["gone"]\n', 901063),
        ("[plc]\nlibraries = 5\n", 901062),
        ('[plc]\nlibarries = ["libraries"]\n', 901061),
    ],
)
def test_wrong_entries_have_their_line(folder: Path, text: str, number: int) -> None:
    """Folders that are missing, wrong values, unknown names."""
    (folder / "nctakt.toml").write_text(text, "utf-8")
    done = CliRunner().invoke(command, [str(folder / "Cell.plcproj")])
    assert f"nctakt.toml:2:1: error {number}" in done.output


def test_lists_and_structures_of_a_library_begin_with_their_values(folder: Path) -> None:
    """Initial values of its variables are checked and count, those of members as well (ST-403)."""
    text = """VAR_GLOBAL nFirst : INT := 3 + 4; stFirst : ST_First; END_VAR
        TYPE ST_First : STRUCT n : INT := 5; END_STRUCT END_TYPE
        """
    path = folder / "libraries" / "Vendor_Valves" / "valves.st"
    path.write_text(VALVES + text, "utf-8")
    body = "fb(bOpen := TRUE); n := nFirst; m := stFirst.n;"
    declared = "PROGRAM MAIN\nVAR fb : FB_Valve; n, m : INT; END_VAR"
    (folder / "MAIN.TcPOU").write_text(pou_file("MAIN", declared, body), "utf-8")
    plc = load_structured(folder / "Cell.plcproj")
    assert not run(plc, 2).errors
    assert (plc.read("MAIN.n"), plc.read("MAIN.m")) == (7, 5)
