# SPDX-License-Identifier: MIT
"""``nctakt run``: how words become requests, and results become output and exit codes.

A controller that only notes what it is asked for replaces the real one; the command with the real
controller is tested in ``test_command.py``.
"""

from __future__ import annotations

import signal
import sys
import types
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.lists.format.times import Time
from nctakt.lists.machine.machine import load_machine
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import RUNNING_UNCOMPILED
from nctakt.messages.commands.inputs import NOT_AN_ASSIGNMENT
from nctakt.messages.files import STDIN_NAMED_TWICE
from nctakt.messages.plcs.plc import PLC_FAILED
from nctakt.plc import PlcError
from nctakt.results.run import ProgramMessage, Run
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import Signal, TraceHeader
from nctakt.run.access.stimuli import Stimulus


@dataclass(frozen=True, slots=True)
class NcText:
    """A program given as text."""

    name: str
    text: str


class Asked:
    """What the controller was asked for, and what it is to do."""

    machine: object = None
    level: float = 3.0
    programs: tuple[object, ...] = ()
    options: dict[str, Any]
    behave: Callable[..., Run]

    def __init__(self) -> None:
        self.options = {}
        self.behave = lambda **_: result()


def result(**fields: Any) -> Run:
    """A run of 726 ticks that ended well."""
    return Run(
        **({"programs": ("part.nc",), "cycle_time_us": 1000, "first_tick": 0} | fields)
        | {"ticks": 726, "state": fields.get("state", "ended")}
    )


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> Iterator[Asked]:
    """The command talks to a controller that notes what it is asked for."""
    noted = Asked()

    class Controller:
        cycle_time_us = 1000
        tick = 0
        machine = load_machine(None)

        def __init__(
            self, machine: object = None, schedule: object = None, access: object = None
        ) -> None:
            assert schedule is None
            noted.machine = machine

        def read(self, name: str) -> float:
            assert name == "CH1.V.RTG.CYCLES.DIAG_LEVEL"
            return noted.level

        def run(self, *programs: object, **options: Any) -> Run:
            noted.programs = programs
            noted.options = options
            for sink in options["sinks"]:
                sink.open(TraceHeader(1000, (Signal("X.ACS.ACT_POS"),)))
            return noted.behave(**options)

    module = types.ModuleType("nctakt.run.controller")
    module.__dict__.update(Controller=Controller, NcText=NcText)
    monkeypatch.setitem(sys.modules, "nctakt.run.controller", module)
    mode = types.ModuleType("nctakt.base.mode")
    mode.__dict__.update(use_plain=lambda: None, is_compiled=lambda: True)
    monkeypatch.setitem(sys.modules, "nctakt.base.mode", mode)
    monkeypatch.setattr("nctakt.base.mode", mode, raising=False)
    yield noted


