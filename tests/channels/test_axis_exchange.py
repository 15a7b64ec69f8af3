# SPDX-License-Identifier: MIT
"""``#CALL AX``, ``#PUT AX``, ``#SET AX``, ``#AX``: rules, mistakes, waits and deadlocks.

Sources: programming manual, pages 206987659 (#CALL AX), 206995083 (#PUT AX), 207001739 (#SET AX),
207029131 and 559929099 (#AX DEF); ``docs/conformance/axis-exchange.md`` has what they leave open.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Mapping
from pathlib import Path

import pytest
from support.insides import machine_of
from support.random_seeds import all_seeds

from nctakt.base.failure import Failure
from nctakt.decoder.fast import handover
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.lists.machine.machine import load_machine
from nctakt.nc import outline
from nctakt.results.run import Run
from nctakt.results.timelines.timeline_events import timeline_of
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.snapshot import Snapshot

#: Channel 1 has X (1), Y (2), Z (3), C (5), channel 2 has X (4); axis 6 belongs to none.
MACHINE = load_machine(Path(__file__).parent / "exchange_machine")


def text(name: str, *lines: str) -> NcText:
    """A main program of these lines."""
    return NcText(name, "\n".join([f"%{name}", *lines, "M30", ""]))


def run(
    one: list[str], two: list[str], controller: Controller | None = None, ticks: int = 3000
) -> Run:
    """A run of both channels."""
    controller = controller or Controller(MACHINE)
    return controller.run(text("one", *one), channels={2: [text("two", *two)]}, ticks=ticks)


def numbers(found: Run) -> list[int]:
    """The numbers of all errors and warnings."""
    return [one.id for one in found.diagnostics if one.severity.name != "NOTE"]


def at_end(found: Run, signal: str) -> float:
    """The value of a signal at the end of a run."""
    assert found.trace is not None
    return float(found.trace[signal][-1])


def exchanges(found: Run) -> list[tuple[int, int, str]]:
    """Time in ms, channel and text of each event of the exchange."""
    events = (one for one in found.events if one.kind == "exchange")
    return [(one.time_us // 1000, one.channel, one.text) for one in events]


def test_an_axis_is_given_and_fetched() -> None:
    """C goes to 90° in 1 s + 0 (6000°/min = 100°/s, 1000°/s²: 0.1 s more), then to channel 2."""
    found = run(
        ["G01 C90 F6000", "#PUT AX [C]", "G01 X10"],
        ["#CALL AX [C, 5, 3]", "P1=V.A.ABS.C", '#MSG ["%f", P1]', "G01 C180 F6000"],
    )
    assert numbers(found) == []
    assert exchanges(found) == [
        (1, 2, "C awaited CH1"),
        (1001, 1, "C given"),
        (1001, 2, "C taken"),
    ]
    assert [one.text for one in found.messages] == ["90.000000"]
    assert at_end(found, "CH1.C.ACS.ACT_POS") == 180.0


def test_a_path_moves_fetched_axes_together() -> None:
    """The corners of a line in two axes, one of which came from the pool (6)."""
    controller = Controller(MACHINE)
    run(["#CALL AX [W, 6, 4]", "G01 X30 W40 F6000", "G01 X0 W0"], [], controller)
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 0.0
    found = run(["#CALL AX [W, 6, 4]", "G01 X30 W40 F6000"], [], controller)
    assert numbers(found) == []
    # 50 mm at 100 mm/s; W has 4/5 of the way and allows 1250 mm/s². 2 ticks: exchanges.
    assert found.virtual_time_us == 500_000 + 80_000 + 2000


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("#CALL AX", [900233]),
        ("#CALL AX [W]", [900233]),
        ("#CALL AX [W, 6]", [900233]),
        ("#CALL AX W", [900233]),
        ("#PUT AX", [900233]),
        ("#PUT AX []", [900233]),
        ("#PUT AX [3]", [900233]),
        ("#PUT AX ALL [X]", [900233]),
        ("#SET AX", [900233]),
        ("#AX DEF", [900233]),
        ("#AX RELEASE NBR [X]", [900233]),
        ("#AX FOO [X]", [900200]),
        ("#CALL AX [M, 6, 4]", [901804]),
        ("#CALL AX [W, 6, 4, ALL]", [901805]),
        ("#CALL AX [W, 7, 4]", [901801]),
        ("#CALL AX [W, 6.5, 4]", [901801]),
        ("#CALL AX [W, 6, 6]", [901802]),
        ("#CALL AX [W, 6, -1]", [901802]),
        ("#CALL AX [W, 6, 0.5]", [901802]),
        ("#CALL AX [X, 6, 4]", [901803]),
        ("#CALL AX [W, 6, 1]", [901803]),
        ("#CALL AX [W, 1, 4]", [901803]),
        ("#SET AX [X, 1, 0] [X, 2, 1]", [901803]),
        ("#SET AX [X, 1, 0] [Y, 1, 1]", [901803]),
        ("#SET AX [X, 1, 0] [Y, 2, 0]", [901803]),
    ],
)
def test_a_wrong_command_is_reported_at_its_place(line: str, expected: list[int]) -> None:
    controller = Controller(MACHINE)
    try:
        found = numbers(run([line], ["G04 0.01"], controller))
    except Failure as failure:
        found = [one.id for one in failure.diagnostics]
    assert found == expected


@pytest.mark.parametrize(
    "line", ["G01 C10 F1000", "G90 X1 C[10]", "P1=V.A.ABS.C", "#PSET C1", "C[OVERRIDE FEED_FACT=5]"]
)
def test_an_axis_that_is_not_there_is_reported(line: str) -> None:
    found = run(["#PUT AX [C]", line], ["G04 0.01"])
    assert numbers(found) == [901800]
    (error,) = [one for one in found.diagnostics if one.id == 901800]
    assert "no channel has it" in error.headline()
    assert error.span is not None
    assert error.span.line == 3


def test_who_has_the_axis_is_reported() -> None:
    found = run(["#PUT AX [C]", "#SIGNAL [ID=1 CH=2]", "#WAIT [ID=2 CH=2]", "G01 C1 F1"],
                ["#WAIT [ID=1 CH=1]", "#CALL AX [C, 5, 1]", "#SIGNAL [ID=2 CH=1]"])  # fmt: skip
    (error,) = [one for one in found.diagnostics if one.id == 901800]
    assert "channel 2 has it" in error.headline()


def test_absent_axes_and_known_ones_are_no_mistake() -> None:
    """#PUT AX of an absent axis (206995083), #CALL AX of one that is there (206987659)."""
    found = run(["#PUT AX [B]", "#CALL AX [X, 1, 0]", "#AX RELEASE NBR [6]", "G01 X1 F600"], [])
    assert numbers(found) == []
    assert exchanges(found) == []


