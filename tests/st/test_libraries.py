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
from nctakt.messages import Collector
from nctakt.plc.error import PlcError
from nctakt.plc.structured_text import load_structured
from nctakt.plc.unit_tests import load_suites
from nctakt.st.check.project import checker_of
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Sources
from nctakt.st.vocabulary.libraries import (
    BASE_TYPES,
    NC_AXES,
    declared_names,
    default_libraries,
    seen_words,
)

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


def test_interfaces_and_properties_of_a_library_run(folder: Path) -> None:
    """ST-603, 604: a call through its interface, Get and Set with their own variables."""
    text = """INTERFACE I_Level METHOD Add : INT VAR_INPUT n : INT; END_VAR END_METHOD
        PROPERTY Level : INT GET END_GET SET END_SET END_PROPERTY END_INTERFACE
        FUNCTION_BLOCK FB_Level IMPLEMENTS I_Level VAR _n : INT; END_VAR
        METHOD Add : INT VAR_INPUT n : INT; END_VAR _n := _n + n; Add := _n; END_METHOD
        PROPERTY Level : INT GET Level := _n; END_GET
        SET VAR k : INT; END_VAR k := 2 * Level; _n := k; END_SET END_PROPERTY
        END_FUNCTION_BLOCK
        """
    path = folder / "libraries" / "Vendor_Valves" / "valves.st"
    path.write_text(VALVES + text, "utf-8")
    declared = "PROGRAM MAIN\nVAR fb : FB_Level; i : I_Level; n, m : INT; END_VAR"
    body = "i := fb; i.Level := 4; n := i.Add(3); m := i.Level;"
    (folder / "MAIN.TcPOU").write_text(pou_file("MAIN", declared, body), "utf-8")
    plc = load_structured(folder / "Cell.plcproj")
    assert not run(plc, 1).errors
    assert (plc.read("MAIN.n"), plc.read("MAIN.m")) == (11, 11)


def test_libraries_use_others_that_the_project_does_not_name(folder: Path) -> None:
    """TcUnit's names use those of Tc2_Utilities, which the project itself does not see."""
    project = PROJECT.replace("Vendor_Valves", "TcUnit")
    (folder / "Cell.plcproj").write_text(project, "utf-8")
    declared = "PROGRAM MAIN\nVAR s : STRING; END_VAR"
    for body, expected in (("TcUnit.RUN();", []), ("s := F_ToUCase('a');", [902190])):
        (folder / "MAIN.TcPOU").write_text(pou_file("MAIN", declared, body), "utf-8")
        found = [number for number, file in checked(folder / "Cell.plcproj")]
        assert found == expected


def test_files_of_a_known_name_add_to_it_and_a_project_replaces_it(folder: Path) -> None:
    """ST-107: an object of the user's comes before one that nctakt has."""
    valves = folder / "libraries" / "Vendor_Valves"
    (valves / "Tc2_Standard").mkdir()
    standard = folder / "libraries" / "Tc2_Standard"
    standard.mkdir()
    own = "FUNCTION_BLOCK TON VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; END_VAR"
    (standard / "ton.st").write_text(f"{own} Q := TRUE; END_FUNCTION_BLOCK", "utf-8")
    declared = "PROGRAM MAIN\nVAR t : TON; c : CTU; n : INT; END_VAR"
    body = "t(PT := T#1H); c(CU := TRUE, PV := 1); IF t.Q THEN n := c.CV; END_IF"
    (folder / "MAIN.TcPOU").write_text(pou_file("MAIN", declared, body), "utf-8")
    plc = load_structured(folder / "Cell.plcproj")
    assert not run(plc, 1).errors
    assert plc.read("MAIN.n") == 1
    whole = '<Project><ItemGroup><Compile Include="ton.TcPOU"/></ItemGroup></Project>'
    (standard / "Tc2_Standard.plcproj").write_text(whole, "utf-8")
    (standard / "ton.TcPOU").write_text(pou_file("TON", own, "Q := TRUE;"), "utf-8")
    assert checked(folder / "Cell.plcproj") == [(902191, "MAIN.TcPOU")]


def test_suites_of_other_sources_are_refused_by_the_test_command(folder: Path) -> None:
    """ST-904, 902911: a project of the name TcUnit keeps its results in its own way."""
    (folder / "Cell.plcproj").write_text(PROJECT.replace("Vendor_Valves", "TcUnit"), "utf-8")
    own = folder / "libraries" / "TcUnit"
    own.mkdir()
    whole = '<Project><ItemGroup><Compile Include="FB_TestSuite.TcPOU"/></ItemGroup></Project>'
    (own / "TcUnit.plcproj").write_text(whole, "utf-8")
    (own / "FB_TestSuite.TcPOU").write_text(
        pou_file("FB_TestSuite", "FUNCTION_BLOCK FB_TestSuite", ""), "utf-8"
    )
    declared = "PROGRAM MAIN\nVAR fb : FB_TestSuite; END_VAR"
    (folder / "MAIN.TcPOU").write_text(pou_file("MAIN", declared, "fb();"), "utf-8")
    assert checked(folder / "Cell.plcproj") == []
    with pytest.raises(PlcError, match="902911"):
        load_suites(folder / "Cell.plcproj")


