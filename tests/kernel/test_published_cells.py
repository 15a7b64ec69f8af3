# SPDX-License-Identifier: MIT
"""What the realtime part writes into its memory, against the table of names (RC-304, RC-305).

The tick knows cells by number, the table by name; only a run shows that both mean the same.
"""

from __future__ import annotations

import random

from support.insides import machine_of
from support.kernel_rig import DEMO

from nctakt.kernel import cells
from nctakt.nc.vocabulary.variables.realtime_variables import AXIS_VARIABLES, CHANNEL_VARIABLES
from nctakt.run.controller import Controller, NcText

PROGRAM = """#RT CYCLE [SCOPE=PROG]
  V.RTG.OVERRIDE.VEL.CYCLE = 51
  V.RTA.OVERRIDE.VEL.CYCLE.Y = 33
#RT CYCLE END
N10 G01 F6000 X30 Y40 A5
M30"""

#: Rows that no part of the tick writes by itself.
UNWRITTEN = (
    "MEAS_DELTA",
    "LOOP.ENABLED",
    "LOOP.COUNT",
    "TIMER",
    "OVERRIDE.VEL.TOTAL",
    "FIXED_STOP.ACTIVE",
    "FIXED_STOP.DETECTED",
    "FIXED_STOP.ACS.POS",
)


def half_way() -> Controller:
    """In the middle of a motion, with both overrides written, the operator's at 30.5 %."""
    controller = Controller(DEMO)
    machine_of(controller).channels[0].panel.put(cells.PANEL_OVERRIDE, 30.5)
    controller.start(NcText("p.nc", PROGRAM))
    controller.step(400)
    return controller


def test_every_cell_of_an_axis_holds_what_its_name_says() -> None:
    """ACT_POS is the command, CUR_POS the actual, CMD_POS the target position, in all systems."""
    controller = half_way()
    machine = machine_of(controller)
    targets = {"X": 30.0, "Y": 40.0, "Z": 0.0, "A": 5.0}
    positions = dict(zip(targets, machine.positions(), strict=True))
    assert 0.0 < positions["X"] < 30.0
    known = {name: machine.cells[cell] for name, (cell, *_) in machine.signals().items()}
    for axis, target in targets.items():
        position = positions[axis]
        expected = {"OVERRIDE.VEL.CYCLE": 33.0 if axis == "Y" else 100.0}
        expected["STATE"] = 1.0 if axis == "Z" else 6.0
        for system in ("ACS", "MCS", "PCS", "IPO"):
            expected[f"{system}.ACT_POS"] = position
            expected[f"{system}.CUR_POS"] = position
            expected[f"{system}.CMD_POS"] = target
            if system != "ACS":
                expected[f"{system}.DIST_TO_GO"] = target - position
        assert set(expected) | set(UNWRITTEN) >= {row.path for row in AXIS_VARIABLES}
        for path, value in expected.items():
            assert known[f"{axis}.{path}"] == value, (axis, path)


def test_every_cell_of_the_channel_holds_what_its_name_says() -> None:
    """Overrides, speed, block number, cycles that run, way to go; TOTAL is rounded (RC-305)."""
    controller = half_way()
    machine = machine_of(controller)
    x = machine.positions()[0]
    expected = {
        "OVERRIDE.VEL.CYCLE": 51.0,
        "OVERRIDE.VEL.TOTAL": 16.0,
        "CYCLES.DIAG_LEVEL": 3.0,
        "BLOCK": 10.0,
        "CYCLES.ACTIVE": 1.0,
        "PATH.RAPID": 0.0,
        **dict.fromkeys(("TOOL.DIRECTION.X", "TOOL.DIRECTION.Y", "TOOL.DIRECTION.Z"), 0.0),
    }
    known = {name: machine.cells[cell] for name, (cell, *_) in machine.signals().items()}
    for name, value in expected.items():
        assert known[name] == value, name
    # The motion uses the exact product: 100 mm/s of 15.555 %.
    assert abs(known["PATH.SPEED"] - 15.555) < 1e-9
    assert abs(known["PATH.DIST_TO_GO"] - (50.0 - x / 0.6)) < 1e-9
    written = {*expected, "PATH.SPEED", "PATH.DIST_TO_GO"}
    assert written | set(UNWRITTEN) >= {row.path for row in CHANNEL_VARIABLES}


def test_overrides_of_cycles_are_a_hundred_again_in_each_tick() -> None:
    """What a cycle wrote holds for its tick only (RC-305)."""
    controller = Controller(DEMO)
    text = PROGRAM.replace("  V.", "  $IF V.E.COUNT == 0\n  V.", 1)
    text = text.replace("#RT CYCLE END", "  V.E.COUNT = 1\n  $ENDIF\n#RT CYCLE END")
    controller.start(NcText("p.nc", text))
    controller.step(1)
    assert controller.read("V.RTG.OVERRIDE.VEL.CYCLE") == 51
    assert controller.read("V.RTA.OVERRIDE.VEL.CYCLE.Y") == 33
    controller.step(1)
    assert controller.read("V.RTG.OVERRIDE.VEL.CYCLE") == 100
    assert controller.read("V.RTA.OVERRIDE.VEL.CYCLE.Y") == 100


def test_overrides_of_axes_follow_in_the_tick_of_each_change() -> None:
    """Whatever changes, operator, cycle or release, TOTAL of an axis is that of the tick (RC-305).

    Most ticks change nothing, some change more than one.
    """
    controller = Controller(DEMO)
    machine = machine_of(controller)
    text = PROGRAM.replace("CYCLE.Y = 33", "CYCLE.Y = V.E.COUNT").replace("X30", "X3000")
    controller.start(NcText("p.nc", text.replace("  V.RTG.OVERRIDE.VEL.CYCLE = 51\n", "")))
    chance = random.Random(305)
    operator_pct, cycle_pct, is_locked = 100.0, 100, False
    seen = set()
    for _ in range(600):
        if chance.random() < 0.2:
            operator_pct = chance.choice((0.0, 12.5, 50.0, 100.0))
        if chance.random() < 0.2:
            cycle_pct = chance.choice((0, 20, 100, 100))
        if chance.random() < 0.1:
            is_locked = not is_locked
            machine.lock_axis(1, is_locked)
        machine.channels[0].panel.put(cells.PANEL_OVERRIDE, operator_pct)
        controller.write("V.E.COUNT", cycle_pct)
        controller.step(1)
        x_pct, y_pct = round(operator_pct), round(operator_pct * cycle_pct / 100.0)
        assert controller.read("V.RTA.OVERRIDE.VEL.TOTAL.X") == x_pct
        assert controller.read("V.RTA.OVERRIDE.VEL.TOTAL.Y") == (0 if is_locked else y_pct)
        seen.add((x_pct, y_pct, is_locked))
    assert len(seen) > 15


def test_every_name_has_a_cell_of_its_own() -> None:
    """No two variables share a cell, and all lie within the memory."""
    machine = machine_of(Controller(DEMO))
    cells = [cell for _, cell in machine.names.realtime()]
    cells += [cell for _, cell, _ in machine.names.values()]
    assert len(cells) == len(set(cells))
    assert 0 <= min(cells)
    assert max(cells) < len(machine.cells)
