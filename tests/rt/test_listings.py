# SPDX-License-Identifier: MIT
"""``nctakt disassemble``: each program in this folder gives the listing next to it, word for word.

Lines ``; --set NAME=VALUE`` at a program's head are options of the command. ``NCTAKT_UPDATE=1``
writes the listings anew: then read what ``git diff`` says.
"""

from __future__ import annotations

import os
import random
from pathlib import Path

import pytest
from support.insides import machine_of

from nctakt.cli import main
from nctakt.decoder.cycles.builder import CycleDefinition
from nctakt.nc.meaning.cost import max_steps
from nctakt.results.instruction_tree import ListedCycle, list_cycle
from nctakt.run.controller import Controller, NcText

pytestmark = pytest.mark.slow

FOLDER = Path(__file__).parent
PROGRAMS = sorted(FOLDER.glob("*.nc"))

Captured = pytest.CaptureFixture[str]


def options_of(program: Path) -> list[str]:
    lines = program.read_text("utf-8").splitlines()
    found = [line.removeprefix("; ") for line in lines if line.startswith("; --")]
    return [word for line in found for word in line.split()]


@pytest.mark.parametrize("language", ["en", "de"])
@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.stem)
def test_listing(
    program: Path, language: str, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    """RC-302, RC-501: the listing of a program's realtime cycles."""
    monkeypatch.chdir(FOLDER)
    words = ["list", program.name, "--lang", language, *options_of(program)]
    assert main(words) == 0, capsys.readouterr().err
    shown = capsys.readouterr().out
    expected = program.with_suffix(".listing" if language == "en" else f".{language}.listing")
    if os.environ.get("NCTAKT_UPDATE"):
        expected.write_text(shown, "utf-8", newline="\n")
    assert shown == expected.read_text("utf-8")


# --- the counts are those of the tick ------------------------------------------------------------


def listed(text: str) -> list[ListedCycle]:
    """The listings of the cycles of a program, while ``instructions`` of its tick are counted."""
    return [list_cycle(definition) for definition in definitions(text, Controller())]


def definitions(text: str, controller: Controller) -> list[CycleDefinition]:
    found: list[CycleDefinition] = []
    run = controller.run(
        NcText("part.nc", text),
        ticks=20,
        memory_trace=False,
        on_cycle=lambda _, definition: found.append(definition),
    )
    assert not run.errors, [error.render() for error in run.errors]
    return found


STATEMENTS = (
    "V.E.VALUE1 = 7",
    "V.E.COUNT = V.E.COUNT + 1 - 1",
    "V.E.COUNT += 0",
    "V.E.VALUE1 = SIN[30] * ATAN2[V.E.VALUE1, 2]",
    "V.E.VALUE1 = V.E.VALUE2 MOD 7 + PI",
    "V.E.VALUE1 = P1 + P[P1]",
    "V.E.VALUE1 = 2 * 3 + 4",
    "V.E.VALUE1 *= V.E.VALUE2 + 1",
    "V.E.VALUE1",
    "P1",
    "V.RTG.OVERRIDE.VEL.CYCLE = 50 + V.RTG.TIMER[V.E.COUNT]",
    "V.E.VALUE2 = V.RTA.ACS.ACT_POS.X / 5",
    "#TIMER START SYN [ID=V.E.COUNT + 1]",
    "V.E.LIST[V.E.COUNT] += V.E.ASYNC",
    "V.E.LIST[2] = V.E.LIST[V.E.COUNT + 1] / 2",
    "$IF Vs.E.ASYNC > 5000\n$ENDIF",
    "$IF V.E.COUNT > 1000\n$ELSEIF V.E.VALUE1 > 1E9\n$ENDIF".replace("1E9", "1000000000"),
    "$IF EDGE V.E.COUNT < 0 || 0\n$ENDIF",
    "$IF 1\nV.E.COUNT = 0\n$ENDIF",
)


@pytest.mark.parametrize("statement", STATEMENTS)
def test_counts_of_statements_are_those_of_the_tick(statement: str) -> None:
    """RC-501: what the listing counts is what the tick adds up."""
    assert counted_in_tick([statement]) == listed(program([statement]))[0].max_count


@pytest.mark.parametrize("seed", range(30))
def test_counts_of_cycles_are_those_of_the_tick(seed: int) -> None:
    """RC-501: total of the listing, count in the tick and the checker's cost are the same."""
    chosen = random.Random(seed).choices(STATEMENTS, k=12)
    cycle = listed(program(chosen))[0]
    assert cycle.max_count == counted_in_tick(chosen)
    assert cycle.max_count == cycle.count


def program(statements: list[str]) -> str:
    body = "\n".join(statements)
    return f"P1 = 2\n#RT CYCLE [ID=1 SCOPE=GLOBAL]\n{body}\n#RT CYCLE END\n#TIME 0.005\nM30\n"


def counted_in_tick(statements: list[str]) -> int:
    controller = Controller()
    controller.start(NcText("part.nc", program(statements)))
    controller.step(3)
    return controller.instructions_in_tick


@pytest.mark.parametrize("file", PROGRAMS, ids=lambda program: program.stem)
def test_most_of_a_run_through_is_what_the_checker_says(file: Path) -> None:
    """RC-501: the checker, which warns of costly cycles, and the listing have one opinion."""
    controller = Controller()
    for definition in definitions(file.read_text("utf-8"), controller):
        names = machine_of(controller).names
        assert list_cycle(definition).max_count == max_steps(definition.statement.body, names)


# --- the command ---------------------------------------------------------------------------------


def test_a_program_without_cycles(
    capsys: Captured, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing to list is said, and is no error."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text("G00 X1\nM30\n", "utf-8")
    assert main(["disassemble", "part.nc"]) == 0
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("note 900591: no realtime cycle was defined")


def test_an_error_after_a_cycle(
    capsys: Captured, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What was decoded before an error is listed; the error is reported, exit code 1."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text("#RT CYCLE\nM100\n#RT CYCLE END\nP1 = 1 / 0\nM30\n", "utf-8")
    assert main(["disassemble", "part.nc"]) == 1
    captured = capsys.readouterr()
    assert captured.out.startswith("Realtime cycle #1, part.nc:1\n")
    assert "part.nc:4:8: error 20396" in captured.err


def test_a_limit(capsys: Captured, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """At the limit of the run the listing says that something may be missing."""
    monkeypatch.chdir(tmp_path)
    text = "#TIME 1\nP1 = V.RTA.ACS.ACT_POS.X\n#RT CYCLE\nM100\n#RT CYCLE END\nM30\n"
    Path("part.nc").write_text(text, "utf-8")
    assert main(["disassemble", "part.nc", "--until", "10ms"]) == 0
    assert "note 900590: the listing ends at the limit of the run, tick 10" in (
        capsys.readouterr().err
    )


def test_wrong_words(capsys: Captured) -> None:
    """What cannot be used is reported as for nctakt run: exit code 2."""
    assert main(["disassemble", "nowhere.nc", "--set", "V.E.COUNT"]) == 2
    reported = capsys.readouterr().err
    assert "error 900500" in reported
    assert "error 900511" in reported


def test_values_at_times(capsys: Captured, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """RC-302: a value that a stimulus gave before the definition was decoded is the frozen one."""
    monkeypatch.chdir(tmp_path)
    text = "#TIME 0.01\nP1 = Vs.E.COUNT\n#RT CYCLE\n$IF P1\n$ENDIF\n#RT CYCLE END\nM30\n"
    Path("part.nc").write_text(text, "utf-8")
    assert main(["disassemble", "part.nc", "--at", "5ms", "V.E.COUNT=42"]) == 0
    assert "frozen when it was decoded: P1 = 42 (line 4)" in capsys.readouterr().out


def test_a_plc_that_fails(
    capsys: Captured, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What was decoded before the user's PLC failed is listed; exit code 1."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text("#RT CYCLE\nM100\n#RT CYCLE END\n#TIME 1\nM30\n", "utf-8")
    plc = "class Mine:\n    def cycle(self, hli):\n        raise ValueError('no')\n"
    Path("mine.py").write_text(plc, "utf-8")
    assert main(["disassemble", "part.nc", "--plc", "mine.py"]) == 1
    captured = capsys.readouterr()
    assert captured.out.startswith("Realtime cycle #1, part.nc:1\n")
    assert "error 900523" in captured.err


def test_no_run_is_left_half_listed(
    capsys: Captured, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A program with mistakes is refused as a whole: nothing is listed."""
    monkeypatch.chdir(tmp_path)
    text = "#RT CYCLE\nM100\n#RT CYCLE END\n#CHANNEL INTERFACE OFF\nM30\n"
    Path("part.nc").write_text(text, "utf-8")
    assert main(["disassemble", "part.nc"]) == 1
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "error 9002" in captured.err
    assert "900591" not in captured.err
