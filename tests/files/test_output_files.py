# SPDX-License-Identifier: MIT
"""What a command writes destroys nothing that it reads, and nothing that it cannot replace."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest
from support.insides import break_output

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.files import access as file_access
from nctakt.files.access import FileAccess
from nctakt.files.output import OutputFile, write_file
from nctakt.lists.writing.commented import commented_lists

pytestmark = pytest.mark.slow

PART = '#MSG SAVE ["hello"]\n#ERROR [ID=1 RC=0]\nL SUB.NC\nM30\n'
SUB = "M100\nM17\n"
PLC = "class P:\n    def cycle(self, hli):\n        hli.acknowledge_all()\n"
STARVED = Path(__file__).parent.parent / "runs" / "rtconf_starved_decoder"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a program, its subprogram, a machine, a PLC, a list and a load."""
    (tmp_path / "part.nc").write_text(PART, "utf-8")
    (tmp_path / "SUB.NC").write_text(SUB, "utf-8")
    (tmp_path / "plc.py").write_text(PLC, "utf-8")
    (tmp_path / "machine").mkdir()
    for name, text in commented_lists("en").items():
        (tmp_path / "machine" / name).write_bytes(text)
    for name in ("rtconf.lis", "load.toml"):
        (tmp_path / name).write_bytes((STARVED / name).read_bytes())
    monkeypatch.chdir(tmp_path)
    return tmp_path


