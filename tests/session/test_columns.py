# SPDX-License-Identifier: MIT
"""What is recorded of signals and writes: as by looking at all of the ticks."""

from __future__ import annotations

import operator
import random
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from support.random_seeds import each_seed

from nctakt import NcText
from nctakt.kernel import rows
from nctakt.session.core import SessionCore
from nctakt.session.history import columns
from nctakt.session.history.branch import Branch
from nctakt.session.history.columns import ColumnRecord, ColumnTrail, Necessary, extent_end
from nctakt.session.process.process_pool import RemoteEngine
from nctakt.session.process.worker import can_fork
from nctakt.session.setup import Setup
from nctakt.session.stops import EventFilter, StopAt, read_stop

OPERATORS: dict[str, Callable[[float, float], bool]] = {
    "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge, "==": operator.eq,
    "!=": operator.ne,
}  # fmt: skip


def holds(needed: Necessary, before: float, value: float) -> bool:
    """Whether the stop that needs this holds after a tick."""
    if needed.operator == "changes":
        return before != value
    is_true = OPERATORS[needed.operator]
    return is_true(value, needed.number) and not is_true(before, needed.number)


def extent_of(lowest: float, highest: float) -> memoryview[float]:
    """What a controller leaves of one signal."""
    return memoryview(np.array([lowest, highest]).tobytes()).cast("d")


@each_seed(20, 20)
def test_no_tick_in_which_a_stop_holds_is_left_out(seed: int, monkeypatch: Any) -> None:
    """Signals that are at rest, step and swing, recorded in parts of any length on two branches."""
    monkeypatch.setattr(columns, "EXTENT_TICKS", 16)
    chance = random.Random(seed)
    values = [float(chance.randint(0, 3))]
    for _ in range(300):
        change = chance.random()
        values.append(values[-1] if change < 0.9 else float(chance.randint(0, 3)))
    cut = chance.randint(1, 299)
    parent = Branch(1, None, 0)
    branch = Branch(2, parent, cut)
    for own, first, last in ((parent, 0, 300), (branch, cut, 300)):
        trail, tick = ColumnTrail(), first
        while tick < last:
            end = min(last, extent_end(tick), tick + chance.randint(1, 40))
            count, part = end - tick, values[tick : end + 1]
            trail.extent(tick, count, extent_of(min(part), max(part)))
            tick += count
            if tick == last or chance.random() < 0.5:
                own.record.add([], b"", trail.take())
    for name in ("changes", *OPERATORS):
        needed: Any = Necessary(0, name, float(chance.randint(0, 3)))  # type: ignore[arg-type]
        for before in (300, chance.randint(1, 300)):
            ticks = [t for t in range(before) if holds(needed, values[t], values[t + 1])]
            end = branch.possible_end(needed, before)
            assert end <= before
            assert end > max(ticks, default=-1)
    assert branch.possible_end(Necessary(0, ">", 9.0), 300) == 0


def test_ticks_that_are_not_recorded_are_possible() -> None:
    own = Branch(1, None, 0)
    never = Necessary(0, ">", 9.0)
    assert own.possible_end(never, 50) == 50
    trail = ColumnTrail()
    trail.extent(20, 10, extent_of(0.0, 0.0))
    own.record.add([], b"", trail.take())
    assert own.possible_end(never, 40) == 40
    assert own.possible_end(never, 30) == 20
    trail.extent(30, 5, extent_of(np.nan, np.nan))
    own.record.add([], b"", trail.take())
    assert own.possible_end(never, 35) == 35


def any_write(cell: float) -> EventFilter:
    """The writes of cycles into a cell."""
    low, high = [-np.inf] * rows.EVENT_WIDTH, [np.inf] * rows.EVENT_WIDTH
    low[rows.EVENT_A] = high[rows.EVENT_A] = cell
    return EventFilter(columns.WRITE_KINDS, tuple(low), tuple(high))


@each_seed(20, 20)
def test_the_last_write_is_found(seed: int, monkeypatch: Any) -> None:
    """Series of ticks and single ones; of what is forgotten it is known that it is."""
    monkeypatch.setattr(columns, "MAX_SERIES", 40)
    monkeypatch.setattr(columns, "_MAX_WAITING", 30)
    chance = np.random.default_rng(seed)
    events = np.zeros((300, rows.EVENT_WIDTH))
    events[:, rows.EVENT_TICK] = np.sort(chance.integers(0, 200, 300))
    events[:, rows.EVENT_KIND] = rows.EVENT_WRITTEN
    events[:, rows.EVENT_SUBJECT] = chance.integers(0, 2, 300)
    events[:, rows.EVENT_A] = chance.integers(0, 3, 300)
    own, trail = ColumnRecord(), ColumnTrail()
    for part in np.array_split(events, 12):
        trail.writes(part)
        own.add(*trail.take())
    for cell in range(3):
        for before in (1, 77, 150, 200):
            ticks = [
                int(row[rows.EVENT_TICK])
                for row in events
                if row[rows.EVENT_A] == cell and row[rows.EVENT_SUBJECT] >= 1
                if row[rows.EVENT_TICK] < before
            ]
            kept = [tick for tick in ticks if tick >= own.writes_from]
            found = own.last_write(any_write(cell), before)
            assert max(kept, default=None) == (found if kept else None)
            assert found is None or found in ticks
    assert 0 < own.writes_from < 200


PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.RTA.ACS.ACT_POS.X > 20
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
$FOR P1 = 1, 20, 1
  G01 X[2*P1] Y[P1 MOD 3] F6000
$ENDFOR
M30
"""


@pytest.fixture
def core() -> Iterator[SessionCore]:
    """A session that has run to tick 600."""
    own = SessionCore(Setup({1: [NcText("p.nc", PROGRAM)]}))
    own.step(600)
    yield own
    own.close()


@pytest.mark.skipif(not can_fork(), reason="a controller cannot be copied here")
def test_writes_and_signals_are_found_in_the_record(
    core: SessionCore, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same as by running again, which needs no tick where it cannot have been."""
    for text in ("V.RTA.ACS.ACT_POS.X > 30", "changes V.E.COUNT", "V.RTA.ACS.ACT_POS.Y > 1"):
        stop = read_stop(text)
        again = StopAt(stop.kind, stop.text, only_if="V.E.COUNT >= 0")
        assert core.back_to([again]) is not None
        found = core.tick
        core.go_to(600)
        assert core.back_to([stop]) is not None
        assert core.tick == found
        core.go_to(600)
    by_running = core.timeline.previous([StopAt("written", "V.E.COUNT", only_if="1 > 0")])
    with monkeypatch.context() as patch:
        patch.setattr(RemoteEngine, "last_hit", None)
        patch.setattr(RemoteEngine, "run", None)
        assert core.timeline.previous([read_stop("written V.E.COUNT")]) == by_running
        for text in ("V.RTA.ACS.ACT_POS.X > 30000", "changes V.E.VALUE", "written V.E.VALUE"):
            assert core.timeline.previous([read_stop(text)]) is None
