# SPDX-License-Identifier: MIT
"""``nctakt init``: a folder with lists and programs becomes a project; nothing is overwritten."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.cli.init import CHECKOUT, CI_FILES, INSTALL, PYTHON, SETUP_PYTHON
from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import startup_lists
from nctakt.project.project_file import find_project

Captured = pytest.CaptureFixture[str]


@pytest.fixture
def cell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a machine, a program, a subprogram, a PLC and other Python code."""
    monkeypatch.chdir(tmp_path)
    assert main(["new", "lists", "--quiet"]) == 0
    (tmp_path / "programs").mkdir()
    (tmp_path / "programs" / "a_sub.nc").write_text("G91 X1\nM29\n", "utf-8")
    (tmp_path / "programs" / "part.nc").write_text("G01 X1 F6000\nM30\n", "utf-8")
    plc = "raise SystemExit\n\nclass Cell(Plc):\n    pass\n"
    (tmp_path / "cell_plc.py").write_text(plc, "utf-8")
    (tmp_path / "tool.py").write_text("class Tool:\n    pass\n", "utf-8")
    return tmp_path


def test_a_folder_becomes_a_project(cell: Path, capsys: Captured) -> None:
    """It says what it found, by reading alone; the files are a project and a test that runs."""
    assert main(["init"]) == 0
    captured = capsys.readouterr()
    assert captured.err == ""
    assert "programs: programs/a_sub.nc, programs/part.nc" in captured.out
    assert "PLCs: cell_plc.py" in captured.out
    assert "nctakt run programs/part.nc" in captured.out
    project = find_project(cell, FileAccess())
    assert project is not None
    assert project.machine is not None
    assert project.machine.exists()
    assert project.plc == Path("cell_plc.py")
    assert 'run_nc("programs/part.nc")' in (cell / "test_programs.py").read_text("utf-8")
    assert main(["run", "programs/part.nc", "--plc", "default", "--quiet"]) == 0


def test_the_first_test_takes_a_program_without_errors(cell: Path) -> None:
    """A program that the machine cannot run comes first by name, and is no first test."""
    (cell / "programs" / "b_wrong.nc").write_text("G01 Q1 F6000\nM30\n", "utf-8")
    (cell / "programs" / "part.nc").rename(cell / "programs" / "c_part.nc")
    assert main(["init", "--quiet"]) == 0
    assert 'run_nc("programs/c_part.nc")' in (cell / "test_programs.py").read_text("utf-8")


def test_the_first_test_takes_a_program_that_needs_no_other_channel(cell: Path) -> None:
    """A program that waits for a signal of another channel never continues alone."""
    waits = "#WAIT [ID1 CH2]\nG01 X1 F6000\nM30\n"
    (cell / "programs" / "b_waits.nc").write_text(waits, "utf-8")
    assert main(["check", "programs/b_waits.nc", "--quiet"]) == 0
    assert main(["init", "--quiet"]) == 0
    assert 'run_nc("programs/part.nc")' in (cell / "test_programs.py").read_text("utf-8")


def test_a_plc_in_structured_text_is_found(cell: Path, capsys: Captured) -> None:
    """Files without a project count as those of a project do; several are named as a comment."""
    (cell / "gate.st").write_text("PROGRAM MAIN\nEND_PROGRAM\n", "utf-8")
    assert main(["init"]) == 0
    assert "PLCs: cell_plc.py, gate.st" in capsys.readouterr().out
    assert '# plc = "cell_plc.py"' in (cell / "nctakt.toml").read_text("utf-8")


@pytest.mark.parametrize("ci", CI_FILES)
def test_a_file_for_ci(ci: str, cell: Path) -> None:
    """It checks the folder and runs the tests."""
    assert main(["init", "--ci", ci, "--quiet"]) == 0
    text = (cell / CI_FILES[ci][0]).read_text("utf-8")
    assert "nctakt check ." in text
    assert INSTALL in text
    assert PYTHON in text
    assert "{INSTALL" not in text


def test_the_guide_to_ci_names_the_same_versions() -> None:
    """docs/ci.md installs and uses what the files use."""
    guide = Path(__file__).parents[2].joinpath("docs", "ci.md").read_text("utf-8")
    for word in (INSTALL, f'"{PYTHON}"', CHECKOUT, SETUP_PYTHON):
        assert word in guide


def test_a_file_for_ci_asks_for_the_wheel_that_it_installs(cell: Path, capsys: Captured) -> None:
    """It is reported as long as none lies in the folder."""
    assert main(["init", "--ci", "github"]) == 0
    assert "put a wheel of nctakt into wheels" in capsys.readouterr().out
    (cell / "wheels").mkdir()
    (cell / "wheels" / "nctakt-0.3.0-any.whl").touch()
    assert main(["init", "--ci", "gitlab"]) == 0
    assert "put a wheel" not in capsys.readouterr().out