def test_a_place_left_free_stays_free() -> None:
    """Z keeps index 2 when Y has gone, and Y can come back to 1 (206995083)."""
    found = run(["#PUT AX [Y]", "G01 X3 Z4 F6000", "#CALL AX [Y, 2, 1]", "G17 G02 X5 Y0 I1 J0"], [])
    assert numbers(found) == []


def test_the_example_of_the_extended_form() -> None:
    """X1 stays, Y2 goes, Z3 moves to index 4, 5 and 6 come (559929099, with other numbers)."""
    found = run(
        ["#AX DEF [X, 1, 0] [Y1, 5, 2] [Z1, 6, 3] [Z, 3, 4]", "G01 X1 Z2 F6000", "G01 Y1=3 Z1=4"],
        [],
    )
    assert numbers(found) == []
    taken = [one for one in exchanges(found)]
    assert [what for _, _, what in taken] == ["Y given", "6 taken"]


def test_default_is_the_list_with_changes() -> None:
    found = run(["#AX DEF [X, 1, 0]", "#AX DEF DEFAULT [W, 6, 5]", "G01 X1 Y1 Z1 C1 W1 F6000"], [])
    assert numbers(found) == []


def test_two_channels_swap_axes() -> None:
    """Each gives first, then takes: no deadlock."""
    found = run(["#SET AX [X, 4, 0]", "G01 X5 F6000"], ["#SET AX [X, 1, 0]", "G01 X7 F6000"])
    assert numbers(found) == []
    assert at_end(found, "CH1.X.ACS.ACT_POS") == 7.0
    assert at_end(found, "CH2.X.ACS.ACT_POS") == 5.0