def contents(folder: Path) -> dict[str, bytes]:
    """All files of a folder but those that Python keeps of a PLC that it has translated."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.parent.name != "__pycache__"
    }


RUN = ["run", "part.nc", "--machine", "machine", "--plc", "plc.py", "--quiet"]
SCHEDULE = ["schedule", "simulate", "rtconf.lis", "--load", "load.toml", "--cycles", "3"]


@pytest.mark.parametrize(
    "words",
    [
        *([*RUN, option, "part.nc"] for option in ("--messages", "--error-log", "--diagnosis")),
        *([*RUN, "--messages", file] for file in ("SUB.NC", "plc.py", "machine/hochlauf.lis")),
        [*RUN, "--messages", "machine/ext_var1.lis"],
        [*RUN, "--messages", "machine/sda_mds1.lis"],
        [*RUN, "--messages", "./machine/../part.nc"],
        [*RUN, "--messages", "link.nc"],
        [*RUN, "--messages", "hard.nc"],
        [*RUN, "--diagnosis", "SUB.NC"],
        [*RUN, "--rtconf", "rtconf.lis", "--load", "load.toml", "--messages", "load.toml"],
        [*RUN, "--rtconf", "rtconf.lis", "--load", "load.toml", "--messages", "rtconf.lis"],
        ["run", "c.csv", "--trace", "c.csv"],
        ["run", "c.csv", "--trace", "part.jsonl", "--messages", "c.csv"],
        ["run", "p.svg", "--plot", "p.svg"],
        ["check", "part.nc", "--output", "part.nc"],
        ["check", "part.nc", "--output", "SUB.NC"],
        ["check", ".", "--output", "part.nc"],
        ["check", ".", "--output", "machine/hochlauf.lis"],
        ["coverage", "part.nc", "--data", "part.nc"],
        ["coverage", "--data", "all.json", "--merge", "all.json"],
        [*SCHEDULE, "--csv", "rtconf.lis"],
        [*SCHEDULE, "--perfetto", "load.toml"],
        [*SCHEDULE, "--csv", "hard.lis"],
    ],
    ids=" ".join,
)
def test_no_command_overwrites_what_it_reads(
    folder: Path, words: Sequence[str], capsys: pytest.CaptureFixture[str]
) -> None:
    """Programs, called programs, lists, PLC, schedule and load, by any name that leads there."""
    for name in ("c.csv", "p.svg"):
        (folder / name).write_text("M30\n", "utf-8")
    (folder / "all.json").write_text("", "utf-8")
    (folder / "link.nc").symlink_to("part.nc")
    os.link("part.nc", "hard.nc")
    os.link("rtconf.lis", "hard.lis")
    before = contents(folder)
    code = main(words)
    err = capsys.readouterr().err
    after = contents(folder)
    assert {name: after.get(name) for name in before} == before
    assert "900913" in err or ("900801" in err and words[0] == "coverage")
    assert code in (1, 2)
    assert (folder / "link.nc").is_symlink()


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (["--messages", "o.txt"], ["--diagnosis", "o.txt"]),
        (["--messages", "o.txt"], ["--error-log", "./machine/../o.txt"]),
        (["--messages", "o.csv"], ["--trace", "o.csv"]),
        (["--messages", "here.txt"], ["--diagnosis", "there.txt"]),
        (["--plot", "o.svg"], ["--messages", "o.svg"]),
        (["--trace", "o.csv"], ["--messages", "o.partial.csv"]),
    ],
)
def test_two_outputs_do_not_mix(
    folder: Path, first: list[str], second: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    """One file by two names, there already or not; both options are named."""
    (folder / "here.txt").write_text("of yesterday", "utf-8")
    (folder / "there.txt").symlink_to("here.txt")
    before = contents(folder)
    assert main([*RUN, *first, *second]) == 2
    err = capsys.readouterr().err
    assert "900914" in err
    assert ("partial" in err) == ("partial" in second[1])
    assert first[0] in err
    assert second[0] in err
    assert contents(folder) == before


def test_devices_take_any_number_of_outputs(folder: Path) -> None:
    """/dev/null is no file that could be lost."""
    assert main([*RUN, "--messages", "/dev/null", "--diagnosis", "/dev/null"]) == 0


def test_standard_output_is_an_output(folder: Path) -> None:
    """``> out.txt`` and ``--messages out.txt``: 900914; the same into a pipe is meant."""
    command = [sys.executable, "-m", "nctakt", "run", "part.nc", "--quiet", "--messages"]
    with Path("out.txt").open("wb") as out:
        done = subprocess.run(
            [*command, "out.txt"], stdout=out, stderr=subprocess.PIPE, check=False
        )
    assert (done.returncode, b"900914" in done.stderr) == (2, True)
    done = subprocess.run([*command, "/dev/stdout"], capture_output=True, check=False)
    assert (done.returncode, done.stdout.count(b"hello")) == (0, 2)


def test_an_output_takes_its_name_when_it_is_complete(tmp_path: Path) -> None:
    """Until then it is beside it; what was there before stays, with its rights."""
    path = tmp_path / "out.csv"
    path.write_text("of yesterday", "utf-8")
    path.chmod(0o640)
    with OutputFile(path) as file:
        file.write("of today")
        assert path.read_text("utf-8") == "of yesterday"
        assert (tmp_path / "out.partial.csv").read_text("utf-8") == "of today"
    assert path.read_text("utf-8") == "of today"
    assert path.stat().st_mode & 0o777 == 0o640
    assert [one.name for one in tmp_path.iterdir()] == ["out.csv"]


def test_an_output_that_was_not_begun_leaves_what_was_there(tmp_path: Path) -> None:
    """A command that fails before its run."""
    path = tmp_path / "out.csv"
    path.write_text("of yesterday", "utf-8")
    OutputFile(path).close()
    assert [one.name for one in tmp_path.iterdir()] == ["out.csv"]
    assert path.read_text("utf-8") == "of yesterday"


def test_an_output_that_was_cut_off_says_so_by_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A disk that is full: what is there can be read, what was there before stays."""
    path = tmp_path / "out.csv"
    path.write_text("of yesterday", "utf-8")
    file = OutputFile(path)
    file.write("first line\n")

    def refuse(_data: object) -> int:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        break_output(patch, file, lambda inner: _Refusing(inner, refuse))
        with pytest.raises(Failure) as caught:
            file.write("second line\n")
    assert [one.id for one in caught.value.diagnostics] == [900507, 900918]
    file.close()
    assert path.read_text("utf-8") == "of yesterday"
    assert (tmp_path / "out.partial.csv").read_text("utf-8") == "first line\n"


class _Refusing:
    """A file whose ``write`` is another one."""

    def __init__(self, file: object, write: object) -> None:
        self._file = file
        self.write = write

    def __getattr__(self, name: str) -> object:
        return getattr(self._file, name)


def test_two_processes_do_not_write_one_file(tmp_path: Path) -> None:
    """The second one is reported (900919)."""
    path = tmp_path / "out.csv"
    with OutputFile(path) as first:
        first.write("one")
        with pytest.raises(Failure) as caught:
            OutputFile(path)
    assert [one.id for one in caught.value.diagnostics] == [900919]
    assert path.read_text("utf-8") == "one"


