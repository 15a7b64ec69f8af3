# SPDX-License-Identifier: MIT
"""RC-302: a run shows which asynchronous values its realtime cycles see."""

from __future__ import annotations

import io

from nctakt.base.diagnostics import Span
from nctakt.results.run import CycleResult, FrozenValue, Run
from nctakt.results.summary import MAX_FROZEN, print_summary
from nctakt.run.controller import Controller, NcText


def perform(text: str, **initial: float) -> Run:
    values = {name.replace("__", "."): value for name, value in initial.items()}
    run = Controller().run(NcText("part.nc", text), set=values)
    assert not run.errors, [error.render() for error in run.errors]
    return run


def frozen(run: Run) -> list[list[tuple[str, float, int]]]:
    return [[(one.name, one.value, one.span.line) for one in cycle.frozen] for cycle in run.cycles]


def test_values_when_the_definition_was_decoded() -> None:
    """Name, value and line of each, in the order of the text; not those of START or later."""
    text = """P1 = 10
#RT CYCLE DEF [ID=1]
  $IF V.RTA.ACS.ACT_POS.X > P1
    V.E.VALUE1 = P[P1 + 1] + V.E.VALUE2
  $ENDIF
#RT CYCLE END
P1 = 20
#RT CYCLE START [ID=1]
M30
"""
    run = perform(text, V__E__VALUE2=5.0)
    assert frozen(run) == [[("P1", 10.0, 3), ("P[P1 + 1]", 0.0, 4)]]
    assert run.cycles[0].frozen[0].span == Span("part.nc", 3, 29, 31)


def test_a_definition_that_is_decoded_again_tells_its_latest_values() -> None:
    """Cycles of one definition are reported together, with what the last of them sees."""
    text = """$FOR P1 = 1, 3, 1
#RT CYCLE [SCOPE=BLOCK]
  P1
#RT CYCLE END
#TIME 0.002
$ENDFOR
M30
"""
    run = perform(text)
    assert [cycle.instances for cycle in run.cycles] == [3]
    assert frozen(run) == [[("P1", 3.0, 3)]]


def test_definitions_of_one_id_keep_their_own_values() -> None:
    """Two definitions that use an ID one after the other are distinguished."""
    text = """P1 = 1
#RT CYCLE [ID=7]
  P1
#RT CYCLE END
#RT CYCLE DELETE [ID=7]
P1 = 2
#RT CYCLE [ID=7]
  P1
#RT CYCLE END
M30
"""
    assert frozen(perform(text)) == [[("P1", 1.0, 3)], [("P1", 2.0, 8)]]


def test_only_synchronous_variables() -> None:
    """A cycle that reads each value in its tick has nothing frozen."""
    run = perform("#RT CYCLE\nV.E.COUNT = V.E.COUNT + 1\n#RT CYCLE END\nM30\n")
    assert frozen(run) == [[]]


def summary(run: Run, language: str = "en") -> list[str]:
    file = io.StringIO()
    print_summary(run, file, "de" if language == "de" else "en")
    return file.getvalue().splitlines()


def test_the_summary_tells_them() -> None:
    """One line for each cycle with frozen values, in the language asked for."""
    run = perform("P1 = 0.5\n#RT CYCLE [ID=7]\nP1\nP2\n#RT CYCLE END\nM30\n")
    assert "Frozen in cycle 7: P1 = 0.5 (line 3), P2 = 0 (line 4)" in summary(run)
    assert "Eingefroren in Zyklus 7: P1 = 0.5 (Zeile 3), P2 = 0 (Zeile 4)" in summary(run, "de")


def cycle_with(count: int) -> Run:
    values = tuple(
        FrozenValue(f"P{i}", float(i), Span("part.nc", i, 1, 2)) for i in range(1, count + 1)
    )
    cycle = CycleResult("1", "PROG", None, (), frozen=values)
    return Run(("part.nc",), 1000, 0, 5, "ended", cycles=(cycle,))


def test_the_summary_stays_short() -> None:
    """Up to the maximum of a line all are named, one more is only counted."""
    line = next(one for one in summary(cycle_with(MAX_FROZEN)) if one.startswith("Frozen"))
    assert line.count("line") == MAX_FROZEN
    assert " more" not in line
    line = next(one for one in summary(cycle_with(MAX_FROZEN + 1)) if one.startswith("Frozen"))
    assert line.endswith("P6 = 6 (line 6), … 1 more")
