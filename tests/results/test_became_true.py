# SPDX-License-Identifier: MIT
"""How often a branch became true, and how often it ran: one number each, wherever it is shown."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText

#: Cycle 17 lives in ticks 0 … 99. V.E.CONDITION is 1 in ticks 10 … 19 and 50 … 79.
PROGRAM = """\
#RT CYCLE [ID=17 SCOPE=PROG]
$IF V.E.CONDITION == 1
  V.E.COUNT = 1
  $IF EDGE V.E.VALUE == 0
    V.E.COUNT = 2
  $ENDIF
$ELSE
  V.E.COUNT = 0
$ENDIF
$IF ONCE V.E.CONDITION == 1
  V.E.TRIGGER = 1
$ENDIF
#RT CYCLE END
#TIME 0.1
M30
"""
AT = [(10, 1.0), (20, 0.0), (50, 1.0), (80, 0.0)]
#: Line, became true, ran. The EDGE is judged in 40 ticks, true in all of them: one rise.
EXPECTED = [(2, 2, 40), (4, 1, 1), (7, 3, 60), (10, 1, 1)]


def stimuli() -> list[Stimulus]:
    """The condition comes twice."""
    return [Stimulus(f"{ms} ms", "V.E.CONDITION", value) for ms, value in AT]


def test_the_run_counts_both() -> None:
    """Series of run-throughs, and run-throughs."""
    run = Controller().run(NcText("part.nc", PROGRAM), at=stimuli(), why=True)
    (cycle,) = run.cycles
    assert cycle.runs == 100
    found = [(one.span.line, one.became_true, one.ran) for one in cycle.reactions if one.span]
    assert found == EXPECTED
    assert run.why is not None and run.coverage is not None
    (history,) = run.why.cycles
    assert [(one.span.line, one.became_true, one.bodies.ticks) for one in history.branches] == found
    (counts,) = run.coverage.cycles
    assert [(one.line, one.bodies) for one in counts.branches] == [
        (line, ran) for line, _, ran in EXPECTED
    ]
    text = run.why.render()
    assert "    became true 2 times, ran 40 times, in ticks 10 to 19, 50 to 79" in text
    assert "      became true once, ran once, in tick 10 (0.01 s)" in text
    assert [one.text for one in run.events if one.kind == "fired"].count("17 line 2") == 2


def test_a_hold_is_no_other_time() -> None:
    """HOLD keeps the series: became true once, ran in the ticks without it."""
    text = """\
#RT CYCLE [ID=5 SCOPE=PROG]
$IF 1
  V.E.COUNT += 1
$ENDIF
#RT CYCLE END
#TIME 0.01
#RT CYCLE HOLD [ID=5]
#TIME 0.01
#RT CYCLE CONTINUE [ID=5]
#TIME 0.01
M30
"""
    run = Controller().run(NcText("part.nc", text), why=True)
    (reaction,) = run.cycles[0].reactions
    assert run.why is not None
    (branch,) = run.why.cycles[0].branches
    assert (reaction.became_true, branch.became_true) == (1, 1)
    assert reaction.ran == branch.bodies.ticks == run.cycles[0].runs
    assert len(branch.bodies.series) == 2


def test_each_run_of_a_controller_counts_its_own() -> None:
    """Neither run-throughs nor bodies of an earlier run are in the result of the next one."""
    controller = Controller()
    for _ in range(2):
        run = controller.run(NcText("part.nc", PROGRAM), at=stimuli())
        (cycle,) = run.cycles
        assert cycle.runs == 100
        found = [(one.span.line, one.became_true, one.ran) for one in cycle.reactions if one.span]
        assert found == EXPECTED
        controller.write("V.E.CONDITION", 0)


@pytest.mark.parametrize("form", ["text", "json"])
def test_the_command_shows_both(
    form: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Columns of the summary, fields of the document."""
    file = tmp_path / "part.nc"
    file.write_text(PROGRAM, "utf-8")
    given = [word for ms, value in AT for word in ("--at", f"{ms} ms", f"V.E.CONDITION={value:g}")]
    assert main(["run", str(file), *given, "--format", form]) == 0
    shown = capsys.readouterr().out
    if form == "text":
        line = next(line for line in shown.splitlines() if line.startswith("17 "))
        assert line.split()[-7:] == ["2", "40", "tick", "10", "=", "0.010000", "s"]
    else:
        reaction = json.loads(shown)["cycles"][0]["reactions"][0]
        assert (reaction["became_true"], reaction["ran"]) == (2, 40)
