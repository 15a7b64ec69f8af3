# SPDX-License-Identifier: MIT
"""Projects, folders and single files of a PLC, as ``nctakt check`` reads them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner
from support.plc_text import pou_file

from nctakt.checking.inputs import gather
from nctakt.cli.check import command
from nctakt.files.access import FileAccess
from nctakt.messages import Collector
from nctakt.st.inspection import inspect_paths
from nctakt.st.program import Program

PROJECT = """<?xml version="1.0" encoding="utf-8"?>
<Project xmlns="http://schemas.microsoft.com/developer/msbuild/2003">
<PropertyGroup><Name>Cell</Name></PropertyGroup>
<ItemGroup>
<Compile Include="POUs\\MAIN.TcPOU"><SubType>Code</SubType></Compile>
<Compile Include="POUs\\FB_A %28old%29.TcPOU"><SubType>Code</SubType></Compile>
<Compile Include="POUs\\Left.TcPOU"><ExcludeFromBuild>true</ExcludeFromBuild></Compile>
<Compile Include="Gone.TcDUT"><SubType>Code</SubType></Compile>
<Compile Include="PlcTask.TcTTO"><SubType>Code</SubType></Compile>
</ItemGroup>
<ItemGroup><PlaceholderReference Include="Tc2_Standard"/><PlaceholderReference Include="Tc2_X"/>
</ItemGroup>
</Project>
"""
TASK = """<TcPlcObject><Task Name="PlcTask"><CycleTime>2000</CycleTime><Priority>20</Priority>
<PouCall><Name>MAIN</Name></PouCall></Task></TcPlcObject>"""
SYSTEM = """<TcSmProject><Project><Plc><Project Name="Cell" PrjFilePath="Cell.plcproj"/></Plc>
<System><Tasks><Task Priority="3" CycleTime="40000"><Name>PlcTask</Name></Task></Tasks></System>
</Project></TcSmProject>"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A project with one object that is missing, one that is left out, one with a mistake."""
    (tmp_path / "POUs").mkdir()
    files = {
        "Cell.plcproj": PROJECT,
        "Cell.tsproj": SYSTEM,
        "PlcTask.TcTTO": TASK,
        "POUs/MAIN.TcPOU": pou_file("MAIN", "PROGRAM MAIN\nVAR f : FB_A; END_VAR", "f();"),
        "POUs/FB_A (old).TcPOU": pou_file("FB_A", "FUNCTION_BLOCK FB_A", "n := 1;"),
        "POUs/Left.TcPOU": pou_file("Left", "FUNCTION_BLOCK Left", "so wrong"),
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text, "utf-8-sig")
    return tmp_path


def inspected(path: Path) -> tuple[Program, list[str]]:
    """The first project of a path, and what was reported."""
    collector = Collector()
    programs = inspect_paths([path], Path.read_bytes, collector)
    return programs[0], [one.text() for one in collector.diagnostics]


def test_a_project_names_files_libraries_and_tasks(folder: Path) -> None:
    """ST-101, ST-106: back slashes, escapes, left-out and missing files; the task's cycle time."""
    program, found = inspected(folder / "Cell.plcproj")
    assert [Path(file).name for file in program.files] == [
        "MAIN.TcPOU",
        "FB_A (old).TcPOU",
        "PlcTask.TcTTO",
    ]
    assert [one[:60] for one in found] == [
        "the project names Gone.TcDUT, which does not exist",
        "n is not declared (C0046) (FB_A, implementation line 1)",
    ]
    assert [(task.cycle_us, task.priority) for task in program.tasks] == [(2000, 20)]


def test_the_tasks_of_the_system_win(folder: Path) -> None:
    """ST-106: cycle time in 100 ns and priority of the system's project."""
    program, _ = inspected(folder / "Cell.tsproj")
    assert [(task.cycle_us, task.priority) for task in program.tasks] == [(4000, 3)]


def checked(*words: str) -> tuple[int, str]:
    """The exit code of ``nctakt check`` and what it prints."""
    result = CliRunner().invoke(command, list(words), standalone_mode=False)
    assert result.exception is None, result.exception
    return result.return_value, result.output


def test_an_object_is_checked_in_its_project(folder: Path) -> None:
    """ST-1002: only its own mistakes are shown, and what it uses is known."""
    assert checked(str(folder / "POUs" / "MAIN.TcPOU"))[0] == 0
    code, text = checked(str(folder / "POUs" / "FB_A (old).TcPOU"))
    assert (code, "error 902190: n is not declared" in text) == (1, True)


def test_a_folder_is_its_projects(folder: Path) -> None:
    """ST-101, ST-1002: what no project lists has been left out; findings as JSON and SARIF."""
    inputs = gather([folder], FileAccess(), [])
    assert [one.paths[0].name for one in inputs.plc] == ["Cell.plcproj"]
    _, text = checked(str(folder), "--format", "json")
    assert sorted(one["id"] for one in json.loads(text)["diagnostics"]) == [902160, 902190]
    _, text = checked(str(folder), "--format", "sarif", "--lang", "de")
    assert "n ist nicht deklariert (C0046) (FB_A, Implementierung Zeile 1)" in text


def test_plain_files_are_one_project(tmp_path: Path) -> None:
    """ST-101: without a project each named file counts."""
    (tmp_path / "a.st").write_text("FUNCTION F : INT\nF := 1;\nEND_FUNCTION", "utf-8")
    (tmp_path / "b.st").write_text("PROGRAM MAIN\nVAR n : INT; END_VAR\nn := F();\nEND_PROGRAM")
    assert checked(str(tmp_path / "a.st"), str(tmp_path / "b.st"))[0] == 0
    assert checked(str(tmp_path / "b.st"))[0] == 1
    assert checked(str(tmp_path))[0] == 0
