# SPDX-License-Identifier: MIT
"""What is run again is compared with the first run, and found without running where it can be."""

from __future__ import annotations

import contextlib
import random
import subprocess
import sys
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nctakt import NcText
from nctakt.base.failure import Failure
from nctakt.kernel import rows
from nctakt.session.core import SessionCore
from nctakt.session.engine import Engine, StepResult
from nctakt.session.history import record
from nctakt.session.history.parking import (
    DENSE_US,
    EVEN_SHARE,
    MAX_PARKED,
    SPARSE_US,
    approach,
    first_gap,
    surplus,
)
from nctakt.session.history.past_runs import PastRuns
from nctakt.session.history.record import BranchRecord, PastMark
from nctakt.session.history.trail import MARK_US, Mark
from nctakt.session.listening import Notice
from nctakt.session.process.process_pool import RemoteEngine
from nctakt.session.process.worker import can_fork
from nctakt.session.session import Session
from nctakt.session.setup import Setup
from nctakt.session.stops import EventFilter, StopAt, read_stop

pytestmark = pytest.mark.slow

needs_copies = pytest.mark.skipif(not can_fork(), reason="a controller cannot be copied here")

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.RTA.ACS.ACT_POS.X > 20
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
$FOR P1 = 1, 20, 1
  G01 X[2*P1] Y[P1 MOD 3] F6000
  M100
$ENDFOR
M30
"""


@pytest.fixture
def core() -> Iterator[SessionCore]:
    """A session that has run to tick 600, after ticks run in parts."""
    own = SessionCore(Setup({1: [NcText("p.nc", PROGRAM)]}))
    for _ in range(12):
        own.step(50)
    yield own
    own.close()


def let_differ(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let each controller that runs again come to something else."""
    run = RemoteEngine.run

    def other(engine: RemoteEngine, end: int, *words: Any, **keywords: Any) -> StepResult:
        done = run(engine, end, *words, **keywords)
        if not keywords.get("marks"):
            return done
        wrong = tuple(Mark(mark.tick, b"otherwise", 0.0) for mark in done.marks)
        return StepResult(
            **{name: getattr(done, name) for name in done.__slots__} | {"marks": wrong}
        )

    monkeypatch.setattr(RemoteEngine, "run", other)


# --- marks ----------------------------------------------------------------------------------------


def test_the_same_ticks_leave_the_same_marks_however_they_are_cut() -> None:
    """Marks depend on what was run, not on where a run was cut into parts."""
    found = []
    for size in (1000, 7, 130):
        engine = Engine(Setup({1: [NcText("p.nc", PROGRAM)]}))
        marks = [*range(100, 500, 50), 500]
        while engine.tick < 500:
            end = min(500, engine.tick + size)
            found += engine.run(end, marks=[one for one in marks if engine.tick < one <= end]).marks
    digests = [{mark.tick: mark.digest for mark in found[9 * k : 9 * k + 9]} for k in range(3)]
    assert len(digests[0]) == 9
    assert digests[0] == digests[1] == digests[2]


@pytest.mark.parametrize("change", ["position", "event"])
def test_a_mark_is_another_one_for_another_past(change: str) -> None:
    texts = {"position": PROGRAM.replace("MOD 3", "MOD 4"), "event": PROGRAM.replace("100", "101")}
    marks = [
        Engine(Setup({1: [NcText("p.nc", text)]})).run(300, marks=[300]).marks[0]
        for text in (PROGRAM, texts[change])
    ]
    assert marks[0].tick == marks[1].tick
    assert marks[0].digest != marks[1].digest


def explained(core: SessionCore) -> object:
    with contextlib.closing(PastRuns()) as runs:
        return runs.explained(core.past(), lambda: None)


TRAVEL: dict[str, Callable[[SessionCore], object]] = {
    "go_to": lambda core: core.go_to(120),
    "back": lambda core: core.back(3),
    "back_to": lambda core: core.back_to([read_stop("V.E.COUNT > 5")]),
    "look": lambda core: core.look(100, 400, ["X.ACS.ACT_POS"]),
    "happened": lambda core: core.happened(100, 400),
    "why": explained,
}


@pytest.mark.nightly
@needs_copies
def test_a_past_that_is_not_as_it_was_is_not_shown(core: SessionCore) -> None:
    """It is an internal error, which says so; the session stays where it is right."""
    own = core.branch.record
    true = list(own.marks)
    own.marks[:] = [PastMark(mark.tick, b"another", mark.work_us, mark.is_over) for mark in true]
    before = core.read(["V.RTA.ACS.ACT_POS.X"])
    for name, travel in TRAVEL.items():
        with pytest.raises(Failure) as failed:
            travel(core)
        assert failed.value.diagnostics[0].id == 901901, name
        assert core.tick == 600
        assert core.read(["V.RTA.ACS.ACT_POS.X"]) == before
    own.marks[:] = true
    for travel in TRAVEL.values():
        travel(core)


