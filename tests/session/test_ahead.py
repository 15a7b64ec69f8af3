# SPDX-License-Identifier: MIT
"""What a session knows of ticks to come, and where its branches differ first."""

import math
import struct
from pathlib import Path
from typing import Any, cast

import pytest

from nctakt import NcText, Session
from nctakt.session.history.comparing import first_difference

PROGRAM = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > 5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
G01 X10 F6000
M30
"""
X = "X.ACS.ACT_POS"


def test_the_future_is_what_comes_then() -> None:
    """Before the first tick all of the program is known; the session stays where it is."""
    with Session(NcText("part.nc", PROGRAM)) as session:
        *_, future = session.future(X, "Y.ACS.ACT_POS")
        assert (session.tick, session.branches) == (0, {1: 0})
        done = session.run()
        assert future.reason == "over"
        assert future.ticks == tuple(range(done.tick))
        assert future.columns[:1] == (tuple(session.look(0, done.tick, [X])[1].tolist()),)
        fired = [event.tick for event in future.events if event.kind == "fired"]
        assert fired == [one.tick for one in session.events(0, done.tick)[0] if one.kind == "fired"]
        assert len(fired) == 1


@pytest.mark.nightly
def test_the_future_ends_where_somebody_has_to_act(tmp_path: Path) -> None:
    """At a function that the PLC has to acknowledge; with a PLC in Python nothing is known."""
    with Session(NcText("part.nc", "G01 X1 F6000\nM7\nX2 M30"), acknowledges=False) as session:
        *_, future = session.future(X)
        assert future.reason == "wait"
        assert [one.span.line for one in future.causes if one.span is not None] == [2]
        assert future.columns[0][-1] == 1.0
    plc = tmp_path / "cell.py"
    plc.write_text("class Cell:\n    def cycle(self, hli):\n        pass\n", "utf-8")
    with Session(NcText("part.nc", "G01 X1 F6000 M30"), plc=plc) as session:
        assert [one.reason for one in session.future(X)] == ["unknown"]


@pytest.mark.nightly
def test_branches_differ_first_in_the_tick_of_the_input() -> None:
    """A value written before tick 7 is there after tick 7 (RC-002), and in nothing before."""
    with Session(NcText("part.nc", PROGRAM)) as session:
        session.run(20)
        session.go_to(7)
        session.write({"V.E.VALUE": 3})
        session.step(5)
        assert session.origins == {1: (0, 0), 2: (1, 7)}
        found = session.compare_branches(1, 2)
        assert (found.fork, found.tick, found.end) == (7, 7, 12)
        assert ("V.E.VALUE", 0.0, 3.0) in found.signals
        assert session.branch == 2
        session.go_to(9, 1)
        session.write({"V.E.VALUE": 0})
        session.step(3)
        assert session.compare_branches(3, 1).tick is None


def test_what_is_no_number_is_the_same_in_both_branches() -> None:
    """Values that are no numbers, and zeros of both signs, are no difference."""

    class Engine:
        tick = 5

        def __init__(self, *rows: tuple[float, float]) -> None:
            self.data = struct.pack("<6d", *(value for row in rows for value in row))

        def ask(self, *_: object) -> bytes:
            return self.data

    one = Engine((math.nan, 0.0), (1.0, 2.0), (1.0, 3.0))
    other = Engine((math.nan, -0.0), (1.0, 2.0), (1.0, 4.0))
    found = first_difference(cast("Any", (one, other)), 8, ("A", "B"), lambda: None)
    assert (found.fork, found.end, found.tick) == (5, 8, 7)
    assert found.signals == (("B", 3.0, 4.0),)
