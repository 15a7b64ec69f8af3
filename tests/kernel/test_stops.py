# SPDX-License-Identifier: MIT
"""Stops of the kernel: where a run ends for those who watch it, and that they change nothing."""

from __future__ import annotations

import math
import random
from array import array

import pytest
from support.insides import machine_of

from nctakt import Controller, NcText
from nctakt.base.source_ids import LAST_COLUMN, pack
from nctakt.decoder.cycles.builder import CycleDefinition
from nctakt.kernel import codes, rows
from nctakt.kernel.cycles.expressions import Constant, Expression, Load
from nctakt.kernel.tick.stops import BecomesTrue, Changes, Happens, Runs, Stop, Turns
from nctakt.run.program_run import ProgramRun

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.E.VALUE > 0.5 && V.RTA.ACS.ACT_POS.X < 90
    V.E.COUNT += 1
  $ENDIF
  $IF V.RTA.ACS.ACT_POS.X >= 50
    V.E.CONDITION = 1
  $ENDIF
#RT CYCLE END
G01 X100 F6000
M100
G04 X0.05
M30
"""

PULSES = [("20 ms", "V.E.VALUE", 1), ("30 ms", "V.E.VALUE", 0), ("45 ms", "V.E.VALUE", 1)]

ALWAYS = Constant(1.0)


def begun(program: str = PROGRAM) -> tuple[Controller, ProgramRun]:
    """Return a run of a program before its first tick."""
    controller = Controller()
    run = controller.begin({1: [NcText("p.nc", program)]}, at=PULSES)
    run.load()
    return controller, run


def cell(controller: Controller, name: str) -> Expression:
    """Return the load of a variable."""
    machine = machine_of(controller)
    return Load(machine.access.cell_of(name)[0], len(machine.memory) // 8)


def first_tick_of(kind: str, text: str) -> int:
    """Return the tick of the first event of this kind and text."""
    run = Controller().run(NcText("p.nc", PROGRAM), at=PULSES)
    return next(event.tick for event in run.events if event.kind == kind and text in event.text)


def stopping_ticks(stop: Stop, controller: Controller, run: ProgramRun) -> list[int]:
    """Return the ticks after which a stop ends the run, up to the run's end."""
    stops = machine_of(controller).kernel.stops
    stops.watch([stop])
    ticks = []
    while run.state is None:
        if run.advance():
            ticks.append(controller.tick - 1)
            assert stop.last_tick == ticks[-1]
    return ticks


def test_a_condition_that_becomes_true_stops_after_its_first_tick() -> None:
    """An input of 20 ms is latched by tick 20 (RC-002), after which the variable has it."""
    controller, run = begun()
    stop = BecomesTrue(cell(controller, "V.E.VALUE"), 1, ALWAYS, 1)
    assert stopping_ticks(stop, controller, run) == [20, 45]


def test_a_condition_that_becomes_false() -> None:
    controller, run = begun()
    stop = BecomesTrue(cell(controller, "V.E.VALUE"), 0, ALWAYS, 1)
    assert stopping_ticks(stop, controller, run) == [30]


def test_each_change_of_a_variable_stops() -> None:
    controller, run = begun()
    stop = Changes(cell(controller, "V.E.COUNT"), ALWAYS, 1)
    assert stopping_ticks(stop, controller, run) == [20, 45]


def test_a_count_leaves_the_first_hits_out() -> None:
    controller, run = begun()
    stop = Changes(cell(controller, "V.E.VALUE"), ALWAYS, 2)
    assert stopping_ticks(stop, controller, run) == [30, 45]
    assert stop.count == 3


def test_a_hit_counts_only_under_its_guard() -> None:
    controller, run = begun()
    stop = Changes(cell(controller, "V.E.VALUE"), cell(controller, "V.E.VALUE"), 1)
    assert stopping_ticks(stop, controller, run) == [20, 45]


def test_events_stop_by_kind_place_and_value() -> None:
    """M100 goes out when the path of line 9 has ended; it is the function's event, no other."""
    controller, run = begun()
    first = pack(0, 10, 1)
    kinds = 1 << rows.EVENT_TECHNOLOGY
    lowest = array("d", [-math.inf] * rows.EVENT_WIDTH)
    highest = array("d", [math.inf] * rows.EVENT_WIDTH)
    lowest[rows.EVENT_SOURCE], highest[rows.EVENT_SOURCE] = first, first | LAST_COLUMN
    lowest[rows.EVENT_A] = highest[rows.EVENT_A] = 100.0
    stop = Happens(kinds, lowest, highest, ALWAYS, 1)
    ticks = stopping_ticks(stop, controller, run)
    (function,) = Controller().run(NcText("p.nc", PROGRAM), at=PULSES).technology
    assert [1000 * tick for tick in ticks] == [function.time_us]


def test_bounds_have_a_value_for_each_column_of_an_event() -> None:
    """The tick reads them by their number and checks none."""
    short, whole = array("d", [0.0]), array("d", [0.0] * rows.EVENT_WIDTH)
    for bounds in ((short, whole), (whole, short)):
        with pytest.raises(ValueError, match="1"):
            Happens(1, *bounds, ALWAYS, 1)


def test_a_branch_stops_in_each_tick_in_which_its_body_runs() -> None:
    controller, run = begun()
    machine_of(controller).registry.on_cycle = lambda _, cycle: found.append(cycle)
    found: list[CycleDefinition] = []
    run.advance(1)
    stop = Runs(found[0].reactions[1].node, ALWAYS, 1)
    ticks = stopping_ticks(stop, controller, run)
    assert ticks == list(range(ticks[0], ticks[-1] + 1))
    assert ticks[0] == first_tick_of("fired", "line 5")


def test_a_condition_of_a_cycle_stops_when_it_turns() -> None:
    controller, run = begun()
    machine_of(controller).registry.on_cycle = lambda _, cycle: found.append(cycle)
    found: list[CycleDefinition] = []
    run.advance(1)
    stop = Turns(found[0].reactions[0].node.condition, codes.TRUE, ALWAYS, 1)
    assert stopping_ticks(stop, controller, run) == [20, 45]


@pytest.mark.parametrize("seed", range(5))
def test_cuts_and_stops_change_nothing(seed: int) -> None:
    """However a run is cut, its events and its end are those of the run in one piece."""
    chance = random.Random(seed)
    expected = Controller().run(NcText("p.nc", PROGRAM), at=PULSES)
    controller, run = begun()
    stops = machine_of(controller).kernel.stops
    while run.state is None:
        stops.watch([Changes(cell(controller, "V.E.VALUE"), ALWAYS, 1)] * chance.randint(0, 3))
        run.advance(controller.tick + chance.randint(1, 400))
    run.close()
    result = run.result()
    assert result.ticks == expected.ticks
    assert list(result.events) == list(expected.events)
    assert result.trace is not None
    assert expected.trace is not None
    for signal in expected.trace:
        assert (result.trace[signal] == expected.trace[signal]).all()
