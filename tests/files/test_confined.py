# SPDX-License-Identifier: MIT
"""``--confine DIR``: programs and lists read nothing outside of it, and nothing is quoted."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.files.access import FileAccess
from nctakt.lists.writing.commented import commented_lists
from nctakt.run.controller import Controller

pytestmark = pytest.mark.slow

SECRET = "the secret line"


@pytest.fixture
def jobs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder of jobs with a machine, and a file next to it that is none of theirs."""
    (tmp_path / "secret.nc").write_text(f"{SECRET}\n", "utf-8")
    folder = tmp_path / "jobs"
    (folder / "machine").mkdir(parents=True)
    for name, text in commented_lists("en").items():
        (folder / "machine" / name).write_bytes(text)
    (folder / "sub.nc").write_text("M17\n", "utf-8")
    (folder / "link.nc").symlink_to("../secret.nc")
    (folder / "part.nc").write_text("L sub.nc\nM30\n", "utf-8")
    monkeypatch.chdir(folder)
    return folder


def shown(capsys: pytest.CaptureFixture[str]) -> str:
    """All that the command has shown."""
    out, err = capsys.readouterr()
    return out + err


@pytest.mark.parametrize("command", ["run", "check", "list", "why", "coverage"])
def test_what_lies_inside_is_read(
    jobs: Path, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """The program, what it calls, its machine, and the built-in one."""
    assert main([command, "part.nc", "--confine", "."]) == 0
    assert main([command, "part.nc", "--confine", ".", "--machine", "machine"]) == 0
    assert "900917" not in shown(capsys)


@pytest.mark.parametrize("command", ["run", "check"])
@pytest.mark.parametrize(
    "called",
    [
        '"../secret.nc"',
        '"link.nc"',
        '"{folder}/secret.nc"',
        '"..\\\\secret.nc"',
        '"/etc/passwd"',
        '"../not_there.nc"',
        '"machine/../../secret.nc"',
    ],
)
def test_a_program_calls_nothing_outside(
    jobs: Path, command: str, called: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """By relative and absolute paths, over links; whether the file is there is not reported."""
    name = called.format(folder=jobs.parent.as_posix())
    (jobs / "part.nc").write_text(f"L {name}\nM30\n", "utf-8")
    assert main([command, "part.nc", "--confine", "."]) == 1
    found = shown(capsys)
    assert "900917" in found
    assert "20369" not in found
    assert SECRET not in found
    assert "root:" not in found


def test_a_computed_name_leads_nowhere_else(jobs: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The name is known only when the program runs."""
    text = '#VAR\nV.P.N : STRING[20]\n#ENDVAR\nV.P.N = "../secret" + ".nc"\nL V.P.N\nM30\n'
    (jobs / "part.nc").write_text(text, "utf-8")
    assert main(["run", "part.nc", "--confine", "."]) == 1
    found = shown(capsys)
    assert "900917" in found
    assert SECRET not in found


@pytest.mark.parametrize(
    "words",
    [
        ["run", "../secret.nc"],
        ["check", "../secret.nc"],
        ["check", "link.nc"],
        ["run", "part.nc", "--plc", "../secret.nc"],
        ["run", "part.nc", "--machine", "../machine"],
        ["check", "part.nc", "--machine", "../machine"],
        ["run", "part.nc", "--rtconf", "../secret.nc"],
        ["schedule", "show", "../secret.nc"],
        ["schedule", "simulate", "machine/rtconf.lis", "--load", "../secret.nc"],
        ["coverage", "--merge", "../secret.nc"],
    ],
    ids=" ".join,
)
def test_the_words_of_the_command_name_nothing_outside(
    jobs: Path, words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    """Whoever takes the words from others need not look at them."""
    shutil.copytree(jobs / "machine", jobs.parent / "machine")
    assert main([*words, "--confine", "."]) in (1, 2)
    found = shown(capsys)
    assert "900917" in found
    assert SECRET not in found


@pytest.mark.parametrize("path", ["../secret.nc", "/etc/passwd", "../not_there.lis"])
def test_a_list_names_nothing_outside(
    jobs: Path, path: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of a start-up list the entries of other lists, and the file of error texts."""
    startup = jobs / "machine" / "hochlauf.lis"
    text = startup.read_text("utf-8")
    assert text.count(" achs_mds1.lis") == 1
    startup.write_text(text.replace(" achs_mds1.lis", f" {path}"), "utf-8")
    assert main(["check", "machine", "--confine", "machine"]) == 1
    found = shown(capsys)
    assert "900917" in found
    assert SECRET not in found
    assert "root:" not in found


def test_several_folders_may_be_read(jobs: Path) -> None:
    """``--confine`` again for more."""
    (jobs / "part.nc").write_text('L "../other/sub.nc"\nM30\n', "utf-8")
    (jobs.parent / "other").mkdir()
    (jobs.parent / "other" / "sub.nc").write_text("M17\n", "utf-8")
    assert main(["run", "part.nc", "--confine", "."]) == 1
    assert main(["run", "part.nc", "--confine", ".", "--confine", "../other"]) == 0


def test_a_folder_that_is_not_there_confines_nothing(jobs: Path) -> None:
    """Wrong usage, reported before anything is read."""
    assert main(["run", "part.nc", "--confine", "nowhere"]) == 2


def test_a_controller_can_be_confined(jobs: Path) -> None:
    """For servers that take programs from others."""
    controller = Controller(access=FileAccess([jobs]))
    assert controller.run("part.nc").state == "ended"
    with pytest.raises(Failure, match="900917"):
        controller.start(jobs.parent / "secret.nc")


@pytest.mark.parametrize("is_confined", [False, True])
def test_a_name_with_a_zero_character_is_that_of_no_file(tmp_path: Path, is_confined: bool) -> None:
    """A client may ask for it: 900500, as for any file that is not there."""
    access = FileAccess([tmp_path] if is_confined else [])
    with pytest.raises(Failure) as caught:
        access.read_lines(tmp_path / "a\0b.nc")
    assert caught.value.diagnostics[0].id == 900500
    assert "\0" not in str(caught.value)
