# SPDX-License-Identifier: MIT
"""``nctakt new --from Project.tsproj``: the lists of a TwinCAT project (LG-401 … LG-405)."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.lists.machine.files import DEMO_FOLDER
from nctakt.lists.machine.machine import load_machine


def project(cycle_time: str = "2000") -> str:
    """The demo machine as a project has it: two lists share a name, one has an umlaut."""
    startup = (DEMO_FOLDER / "hochlauf.lis").read_text("utf-8")
    data: list[str] = []

    def virtual(match: re.Match[str]) -> str:
        text = (DEMO_FOLDER / match[1]).read_text("utf-8")
        data.append(f'<Data Offset="{len(data) + 1}"><![CDATA[\n# Größe\n{text}]]></Data>')
        name = "liste.lis" if match[1].startswith("achs") else match[1]
        return f"tc_virtual_{len(data)}\\{name}"

    startup = re.sub(r"\./(\w+\.lis)", virtual, startup)
    body = "".join(f"<Axis>{one}</Axis>" for one in data)
    first = f'<Data Name="Startup"><![CDATA[{startup}]]></Data>'
    cnc = f"<CNC><GeoTask CycleTime='{cycle_time}'/>{first}{body}</CNC>"
    return f"<TcSmProject><Project><Motion>{cnc}</Motion></Project></TcSmProject>"


@pytest.mark.parametrize("source", ["Cell/Cell.tsproj", "."])
def test_lists_of_a_project(source: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By file and by the folder around it: the same machine, without a finding."""
    monkeypatch.chdir(tmp_path)
    Path("Cell").mkdir()
    Path("Cell/Cell.tsproj").write_text(project(), "utf-8")
    assert main(["new", "mill", "--from", source, "--quiet"]) == 0
    machine, demo = load_machine("mill"), load_machine(None)
    assert [axis.name for axis in machine.axes] == [axis.name for axis in demo.axes]
    assert [axis.dynamics for axis in machine.axes] == [axis.dynamics for axis in demo.axes]
    assert machine.channels[0].tools == demo.channels[0].tools
    assert not [one for one in machine.diagnostics if one.severity.name == "ERROR"]


@pytest.mark.parametrize(
    ("cycle_time", "reported"),
    [
        ("2000", "Task des Projekts läuft alle 200 µs; hier beträgt der NC-Takt 1000 µs"),
        ("1250", "alle 125 µs"),
        ("10000", ""),
        ("0", ""),
        ("fast", ""),
        ("9" * 5000, ""),
    ],
)
def test_the_tick_of_a_project(
    cycle_time: str,
    reported: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """LG-401: CycleTime of the GEO task is in 100 ns; 902954 where runs take another tick."""
    monkeypatch.chdir(tmp_path)
    Path("Cell.tsproj").write_text(project(cycle_time), "utf-8")
    assert main(["new", "mill", "--from", "Cell.tsproj", "--lang", "de"]) == 0
    found = capsys.readouterr().err
    assert ("902954" in found) == bool(reported)
    assert reported in found


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("<TcSmProject><Project/></TcSmProject>", "no CNC"),
        ("<TcSmProject><CNC File='CNC.xti'/></TcSmProject>", "CNC.xti"),
        ("<!DOCTYPE a [<!ENTITY b 'c'>]><TcSmProject/>", "document type"),
        ("<TcSmProject><CNC>", "line 1"),
    ],
)
def test_what_is_no_project_of_a_cnc(
    text: str, reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """902680 says why, and no folder is made."""
    file = tmp_path / "a.tsproj"
    file.write_text(text, "utf-8")
    assert main(["new", str(tmp_path / "mill"), "--from", str(file)]) == 2
    said = capsys.readouterr().err
    assert "902680" in said
    assert reason in said
    assert not (tmp_path / "mill").exists()


@pytest.mark.parametrize("words", [["--format", "xml"], ["--root", "."]])
def test_options_without_a_use_are_refused(
    words: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """902735: the lists stay as the project has them; no folder is made."""
    monkeypatch.chdir(tmp_path)
    Path("Cell.tsproj").write_text(project(), "utf-8")
    assert main(["new", "mill", "--from", "Cell.tsproj", *words]) == 2
    assert "902735" in capsys.readouterr().err
    assert not Path("mill").exists()
