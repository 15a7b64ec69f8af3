# SPDX-License-Identifier: MIT
"""``nctakt run`` as a user meets it: good and bad input, pipes, interrupts, files."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import nctakt
from nctakt.cli import main
from nctakt.results.trace.reading import read_trace

pytestmark = pytest.mark.slow

PART = """\
#RT CYCLE [ID = 17 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    M100
  $ENDIF
  $IF EDGE V.E.TRIGGER == 1
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
#MSG ["on the way"]
N20 G00 X300
M30
"""

ENDLESS = """\
$WHILE 1
G01 X100 F60000
G01 X0
$ENDWHILE
M30
"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The command runs in its own folder, where part.nc is."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "part.nc").write_text(PART, encoding="utf-8")
    return tmp_path


def command(*words: str) -> list[str]:
    """The command as its own process."""
    return [sys.executable, "-m", "nctakt", *words]


def environment() -> dict[str, str]:
    """The environment of such a process: it finds the package that is tested."""
    return os.environ | {"PYTHONPATH": str(Path(nctakt.__file__).parent.parent)}


def test_a_run_tells_what_the_cycle_did(capsys: pytest.CaptureFixture[str]) -> None:
    """RC worked example: M100 in tick 463, the move lasts to tick 724, M30 in tick 725."""
    assert main(["run", "part.nc", "--quiet"]) == 0
    assert capsys.readouterr().out == "0.000000 s  on the way\n"
    assert main(["run", "part.nc"]) == 0
    shown = capsys.readouterr().out.splitlines()
    assert shown[1] == "part.nc: ended, 726 ticks = 0.726000 s"
    assert (
        shown[5].split() == "17 part.nc:1 PROG 725 part.nc:2 ONCE 1 1 tick 463 = 0.463000 s".split()
    )
    assert shown[6].split() == "part.nc:5 EDGE never".split()
    assert shown[10].split() == "M100 realtime cycle 1 tick 463 = 0.463000 s".split()


def test_stimuli_act_at_their_tick(capsys: pytest.CaptureFixture[str]) -> None:
    """RC-002: a value given at 99.5 ms is latched at tick 100, where the EDGE fires."""
    assert main(["run", "part.nc", "--at", "99.5ms", "V.E.TRIGGER=1"]) == 0
    assert "part.nc:5 EDGE  1            1    tick 100 = 0.100000 s" in capsys.readouterr().out


@pytest.mark.parametrize("suffix", ["csv", "jsonl"])
def test_a_trace_is_written_and_read(suffix: str) -> None:
    """The signals asked for are there for each tick, and the events with their places."""
    words = ["run", "part.nc", "--trace", f"out.{suffix}", "--signals", "X.ACS.ACT_POS,V.E.COUNT"]
    assert main([*words, "--set", "V.E.TRIGGER=TRUE", "--quiet"]) == 0
    trace = read_trace(f"out.{suffix}")
    assert list(trace) == ["X.ACS.ACT_POS", "V.E.COUNT"]
    assert trace.ticks == 726
    assert trace.at(462, "X.ACS.ACT_POS") == 200.25
    assert trace.at(0, "V.E.COUNT") == 1.0
    fired = [event for event in trace.events if event.kind == "M"]
    assert [(event.tick, event.text, str(event.span)) for event in fired] == [
        (463, "100 1 463000", "part.nc:3:5")
    ]


def test_several_programs_run_on_one_controller(capsys: pytest.CaptureFixture[str]) -> None:
    """The second program begins where the first one ended; --after continues after the last."""
    Path("back.nc").write_text("G00 X0\nM30\n", encoding="utf-8")
    words = ["run", "part.nc", "back.nc", "--trace", "out.csv", "--after", "10ms"]
    assert main(words) == 0
    assert "part.nc, back.nc: ended, 1462 ticks" in capsys.readouterr().out
    trace = read_trace("out.csv")
    assert [event.text for event in trace.events if event.kind == "end"] == ["part.nc", "back.nc"]
    assert trace.at(1461, "X.ACS.ACT_POS") == 0.0


def test_a_limit_ends_a_run_that_does_not(capsys: pytest.CaptureFixture[str]) -> None:
    """--until and --ticks: the earlier one ends the run; that is no error."""
    Path("endless.nc").write_text(ENDLESS, encoding="utf-8")
    assert main(["run", "endless.nc", "--until", "0.5", "--ticks", "2000"]) == 0
    assert "limit (--until or --ticks sets another), 500 ticks" in capsys.readouterr().out


@pytest.mark.parametrize("language", ["en", "de"])
def test_diagnosis_data_follow_the_programs_level(language: str) -> None:
    """RC-601, RC-603: the program sets the level to 99, and the actions are listed too."""
    level = "V.RTG.CYCLES.DIAG_LEVEL = 99\n"
    Path("part.nc").write_text(level + PART, encoding="utf-8")
    words = ["run", "part.nc", "--quiet", "--diagnosis", "diag.txt", "--lang", language]
    assert main(words) == 0
    text = Path("diag.txt").read_text(encoding="utf-8")
    assert ("Zyklus 17 wurde gestartet" if language == "de" else "Cycle 17 was started") in text
    assert "ACTION  " in text
    assert "M100" in text


