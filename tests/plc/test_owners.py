# SPDX-License-Identifier: MIT
"""One owner at a time: the PLC, a realtime cycle and the path want one axis (MO-13, RC-409).

What the PLC calls after tick n is latched at the start of tick n + 1; then come commands and
blocks, then the cycles, then the path. So in one tick the PLC is first, the path second, a cycle
last. The demo machine: 500 mm/s, 4000 mm/s²; 10 mm from rest to rest take 100 ticks.
"""

from __future__ import annotations

import itertools

import pytest

from nctakt.plc import MC_MoveAbsolute, MC_MoveVelocity, Plc
from nctakt.plc.axes import AxisBlock
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

#: A cycle that sends Z to -5 as soon as V.E.TRIGGER is 1.
CYCLE = """#RT CYCLE [ID=1 SCOPE=PROG]
$IF ONCE V.E.TRIGGER
Z[INDP G90 G00 POS=-5]
$ENDIF
#RT CYCLE END
"""


class Owner(Plc):
    """Sends Z to 10, or on and on, in one tick, and sets V.E.TRIGGER for another one."""

    def __init__(self, moves: int, triggers: int = 10_000, *, endless: bool = False) -> None:
        self.moves, self.triggers, self.endless = moves, triggers, endless
        self.block: AxisBlock = MC_MoveVelocity("Z") if endless else MC_MoveAbsolute("Z")
        self.ends: list[tuple[int, str]] = []

    def each_tick(self, hli: PlcView) -> None:
        """What is called after tick n acts in tick n + 1."""
        execute = hli.tick + 1 >= self.moves
        if isinstance(self.block, MC_MoveVelocity):
            self.block(hli, execute=execute, velocity=100)
        elif isinstance(self.block, MC_MoveAbsolute):
            self.block(hli, execute=execute, position=10, velocity=500)
        if hli.tick + 1 == self.triggers:
            hli.write("V.E.TRIGGER", 1)
        one = self.block
        shown = "done" if one.done else "aborted" if one.command_aborted else ""
        shown = f"error {one.error_id}" if one.error else shown
        if shown and (not self.ends or self.ends[-1][1] != shown):
            self.ends.append((hli.tick, shown))


def run(text: str, plc: Owner) -> Run:
    """Run a program with a PLC; whatever happens, no limit of Z is broken (MO-1)."""
    made = Controller().run(NcText("p.nc", text), plc=plc, signals=["Z.ACS.ACT_POS", "Z.STATE"])
    assert made.trace is not None
    places = [0.0, *made.trace["Z.ACS.ACT_POS"]]
    steps = [after - before for before, after in itertools.pairwise(places)]
    assert all(abs(step) <= 0.5 + 1e-9 for step in steps)
    changes = (abs(after - before) for before, after in itertools.pairwise([0.0, *steps]))
    assert all(change <= 0.004 + 1e-9 for change in changes)
    return made


def axis_events(made: Run) -> list[tuple[int, str]]:
    """What the axes did."""
    return [(event.tick, event.text) for event in made.events if event.kind == "axis"]


def last(made: Run) -> float:
    """Where Z is in the end."""
    assert made.trace is not None
    return float(made.trace["Z.ACS.ACT_POS"][-1])


def errors(made: Run) -> list[int]:
    """The numbers of the errors."""
    return [found.id for found in made.errors]


# --- PLC and cycle ------------------------------------------------------------------------------


def test_a_cycle_takes_the_axis_from_the_plc() -> None:
    """The PLC moves Z from tick 10 on, the cycle commands it in tick 50: the PLC's is aborted."""
    plc = Owner(10, triggers=50)
    made = run(CYCLE + "G04 X0.4\nM30", plc)
    assert plc.ends == [(50, "aborted")]
    assert axis_events(made)[:3] == [(10, "Z begun 10"), (50, "Z aborted"), (50, "Z begun -5")]
    assert (made.state, last(made)) == ("ended", -5.0)


