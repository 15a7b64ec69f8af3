# SPDX-License-Identifier: MIT
"""Values of the commands of realtime cycles, and a corner that the path has to stop at."""

from __future__ import annotations

import math

import pytest
from support.decided import numbers, perform, reported

from nctakt.run.controller import Controller, NcText


def test_g01_needs_a_feed_of_this_run() -> None:
    """RC-405: one that is in a branch that has not run does not count (50967)."""
    run = perform(
        "#RT CYCLE [ID=1]\n$IF V.E.TRIGGER == 1\nX[INDP G90 G01 FEED=600 POS=5]\n"
        "$ELSE\nX[INDP G90 G01 POS=5]\n$ENDIF\n#RT CYCLE END\nG04 0.01\nM30"
    )
    assert numbers(run) == [50967]


def test_a_position_of_a_spindle_must_be_finite() -> None:
    """RC-207: 50879, and the spindle gets no job."""
    run = perform(
        "#RT CYCLE [ID=1]\n$IF ONCE 1\nM3 M19 S100 S.POS=V.E.VALUE * V.E.VALUE\n$ENDIF\n"
        "#RT CYCLE END\nG04 0.01\nM30",
        set={"V.E.VALUE": 1e200},
    )
    assert numbers(run) == [50879]
    assert reported(run, "spindle") == []


@pytest.mark.parametrize(
    ("unit", "axis", "distance"),
    [
        ("G71", "X", 1.0),  # 600 mm/min are 10 mm/s
        ("G70", "X", 25.4),  # inch/min, and the position in inch
        ("G71", "A", 1.0),  # degrees/min, whatever the unit of length
        ("G70", "A", 1.0),
    ],
)
def test_feed_is_in_the_unit_of_its_axis(unit: str, axis: str, distance: float) -> None:
    """RC-405, RC-410: far from its ends a motion of FEED=600 goes 10 units a second."""
    run = perform(
        f"{unit}\n#RT CYCLE [ID=1 SCOPE=GLOBAL]\n$IF ONCE 1\n"
        f"{axis}[INDP G90 G01 FEED=600 POS=4]\n$ENDIF\n#RT CYCLE END\n#TIME 0.25\nM30",
        Controller(),
        signals=[f"{axis}.ACS.ACT_POS"],
    )
    assert numbers(run) == []
    assert run.trace is not None
    positions = run.trace[f"{axis}.ACS.ACT_POS"]
    assert positions[219] - positions[119] == pytest.approx(distance)


def test_the_path_stops_at_a_right_angle() -> None:
    """MO-3: at 4000 mm/s² a millimetre from rest to rest takes 2·√(1/4000) s, twice."""
    run = perform("G01 F6000 X1\nY1\nM30", signals=["X.ACS.ACT_POS", "Y.ACS.ACT_POS"])
    assert run.trace is not None
    first_t = 2.0 * math.sqrt(1.0 / 4000.0)
    for tick in (31, 35, 40, 46):
        since_t = (tick + 1) / 1000.0 - first_t
        assert run.trace["X.ACS.ACT_POS"][tick] == pytest.approx(1.0)
        assert run.trace["Y.ACS.ACT_POS"][tick] == pytest.approx(2000.0 * since_t * since_t)


@pytest.mark.parametrize(
    ("operator", "ticks"),
    [
        ("<", [0, 1]),
        ("<=", [0, 1, 2]),
        (">", [3, 4]),
        (">=", [2, 3, 4]),
        ("==", [2]),
        ("!=", [0, 1, 3, 4]),
    ],
)
@pytest.mark.parametrize("right", ["V.E.VALUE", "2", "V.E.VALUE * 1"])
def test_two_sides_are_compared(operator: str, ticks: list[int], right: str) -> None:
    """RC-202, RC-304: V.E.COUNT is 0 … 4 in the first five ticks, the other side 2."""
    run = perform(
        f"#RT CYCLE [ID=1]\n$IF V.E.COUNT {operator} {right}\nV.E.VALUE1 += 1\n$ENDIF\n"
        "V.E.COUNT += 1\n#RT CYCLE END\n#TIME 0.005\nM30",
        set={"V.E.VALUE": 2},
    )
    assert numbers(run) == []
    written = [line.split() for line in reported(run, "written")]
    assert [int(words[0]) for words in written if words[2] == "V.E.VALUE1"] == ticks


@pytest.mark.parametrize(
    ("statement", "more"),
    [
        ("V.E.COUNT += 1", 1),
        ("M100", 2),
        ("$IF V.E.COUNT > 1\n$ENDIF", 2),
    ],
)
def test_room_for_all_that_a_cycle_can_record_in_a_tick(statement: str, more: int) -> None:
    """RC-603: each statement may be an event, and what it puts out another one."""
    found: list[int] = []
    for count in (1, 4):
        body = f"{statement}\n" * count
        Controller().run(
            NcText("part.nc", f"#RT CYCLE [ID=1]\n{body}#RT CYCLE END\nM30"),
            on_cycle=lambda _name, definition: found.append(definition.cycle.events),
        )
    assert found[1] - found[0] == 3 * more