def test_the_next_program_begins_with_the_axes_of_the_list() -> None:
    """P-CHAN-00460 = 0: what the program before has fetched goes, what it has given comes back."""
    controller = Controller(MACHINE)
    run(["#PUT AX [C]", "#CALL AX [W, 6, 3]", "G01 W5 F6000"], [], controller)
    found = run(["G01 C7 X1 F6000"], ["#CALL AX [W, 6, 3]", "G01 W6 F6000"], controller)
    assert numbers(found) == []
    assert [what for _, channel, what in exchanges(found) if channel == 1] == ["6 given", "C taken"]


def test_offsets_of_an_exchanged_axis_begin_at_zero() -> None:
    found = run(
        ["#PSET X10", "#SET AX [X, 1, 0]", "#PUT AX ALL", "#CALL AX [X, 1, 0]", "G90 G01 X3 F6000"],
        [],
    )
    assert numbers(found) == []
    assert at_end(found, "CH1.X.ACS.ACT_POS") == 3.0


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("#CS ON [0, 0, 0, 0, 0, 30]", 20660),
        ("G17 G02 I5 J0 F100", 20938),
        ("#ROTATION ON [ANGLE=30]", 20938),
    ],
)
def test_what_needs_a_main_axis_is_refused_without_it(line: str, expected: int) -> None:
    assert numbers(run(["#PUT AX [Y]", line], [])) == [expected]


def test_a_block_search_does_not_exchange_axes() -> None:
    """Before the start block; after it as always."""
    program = text("one", "#PUT AX [C]", "G01 X1 F600", "#CALL AX [C, 5, 3]", "G01 C5")
    found = Controller(MACHINE).run(program, from_line=3)
    assert 901809 in numbers(found)
    program = text("one", "G01 X1 F600", "G01 X2", "#PUT AX [C]", "#CALL AX [C, 5, 3]", "G01 C5")
    found = Controller(MACHINE).run(program, from_line=3)
    assert [number for number in numbers(found) if number != 901731] == []


def test_an_active_coordinate_system_keeps_its_axes() -> None:
    found = run(["#CS ON [0, 0, 0, 0, 0, 30]", "#PUT AX [Y]"], [])
    assert numbers(found) == [901806]
    found = run(["#CS ON [0, 0, 0, 0, 0, 30]", "#CS OFF", "#PUT AX [Y]"], [])
    assert numbers(found) == []


# --- deadlocks ------------------------------------------------------------------------------------


def test_a_deadlock_of_axes_tells_who_waits_for_whom() -> None:
    found = run(["#CALL AX [U, 4, 4]", "#PUT AX [C]"], ["#CALL AX [C, 5, 3]", "#PUT AX [X]"])
    errors = [one for one in found.diagnostics if one.id == 901506]
    assert [one.headline() for one in errors] == [
        "one:2:1: error 901506: channel 1 has waited since 0.001000 s for something that cannot "
        "happen: axis X, which channel 2 has",
        "two:2:1: error 901506: channel 2 has waited since 0.001000 s for something that cannot "
        "happen: axis C, which channel 1 has",
    ]
    assert "Line 3 of two in channel 2 would free it" in str(errors[0])
    assert "Line 3 of one in channel 1 would free it" in str(errors[1])


def test_a_deadlock_between_an_axis_and_a_signal_is_reported() -> None:
    found = run(["#WAIT [ID=1 CH=2]", "#PUT AX [C]"], ["#CALL AX [C, 5, 3]", "#SIGNAL [ID=1 CH=1]"])
    errors = [one for one in found.diagnostics if one.id == 901506]
    assert ["signal 1 of channel 2" in errors[0].headline(), len(errors)] == [True, 2]
    assert "axis C, which channel 1 has" in errors[1].headline()
    found = run(
        ["#WAIT SYN [ID=1 CH=2]", "#PUT AX [C]"], ["#CALL AX [C, 5, 3]", "#SIGNAL SYN [ID=1 CH=1]"]
    )
    assert numbers(found) == [901506, 901506]


