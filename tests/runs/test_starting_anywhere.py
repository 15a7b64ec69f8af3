# SPDX-License-Identifier: MIT
"""Each example of the manuals, started and resumed in every way: it does what the plain run does.

Ways: block search to each block, single block, backward and forward again, a session that goes back
to each 50th tick. (``test_replays.py`` replays all of them from their tapes.) Without
``NCTAKT_SEEDS`` a few places of each example are tried, with it all of them.
"""

from __future__ import annotations

import random
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from support.polylines import apart, way
from support.random_seeds import MANY
from support.run_folders import DEMO, FOLDERS, HERE, changed_machine, settings

from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.results.run import Run
from nctakt.results.trace.events import Event
from nctakt.run.controller import Controller
from nctakt.session.session import Session

pytestmark = pytest.mark.slow

#: Examples of the manuals, and of motion; those with several channels or a schedule have no search.
EXAMPLES = [
    name
    for name in FOLDERS
    if name.startswith(("manual_", "mo_"))
    and name != "manual_3_4_structure_for_a_number"  # refused
    and not {"channels", "rtconf"} & settings(HERE / name).keys()
]
#: Those without inputs at times.
UNTIMED = [name for name in EXAMPLES if not settings(HERE / name).keys() & {"at", "set", "plc"}]
ALONE = [name for name in UNTIMED if not settings(HERE / name).keys() & {"machine", "after"}]
AXES = [f"{axis}.ACS.ACT_POS" for axis in "XYZ"]
#: More than the longest of them takes.
TICKS = 100_000

#: What a start at a block changes in these, and rightly.
NOT_THE_SAME_PLACE = {
    "manual_4_5_1_endless": "a cycle moves Z for as long as the program takes",
    "manual_4_5_1_positioning": "a cycle moves Z for as long as the program takes",
    "mo_003_bend": "the axes begin at the corner that a whole run cuts",
    "mo_007_turns_in_passing": "the operator turns back at a time",
    "mo_007_backward_and_forward": "the operator turns back at a time",
    "manual_4_5_2_position_request": "a cycle of a block that is left out moves Z",
    "manual_4_5_3_units": "a cycle of a block that is left out moves Z",
    "mo_013_cycle_wants_an_axis_of_the_path": "a cycle moves Z for as long as the program takes",
    "mo_012_fixed_stop": "no fixed stop is found in front of the start block",
}
NOT_THE_SAME_TEXTS = {"manual_4_1_timers": "they show times"}


@cache
def machine_of(changes: tuple[tuple[str, tuple[str, ...]], ...], work: Path) -> Machine:
    """The demo machine with other lines."""
    return load_machine(changed_machine(dict(changes), work / str(abs(hash(changes))), DEMO))


def perform(name: str, work: Path, **more: Any) -> Run:
    """Run an example, blocks included in its events."""
    given = settings(HERE / name)
    changes = tuple((file, tuple(lines)) for file, lines in given.get("machine", {}).items())
    return Controller(machine_of(changes, work)).run(
        *sorted((HERE / name).glob("*.nc")),
        set={**given.get("set", {}), **more.pop("set", {})},
        at=[*(tuple(one) for one in given.get("at", ())), *more.pop("at", ())],
        after=given.get("after", 0),
        ticks=TICKS,
        signals=AXES,
        blocks=True,
        **more,
    )


