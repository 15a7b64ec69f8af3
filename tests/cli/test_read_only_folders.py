# SPDX-License-Identifier: MIT
"""Each command in a folder that nobody may write: what it would write there is refused by number.

The commands and options are those of the command's own table: each that names a file or a folder is
known here as one that is read or written, so that a new one is tried as well.
"""

from __future__ import annotations

import ctypes
import json
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

import click
import pytest
from support.command_table import command_of, commands

from nctakt.cli import group, main

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform != "linux", reason="takes a right from the test's process"),
]

EXAMPLES = Path(__file__).parents[2] / "examples"

#: What names files and folders that are only read.
READ = {
    "--machine", "--root", "--confine", "--from", "--rtconf", "--load", "--load-b", "--plc",
    "--fmu", "--map", "--merge", "--upload", "paths", "files", "live --log",
}  # fmt: skip

#: What each command is called with, beside an option that writes; two write without one.
CALLS = {
    "init": ".",
    "new": "machine",
    "check": "part.nc --format json",
    "run": "part.nc",
    "live": "part.nc --port 0",
    "why": "part.nc",
    "time": "part.nc",
    "compare": "log.csv part.nc",
    "coverage": "part.nc",
    "disassemble": "part.nc",
    "explain": "V.E.WORD",
    "test": "part.nc",
    "study": "plan.toml --yes --processes 1",
    "replay": "part.tape",
    "schedule analyse": "rtconf.lis --load load.toml",
    "schedule compare": "rtconf.lis rtconf.lis --load load.toml",
    "schedule learn": "rtconf.lis times.csv",
    "schedule run": "rtconf.lis --load load.toml --duration 10ms",
    "schedule show": "mistaken.lis",
    "schedule simulate": "rtconf.lis --load load.toml --cycles 3",
    "schedule suggest": "rtconf.lis --load load.toml",
    "serve": "part.nc --ads=127.0.0.1:0",
    "fmu": "part.nc",
}

#: Options that write without naming a file, and words that some options need beside them.
UNNAMED = {"schedule show": ("--fix",)}
BESIDE = {
    "compare --share": "--yes",
    "run --retain": "--plc keeps.st",
    "live --retain": "--plc keeps.st",
    "serve --opcua-folder": "--opcua=0.0.0.0:0",
    "study --corpus": "--cover --sample 3",
}

#: How a file ends that an option writes; others write any file.
ENDS = {
    "--csv": ".csv", "--trace": ".csv", "--out": ".csv", "--plot": ".svg", "--vcd": ".vcd",
    "--fst": ".fst", "--perfetto": ".json", "--flame": ".json", "--data": ".json",
    "--report": ".html", "--junit": ".xml", "fmu --output": ".fmu",
}  # fmt: skip

#: Those that serve until somebody ends them.
ENDLESS = ("live", "serve")

#: What cannot be written: a file, a folder, that of OPC UA.
REFUSED = ("error 900507", "error 900747", "error 901472")

#: What the process without the right does: commands from standard input, their results to a file.
WORKER = """\
import contextlib, io, json, sys
from nctakt.cli import main
done = []
for words in json.load(sys.stdin):
    print(*words, flush=True)
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = main(words)
    done.append([code, out.getvalue(), err.getvalue()])
    open(sys.argv[1], "w").write(json.dumps(done))
"""


def paths_of(words: Sequence[str]) -> Iterator[str]:
    """The options and arguments of a command that name files or folders."""
    for parameter in command_of(words).params:
        shown = str(parameter.make_metavar(click.Context(group)))
        if "FILE" in shown or "FOLDER" in shown:
            is_option = isinstance(parameter, click.Option)
            yield max(parameter.opts, key=len) if is_option else str(parameter.name)


