# SPDX-License-Identifier: MIT
"""However a session was lived through, it is a straight run of its tape."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from support.random_seeds import MANY, each_seed

from nctakt import Controller, NcText
from nctakt.plc.loading import load_plc
from nctakt.results.run import Run
from nctakt.run.access.inputs import PLC as PLC_SOURCE
from nctakt.run.access.tape import Tape
from nctakt.session.core import SessionCore
from nctakt.session.process.worker import can_fork
from nctakt.session.setup import Setup
from nctakt.session.stops import read_stop

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.E.VALUE > 0.5
    V.E.COUNT += 1
    Z[INDP G90 FEED=2000 POS=V.E.COUNT]
  $ELSEIF V.RTA.ACS.ACT_POS.X > 30 && V.E.COUNT > 2
    V.E.CONDITION = 1
  $ENDIF
#RT CYCLE END
$FOR P1 = 1, 4, 1
  G01 X[10*P1] Y[P1] F3000
  M111
  #FLUSH WAIT
  $IF V.E.COUNT > 3
    G04 X0.02
  $ENDIF
$ENDFOR
G01 X0
M30
"""

PLC = """\
from nctakt import Plc

class Cell(Plc):
    def __init__(self):
        self.calls = 0

    def cycle(self, hli):
        self.calls += 1
        for function in hli.functions():
            if self.calls % 7 == 0:
                hli.acknowledge(function)
        if self.calls % 50 == 0:
            hli.override_pct = 40 + self.calls % 60
"""

STOPS = ["V.E.COUNT > 2", "fires 2", "line 11", "changes V.E.VALUE", "M111", "runs 5"]


def straight(core: SessionCore, plc: Path | None, programs: list[NcText]) -> tuple[Controller, Run]:
    """Run the tape of a session from the start up to where the session is."""
    inputs = tuple(one for one in core.tape() if one.source != PLC_SOURCE)
    controller = Controller()
    tape = Tape({}, {}, plc is not None, inputs, {}, 0, "", {})
    run = controller.run(
        *programs,
        plc=None if plc is None else load_plc(plc),
        replay=tape,
        ticks=core.tick,
        memory_trace=False,
    )
    return controller, run


def wander(core: SessionCore, chance: random.Random) -> None:
    """Do something with a session."""
    match chance.randrange(8):
        case 0:
            core.step(chance.randint(1, 300))
        case 1:
            core.run(stops=[read_stop(chance.choice(STOPS))])
        case 2:
            core.go_to(chance.randint(0, core.branch.latest))
        case 3:
            core.back(chance.randint(1, 50))
        case 4:
            core.back_to([read_stop(chance.choice(STOPS))])
        case 5 | 6:
            name = chance.choice(["V.E.VALUE", "V.E.VALUE", "HLI.OVERRIDE"])
            core.write({name: chance.choice([0, 1, 60])}, "page")
            core.step()
        case 7:
            branch = chance.choice(core.branches)
            core.go_to(chance.randint(0, branch.latest), branch.number)


@pytest.mark.nightly
@each_seed(4, 2)
@pytest.mark.parametrize("has_plc", [False, True])
def test_a_session_is_a_straight_run_of_its_tape(seed: int, has_plc: bool, tmp_path: Path) -> None:
    """Steps, travel, stops and inputs in the past leave no trace but the tape."""
    chance = random.Random(1000 * seed + has_plc)
    file = tmp_path / "cell.py"
    file.write_text(PLC, "utf-8")
    plc = file if has_plc else None
    programs = [NcText("p.nc", PROGRAM)]
    core = SessionCore(Setup({1: programs}, plc=plc, options={"at": [("60 ms", "V.E.VALUE", 1)]}))
    try:
        for _ in range(25):
            wander(core, chance)
        controller, run = straight(core, plc, programs)
        assert controller.tick == core.tick
        signals = sorted(core.description.signals)
        assert core.read(signals) == [controller.signal(name) for name in signals]
        result = core.result()
        assert result.cycles == run.cycles
        assert result.outputs == run.outputs
        assert result.messages == run.messages
    finally:
        core.close()


def long_program(path: Path, size: int, chance: random.Random) -> None:
    """Write a program of about this many bytes."""
    lines = ["G01 X0 Y0 F60000"]
    lines += (
        f"N{number} G01 X{chance.uniform(0, 0.6):.3f} Y{chance.uniform(0, 0.6):.3f}"
        for number in range(size // 27)
    )
    path.write_text("\n".join([*lines, "M30", ""]), "utf-8")


#: Bytes of the programs, ticks of them, jumps: a beginning, or all of it with ``NCTAKT_SEEDS``.
SIZES = (500_000, 2_000_000, 10_000_000) if MANY else (500_000, 2_000_000)
TICKS, JUMPS = (10_000_000, 40) if MANY else (5_000, 6)


@pytest.mark.nightly
@pytest.mark.skipif(not can_fork(), reason="elsewhere the past is run again from the start")
@each_seed(1, 1)
@pytest.mark.parametrize("size", SIZES)
def test_each_jump_leads_to_where_the_run_was(seed: int, size: int, tmp_path: Path) -> None:
    """Programs that are kept in memory, and such that are read when their lines are due."""
    chance = random.Random(seed)
    path = tmp_path / "p.nc"
    long_program(path, size, chance)
    run = Controller().run(
        path, ticks=TICKS, until="24 h", signals=["X.ACS.ACT_POS", "Y.ACS.ACT_POS"]
    )
    ticks = run.ticks
    names = ["V.RTA.ACS.ACT_POS.X", "V.RTA.ACS.ACT_POS.Y"]
    core = SessionCore(Setup({1: [path]}, options={"until": "24 h"}))
    try:
        while core.tick < ticks:
            core.run(min(ticks, core.tick + 50_000))
        for _ in range(JUMPS):
            tick = chance.randint(1, ticks)
            core.go_to(tick)
            expected = [run.trace[name][tick - 1] for name in run.trace.keys()]
            assert core.read(names) == expected
            assert not core.latest.diagnostics
    finally:
        core.close()
