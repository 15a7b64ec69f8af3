# SPDX-License-Identifier: MIT
"""What conditions and branches keep of a run: truths, nearest misses, firings."""

from __future__ import annotations

import struct

import pytest
from support.insides import living_cycles, loop_of, machine_of
from support.kernel_rig import DEMO

from nctakt.kernel import rows
from nctakt.run.controller import Controller, NcText

FORMS = [
    "V.E.VALUE > 2",
    "2 < V.E.VALUE",
    "V.E.VALUE + 0 > 2",
    "V.E.VALUE >= 2.5",
    "NOT [V.E.VALUE <= 2]",
    "V.E.VALUE * 0.5 - 0.9",
    "V.E.VALUE != 1 && V.E.VALUE != 2",
]


def rows_of(condition: str, values: list[float]) -> tuple[Controller, list[tuple[int, int]]]:
    """Run a condition over values, one a tick: tick and truth of its probe rows."""
    controller = Controller(DEMO)
    machine = machine_of(controller)
    text = f"#RT CYCLE\n$IF {condition}\nV.E.COUNT += 1\n$ENDIF\n#RT CYCLE END\nG04 X10\nM30"
    controller.write("V.E.VALUE", values[0])
    controller.start(NcText("p.nc", text))
    found = machine.names.resolve_text("V.E.VALUE")
    assert isinstance(found, tuple)
    machine.kernel.run(0)
    loop_of(controller).channels[0].feeder.refill()
    found_rows: list[tuple[int, int]] = []
    for value in values:
        machine.kernel.posted.post(found[1], value)
        machine.reserve()
        machine.kernel.run(1)
        machine.record.take_events()
        data = struct.iter_unpack(f"={rows.PROBE_WIDTH}d", machine.record.take_probes())
        # Number 0 is the cycle, 1 its condition; after it are the parts of && and ||.
        found_rows += [
            (int(row[rows.PROBE_TICK]), int(row[rows.PROBE_KIND] == rows.PROBE_TRUE))
            for row in data
            if row[rows.PROBE_NUMBER] == 1
        ]
    return controller, found_rows


@pytest.mark.parametrize("condition", FORMS)
def test_a_condition_records_each_change_of_its_truth(condition: str) -> None:
    """The first evaluation and every change, in whatever form the comparison is written."""
    _, changes = rows_of(condition, [1, 1, 3, 3, 3, 2, 1, 3, 1])
    assert changes == [(0, 0), (2, 1), (5, 0), (7, 1), (8, 0)]


def reaction(controller: Controller):
    """The node of the only branch of the only cycle."""
    (definition,) = living_cycles(controller)
    return definition.reactions[0].node


@pytest.mark.parametrize("condition", ["V.E.VALUE > 10", "10 < V.E.VALUE", "V.E.VALUE + 0 > 10"])
def test_a_condition_that_was_never_true_keeps_its_nearest_miss(condition: str) -> None:
    """The smallest distance of the two sides, the values, and the first tick with them."""
    controller, _ = rows_of(condition, [1, 7, 3, 9.5, 4, 9.5])
    kept = reaction(controller).condition
    assert not kept.was_ever_true
    assert kept.nearest == 0.5
    assert sorted((kept.nearest_left, kept.nearest_right)) == [9.5, 10.0]
    assert kept.nearest_tick == 3


def test_a_condition_that_was_never_false_keeps_its_nearest_sides() -> None:
    """The same for the other side; what has been both keeps nothing."""
    kept = reaction(rows_of("V.E.VALUE > 2", [9, 3, 4])[0]).condition
    assert not kept.was_ever_false
    assert (kept.nearest, kept.nearest_left, kept.nearest_tick) == (1.0, 3.0, 1)
    assert reaction(rows_of("V.E.VALUE > 2", [9, 3, 1])[0]).condition.nearest == -1.0


def test_a_combination_keeps_how_near_one_side_came_beside_the_other() -> None:
    """As d / (d + 1); of ``||``, which is false where both are, beside the one that is false."""
    kept = reaction(rows_of("V.E.VALUE < 2 && V.E.VALUE > 4", [1, 3, 5, 1.5])[0]).condition
    assert not kept.was_ever_true
    assert kept.beside_first == 2.5 / 3.5  # 1.5 < 2: 1.5 > 4 misses by 2.5
    assert kept.beside_second == 3.0 / 4.0  # 5 > 4: 5 < 2 misses by 3
    assert kept.nearest == 2.5 / 3.5
    either = reaction(rows_of("V.E.VALUE < 2 || V.E.VALUE > 0", [1, 3, 5])[0]).condition
    assert not either.was_ever_false
    assert either.beside_first == 3.0 / 4.0  # 3 is not below 2: 3 > 0 is true by 3
    assert either.beside_second > 1e300  # 3 > 0 is never false


def test_a_branch_counts_its_firings() -> None:
    """Every run-through of the body counts; the first tick is kept."""
    controller, _ = rows_of("V.E.VALUE > 2", [1, 3, 3, 1, 3])
    branch = reaction(controller)
    assert branch.count == 3
    assert branch.first_tick == 1
    assert branch.condition.was_ever_true


def test_a_series_of_firings_is_one_event() -> None:
    """A body that runs in consecutive ticks fires once; after a pause it fires again."""
    text = (
        "#RT CYCLE\n$IF V.E.COUNT_POS MOD 5 < 3\nV.E.COUNT += 1\n$ENDIF\n"
        "V.E.COUNT_POS += 1\n#RT CYCLE END\nG04 X0.020\nM30"
    )
    run = Controller(DEMO).run(NcText("p.nc", text))
    fired = [event.tick for event in run.events if event.kind == "fired"]
    assert fired == [0, 5, 10, 15]
    (result,) = run.cycles
    assert [(one.became_true, one.first_tick) for one in result.reactions] == [(4, 0)]
    assert result.runs == 20
