# SPDX-License-Identifier: MIT
"""Decisions on gear steps of spindles: M40 … M45, G112, the step that a speed chooses.

Public manuals: pages 208055307, 287562123, 208157451; P-CHAN-00004, 00052, 00055, 00058, 00074,
P-AXIS-00078, 00079, 00135; IDs 20029, 20030, 60285. Here step 1 of the spindle has up to 1000 1/min
and 4000 degrees/s², step 2 up to 4000 1/min and 1000 degrees/s².
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from support.decided import perform, reported
from support.geared_machine import machine

from nctakt.base.diagnostics import Severity
from nctakt.lists.machine.machine import Machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText


@pytest.fixture(scope="module", name="manual")
def fixture_manual(tmp_path_factory: pytest.TempPathFactory) -> Machine:
    return machine(tmp_path_factory.mktemp("manual"))


@pytest.fixture(scope="module", name="automatic")
def fixture_automatic(tmp_path_factory: pytest.TempPathFactory) -> Machine:
    return machine(tmp_path_factory.mktemp("automatic"), "spindel[0].autom_range 1")


def run_of(machine: Machine, program: str, controller: Controller | None = None) -> Run:
    """A run with speed and position of S."""
    signals = ["S.SPEED", "S.POSITION"]
    return perform(f"{program}\nM30", controller or Controller(machine), signals=signals)


def problems(run: Run) -> list[int]:
    return [one.id for one in run.diagnostics if one.severity is not Severity.NOTE]


def steps(run: Run) -> list[str]:
    """Jobs of the spindle, and M functions, in their order."""
    lines = [line.split()[1:] for line in reported(run, "spindle", "output")]
    return ["".join(words[1:]) if words[0] == "output" else " ".join(words) for words in lines]


def test_a_change_stops_turns_and_goes_on(manual: Machine) -> None:
    """S800 M41 M03: to the position of step 1 (90°), M41 is awaited, then the speed."""
    run = run_of(manual, "S300 M3\nG04 1\nS800 M41 M03\nG04 6")
    assert problems(run) == []
    assert steps(run)[:4] == ["spindle S M3 300", "spindle S M19 100", "M41", "spindle S M3 800"]
    assert run.trace is not None
    changed = next(event.tick for event in run.events if event.kind == "output")
    assert run.trace["S.POSITION"][changed] == pytest.approx(90.0)
    assert run.trace["S.SPEED"][changed] == 0.0
    speed = np.asarray(run.trace["S.SPEED"])
    assert speed[-2] == pytest.approx(800.0)
    assert np.diff(speed[changed:]).max() == pytest.approx(1000 / 6 / 1000)  # step 2


def test_the_spindle_goes_on_by_itself(manual: Machine) -> None:
    """Choice: M41 alone leaves M3 and S as they were."""
    run = run_of(manual, "S300 M4\nG04 1\nM41\nG04 4")
    assert steps(run)[1:] == ["spindle S M19 100", "M41", "spindle S M4 300"]
    run = run_of(manual, "M41\nS3000 M3\nG04 20")
    assert run.trace is not None
    assert run.trace["S.SPEED"][run.ticks - 2] == pytest.approx(3000.0)


def test_the_same_step_changes_nothing(manual: Machine) -> None:
    """Public manual: changes are kept few; the next program begins with the step of the last."""
    controller = Controller(manual)
    assert steps(run_of(manual, "M40\nM41\nM41", controller)) == ["spindle S M19 100", "M41"]
    assert steps(run_of(manual, "M41\nM40", controller)) == ["spindle S M19 100", "M40"]


def test_functions_are_free_without_gear_change() -> None:
    """P-CHAN-00052 = 0: M41 of the demo machine is an M function as others."""
    run = perform("M41\nM30")
    assert "spindle" not in {event.kind for event in run.events}


@pytest.mark.parametrize(
    ("speeds", "functions"),
    [
        ((300,), []),
        ((600,), []),
        ((2000,), ["M41"]),
        ((2000, 600), ["M41"]),
        ((2000, 300), ["M41", "M40"]),
        ((300, 2000, 0, 300), ["M41", "M40"]),
    ],
)
def test_the_speed_chooses(automatic: Machine, speeds: Sequence[int], functions: list[str]) -> None:
    """P-CHAN-00004: the active step stays while it has the speed."""
    run = run_of(automatic, "\n".join(f"S{speed} M3\nG04 1" for speed in speeds))
    assert problems(run) == []
    assert [step for step in steps(run) if step.startswith("M4")] == functions


def test_the_search_begins_at_the_last_step(tmp_path: Path) -> None:
    """P-CHAN-00074 = 1: of the ranges that have 600 the one of step 2, where no step is active."""
    lists = machine(tmp_path, "spindel[0].autom_range 1", "spindel[0].range_way 1")
    run = run_of(lists, "S40 M3")
    assert problems(run) == [901877]
    run = run_of(lists, "S20 M3", Controller(lists))
    assert "500 … 4000, 50 … 1000" in str(run.diagnostics[-1])


def test_g112_takes_the_limits_only(manual: Machine) -> None:
    """No M function, no motion: 3000 1/min only with step 2."""
    run = run_of(manual, "G112 S2\nM3 S3000\nG04 20")
    assert steps(run) == ["spindle S M3 3000"]
    assert run.trace is not None
    assert run.trace["S.SPEED"][run.ticks - 2] == pytest.approx(3000.0)
    run = run_of(manual, "M3 S3000\nG04 20")
    assert run.trace is not None
    assert run.trace["S.SPEED"][run.ticks - 2] == pytest.approx(1000.0)
    run = run_of(manual, "M3 S500\nG04 1\nM5\nG112 S2\nM3 S3000\nG04 20")
    assert problems(run) == []
    assert run.trace is not None
    assert run.trace["S.SPEED"][run.ticks - 2] == pytest.approx(3000.0)


@pytest.mark.parametrize(
    ("program", "number"),
    [
        ("M42", 20029),
        ("G112 S7", 20029),
        ("G112 S0", 20030),
        ("G112 S1.5", 20030),
        ("M3 S100\nG112 S2", 60285),
        ("#MAIN SPINDLE [S3]\nM41", 901876),
        ("G112 X2", 900706),
        ("G112", 900233),
    ],
)
def test_what_cannot_be(manual: Machine, program: str, number: int) -> None:
    """Each with its own number."""
    assert number in problems(run_of(manual, program))


def test_a_function_that_is_not_awaited(tmp_path: Path) -> None:
    """Public manual: M40 … M45 must be MVS_SVS; 901878 says so."""
    lists = machine(tmp_path, "m_synch[41] MOS")
    assert problems(run_of(lists, "M41")) == [901878]


def test_a_step_counts_once_it_is_engaged(manual: Machine) -> None:
    """A reset before M41 leaves the step that the spindle has; the next program changes it."""
    controller = Controller(manual)
    program = "M3 S900\nG01 X200 F2000\nM41\nX300\nM30\n"
    controller.start(NcText("part.nc", program))
    controller.step(500)
    controller.reset()
    controller.step(3000)
    run = run_of(manual, "M41\nM3 S1500\nG04 10", controller)
    assert problems(run) == []
    assert run.trace is not None
    assert run.trace["S.SPEED"][-1] == 1500.0
    assert "M 41" in " ".join(reported(run, "output"))


def test_functions_beside_g112(manual: Machine) -> None:
    """S is the gear step of its block, M3 counts as in any other."""
    run = run_of(manual, "G112 S2 M3\nS1500\nG04 10")
    assert problems(run) == []
    assert run.trace is not None
    assert run.trace["S.SPEED"][-1] == 1500.0


def test_block_search_changes_the_step_at_the_start_block(manual: Machine) -> None:
    """The PLC shifts there, and the spindle gets its last job with the limits of the step."""
    program = "M41\nG01 X5 F600\nG112 S1\nG112 S2\nX6\nM3 S1500\nX7\nG04 10\nM30"
    found = perform(program, Controller(manual), signals=["S.SPEED"], from_line=7)
    assert problems(found) == []
    assert found.trace is not None
    assert found.trace["S.SPEED"][-1] == 1500.0
    assert [line.split()[1:4] for line in reported(found, "output")] == [["output", "M", "41"]]
    with_limits_only = "G112 S2\nG01 X5 F600\nX6\nM30"
    found = perform(with_limits_only, Controller(manual), signals=["S.SPEED"], from_line=3)
    assert problems(found) == []
    assert reported(found, "output") == []