@pytest.fixture
def part(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A program in the folder in which the command runs."""
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "part.nc"
    path.write_text("M30\n", encoding="utf-8")
    return path


@pytest.mark.usefixtures("part")
def test_words_become_a_request(asked: Asked, tmp_path: Path) -> None:
    """Each option reaches the controller under its own name."""
    (tmp_path / "machine").mkdir()
    words = "run part.nc part.nc --machine machine --set V.E.A=5 --set V.E.B=TRUE"
    words += " --at 1.5ms V.E.A=-1 --at 2 V.E.B=0 --ticks 7 --until 3s --after 10ms"
    words += " --trace out.csv --signals X.ACS.ACT_POS,V.E.M[1,2],"
    assert main(words.split()) == 0
    assert asked.machine == "machine"
    assert asked.programs == (Path("part.nc"), Path("part.nc"))
    expected = {
        "plc": None,
        "until": Time(3_000_000),
        "ticks": 7,
        "after": Time(10_000),
        "set": {"V.E.A": 5.0, "V.E.B": 1.0},
        "at": (Stimulus("1.5 ms", "V.E.A", -1.0), Stimulus("2 s", "V.E.B", 0.0)),
        "signals": ("X.ACS.ACT_POS", "V.E.M[1,2]"),
        "memory_trace": False,
    }
    assert {name: asked.options[name] for name in expected} == expected


@pytest.mark.usefixtures("part")
def test_without_options_the_controller_chooses(asked: Asked) -> None:
    """No machine, limits or signals: the demo machine and the controller's defaults."""
    assert main(["run", "part.nc"]) == 0
    assert asked.machine is None
    assert asked.options["signals"] is None
    assert asked.options["until"] is None
    assert asked.options["ticks"] is None
    assert asked.options["sinks"] == []


@pytest.mark.usefixtures("part")
@pytest.mark.parametrize(
    ("state", "diagnostics", "code"),
    [
        ("ended", (), 0),
        ("limit", (), 0),
        ("error", (), 1),
        ("interrupted", (), 1),
        ("ended", (diagnostic(RUNNING_UNCOMPILED),), 0),
        ("ended", (diagnostic(STDIN_NAMED_TWICE),), 1),
    ],
)
def test_exit_codes(asked: Asked, state: str, diagnostics: Any, code: int) -> None:
    """0 it ran, also up to a limit; 1 an error of the program, or interrupted."""
    asked.behave = lambda **_: result(state=state, diagnostics=diagnostics)
    assert main(["run", "part.nc"]) == code


@pytest.mark.usefixtures("part")
def test_messages_and_summary_go_out_and_diagnostics_to_stderr(
    asked: Asked, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """What programs say is printed with its time, without control characters, and kept."""

    def behave(on_message: Callable[[ProgramMessage], None], **_: Any) -> Run:
        on_message(ProgramMessage(463_000, "half way\x1b[2J"))
        on_message(ProgramMessage(464_000, "no stamp, ", is_exclusive=True, is_unbroken=True))
        on_message(ProgramMessage(465_000, "one line", is_exclusive=True))
        return result(diagnostics=(diagnostic(RUNNING_UNCOMPILED), diagnostic(STDIN_NAMED_TWICE)))

    asked.behave = behave
    main(["run", "part.nc", "--messages", "said.txt"])
    shown = capsys.readouterr()
    assert shown.out.splitlines()[0] == "0.463000 s  half way·[2J"
    assert "part.nc: ended, 726 ticks = 0.726000 s" in shown.out
    assert "note 900531" in shown.err
    assert "error 900504" in shown.err
    said = (tmp_path / "said.txt").read_text(encoding="utf-8")
    assert said == "0.463000 s  half way·[2J\nno stamp, one line\n"


@pytest.mark.usefixtures("part")
def test_quiet_leaves_errors_and_messages(asked: Asked, capsys: pytest.CaptureFixture[str]) -> None:
    """With --quiet there is neither summary nor note."""

    def behave(on_message: Callable[[ProgramMessage], None], **_: Any) -> Run:
        on_message(ProgramMessage(0, "hello"))
        return result(diagnostics=(diagnostic(RUNNING_UNCOMPILED), diagnostic(STDIN_NAMED_TWICE)))

    asked.behave = behave
    main(["run", "part.nc", "--quiet", "--lang", "de"])
    shown = capsys.readouterr()
    assert shown.out == "0.000000 s  hello\n"
    assert "900531" not in shown.err
    assert "Fehler 900504" in shown.err


@pytest.mark.usefixtures("part")
@pytest.mark.parametrize(("level", "language", "line"), [(3, "en", ""), (4, "de", "M100 wurde")])
def test_diagnosis_data_are_written(
    asked: Asked, tmp_path: Path, level: int, language: str, line: str
) -> None:
    """RC-601: --diagnosis writes the cycles' diagnosis data, by the level at the end (RC-603)."""

    def behave(sinks: Any, **_: Any) -> Run:
        for sink in sinks:
            sink.events([Event(4, 4000, "M", "100 1 4000", None, "17")])
        return result()

    asked.behave = behave
    asked.level = level
    main(["run", "part.nc", "--diagnosis", "diag.txt", "--lang", language])
    text = (tmp_path / "diag.txt").read_text(encoding="utf-8")
    assert len(text.splitlines()) == 8 + level
    assert line in text


@pytest.mark.usefixtures("part")
def test_a_plc_that_fails_while_it_runs_stops_the_run(
    asked: Asked, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """Its diagnostic is shown, the exit code is 1, and the trace so far is kept."""

    def behave(**_: Any) -> Run:
        raise PlcError(diagnostic(PLC_FAILED, tick=3, reason="oops", traceback=""))

    asked.behave = behave
    assert main(["run", "part.nc", "--trace", "out.csv"]) == 1
    assert "error 900523: the PLC failed after tick 3: oops" in capsys.readouterr().err
    assert (tmp_path / "out.csv").read_text(encoding="utf-8").startswith("tick,")


@pytest.mark.usefixtures("part")
def test_what_the_controller_refuses_is_wrong_usage(
    asked: Asked, capsys: pytest.CaptureFixture[str]
) -> None:
    """A name that the machine does not know ends with exit code 2."""

    def behave(**_: Any) -> Run:
        raise Failure(diagnostic(NOT_AN_ASSIGNMENT, text="V.E.X"))

    asked.behave = behave
    assert main(["run", "part.nc"]) == 2
    assert "900511" in capsys.readouterr().err


@pytest.mark.usefixtures("part")
def test_an_error_of_our_own_is_reported_shortly(
    asked: Asked, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Exit code 3, one line, and how to get the traceback."""

    def behave(**_: Any) -> Run:
        raise IndexError("of ours")

    asked.behave = behave
    monkeypatch.delenv("NCTAKT_DEBUG", raising=False)
    assert main(["run", "part.nc"]) == 3
    shown = capsys.readouterr().err
    assert "internal error: IndexError: of ours" in shown
    assert "NCTAKT_DEBUG=1" in shown
    assert "Traceback" not in shown
    monkeypatch.setenv("NCTAKT_DEBUG", "1")
    assert main(["run", "part.nc"]) == 3
    assert "Traceback" in capsys.readouterr().err


@pytest.mark.usefixtures("part")
def test_an_interrupt_outside_the_run_is_reported(
    asked: Asked, capsys: pytest.CaptureFixture[str]
) -> None:
    """Ctrl-C while nothing runs ends with exit code 1 and without a traceback."""

    def behave(**_: Any) -> Run:
        raise KeyboardInterrupt

    asked.behave = behave
    assert main(["run", "part.nc"]) == 1
    assert capsys.readouterr().err.strip() == "interrupted"


@pytest.mark.usefixtures("part")
def test_ctrl_c_ends_a_run_between_two_ticks(asked: Asked) -> None:
    """The first Ctrl-C waits for the next look at the progress, a second one does not wait."""
    reached: list[str] = []

    def behave(on_progress: Callable[[int, int | None], None], **_: Any) -> Run:
        on_progress(1, 10)
        signal.raise_signal(signal.SIGINT)
        reached.append("goes on")
        with pytest.raises(KeyboardInterrupt):
            on_progress(2, 10)
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
        return result(state="interrupted")

    asked.behave = behave
    before = signal.getsignal(signal.SIGINT)
    assert main(["run", "part.nc"]) == 1
    assert reached == ["goes on"]
    assert signal.getsignal(signal.SIGINT) is before


@pytest.mark.usefixtures("part", "asked")
@pytest.mark.parametrize(
    ("words", "numbers"),
    [
        ("run missing.nc", [900500]),
        ("run .", [901015]),
        ("run - -", [900504]),
        ("run part.nc --machine missing", [900500]),
        ("run part.nc --machine part.nc", [900502]),
        ("run part.nc --trace out.txt", [900506]),
        ("run part.nc --trace no/out.csv", [900507]),
        ("run part.nc --blocks --signals BLOCK", [900817, 900817]),
        ("run part.nc --messages no/said.txt", [900507]),
        ("run part.nc --diagnosis no/diag.txt", [900507]),
        ("run part.nc --set V.E.X", [900511]),
        ("run part.nc --set V.E.X=y", [900512]),
        ("run part.nc --at soon V.E.X=1", [900510]),
        ("run part.nc --until soon", [900510]),
        ("run part.nc --after -1s", [900510]),
        ("run part.nc --plc missing.py", [900500]),
        ("run a.nc b.nc --set X --until soon --plc c.py", [900500, 900500, 900511, 900510, 900500]),
    ],
)
def test_unusable_input_is_reported_all_at_once(
    words: str, numbers: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    """Everything that is wrong is reported by number, with a remedy, and the exit code is 2."""
    assert main(words.split()) == 2
    shown = capsys.readouterr().err
    reported = [
        int(line.split("error ")[1][:6]) for line in shown.splitlines() if "error 9" in line
    ]
    assert reported == numbers
    assert shown.count("remedy: ") == len(numbers)


@pytest.mark.usefixtures("part", "asked")
@pytest.mark.parametrize(
    ("words", "text"),
    [
        ("", "Usage"),
        ("run", "no program was named"),
        ("rum part.nc", "900912: unknown command rum"),
        ("run part.nc --ticks 0", "--ticks"),
        ("run part.nc --ticks many", "--ticks"),
        ("run part.nc --lang fr", "--lang"),
        ("run part.nc --at 1s", "--at"),
        ("run part.nc --tick 5", "--ticks"),
    ],
)
def test_wrong_words_are_wrong_usage(
    words: str, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """What the command line does not know is reported with exit code 2."""
    assert main(words.split()) == 2
    assert text in capsys.readouterr().err


def test_a_mode_that_cannot_be_had_is_wrong_usage(
    asked: Asked,
    part: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """--compiled without a build is an error; without the option a note says that it is slower.

    Who asks for plain Python, by option or by NCTAKT_PLAIN=1, is not reported.
    """
    monkeypatch.delenv("NCTAKT_PLAIN", raising=False)
    monkeypatch.setattr("nctakt.base.mode.is_compiled", lambda: False)
    assert main(["run", str(part), "--compiled"]) == 2
    assert "error 900530" in capsys.readouterr().err
    assert main(["run", str(part)]) == 0
    assert "note 900531" in capsys.readouterr().err
    assert main(["run", str(part), "--plain"]) == 0
    assert main(["run", str(part), "--quiet"]) == 0
    monkeypatch.setenv("NCTAKT_PLAIN", "1")
    assert main(["run", str(part)]) == 0
    assert "900531" not in capsys.readouterr().err


def test_a_program_from_standard_input(
    asked: Asked, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """'-' is the text on standard input, whatever its encoding, under the name <stdin>."""
    path = tmp_path / "in"
    path.write_bytes('#MSG ["\xc4"]\nM30\n'.encode("cp1252"))
    with path.open(encoding="utf-8") as file:
        monkeypatch.setattr("sys.stdin", file)
        assert main(["run", "-"]) == 0
    assert asked.programs == (NcText("<stdin>", '#MSG ["Ä"]\nM30\n'),)


def test_help_names_all_options(capsys: pytest.CaptureFixture[str]) -> None:
    """The help of the command and of nctakt itself can be had, with exit code 0."""
    assert main(["run", "--help"]) == 0
    shown = capsys.readouterr().out
    for option in ("--machine", "--set", "--at", "--until", "--plc", "--trace", "--diagnosis"):
        assert option in shown
    assert main(["--help"]) == 0
    assert "run" in capsys.readouterr().out
    assert main(["--version"]) == 0


@pytest.mark.usefixtures("part")
def test_a_machine_around_the_program_is_reported(
    asked: Asked, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A program runs on the machine in whose folder it lies, and a note says so (900816)."""
    (tmp_path / "hochlauf.lis").write_text("kanal_anzahl 1\n", encoding="utf-8")
    assert main("run part.nc".split()) == 0
    assert asked.machine == "hochlauf.lis"
    reported = capsys.readouterr().err
    assert "note 900816: the program runs on the machine of hochlauf.lis" in reported
    assert main("run part.nc --machine .".split()) == 0
    assert asked.machine == "."
    assert main("run part.nc --machine demo".split()) == 0
    assert asked.machine == "demo"
    assert main("run part.nc --quiet".split()) == 0
    assert "900816" not in capsys.readouterr().err
