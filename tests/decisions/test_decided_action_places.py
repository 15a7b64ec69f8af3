# SPDX-License-Identifier: MIT
"""P-CHAN-00480: how many actions of one cycle may be open at once (RC-408, RC-505)."""

from __future__ import annotations

import pytest
from support.decided import machine, numbers, perform, reported

from nctakt.results.run import Run
from nctakt.run.controller import Controller

SIGNALS = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "Z.ACS.ACT_POS"]


def commanding(limit: int, *commands: str, tail: str = "") -> Run:
    """A cycle that gives these commands in tick 0; places: ``limit``."""
    program = "#RT CYCLE [ID=1]\n$IF ONCE 1\n" + "\n".join(commands) + "\n$ENDIF\n"
    controller = Controller(machine(buffers=limit))
    return perform(f"{program}{tail}#RT CYCLE END\nG04 0.2\nM30", controller, signals=SIGNALS)


MOVES = ("X[INDP G90 POS=10]", "Y[INDP G90 POS=10]", "Z[INDP G90 POS=10]")


@pytest.mark.parametrize(("count", "found"), [(1, []), (2, []), (3, [51028])])
def test_the_limit_of_open_actions_is_exact(count: int, found: list[int]) -> None:
    """RC-408: one below the limit, at it, one above: 51028, the cycle ends, its motions brake."""
    run = commanding(2, *MOVES[:count])
    assert numbers(run) == found
    assert reported(run, "ended") == (["0 ended 1 error"] if found else ["200 ended 1 scope"])
    assert run.trace is not None
    assert (run.trace["X.ACS.ACT_POS"][-1] == 10) == (not found)
    assert run.trace["Z.ACS.ACT_POS"][-1] == 0


def test_without_places_there_is_no_action() -> None:
    """RC-408: P-CHAN-00480 may be 0."""
    run = commanding(0, MOVES[0])
    assert numbers(run) == [51028]
    assert "it has no slots for actions at all" in run.errors[0].text("en")
    only = commanding(1, *MOVES[:2])
    assert "an action is open in its only slot" in only.errors[0].text("en")
    more = "More slots: configuration.rt_cycles.buffers (P-CHAN-00480)."
    assert run.errors[0].remedy() == more
    assert only.errors[0].remedy() == f"Let an action end first (open: 1). {more}"


def test_a_motion_that_is_replaced_frees_its_place_first() -> None:
    """RC-408: ABORTING on the same axis needs no further place, BUFFERED does."""
    assert numbers(commanding(1, MOVES[0], "X[INDP G90 POS=20]")) == []
    assert numbers(commanding(1, MOVES[0], "X[INDP BUFFERED G90 POS=20]")) == [51028]
    assert numbers(commanding(2, MOVES[0], "X[INDP BUFFERED G90 POS=20]")) == []


def test_a_motion_that_has_ended_frees_its_place() -> None:
    """RC-408: X is at 10 long before Y is sent off; STOP needs no place."""
    later = "$IF ONCE V.RTA.ACS.ACT_POS.X == 10\nY[INDP G90 POS=1]\nX[INDP STOP]\n$ENDIF\n"
    run = commanding(1, MOVES[0], tail=later)
    assert numbers(run) == []
    assert run.trace is not None
    assert run.trace["Y.ACS.ACT_POS"][-1] == 1


def test_each_cycle_has_its_own_places() -> None:
    """RC-408: places are those of one cycle."""
    cycles = "".join(
        f"#RT CYCLE [ID={number}]\n$IF ONCE 1\n{move}\n$ENDIF\n#RT CYCLE END\n"
        for number, move in enumerate(MOVES, start=1)
    )
    run = perform(f"{cycles}G04 0.2\nM30", Controller(machine(buffers=1)), signals=SIGNALS)
    assert numbers(run) == []