def written() -> list[list[str]]:
    """A command line for each option of each command that writes into the working directory."""
    found = []
    for words in commands(group):
        name = " ".join(words)
        for option in (*paths_of(words), *UNNAMED.get(name, ())):
            if {option, f"{name} {option}"} & READ:
                continue
            line = [*words, *CALLS[name].split(), *BESIDE.get(f"{name} {option}", "").split()]
            if option.startswith("-"):
                end = ENDS.get(f"{name} {option}", ENDS.get(option, ""))
                line += [option] if option in UNNAMED.get(name, ()) else [option, f"out{end}"]
            found.append(line)
    return found


def without_rights() -> None:
    """Take from the process to start that root may write everywhere: CAP_DAC_OVERRIDE."""
    ctypes.CDLL(None).prctl(24, 1, 0, 0, 0)  # PR_CAPBSET_DROP


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with what the commands read."""
    made = tmp_path / "locked"
    made.mkdir()
    monkeypatch.chdir(made)
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")
    monkeypatch.setenv("PYTEST_ADDOPTS", "-p no:cacheprovider")
    (made / "part.nc").write_text("G01 X1 F6000 ; expect: ended\nM30\n", "utf-8")
    (made / "keeps.st").write_text(
        "PROGRAM MAIN\nVAR RETAIN n : INT; END_VAR\nn := n + 1;\nEND_PROGRAM\n", "utf-8"
    )
    (made / "plan.toml").write_text(
        'program = "part.nc"\nvary = [{ variable = "V.E.VALUE", values = [1, 2] }]\n'
        'expect = ["max X < 0.5"]\nmeasure.end = "X at end"\n',
        "utf-8",
    )
    for name in ("rtconf.lis", "load.toml"):
        shutil.copy(EXAMPLES / "schedule" / name, made)
    (made / "mistaken.lis").write_text(
        (made / "rtconf.lis").read_text("utf-8").replace("windows_time 500", "windows_time 9e9"),
        "utf-8",
    )
    assert main(["run", "part.nc", "--trace", "log.csv", "--record", "part.tape", "--quiet"]) == 0
    words = [*"schedule simulate rtconf.lis --load load.toml --csv times.csv --drawn 30".split()]
    assert main(words) == 0
    return made


def reported(folder: Path, lines: list[list[str]]) -> list[tuple[int, str, str]]:
    """Exit code and both outputs of command lines in the folder, which nobody may write now."""
    for path in folder.iterdir():
        path.chmod(0o444)
    folder.chmod(0o555)
    found = folder.parent / "found.json"
    try:
        done = subprocess.run(
            [sys.executable, "-c", WORKER, str(found)],
            input=json.dumps(lines),
            capture_output=True,
            text=True,
            check=False,
            timeout=280,
            preexec_fn=without_rights,
        )
    finally:
        folder.chmod(0o755)
    assert done.returncode == 0, done.stdout + done.stderr
    return [(code, out, err) for code, out, err in json.loads(found.read_text("utf-8"))]


def contents(folder: Path) -> dict[str, bytes]:
    """All files of a folder."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file()
    }


def test_what_would_be_written_is_refused(folder: Path) -> None:
    """Exit code 2 with number and reason, nothing half done; the folder is named or the file."""
    before = contents(folder)
    lines = written()
    assert len(lines) > 40
    otherwise = [
        (line, code, err)
        for line, (code, _, err) in zip(lines, reported(folder, lines), strict=True)
        if code != 2 or "Traceback" in err or not any(number in err for number in REFUSED)
    ]
    assert otherwise == []
    assert contents(folder) == before


def test_what_is_only_read_goes_on(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Each other command does there what it does elsewhere."""
    lines = [
        [*name.split(), *words.split()]
        for name, words in CALLS.items()
        if name not in (*ENDLESS, "init", "new", "fmu")
    ]
    before = contents(folder)
    elsewhere = [main(line) for line in lines]
    capsys.readouterr()
    otherwise = [
        (line, own, other)
        for line, own, other in zip(lines, reported(folder, lines), elsewhere, strict=True)
        if own[0] != other or "Traceback" in own[2]
    ]
    assert otherwise == []
    assert contents(folder) == before