@pytest.mark.parametrize(
    ("words", "file", "code", "reported"),
    [
        ("missing.nc", None, 2, "error 900500: missing.nc does not exist"),
        (".", None, 2, "error 901015: . is a folder; a program is a file"),
        ("e.nc", ("e.nc", b""), 0, "warning 900109: the program is empty"),
        ("b.nc", ("b.nc", bytes(range(256)) * 40), 1, "error"),
        ("l.nc", ("l.nc", b"G00 X1" + b" " * 1_000_000), 1, "error 20301"),
        ("part.nc --machine .", None, 2, "error 900061"),
        ("part.nc --set V.E.COUNTS=1", None, 2, "Did you mean V.E.COUNT?"),
        ("part.nc --at 1s V.E.COUNTS=1", None, 2, "Did you mean V.E.COUNT?"),
        ("part.nc --trace o.csv --signals X.ACS.ACTPOS", None, 2, "Did you mean X.ACS.ACT_POS?"),
        ("part.nc --trace no/o.csv", None, 2, "error 900507"),
        ("part.nc --until 5parsec", None, 2, "error 900510"),
        ("part.nc --plc p.py", ("p.py", b"raise ValueError(5)"), 2, "ValueError: 5"),
        (
            "part.nc --plc p.py",
            ("p.py", b"class P:\n  def cycle(self, hli):\n    getattr(hli, 'no')"),
            1,
            "error 900523: the PLC failed after tick 0: AttributeError",
        ),
        ("x.nc", ("x.nc", b"#RT CYCLE\nM30\n"), 1, "error 22005"),
    ],
)
def test_bad_input_is_reported_with_number_and_remedy(
    words: str,
    file: tuple[str, bytes] | None,
    code: int,
    reported: str,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Each mistake has its diagnostic and exit code, no traceback of ours, no endless line."""
    if file is not None:
        Path(file[0]).write_bytes(file[1])
    assert main(["run", *words.split()]) == code
    shown = capsys.readouterr().err
    assert reported in shown
    assert "remedy: " in shown
    assert "src/nctakt" not in shown.replace("\\", "/")
    assert max(map(len, shown.splitlines())) < 300


def test_a_failed_command_leaves_the_results_of_another_alone() -> None:
    """Wrong usage is found before a file is overwritten."""
    for name in ("out.csv", "said.txt", "diag.txt"):
        Path(name).write_text("of yesterday", encoding="utf-8")
    words = "run part.nc --trace out.csv --signals NO --messages said.txt --diagnosis diag.txt"
    assert main(words.split()) == 2
    assert Path("out.csv").read_text(encoding="utf-8") == "of yesterday"
    assert Path("diag.txt").read_text(encoding="utf-8") == "of yesterday"


def test_the_programs_plc_is_asked_after_each_tick(capsys: pytest.CaptureFixture[str]) -> None:
    """RC-002: what the PLC writes after tick n counts from tick n+1."""
    text = "class P:\n  def cycle(self, hli):\n    hli.write('V.E.TRIGGER', hli.tick == 41)\n"
    text += "    hli.acknowledge_all()\n"
    Path("plc.py").write_text(text, encoding="utf-8")
    assert main(["run", "part.nc", "--plc", "plc.py"]) == 0
    assert "part.nc:5 EDGE  1            1    tick 42 = 0.042000 s" in capsys.readouterr().out


@pytest.mark.parametrize("form", ["--plain", "--compiled"])
def test_a_pipe_in_and_a_pipe_out(form: str) -> None:
    """A program from standard input; the output of both forms is the same."""
    from nctakt.base.mode import is_compiled  # noqa: PLC0415 - only where it is asked

    if form == "--compiled" and not is_compiled():
        pytest.skip("the realtime part is not compiled here")
    done = subprocess.run(
        command("run", "-", form),
        check=False,
        input=PART.encode(),
        capture_output=True,
        env=environment(),
    )
    assert done.returncode == 0, done.stderr
    shown = done.stdout.decode("utf-8").splitlines()
    assert shown[1] == "<stdin>: ended, 726 ticks = 0.726000 s"
    assert done.stderr == b""


@pytest.mark.skipif(os.name != "posix", reason="pipes close in another way there")
def test_a_reader_that_goes_away_is_no_error() -> None:
    """``nctakt run part.nc | head -1`` shows one line and no traceback."""
    with subprocess.Popen(
        command("run", "part.nc"),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=environment(),
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.readline()
        process.stdout.close()
        shown = process.stderr.read()
    assert b"Traceback" not in shown
    assert b"BrokenPipe" not in shown


@pytest.mark.skipif(os.name != "posix", reason="signals are sent in another way there")
def test_ctrl_c_ends_a_run_with_its_summary_and_trace() -> None:
    """Exit code 1, state interrupted, and a trace that can be read."""
    Path("endless.nc").write_text(ENDLESS, encoding="utf-8")
    words = command("run", "endless.nc", "--until", "9999min", "--trace", "out.csv")
    with subprocess.Popen(
        words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment()
    ) as process:
        trace = Path("out.partial.csv")
        for _ in range(300):
            if trace.exists() and trace.stat().st_size > 100_000:
                break
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=30)
    assert process.returncode == 1, err
    assert b"endless.nc: interrupted, " in out
    assert b"Traceback" not in err
    ticks = int(out.split(b"interrupted, ")[1].split()[0])
    assert read_trace("out.csv").ticks == ticks


@pytest.mark.skipif(os.name != "posix", reason="a folder in use cannot be removed there")
@pytest.mark.parametrize("words", [["check", "."], ["run", "part.nc"], ["study", "plan.toml"]])
def test_a_working_directory_that_somebody_has_removed_is_reported(
    words: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """902925, and nothing false of standard output."""
    folder = tmp_path / "removed"
    folder.mkdir()
    monkeypatch.chdir(folder)
    folder.rmdir()
    assert main(words) == 2
    reported = capsys.readouterr().err
    assert "error 902925: " in reported
    assert "900507" not in reported