def test_names_of_libraries_have_the_libraries_they_refer_to(folder: Path) -> None:
    """ST-203: a library below the name of another; the classes of types of its base library."""
    text = "TYPE E_Bus : (Down, Up := 4); END_TYPE\nVAR_GLOBAL CONSTANT LIMIT : INT := 9; END_VAR\n"
    bus = folder / "libraries" / "Vendor_Bus"
    bus.mkdir()
    (bus / "bus.st").write_text(text, "utf-8")
    project = PROJECT.replace("Tc2_Standard", "Base Interfaces")
    (folder / "Cell.plcproj").write_text(project, "utf-8")
    declared = "PROGRAM MAIN\nVAR n, m, k : INT; e : Vendor_Valves.Vendor_Bus.E_Bus; END_VAR"
    body = (
        "n := Vendor_Valves.Vendor_Bus.E_Bus.Up; m := Vendor_Valves.Vendor_Bus.LIMIT;"
        " IF IBaseLibrary.TypeClass.TYPE_BOOL = 0 THEN k := 1; END_IF"
    )
    (folder / "MAIN.TcPOU").write_text(pou_file("MAIN", declared, body), "utf-8")
    valves = folder / "libraries" / "Vendor_Valves" / "valves.st"
    valves.write_text("TYPE T_Any : INT; END_TYPE", "utf-8")
    assert checked(folder / "Cell.plcproj") == []
    plc = load_structured(folder / "Cell.plcproj")
    assert not run(plc, 1).errors
    assert [plc.read(f"MAIN.{name}") for name in "nmk"] == [4, 9, 1]


def test_all_names_of_known_libraries_are_found_by_their_words() -> None:
    """What a library declares is among the words by which it is read; its objects are listed."""
    for name in (*default_libraries(), NC_AXES, BASE_TYPES):
        checker = checker_of([name], Reporter(Sources(), Collector()))
        space = checker.names.libraries[name.lower()]
        checker.names.read(space)
        seen = {*space.declared, *space.lists, *space.variables, *space.values} - {""}
        assert seen <= seen_words(name)
        assert {one.lower() for one in declared_names(name)} == set(space.declared)


def test_homing_options_have_the_mode_of_the_encoder(tmp_path: Path) -> None:
    """ST-741: E_EncoderReferenceMode of Tc2_MC2, eight modes from 0 to 7."""
    (tmp_path / "Cell.plcproj").write_text(PROJECT.replace("Vendor_Valves", "Tc2_MC2"), "utf-8")
    variables = "PROGRAM MAIN\nVAR o : ST_HomingOptions; n, m : UDINT; END_VAR"
    body = """o.ReferenceMode := E_EncoderReferenceMode.ENCODERREFERENCEMODE_PLCCAM;
n := o.ReferenceMode;
m := Tc2_MC2.E_EncoderReferenceMode.ENCODERREFERENCEMODE_SOFTDRIVELATCHNEG;"""
    (tmp_path / "MAIN.TcPOU").write_text(pou_file("MAIN", variables, body), "utf-8")
    (tmp_path / "T.TcTTO").write_text(
        '<TcPlcObject><Task Name="T"><CycleTime>1000</CycleTime><Priority>20</Priority>'
        "<PouCall><Name>MAIN</Name></PouCall></Task></TcPlcObject>",
        "utf-8",
    )
    plc = load_structured(tmp_path / "Cell.plcproj")
    run(plc, 3)
    assert (plc.read("MAIN.n"), plc.read("MAIN.m")) == (1, 7)


def test_what_the_nc_fills_on_the_machine_is_reported(tmp_path: Path) -> None:
    """902968, ST-742: members of NcToPlc and Status that stay empty, and no others."""
    (tmp_path / "Cell.plcproj").write_text(PROJECT.replace("Vendor_Valves", "Tc2_MC2"), "utf-8")
    variables = (
        "PROGRAM MAIN\nVAR a : AXIS_REF; s : MC_ReadStatus; r : LREAL; b : BOOL; n : UDINT; END_VAR"
    )
    body = """n := a.NcToPlc.DcTimeStamp;
b := a.Status.OpMode.Modulo OR a.Status.OpMode.PositionLagMonitoring;
n := a.NcToPlc.AxisState + a.NcToPlc.HomingState;
n := a.NcToPlc.AxisId;
r := a.NcToPlc.ActPos + a.NcToPlc.ActVelo;
b := a.NcToPlc.StateDWord.2 OR a.Status.Moving;
n := a.ADS.Port;
s(Axis := a, Enable := TRUE, Accelerating => b, StandStill => b);
b := s.Status.CmdBuffered;"""
    (tmp_path / "MAIN.TcPOU").write_text(pou_file("MAIN", variables, body), "utf-8")
    done = CliRunner().invoke(command, [str(tmp_path / "Cell.plcproj"), "--format", "json"])
    found = [one for one in json.loads(done.stdout)["diagnostics"] if one["id"] == 902968]
    reported = [" ".join(one["text"].split(" ")[:3]) for one in found]
    assert reported == [
        "DcTimeStamp of NCTOPLC_AXIS_REF",
        "PositionLagMonitoring of ST_AxisOpModes",
        "HomingState of NCTOPLC_AXIS_REF",
        "ADS of AXIS_REF",
        "CmdBuffered of ST_AxisStatus",
    ]