@needs_copies
def test_a_live_controller_that_has_gone_wrong_shows_nothing_until_it_is_left(
    core: SessionCore, monkeypatch: pytest.MonkeyPatch
) -> None:
    core.go_to(100)
    with monkeypatch.context() as patch:
        let_differ(patch)
        with pytest.raises(Failure):
            core.step(500)
    for look in (lambda: core.read(["V.E.COUNT"]), core.step, core.cycles):
        with pytest.raises(Failure) as failed:
            look()
        assert failed.value.diagnostics[0].id == 901901
    core.go_to(400)
    assert core.read(["V.RTA.ACS.ACT_POS.X"])[0] > 0.0
    core.step(300)
    assert core.tick == 700


@needs_copies
def test_sessions_say_it_to_those_who_listen(monkeypatch: pytest.MonkeyPatch) -> None:
    with Session(NcText("p.nc", PROGRAM)) as session, session.listen() as listener:
        session.step(500)
        session.go_to(10)
        let_differ(monkeypatch)
        session.play(1000.0)
        reported: dict[str, Notice] = {}
        while "refused" not in reported:
            reported |= {notice.kind: notice for notice in listener.notices(20.0)}
        assert "901901" in reported["refused"].text
        assert "interner Fehler" in reported["refused"].text_de
        assert not session.is_playing


@needs_copies
def test_a_program_that_was_changed_on_disk_has_no_past(tmp_path: Path) -> None:
    """The lines of a long program are read again; a change in them is reported."""
    path = tmp_path / "p.nc"
    lines = [f"G01 X{number % 2 * 0.3} F6000 ; {number:030}" for number in range(30_000)]
    path.write_text("\n".join([*lines, "M30"]), "utf-8")
    own = SessionCore(Setup({1: [path]}))
    try:
        for _ in range(10):
            own.step(5000)
        path.write_text("\n".join(["G01 X3 F100", *lines]), "utf-8")
        refused = []
        for tick in range(4000, 50_000, 5000):
            try:
                own.go_to(tick)
            except Failure as failure:
                refused.append(failure.diagnostics[0].id)
        assert set(refused) == {901900}
    finally:
        own.close()


def test_a_selected_program_leaves_the_same_marks_in_the_past(tmp_path: Path) -> None:
    """Selected for later, refused, and selected again: the files are those of the first run."""
    paths = [tmp_path / f"{name}.nc" for name in "abc"]
    for path, text in zip(
        paths, ("G01 X1 F600\nM30", "G01 Y2 F600\nM30", "G01 X\nM30"), strict=True
    ):
        path.write_text(text, "utf-8")
    own = SessionCore(Setup({1: []}, options={"stays": True}))
    try:
        own.step(20)
        with pytest.raises(Failure):
            own.select(str(paths[2]), 1, "page")
        own.select(str(paths[1]), 1, "page")
        own.step(400)
        own.select(str(paths[0]), 1, "page")
        own.step(400)
        for tick in (500, 30, 700, 400):
            own.go_to(tick)
        own.step(820 - own.tick)
        assert own.read(["V.RTA.ACS.ACT_POS.X", "V.RTA.ACS.ACT_POS.Y"]) == [1.0, 2.0]
    finally:
        own.close()


# --- the record -----------------------------------------------------------------------------------