@pytest.mark.parametrize(
    ("name", "number"), [("no/folder.txt", 900507), ("folder", 900501), ("x" * 300, 900507)]
)
def test_an_output_that_cannot_be_is_reported_at_once(
    tmp_path: Path, name: str, number: int
) -> None:
    """Before anything is run."""
    (tmp_path / "folder").mkdir()
    with pytest.raises(Failure) as caught:
        OutputFile(tmp_path / name)
    assert [one.id for one in caught.value.diagnostics] == [number]


def test_an_output_onto_a_link_is_written_where_it_leads(tmp_path: Path) -> None:
    """The link stays one."""
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / "out.txt").write_text("of yesterday", "utf-8")
    (tmp_path / "link.txt").symlink_to("real/out.txt")
    write_file(tmp_path / "link.txt", b"of today")
    assert (tmp_path / "link.txt").is_symlink()
    assert (tmp_path / "real" / "out.txt").read_bytes() == b"of today"


def test_a_link_in_the_place_of_the_partial_file_is_not_followed(tmp_path: Path) -> None:
    """Whoever may write in the folder cannot have another file overwritten."""
    (tmp_path / "victim").write_text("mine", "utf-8")
    (tmp_path / "out.partial.txt").symlink_to("victim")
    (tmp_path / "out.partial-2.txt").symlink_to("nowhere")
    os.mkfifo(tmp_path / "out.partial-3.txt")
    write_file(tmp_path / "out.txt", "text")
    assert (tmp_path / "victim").read_text("utf-8") == "mine"
    assert (tmp_path / "out.partial.txt").is_symlink()
    assert (tmp_path / "out.txt").read_text("utf-8") == "text"
    names = {"victim", "out.txt", "out.partial.txt", "out.partial-2.txt", "out.partial-3.txt"}
    assert {one.name for one in tmp_path.iterdir()} == names


def test_a_file_of_the_user_with_a_partial_name_stays(folder: Path) -> None:
    """Whether it is an input or nobody reads it, and with a run that is given up."""
    texts = {"p.partial.csv": "M30\n", "p.partial-2.csv": "mine"}
    for name, text in texts.items():
        Path(name).write_text(text, "utf-8")
    assert main(["run", "p.partial.csv", "--trace", "p.csv", "--quiet"]) == 0
    assert {name: Path(name).read_text("utf-8") for name in texts} == texts
    assert not Path("p.partial-3.csv").exists()
    file = OutputFile("p.csv")
    assert Path("p.partial-3.csv").exists()
    file.close()
    assert {name: Path(name).read_text("utf-8") for name in texts} == texts
    assert not Path("p.partial-3.csv").exists()


def test_an_output_does_not_take_the_name_of_another_one_while_it_is_written(folder: Path) -> None:
    """``--messages o.partial.csv --trace o.csv``: each has its own file, in any order."""
    access = FileAccess()
    with OutputFile("o.partial.csv", "--messages", access) as first:
        with OutputFile("o.csv", "--trace", access) as second:
            second.write("trace")
        first.write("messages")
    assert Path("o.partial.csv").read_text("utf-8") == "messages"
    assert Path("o.csv").read_text("utf-8") == "trace"


