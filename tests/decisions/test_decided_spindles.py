# SPDX-License-Identifier: MIT
"""Endless spindle jobs of realtime cycles are open actions (RC-408, RC-111, RC-110).

S takes 10 ticks to 60 revolutions a minute, and as many to a standstill.
"""

from __future__ import annotations

import pytest
from support.decided import perform, reported

from nctakt.results.run import Run

TURNING = "#RT CYCLE [ID=1]\n$IF ONCE 1\nM3 S60\n$ENDIF\n#RT CYCLE END\n"


def speeds(run: Run, *ticks: int) -> list[float]:
    """The speed of S after these ticks."""
    assert run.trace is not None
    return [round(float(run.trace.at(tick, "S.SPEED")), 6) for tick in ticks]


def turning(rest: str) -> Run:
    """S turns from tick 0 on; the dwells of ``rest`` set the ticks."""
    run = perform(f"{TURNING}{rest}\nM30", signals=["S.SPEED"])
    assert run.errors == ()
    return run


@pytest.mark.parametrize("tick", [3, 9, 10, 11, 50])
def test_hold_continue_and_abort_act_on_a_spindle_in_any_tick(tick: int) -> None:
    """RC-408: also where the speed has long been reached; each begins in the tick that takes it."""
    begin = min(tick, 10)
    run = turning(
        f"#TIME {tick / 1000}\n#RT CYCLE HOLD [ID=1]\n#TIME 0.02\n#RT CYCLE CONTINUE [ID=1]\n"
        "#TIME 0.03\n#RT CYCLE ABORT ACTION [ID=1]\n#TIME 0.02\n"
        "#RT CYCLE CONTINUE [ID=1]\n#TIME 0.02"
    )
    assert speeds(run, tick - 1, tick) == [6.0 * begin, 6.0 * (begin - 1)]
    assert speeds(run, tick + 19, tick + 20, tick + 29, tick + 49) == [0.0, 6.0, 60.0, 60.0]
    assert speeds(run, tick + 50, tick + 59, tick + 89) == [54.0, 0.0, 0.0]
    assert [line for line in reported(run, "spindle_reached")][
        -1
    ] == f"{tick + 59} spindle_reached S"


def test_the_end_of_the_cycle_leaves_the_spindle_turning() -> None:
    """RC-110, manual 2.4: END_ACTION concerns axes only."""
    run = turning("#TIME 0.05\n#RT CYCLE DELETE [ID=1]\n#TIME 0.05")
    assert speeds(run, 50, 99) == [60.0, 60.0]


@pytest.mark.parametrize("word", ["HOLD", "ABORT ACTION"])
def test_a_spindle_that_has_another_job_is_left_alone(word: str) -> None:
    """RC-408: open is the latest job of the spindle; that of the program is none of the cycle."""
    run = turning(f"#TIME 0.05\nM3 S30\n#TIME 0.05\n#RT CYCLE {word} [ID=1]\n#TIME 0.05")
    assert speeds(run, 99, 110, 149) == [30.0, 30.0, 30.0]
