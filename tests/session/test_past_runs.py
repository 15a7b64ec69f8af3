# SPDX-License-Identifier: MIT
"""The past is explained from the nearest controller on, and says the same as from the start on."""

from __future__ import annotations

import contextlib
import random
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from nctakt import NcText
from nctakt.results.run import Run
from nctakt.session.core import SessionCore
from nctakt.session.history import past_runs
from nctakt.session.history.past import Past
from nctakt.session.history.past_runs import PastRuns
from nctakt.session.process.process_pool import ProcessPool
from nctakt.session.process.worker import can_fork
from nctakt.session.setup import Setup

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not can_fork(), reason="a controller cannot be copied here"),
]

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.E.TRIGGER
    V.E.COUNT += 1
  $ENDIF
  $IF ONCE V.RTA.ACS.ACT_POS.X > 10
    M100
  $ENDIF
#RT CYCLE END
$FOR P1 = 1, 60, 1
  G01 X[2*P1] F6000
  M100
$ENDFOR
M30
"""

#: Answers late, and presses the trigger on its own.
PLC = """\
from nctakt import HliView, Plc, after, when

class Cell(Plc):
    acknowledge = after("7 ticks")

    @when("V.RTA.ACS.ACT_POS.X > 12")
    def press(self, hli: HliView) -> None:
        hli.write("V.E.TRIGGER", 1)
"""


def from_the_start(wanted: Past) -> Run:
    with contextlib.closing(PastRuns()) as runs:
        return runs.explained(wanted, lambda: None)


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """The controllers that are opened for pasts; copies are kept each 50 ticks."""
    monkeypatch.setattr(past_runs, "PART_TICKS", 50)
    found: list[Any] = []

    class Counted(ProcessPool):
        def open(self, setup: Setup) -> Any:
            found.append(super().open(setup))
            return found[-1]

    monkeypatch.setattr(past_runs, "ProcessPool", Counted)
    return found


@contextlib.contextmanager
def session(*plcs: str) -> Iterator[tuple[SessionCore, PastRuns]]:
    """A session that has run to tick 600, and what explains it."""
    core = SessionCore(Setup({1: [NcText("p.nc", PROGRAM)]}, plc=plcs or None))
    with contextlib.closing(core), contextlib.closing(PastRuns()) as runs:
        core.step(600)
        yield core, runs


def test_each_place_of_each_branch(opened: list[Any], monkeypatch: pytest.MonkeyPatch) -> None:
    """Histories of a walk over three branches, where one controller is opened for all."""
    monkeypatch.setattr(past_runs, "MAX_KEPT", 5)
    walk = random.Random(35)
    with session() as (core, runs):
        for tick, is_on in ((300, True), (450, False)):
            core.go_to(tick)
            core.write({"V.E.TRIGGER": is_on}, "test")
            core.step(250)
        assert len(core.branches) == 3
        pasts = [
            core.past(walk.randrange(1, branch.latest + 1), branch.number)
            for branch in walk.choices(core.branches, k=5)
        ]
        found = [runs.explained(one, lambda: None) for one in pasts]
        assert len(opened) == 1
        for one, run in zip(pasts, found, strict=True):
            assert run.why == from_the_start(one).why, (one.branch.number, one.tick)


def test_beside_a_plc(opened: list[Any], tmp_path: Path) -> None:
    """What a PLC in Python has given before the copy is in its state, and is not given twice."""
    path = tmp_path / "plc.py"
    path.write_text(PLC, "utf-8")
    with session(str(path)) as (core, runs):
        for tick in (480, 120, 333):
            one = core.past(tick)
            assert runs.explained(one, lambda: None).why == from_the_start(one).why, tick
    assert len(opened) == 4


def test_several_ask_at_once(opened: list[Any]) -> None:
    """Each gets its own place, whatever files the others leave."""
    with session() as (core, runs):
        pasts = [core.past(tick) for tick in (600, 50, 310)]
        with ThreadPoolExecutor(len(pasts)) as threads:
            found = list(threads.map(lambda one: runs.explained(one, lambda: None), pasts))
        for one, run in zip(pasts, found, strict=True):
            assert run.why is not None
            assert run.why.ticks == one.tick
    assert opened