def test_the_plc_takes_the_axis_from_a_cycle() -> None:
    """The cycle moves Z from tick 10 on, the PLC commands it in tick 40 and arrives."""
    plc = Owner(40, triggers=10)
    made = run(CYCLE + "G04 X0.4\nM30", plc)
    assert [shown for _, shown in plc.ends] == ["done"]
    assert axis_events(made)[:3] == [(10, "Z begun -5"), (40, "Z aborted"), (40, "Z begun 10")]
    assert (made.state, last(made)) == ("ended", 10.0)


def test_plc_and_cycle_in_one_tick() -> None:
    """Both in tick 30: the PLC's is latched first, the cycle's comes later and has the axis."""
    plc = Owner(30, triggers=30)
    made = run(CYCLE + "G04 X0.4\nM30", plc)
    assert plc.ends == [(30, "aborted")]
    assert axis_events(made)[:3] == [(30, "Z begun 10"), (30, "Z aborted"), (30, "Z begun -5")]
    assert last(made) == -5.0


# --- PLC and path -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("moves", "number", "end"),
    [
        (20, 900420, "done"),  # Z has moved to 10 and is where the program does not know
        (150, 50766, "done"),  # Z moves when the block begins in tick 200
        (200, 50766, "done"),  # in the same tick: the PLC is first
    ],
)
def test_a_block_wants_an_axis_that_the_plc_has_or_had(moves: int, number: int, end: str) -> None:
    """Without a cycle that names Z nothing asks for its position; the PLC's motion goes on."""
    plc = Owner(moves)
    made = run("G04 X0.2\nG00 Z-5\nM30", plc)
    assert errors(made) == [number]
    assert [shown for _, shown in plc.ends] == [end]
    assert last(made) == 10.0


def test_the_plc_wants_an_axis_that_the_path_has() -> None:
    """One tick after the begin of the block: 50603 for the PLC, the path continues."""
    plc = Owner(201)
    made = run("G04 X0.2\nG00 Z-5\nM30", plc)
    assert errors(made) == []
    assert plc.ends == [(201, "error 50603")]
    assert last(made) == -5.0


def test_the_plc_has_the_axis_again_after_the_block() -> None:
    """The path moves Z in the ticks 0 … 99; in tick 100 it is free, and the PLC's."""
    plc = Owner(100)
    made = run("G00 Z-10\nG04 X0.3\nM30", plc)
    assert errors(made) == []
    assert [shown for _, shown in plc.ends] == ["done"]
    assert last(made) == 10.0


# --- all three ----------------------------------------------------------------------------------


def test_a_block_asks_for_an_axis_that_a_cycle_names() -> None:
    """RC-409: the request waits for the PLC's motion (ticks 150 … 291) and begins where it ends."""
    plc = Owner(150)
    made = run(CYCLE + "G04 X0.2\nG00 Z-5\nM30", plc)
    assert errors(made) == []
    assert plc.ends == [(249, "done")]
    assert (made.state, last(made)) == ("ended", -5.0)


def test_a_block_asks_for_an_axis_that_the_plc_moves_endlessly() -> None:
    """RC-409, MO-13: 50766, since Z never stops."""
    plc = Owner(150, endless=True)
    made = Controller().run(NcText("p.nc", CYCLE + "G04 X0.2\nG00 Z-5\nM30"), plc=plc, ticks=400)
    assert errors(made) == [50766]
    assert plc.ends == []


def test_path_and_cycle_in_one_tick() -> None:
    """Commands come first: the block has Z from tick 201 on, the cycle's is a fault (50603).

    In tick 200 the block has asked for the position of Z.
    """
    made = run(CYCLE + "G04 X0.2\nG00 Z-5\nM30", Owner(10_000, triggers=201))
    assert errors(made) == [50603]
    assert axis_events(made) == []


def test_plc_path_and_cycle_in_one_tick() -> None:
    """The PLC is first, the block waits for it, so the cycle takes Z over, and the path follows."""
    plc = Owner(200, triggers=200)
    made = run(CYCLE + "G04 X0.2\nG00 Z-20\nM30", plc)
    assert errors(made) == []
    assert plc.ends == [(200, "aborted")]
    assert [text for _, text in axis_events(made)] == [
        "Z begun 10",
        "Z aborted",
        "Z begun -5",
        "Z done",
    ]
    assert (made.state, last(made)) == ("ended", -20.0)