def test_an_axis_that_nobody_gives_is_reported_before_the_first_tick() -> None:
    found = run(["G01 X1 F600"], ["#CALL AX [C, 5, 3]"])
    assert numbers(found) == [901808, 901506]


def test_a_reset_ends_the_wait() -> None:
    controller = Controller(MACHINE)
    controller.start(text("one", "#CALL AX [U, 4, 4]"))
    controller.step(50)
    controller.reset()
    found = run(["G01 X1 F600"], ["G01 X1 F600"], controller)
    assert numbers(found) == []


# --- an independent model -------------------------------------------------------------------------

Steps = list[tuple[str, int]]


def model(programs: Mapping[int, Steps]) -> tuple[dict[int, int], bool]:
    """Who has each axis at the end, and whether channels wait forever.

    In every order of steps the same: axes are only taken by who asks for them, and a step that is
    possible stays so, as at most one channel asks for an axis.
    """
    holder = {1: 1, 2: 1, 3: 1, 5: 1, 4: 2, 6: 0}
    at = dict.fromkeys(programs, 0)
    goes_on = True
    while goes_on:
        goes_on = False
        for channel, steps in programs.items():
            while at[channel] < len(steps):
                what, axis = steps[at[channel]]
                if what == "call" and holder[axis] not in (0, channel):
                    break
                if what == "call":
                    holder[axis] = channel
                elif holder[axis] == channel:
                    holder[axis] = 0
                at[channel] += 1
                goes_on = True
    return holder, any(at[channel] < len(steps) for channel, steps in programs.items())


def lines_of(steps: Steps, channel: int) -> list[str]:
    """The program of these steps, each axis with its own index."""
    names = {2: ("Y", 1), 3: ("Z", 2), 5: ("C", 3), 4: ("U", 4), 6: ("W", 5)}
    if channel == 2:
        names[4] = ("X", 0)
    return [
        f"#CALL AX [{names[axis][0]}, {axis}, {names[axis][1]}]"
        if what == "call"
        else f"#AX RELEASE NBR [{axis}]"
        for what, axis in steps
    ]


@pytest.mark.parametrize("order", list(itertools.permutations(range(4))))
def test_every_order_of_giving_and_taking(order: tuple[int, ...]) -> None:
    """Channel 1 gives C, then wants U; channel 2 gives U, wants C, in every order of its steps."""
    steps: Steps = [("put", 4), ("call", 5), ("put", 5), ("call", 6)]
    programs: dict[int, Steps] = {
        1: [("put", 5), ("call", 4)],
        2: [steps[index] for index in order],
    }
    check(programs)


def check(programs: Mapping[int, Steps]) -> None:
    """Compare a run with the model."""
    controller = Controller(MACHINE)
    found = run(lines_of(programs[1], 1), lines_of(programs[2], 2), controller, ticks=400)
    holder, waits = model(programs)
    assert (901506 in numbers(found)) == waits, (programs, numbers(found))
    exchange = machine_of(controller).channels[0].exchange
    assert {axis: exchange.holder(axis - 1) for axis in holder} == holder, programs


@pytest.mark.parametrize("seed", all_seeds(10, 4))
def test_random_programs_against_the_model(seed: int) -> None:
    """At most one channel asks for an axis, so that the order of ticks does not matter."""
    draw = random.Random(seed)
    programs: dict[int, Steps] = {1: [], 2: []}
    asks = {axis: draw.choice((1, 2)) for axis in range(2, 7)}
    for _ in range(draw.randint(2, 8)):
        axis = draw.randint(2, 6)
        what = draw.choice(("put", "call"))
        channel = asks[axis] if what == "call" else draw.choice((1, 2))
        programs[channel].append((what, axis))
    check(programs)


# --- pictures, snapshots --------------------------------------------------------------------------


