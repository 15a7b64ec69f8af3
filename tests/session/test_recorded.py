# SPDX-License-Identifier: MIT
"""The recorded run of a session is that of a run with the same inputs, at any tick, any branch."""

from __future__ import annotations

import types
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from nctakt import Controller, NcText, Session
from nctakt.base.failure import Failure
from nctakt.results.run import RecordedRun

#: Its path, a reaction to a position, a function, a reaction to an input.
PROGRAM = NcText(
    "part.nc",
    """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > 50
    M100
  $ENDIF
  $IF EDGE V.E.VALUE > 0.5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
G01 X100 Y40 F6000
G01 X0 Y10
M30
""",
)


@pytest.fixture
def session() -> Iterator[Session]:
    with Session(PROGRAM) as session:
        yield session


def assert_begins_with(run: RecordedRun, whole: RecordedRun, ticks: int) -> None:
    """The run has these ticks of another one."""
    assert (run.first_tick, run.ticks) == (0, ticks)
    assert list(run.trace) == list(whole.trace)
    for name in whole.trace:
        assert np.array_equal(run.trace[name], whole.trace[name][:ticks]), name


def test_recorded_run_of_a_finished_session_is_the_run(session: Session) -> None:
    """State, counts and signals are those of ``Controller.run``."""
    session.run()
    run, whole = session.recorded(), Controller().run(PROGRAM)
    assert run.state == whole.state == "ended"
    assert run.cycles == whole.cycles
    assert run.outputs == whole.outputs
    assert_begins_with(run, whole, whole.ticks)


def test_recorded_run_ends_where_the_session_is(session: Session) -> None:
    """Or at an earlier or later tick of its branch; the session stays where it is."""
    whole = Controller().run(PROGRAM)
    session.run()
    session.go_to(700)
    here = session.recorded()
    assert here.state == "interrupted"
    assert_begins_with(here, whole, 700)
    assert_begins_with(session.recorded(20), whole, 20)
    assert_begins_with(session.recorded(1500), whole, 1500)
    assert session.tick == 700


def test_recorded_run_of_each_branch_has_its_inputs(session: Session) -> None:
    """An input in the past is in the branch that it began alone."""
    session.run("500 ms")
    session.go_to(300)
    session.write({"V.E.VALUE": 1})
    session.run("600 ms")
    one, other = session.recorded(500, 1), session.recorded(signals=["V.E.COUNT"])
    at = [("300 ms", "V.E.VALUE", 1.0)]
    assert_begins_with(one, Controller().run(PROGRAM), 500)
    assert_begins_with(other, Controller().run(PROGRAM, at=at, signals=["V.E.COUNT"]), 600)
    assert other.trace["V.E.COUNT"][-1] == 1


def test_recorded_run_with_inputs_of_a_tape(session: Session) -> None:
    """Acknowledgements by hand are inputs, too."""
    with Session(PROGRAM, acknowledges=False) as waiting:
        waiting.acknowledge_after(40)
        waiting.run("600 ms")
        run = waiting.recorded()
    (answer,) = (event for event in run.events if event.kind == "acknowledged")
    (output,) = run.technology
    assert answer.tick - output.tick == 40
    assert session.tick == 0


@pytest.mark.parametrize(
    ("words", "number"),
    [
        ({"end": 11}, 901154),
        ({"end": -1}, 901154),
        ({"branch": 2}, 901157),
        ({"signals": ["X.ACS.ACT_PO"]}, 900545),
    ],
)
def test_what_there_is_not_is_refused(session: Session, words: dict[str, Any], number: int) -> None:
    """A tick, a branch, a signal; the session lives on."""
    session.step(10)
    with pytest.raises(Failure) as refused:
        session.recorded(**words)
    assert [found.id for found in refused.value.diagnostics] == [number]
    assert session.recorded().ticks == 10


def test_an_interrupt_ends_it(session: Session) -> None:
    """As it ends travel (901474)."""
    with Session(NcText("long.nc", "$WHILE 1\nG01 X10 F6000\nX0\n$ENDWHILE\nM30")) as long:
        long.run("1000 s")
        thread = long._thread
        poller = thread.poller

        def interrupted() -> Any:
            poll = poller()
            long.interrupt()
            return poll

        thread.poller = interrupted  # type: ignore[method-assign]
        with pytest.raises(Failure) as refused:
            long.recorded()
    assert refused.value.diagnostics[0].id == 901474
    assert session.tick == 0


def test_whoever_waits_in_a_notebook_sees_how_far_it_is(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    """How many of how many ticks, until the command is done, which changes no result."""
    shown: list[tuple[int, int | None]] = []
    closed: list[bool] = []
    progress = types.SimpleNamespace(
        show=lambda done, total: shown.append((done, total)), close=lambda: closed.append(True)
    )
    monkeypatch.setattr("nctakt.session.process.thread.UPDATE_S", 0.0)
    monkeypatch.setattr("nctakt.session.process.thread.notebook_progress", lambda _: progress)
    monkeypatch.setattr("nctakt.session.session.notebook_progress", lambda _: progress)
    session.run("0.4 s")
    assert shown
    assert {total for _, total in shown} <= {400, None}
    assert all(0 <= done <= 400 for done, _ in shown)
    assert len(closed) > 0
    shown.clear()
    assert session.recorded().ticks == 400
    assert (400, 400) in shown
