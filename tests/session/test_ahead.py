# SPDX-License-Identifier: MIT
"""What a session knows of ticks to come, and where its branches differ first."""

import math
import struct
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
from numpy.typing import NDArray

from nctakt import NcText, Session
from nctakt.session.history.comparing import first_difference
from nctakt.session.outline import outlined

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


def test_rows_where_the_way_bends_are_kept() -> None:
    """It goes up to tick 7, then is at rest: that row is kept, beside the first and even ones.

    Of a straight way only the even ones are. Between rows it is known in which tick it is where.
    """
    ticks = np.arange(21)
    way = ticks.astype(np.float64)[:, np.newaxis]
    assert outlined(ticks, np.clip(way, 0, 7), 4).tolist() == [0, 7, 10, 20]
    assert outlined(ticks, way, 4).tolist() == [0, 10, 20]
    times = np.array([0, 1, 5, 6, 7, 8, 9, 10])  # at one speed
    assert outlined(times, way[times], 4).tolist() == [0, 3, 7]
    assert outlined(ticks, way, 21).tolist() == ticks.tolist()
    assert outlined(ticks[:1], way[:1], 1).tolist() == [0]


def test_long_paths_are_drawn_as_they_are() -> None:
    """A square of 10 mm at 100 mm/s again and again: few rows show its corners, past and future.

    Rows at even distances, as many, cut the corners by more than a millimetre.
    """
    side = ["X10 Y0", "X10 Y10", "X0 Y10", "X0 Y0"]
    text = "\n".join([f"G01 {place} F6000" for _ in range(60) for place in side])
    names = [X, "Y.ACS.ACT_POS"]
    with Session(NcText("squares.nc", f"{text}\nM30")) as session:
        *_, future = session.future(*names)
        end = session.run().tick
        whole = np.array(session.look(0, 20_000, names)[1]).reshape(-1, 2)
        whole = np.concatenate(
            (whole, np.array(session.look(20_000, end, names)[1]).reshape(-1, 2))
        )
        every, cells = session.look(0, end, names, 1000)
        evenly = np.array(cells).reshape(-1, 2).T
        ticks, columns = session.outline(0, end, [*names, "PATH.SPEED"], 2, 1000)
        assert len(ticks) <= 1000
        assert ticks[-1] == end - 1
        assert columns[0] == [whole[tick][0] for tick in ticks]
        assert away(whole, np.arange(len(evenly[0])) * every + every - 1, evenly) > 1.0
        assert away(whole, ticks, columns) < 0.5
        assert away(whole, future.ticks, future.columns) < 0.2


def away(whole: NDArray[np.float64], ticks: Any, columns: Any) -> float:
    """Return how far a path is from lines between some of its places, at the same times, in mm."""
    drawn = [np.interp(np.arange(len(whole)), ticks, column) for column in columns[:2]]
    return float(np.max(np.hypot(*(whole.T - drawn))))


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