def test_ctrl_c_tells_where_the_rest_is(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Standard error has ``interrupted`` and the note 900918; the earlier picture stays."""

    def interrupted(path: Path, data: bytes) -> int:
        with path.open("wb") as file:
            file.write(data[:100])
        raise KeyboardInterrupt

    Path("p.svg").write_text("of yesterday", "utf-8")
    monkeypatch.setattr(Path, "write_bytes", interrupted)
    assert main(["run", "SUB.NC", "--plot", "p.svg", "--quiet"]) == 1
    err = capsys.readouterr().err
    assert "interrupted" in err
    assert "p.partial.svg contains the part written until then" in err
    assert Path("p.svg").read_text("utf-8") == "of yesterday"
    assert Path("p.partial.svg").stat().st_size == 100


def test_what_an_exception_cuts_off_says_so_by_its_name(tmp_path: Path) -> None:
    """Ctrl-C and failures: the earlier file stays, and where the rest is is with the error."""
    path = tmp_path / "out.csv"
    path.write_text("of yesterday", "utf-8")
    for error in (KeyboardInterrupt(), RuntimeError("a fault")):
        with pytest.raises(type(error)) as caught, OutputFile(path) as file:
            file.write("first line\n")
            raise error
        assert any("out.partial" in note for note in caught.value.__notes__)
    with pytest.raises(Failure) as failed, OutputFile(path) as file:
        file.write("first line\n")
        FileAccess().read_bytes(tmp_path / "nothing")
    assert [one.id for one in failed.value.diagnostics] == [900500, 900918]
    with pytest.raises(KeyboardInterrupt), OutputFile(path):  # nothing was written
        raise KeyboardInterrupt
    assert path.read_text("utf-8") == "of yesterday"
    partial = {one.name for one in tmp_path.iterdir()} - {"out.csv"}
    assert partial == {"out.partial.csv", "out.partial-2.csv", "out.partial-3.csv"}
    assert {(tmp_path / name).read_text("utf-8") for name in partial} == {"first line\n"}


def test_a_file_that_is_read_after_its_begin_keeps_its_place(tmp_path: Path) -> None:
    """A subprogram whose name is computed is known only when it is called."""
    path = tmp_path / "sub.nc"
    path.write_text("M17\n", "utf-8")
    access = FileAccess()
    file = OutputFile(path, "--trace", access)
    file.write("text")
    with pytest.raises(Failure, match="900913"):
        access.read_lines(path)
    with pytest.raises(Failure, match="900913"):
        file.close()
    assert path.read_text("utf-8") == "M17\n"


# --- what is read -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "words",
    [
        ["check", "/dev/zero"],
        ["check", "endless.lis"],
        ["run", "/dev/zero"],
        ["run", "part.nc", "--plc", "endless.py"],
        ["run", "part.nc", "--plc", "inputs.py"],
        ["run", "part.nc", "--machine", "machine"],
        ["check", "machine"],
        ["run", "part.nc", "--rtconf", "/dev/zero"],
        ["schedule", "show", "/dev/zero"],
        ["schedule", "simulate", "rtconf.lis", "--load", "/dev/zero"],
        ["coverage", "--merge", "/dev/zero"],
        ["run", "calls.nc"],
    ],
    ids=" ".join,
)
def test_an_endless_file_is_read_up_to_a_bound(
    folder: Path,
    words: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Programs, lists, loads and data: 900915 names the bound."""
    monkeypatch.setattr(file_access, "MAX_BYTES", 1 << 20)
    with (folder / "machine" / "ext_var1.lis").open("ab") as long:
        long.truncate((1 << 20) + 1)
    (folder / "calls.nc").write_text('L "ENDLESS.NC"\nM30\n', "utf-8")
    for name in ("ENDLESS.NC", "endless.lis", "endless.py", "endless.csv"):
        (folder / name).symlink_to("/dev/zero")
    plc = "from nctakt import Plc\n\nclass Cell(Plc):\n    inputs = 'endless.csv'\n"
    (folder / "inputs.py").write_text(plc, "utf-8")
    code = main(words)
    err = capsys.readouterr()
    found = err.err + err.out
    if words == ["run", "calls.nc"]:  # a device is no program that could be called
        assert "20369" in found
    else:
        assert "900915" in found or "900581" in found
        assert "1048576" in found or "900581" in found
    assert code in (1, 2)


def test_standard_input_is_read_up_to_a_bound(folder: Path) -> None:
    """``nctakt run - < /dev/zero`` ends."""
    command = [sys.executable, "-m", "nctakt", "run", "-"]
    with Path("/dev/zero").open("rb") as endless:
        done = subprocess.run(command, stdin=endless, capture_output=True, check=False)
    assert (done.returncode, b"900915" in done.stderr) == (2, True)


def test_a_plain_file_without_lines_is_read_up_to_a_bound(tmp_path: Path) -> None:
    """A hundred megabytes of zeros are no text of lines."""
    path = tmp_path / "p.nc"
    with path.open("wb") as file:
        file.truncate(file_access.MAX_BYTES + (1 << 20))
    with pytest.raises(Failure, match="900915"):
        FileAccess().read_lines(path)