def test_the_timeline_shows_waits_and_who_gave() -> None:
    found = run(["G01 X10 F6000", "#PUT AX [C]"], ["#CALL AX [C, 5, 3]"])
    timeline = timeline_of(
        found.events,
        None,
        cycle_time_us=1000,
        first_tick=0,
        ticks=found.ticks,
        line_at=lambda _: "",
    )
    tracks = {one.label: one for one in timeline.of("channel")}
    assert [one.name for one in tracks["CH2"].slices] == ["C ← CH1", "← C"]
    assert [one.name for one in tracks["CH1"].slices] == ["C →"]


def test_an_exchange_is_part_of_a_snapshot() -> None:
    controller = Controller(MACHINE)
    part = machine_of(controller).realtime
    snapshot = Snapshot(part)
    run(["#PUT AX [C]"], ["#CALL AX [C, 5, 3]", "G01 C5 F6000"], controller)
    assert list(part.channels[1].path.own_axes()) == [3, 6, 6, 4]
    snapshot.put_back()
    assert list(part.channels[1].path.own_axes()) == [3]
    assert [part.channels[0].exchange.holder(axis) for axis in range(6)] == [1, 1, 1, 2, 1, 0]


# --- realtime cycles ------------------------------------------------------------------------------


def test_a_cycle_may_not_move_an_axis_that_its_channel_gave() -> None:
    """It reads on, and its next command for the axis is 50899."""
    found = run(
        [
            "#RT CYCLE [ID=1 SCOPE=PROG]",
            "$IF V.RTA.ACS.ACT_POS.X > 5",
            "C[INDP ABORTING G90 G01 FEED=1000 POS=10]",
            "$ENDIF",
            "#RT CYCLE END",
            "#PUT AX [C]",
            "G01 X10 F6000",
            "G04 0.1",
        ],
        [],
    )
    assert numbers(found) == [50899]


def test_the_example_runs() -> None:
    """``examples/exchange``: the table goes to the loader and back."""
    folder = Path(__file__).parents[2] / "examples" / "exchange"
    controller = Controller(folder / "machine")
    found = controller.run(folder / "mill.nc", channels={2: [folder / "loader.nc"]})
    assert numbers(found) == []
    assert [(channel, what) for _, channel, what in exchanges(found)] == [
        (2, "C awaited CH1"), (1, "C given"), (2, "C taken"),
        (1, "C awaited CH2"), (2, "C given"), (1, "C taken"),
    ]  # fmt: skip
    assert at_end(found, "CH1.C.ACS.ACT_POS") == 0.0


def test_plain_lines_keep_their_short_way(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lines of given and fetched axes: the same trace as from trees, and few trees."""
    monkeypatch.setattr(outline, "KEPT_STATEMENTS", 0)
    plain = [f"X{i % 3} Y{i % 2}" for i in range(30)]
    one = ["G01 F60000 X1", "#PUT AX [C]", *plain, "#CALL AX [B, 6, 3]", "B5", *plain, "X0 B7"]
    two = ["#CALL AX [C, 5, 1]", "G01 F60000 X1", *(f"X{i % 3} C{i}" for i in range(30))]
    taken: list[int] = []
    fill = handover.PlainBlocks.fill

    def count(blocks: handover.PlainBlocks, queue: CommandQueue, timed: int, tick: int) -> None:
        before = queue.timed_count
        fill(blocks, queue, timed, tick)
        taken.append(queue.timed_count - before)

    monkeypatch.setattr(handover.PlainBlocks, "fill", count)
    short = run(one, two, ticks=20_000)
    assert short.errors == ()
    assert short.state == "ended"
    assert sum(taken) > 80
    monkeypatch.setattr(handover.PlainBlocks, "_is_allowed", lambda _: False)
    tree = run(one, two, ticks=20_000)
    assert short.trace is not None and tree.trace is not None
    assert list(short.trace.events) == list(tree.trace.events)
    for signal in ("CH1.X.ACS.ACT_POS", "CH1.C.ACS.ACT_POS", "CH2.X.ACS.ACT_POS"):
        assert list(short.trace[signal]) == list(tree.trace[signal]), signal