def test_a_german_locale_gives_a_german_project(
    cell: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is found, the project file and the messages of all commands are in one language."""
    monkeypatch.setenv("LC_ALL", "de_DE.UTF-8")
    assert main(["init"]) == 0
    assert "Programme: " in capsys.readouterr().out
    assert 'language = "de"' in (cell / "nctakt.toml").read_text("utf-8")


def test_nothing_is_overwritten(cell: Path, capsys: Captured) -> None:
    """A file that is there stays, and is named (902382)."""
    (cell / "nctakt.toml").write_text('language = "de"\n', "utf-8")
    assert main(["init"]) == 0
    assert "note 902382: " in capsys.readouterr().err
    assert (cell / "nctakt.toml").read_text("utf-8") == 'language = "de"\n'


def test_a_reader_that_goes_early_leaves_no_half_project(cell: Path) -> None:
    """All files are written before anything is reported: ``nctakt init | head -1``."""
    reading, writing = os.pipe()
    os.close(reading)
    words = [sys.executable, "-P", "-m", "nctakt", "init", "--ci", "jenkins"]
    subprocess.run(words, cwd=cell, stdout=writing, stderr=subprocess.DEVNULL, check=False)
    os.close(writing)
    names = {path.name for path in cell.iterdir()}
    assert {"nctakt.toml", "test_programs.py", "Jenkinsfile"} <= names


def test_a_folder_without_anything(tmp_path: Path, capsys: Captured) -> None:
    """902383 names ``nctakt new``; nothing is written."""
    assert main(["init", str(tmp_path)]) == 2
    assert "error 902383: " in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_the_next_commands_say_what_they_lack(
    cell: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What installs pytest and the page's library comes before the command that needs it."""
    monkeypatch.setattr("nctakt.cli.init.find_spec", lambda name: None)
    assert main(["init"]) == 0
    lines = [line.strip() for line in capsys.readouterr().out.splitlines()]
    assert lines[-4:] == [
        'pip install "lsprotocol>=2025" "markdown2>=2.4" "nicegui>=3.18"',
        "nctakt live programs/part.nc --open",
        'pip install "pytest>=9"',
        "nctakt test .",
    ]


def test_what_is_installed_is_not_installed_again(
    cell: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The commands have no hint if their libraries are installed."""
    monkeypatch.setattr("nctakt.cli.init.find_spec", lambda name: "there")
    assert main(["init"]) == 0
    captured = capsys.readouterr().out
    assert "pip install" not in captured
    assert captured.endswith("  nctakt test .\n")


def test_a_start_up_list_of_another_name_is_found(cell: Path, capsys: Captured) -> None:
    """902942 names it; the project file does, too, so that the programs run on that machine."""
    (startup,) = startup_lists(cell / "lists")
    startup.rename(cell / "lists" / "begin.lis")
    assert main(["init"]) == 0
    captured = capsys.readouterr()
    assert "note 902942: lists/begin.lis is taken as the start-up list" in captured.err
    assert "machines: lists/begin.lis" in captured.out
    assert 'machine = "lists/begin.lis"' in (cell / "nctakt.toml").read_text("utf-8")
    assert main(["run", "programs/part.nc", "--plc", "default"]) == 0
    assert "the machine is lists/begin.lis" in capsys.readouterr().err


def test_check_names_a_start_up_list_of_another_name(cell: Path, capsys: Captured) -> None:
    """Programs beside the folder are checked for the demo machine, and the note names the list."""
    (startup,) = startup_lists(cell / "lists")
    startup.rename(cell / "lists" / "begin.lis")
    assert main(["check", "."]) == 0
    captured = capsys.readouterr()
    assert "--machine lists/begin.lis checks them for yours." in captured.out + captured.err


def test_lists_without_a_start_up_list(cell: Path, capsys: Captured) -> None:
    """902943 counts them: an error alone, a warning beside programs, which run on the demo."""
    (startup,) = startup_lists(cell / "lists")
    startup.unlink()
    count = len([*(cell / "lists").rglob("*.lis")])
    assert main(["init", "lists"]) == 2
    assert f"error 902943: lists has {count} lists, but no start-up list" in capsys.readouterr().err
    assert not (cell / "lists" / "nctakt.toml").exists()
    assert main(["init"]) == 0
    captured = capsys.readouterr()
    assert f"warning 902943: . has {count} lists" in captured.err
    assert "machines: none" in captured.out


def test_commands_to_copy_have_quoted_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured
) -> None:
    """A folder and a program with a blank in their names are one word each in a shell."""
    monkeypatch.chdir(tmp_path)
    assert main(["new", "my lists"]) == 0
    assert "nctakt check 'my lists'" in capsys.readouterr().out
    (tmp_path / "part 1.nc").write_text("G01 X1 F6000\nM30\n", "utf-8")
    assert main(["run", "part 1.nc"]) == 0
    assert "--machine 'my lists' takes that one" in capsys.readouterr().err
    assert main(["--help"]) == 0
    assert "nctakt run 'part 1.nc' --machine 'my lists'  " in capsys.readouterr().out
    assert main(["init"]) == 0
    assert "nctakt live 'part 1.nc' --open" in capsys.readouterr().out


def test_the_path_shows_a_program_with_a_realtime_cycle(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured
) -> None:
    """Its fourth command explains cycles; without one, the path shows the first program."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.nc").write_text("G01 X1 F6000\nM30\n", "utf-8")
    (tmp_path / "b.nc").write_text("G01 X2 F6000\nM30\n", "utf-8")
    assert main(["--help"]) == 0
    assert "nctakt why a.nc" in capsys.readouterr().out
    cycle = "#RT CYCLE [ID = 1 SCOPE = PROG]\n  V.E.COUNT += 1\n#RT CYCLE END\nM30\n"
    (tmp_path / "b.nc").write_text(cycle, "utf-8")
    assert main(["--help"]) == 0
    assert "nctakt why b.nc" in capsys.readouterr().out