@pytest.fixture(scope="module")
def work(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder for changed machines."""
    return tmp_path_factory.mktemp("machines")


def blocks_of(run: Run, file: str) -> list[tuple[int, Event, int]]:
    """Number among the events, event and line of each block of a file."""
    return [
        (number, event, event.span.line)
        for number, event in enumerate(run.events)
        if event.kind == "block" and event.span is not None and event.span.file == file
    ]


def texts(run: Run, first: int = 0) -> list[str]:
    """Functions and messages from an event on."""
    return [str(one) for one in run.events[first:] if one.kind in ("output", "message")]


def ids(run: Run) -> list[int]:
    """The numbers of the errors."""
    return [error.id for error in run.errors]


def living(run: Run, first: int) -> list[str]:
    """The cycles that can run from an event on: those that live there, and those created later."""
    alive: dict[str, bool] = {}
    for number, event in enumerate(run.events):
        kind, name, *rest = str(event).split()
        if kind == "created":
            following = [str(one) for one in run.events[number + 1 : number + 2]]
            alive[name] = following != [f"started {name}"]
        elif kind == "ended" and number < first and not (alive[name] and rest == ["scope"]):
            del alive[name]
    return sorted(alive)


@pytest.mark.parametrize("name", EXAMPLES)
def test_block_search_to_each_block(name: str, work: Path) -> None:
    """The same blocks, functions, messages, errors, living cycles and the same way from there."""
    plain = perform(name, work)
    file = str(min((HERE / name).glob("*.nc")))
    all_blocks = blocks_of(plain, file)
    places: dict[int, int] = {}
    for place, (_, _, line) in enumerate(all_blocks):
        places.setdefault(line, place)
    lines = sorted(places)
    if not MANY:
        lines = random.Random(name).sample(lines, 1)
    for line in lines:
        first, begun, _ = all_blocks[places[line]]
        found = perform(name, work, from_line=line)
        found_blocks = blocks_of(found, file)
        where = f"from line {line}"
        assert (found.state, ids(found)) == (plain.state, ids(plain)), where
        assert [one[2] for one in found_blocks] == [one[2] for one in all_blocks[places[line] :]]
        assert living(found, found_blocks[0][0]) == living(plain, first), where
        if name not in NOT_THE_SAME_TEXTS:
            assert texts(found) == texts(plain, first), where
        if name not in NOT_THE_SAME_PLACE:
            ways = [
                way(run, AXES, max(0, tick - 1))
                for run, tick in ((plain, begun.tick), (found, found_blocks[0][1].tick))
            ]
            assert ways[0][-1] == pytest.approx(ways[1][-1], abs=1e-9), where
            assert apart(*ways) < 0.02, where


@pytest.mark.parametrize("name", UNTIMED if MANY else UNTIMED[::3])
@pytest.mark.parametrize("is_single", [True, False], ids=["single block", "there and back"])
def test_with_stops_on_the_way(name: str, is_single: bool, work: Path) -> None:
    """In single block, and with a while of motion backward: the same functions, the same end."""
    plain = perform(name, work)
    if is_single:
        more: dict[str, Any] = {"set": {"HLI.SINGLE_BLOCK": 1.0}}
        more["at"] = [(tick / 1000, "HLI.START", 1.0) for tick in range(1, TICKS, 211)]
    else:
        begin = random.Random(name).randint(1, max(2, plain.ticks)) / 1000
        more = {
            "at": [(begin, "HLI.BACKWARD_MOTION", 1.0), (begin + 0.1, "HLI.BACKWARD_MOTION", 0.0)]
        }
    found = perform(name, work, **more)
    assert (found.state, ids(found)) == (plain.state, ids(plain))
    if name not in NOT_THE_SAME_TEXTS:
        assert texts(found) == texts(plain)
    if name not in NOT_THE_SAME_PLACE:
        assert way(found, AXES)[-1] == pytest.approx(way(plain, AXES)[-1], abs=1e-9)


@pytest.mark.parametrize("name", ALONE if MANY else ALONE[::20])
def test_a_session_from_each_50th_tick(name: str, work: Path) -> None:
    """A session that goes back and runs on ends as the run does."""
    plain = perform(name, work)
    with Session(*sorted((HERE / name).glob("*.nc"))) as session:
        end = session.run()
        values = session.read(*AXES)
        ticks = range(0, end.tick, 50 if MANY else max(50, end.tick // 2))
        for tick in ticks:
            session.go_to(tick)
            assert session.run().tick == end.tick
            assert session.read(*AXES) == values
    assert values == pytest.approx(way(plain, AXES)[-1], abs=1e-9)
