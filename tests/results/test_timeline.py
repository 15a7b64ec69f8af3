# SPDX-License-Identifier: MIT
"""The timeline of a run: what happened, from when to when."""

from __future__ import annotations

import itertools
from dataclasses import replace
from pathlib import Path

import pytest
from support.runs_to_draw import drawn, timeline

from nctakt import Plc, after
from nctakt.results.timelines.timeline import KINDS, Slice, Track, rows_of
from nctakt.results.timelines.timeline_events import timeline_of
from nctakt.run.controller import Controller
from nctakt.schedule.open_schedule import open_schedule


def spans(track: Track) -> list[tuple[int, int, str]]:
    """Begin and end of the slices in ms, and their names."""
    return [(item.begin_us // 1000, item.end_us // 1000, item.name) for item in track.slices]


def test_blocks_follow_each_other() -> None:
    """Each lasts until the next one; blocks in one tick have no length and are left out."""
    found = spans(timeline(drawn()).of("block")[0])
    assert [name for _, _, name in found] == ["N10", "N20"]
    assert all(end == begin for (_, end, _), (begin, _, _) in itertools.pairwise(found))


def test_a_reaction_lasts_as_long_as_its_body_runs() -> None:
    """RC-203: ONCE for one tick; a plain $IF while its condition is true."""
    run = timeline(drawn())
    once, held = run.of("reaction")
    assert (once.label, held.label) == ("17: 2", "17: 5")
    assert [end - begin for begin, end, _ in spans(once)] == [1]
    (begin, end, _), *_ = spans(held)
    assert end - begin > 100
    assert run.of("condition")[1].slices[0].begin_us == begin * 1000


def test_a_condition_tells_the_values_that_were_compared() -> None:
    """Those of the change that made it true."""
    condition = timeline(drawn()).of("condition")[0]
    assert condition.text == "$IF ONCE V.RTA.ACS.ACT_POS.X > 5"
    left, operator, right = condition.slices[0].text.split()
    assert (float(left) > 5.0, operator, right) == (True, ">", "5")


def test_a_function_lasts_until_its_acknowledgement() -> None:
    """The PLC answers after 20 ms; the answer counts from the next tick on."""

    class Slow(Plc):
        acknowledge = after("20 ms")

    tracks = {track.label: track for track in timeline(drawn(plc=Slow())).of("function")}
    assert [end - begin for begin, end, _ in spans(tracks["M100"])] == [21]
    assert tracks["M101"].slices[0].span is not None


def test_what_nobody_acknowledges_is_open_at_the_end() -> None:
    """A run that its limit ends."""

    class Late(Plc):
        acknowledge = after("1 h")

    run = drawn(plc=Late(), ticks=400)
    function = next(one for one in timeline(run).of("function") if one.label == "M100")
    assert function.slices[0].is_open
    assert function.slices[0].end_us == 400_000


def test_without_histories_a_reaction_is_as_long_as_it_fired() -> None:
    """``why`` knows more; functions without answers are moments."""
    run = timeline(drawn(why=False, blocks=False))
    assert not run.of("condition")
    assert [len(track.slices) for track in run.of("reaction")] == [1, 1]
    assert all(item.is_moment for track in run.of("function") for item in track.slices)


def test_a_cycle_is_defined_active_and_held() -> None:
    """RC-102: from START to HOLD, and again from CONTINUE on."""
    text = (
        "#RT CYCLE DEF [ID=1 SCOPE=PROG]\n$IF ONCE 1\nV.E.COUNT = 1\n$ENDIF\n#RT CYCLE END\n"
        "G04 0.1\n#RT CYCLE START [ID=1]\nG04 0.1\n#RT CYCLE HOLD [ID=1]\nG04 0.1\n"
        "#RT CYCLE CONTINUE [ID=1]\nG04 0.1\nM30\n"
    )
    cycle = timeline(drawn(text)).of("cycle")[0]
    assert [name for _, _, name in spans(cycle)] == ["defined", "active", "held", "active"]


def test_cycles_without_id_of_one_definition_share_a_track() -> None:
    """A definition that a loop runs three times; what overlaps gets its own rows."""
    text = (
        "V.P.I = 0\n$WHILE V.P.I < 3\n#RT CYCLE [SCOPE=PROG]\n$IF V.RTA.ACS.ACT_POS.X > 1\n"
        "V.E.COUNT = 1\n$ENDIF\n#RT CYCLE END\nV.P.I = V.P.I + 1\n$ENDWHILE\nG00 X10\nM30\n"
    )
    run = timeline(drawn("#VAR\nV.P.I = 0\n#ENDVAR\n" + text))
    (cycle,) = run.of("cycle")
    assert (cycle.label, len(cycle.slices), len(rows_of(cycle))) == ("#1", 3, 3)
    assert [track.label for track in run.of("reaction")] == ["#1: 7"]


def test_the_oldest_firings_are_where_the_history_begins_later() -> None:
    """The history of a body keeps its newest series; the events before them are shown."""
    run = drawn()
    assert run.why is not None
    cycle = run.why.cycles[0]
    branch = cycle.branches[1]
    forgotten = replace(branch, bodies=replace(branch.bodies, series=(), left_out=1))
    why = replace(run.why, cycles=(replace(cycle, branches=(cycle.branches[0], forgotten)),))
    tracks = timeline(replace(run, why=why)).of("reaction")
    assert sorted(track.label for track in tracks) == ["17: 2", "17: 5"]


def test_a_starved_queue_is_a_slice() -> None:
    """The decoder comes in each fifth NC cycle: nothing is there in tick 4, 9 and 14."""
    folder = Path(__file__).parent.parent / "runs" / "rtconf_starved_decoder"
    controller = Controller(None, open_schedule(folder / "rtconf.lis", folder / "load.toml"))
    run = controller.run(folder / "program.nc")
    found = timeline(run).of("starved")[0]
    assert next((begin, end) for begin, end, _ in spans(found)) == (4, 5)
    assert len(found.slices) == 3


def test_messages_errors_and_the_end_are_moments() -> None:
    """With their text and place."""
    done = timeline(drawn())
    assert done.of("message")[0].slices[0].name == "done"
    assert done.of("end")[0].slices[0].name == "part.nc"
    failed = timeline(
        drawn("#RT CYCLE [ID=1]\n$IF ONCE 1\nV.E.VALUE = 1/0\n$ENDIF\n#RT CYCLE END\nG04 1\nM30")
    )
    assert failed.of("error")[0].slices[0].name.startswith("error ")


def test_tracks_are_in_the_order_of_their_kinds() -> None:
    """Whatever came first in the run."""
    kinds = [track.kind for track in timeline(drawn()).tracks]
    assert kinds == sorted(kinds, key=KINDS.index)


@pytest.mark.parametrize("ticks", [1, 60])
def test_a_run_that_is_cut_off_has_a_timeline(ticks: int) -> None:
    """What goes on ends with the run and is open."""
    run = timeline(drawn(ticks=ticks))
    assert run.end_us == ticks * 1000
    last = run.of("cycle")[0].slices[-1]
    assert (last.end_us, last.is_open) == (ticks * 1000, True)


def test_an_empty_run_has_none() -> None:
    """No event, no track."""
    empty = timeline_of(
        (), None, cycle_time_us=1000, first_tick=0, ticks=0, line_at=lambda span: ""
    )
    assert empty.tracks == ()
    assert Slice(5, 5, "x").is_moment


def test_a_decoder_waits_for_an_axis_from_its_request_until_it_is_taken() -> None:
    """Its request of positions before ends with the wait for the axis."""
    folder = Path(__file__).parents[2] / "examples" / "exchange"
    controller = Controller(folder / "machine")
    found = timeline(controller.run(folder / "mill.nc", channels={2: [folder / "loader.nc"]}))
    tracks = {track.label: spans(track) for track in found.of("wait")}
    lanes = {track.label: spans(track) for track in found.of("channel")}
    for label in ("CH1", "CH2"):
        (wait,) = [item for item in tracks[label] if item[2] == "axis C"]
        assert wait[:2] in [item[:2] for item in lanes[label]]
        others = [item for item in tracks[label] if item != wait]
        assert all(end <= wait[0] or begin >= wait[1] for begin, end, _ in others)