def test_a_stop_at_an_event_is_found_without_running(
    core: SessionCore, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Blocks, functions and firings by the record; the same as by running again."""
    for text in ("line 7", "line 8", "M100", "fires 2", "message", "M101"):
        stop = read_stop(text)
        by_running = core.timeline.previous([StopAt(**_fields(stop) | {"only_if": "1 > 0"})])
        with monkeypatch.context() as patch:
            patch.setattr(RemoteEngine, "last_hit", None)
            patch.setattr(RemoteEngine, "run", None)
            assert core.timeline.previous([stop]) == by_running, text


def _fields(stop: StopAt) -> dict[str, Any]:
    return {name: getattr(stop, name) for name in stop.__slots__}


def test_the_latest_of_several_stops_is_found(core: SessionCore) -> None:
    single = [core.timeline.previous([read_stop(text)]) for text in ("M100", "changes V.E.COUNT")]
    stops = [read_stop("M100"), read_stop("changes V.E.COUNT")]
    assert core.timeline.previous(stops) == max(filter(None, single))


def test_events_of_another_branch_are_not_found(core: SessionCore) -> None:
    """A branch has the events before its first tick, and its own."""
    found = core.timeline.previous([read_stop("M100")])
    assert found is not None
    core.go_to(200)
    earlier = core.timeline.previous([read_stop("M100")])
    core.write({"HLI.FEED_HOLD": True}, "page")
    core.step(200)
    assert core.branch.number == 2
    assert core.timeline.previous([read_stop("M100")]) == earlier
    core.go_to(600, 1)
    assert core.timeline.previous([read_stop("M100")]) == found


@pytest.mark.parametrize("seed", range(20))
def test_events_are_found_in_all_chunks(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """In memory, in a file, in the chunk that grows: as by looking at all of them."""
    monkeypatch.setattr(record, "CHUNK_BYTES", 64 * 5)
    monkeypatch.setattr(record, "MAX_BYTES", 64 * 20)
    chance = np.random.default_rng(seed)
    count = int(chance.integers(1, 120))
    events = np.zeros((count, rows.EVENT_WIDTH))
    events[:, rows.EVENT_TICK] = np.sort(chance.integers(0, 60, count))
    events[:, rows.EVENT_KIND] = chance.integers(0, 4, count)
    events[:, rows.EVENT_A] = chance.integers(0, 5, count)
    events[chance.random(count) < 0.1, rows.EVENT_A] = np.nan
    own = BranchRecord()
    for part in np.array_split(events, 15):
        own.add([], part.tobytes())
    low, high = [-np.inf] * rows.EVENT_WIDTH, [np.inf] * rows.EVENT_WIDTH
    low[rows.EVENT_A], high[rows.EVENT_A] = 2, 3
    wanted = EventFilter(0b0110, tuple(low), tuple(high))
    for before in range(0, 62, 3):
        expected = [
            int(row[rows.EVENT_TICK])
            for row in events
            if row[rows.EVENT_TICK] < before and row[rows.EVENT_KIND] in (1, 2)
            if not row[rows.EVENT_A] < 2 and not row[rows.EVENT_A] > 3
        ]
        assert own.last_event(wanted, before) == (expected[-1] if expected else None)
    own.close()


def test_marks_that_are_too_near_give_way() -> None:
    """The last mark is always there; others are about as far from each other as is due."""
    own = BranchRecord()
    for tick in range(1000):
        own.add([Mark(tick, b"", MARK_US / 10)], b"")
        assert own.marks[-1].tick == tick
    assert 80 < len(own.marks) < 220
    assert own.work_us == pytest.approx(100 * MARK_US)


# --- parked controllers ---------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(20))
def test_parked_controllers_are_dense_near_the_present(seed: int) -> None:
    """On both sides of the present; the first and the last one always stay."""
    chance = random.Random(seed)
    parked = sorted(chance.uniform(0, 1e8) for _ in range(300))
    present = chance.choice([parked[-1], chance.uniform(0, 1e8)])
    gone = set(surplus(parked, present))
    kept = [work for index, work in enumerate(parked) if index not in gone]
    assert kept[0] == parked[0]
    assert kept[-1] == parked[-1]
    assert len(kept) <= MAX_PARKED
    widest = (parked[-1] - parked[0]) / EVEN_SHARE
    given = [after - before for before, after in pairwise(parked)]
    for before, after in pairwise(kept):
        farther = max(abs(before - present), abs(after - present))
        assert after - before <= max(2 * min(farther, widest), 2 * DENSE_US, *given)
    assert not surplus(kept, present)


def test_a_gap_is_one_that_is_larger_than_the_way_to_it() -> None:
    assert first_gap([0.0], DENSE_US) is None
    assert first_gap([0.0], 8 * DENSE_US) == (0, 4 * DENSE_US)
    works = [DENSE_US * work for work in (0, 60, 90, 105, 112, 116, 118, 120)]
    assert first_gap(works[:-1], works[-1]) is None
    assert first_gap([works[0], *works[3:-1]], works[-1]) == (0, DENSE_US * 52.5)


def test_a_short_way_has_one_copy_on_it_and_a_long_one_few() -> None:
    assert approach(0.0, 4 * DENSE_US) == []
    assert approach(0.0, SPARSE_US) == [SPARSE_US * 3 / 4]
    assert len(approach(0.0, 1000 * SPARSE_US)) == 11


PRINTING = """\
from nctakt import Plc

class Cell(Plc):
    def __init__(self):
        self.calls = 0

    def cycle(self, hli):
        self.calls += 1
        if self.calls == 3:
            print("third call")
"""

LIVED = """\
import sys
from nctakt import NcText
from nctakt.session import Session

with Session(NcText("p.nc", "N1 G04 X1\\nM30"), plc=sys.argv[1]) as session:
    session.step(100)
    session.go_to(60)
    session.go_to(90)
"""


@needs_copies
def test_what_a_plc_has_printed_is_not_printed_again_by_each_copy(tmp_path: Path) -> None:
    """Once in the first run, and once where these ticks were run again."""
    plc = tmp_path / "cell.py"
    plc.write_text(PRINTING, "utf-8")
    words = [sys.executable, "-c", LIVED, str(plc)]
    printed = subprocess.run(words, capture_output=True, check=True, text=True).stdout
    assert 1 <= printed.count("third call") <= 2
