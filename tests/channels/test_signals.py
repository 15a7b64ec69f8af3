# SPDX-License-Identifier: MIT
"""``#SIGNAL`` and ``#WAIT`` between two channels: rules, mistakes, deadlocks in every order.

Sources: programming manual, pages 207409035 (#SIGNAL), 207421579 (#WAIT), 207414923 (#SIGNAL
REMOVE), 913718283 (#SIGNAL READ), 207058059 (#WAIT FOR); ``tests/runs/signals_*`` are whole runs.
"""

from __future__ import annotations

import itertools
import random
from collections import deque
from pathlib import Path

import pytest
from support.insides import machine_of
from support.random_seeds import all_seeds

from nctakt.kernel import codes
from nctakt.lists.machine.machine import load_machine
from nctakt.nc.meaning.signals import MAX_CHANNEL, SIGNAL_VALUES
from nctakt.results.run import Run
from nctakt.results.timelines.timeline_events import timeline_of
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.snapshot import Snapshot

MACHINE = load_machine(Path(__file__).parent.parent / "runs" / "two_channels" / "machine")


def text(name: str, *lines: str) -> NcText:
    """A main program of these lines."""
    return NcText(name, "\n".join([f"%{name}", *lines, "M30", ""]))


def run(one: list[str], two: list[str], controller: Controller | None = None) -> Run:
    """A run of both channels."""
    controller = controller or Controller(MACHINE)
    return controller.run(text("one", *one), channels={2: [text("two", *two)]}, ticks=500)


def numbers(found: Run) -> list[int]:
    """The numbers of all errors and warnings."""
    return [one.id for one in found.diagnostics if one.severity.name != "NOTE"]


def test_the_limits_of_checker_and_realtime_part_are_the_same() -> None:
    assert (MAX_CHANNEL, SIGNAL_VALUES) == (codes.MAX_SIGNAL_CHANNEL, codes.SIGNAL_VALUES)


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("#SIGNAL", [20998]),
        ("#WAIT NOW [ID=1]", [20998]),
        ("#WAIT ID=1", [20998]),
        ("#SIGNAL [CH=2]", [901500]),
        ("#SIGNAL [ID=1 ID=2]", [21056]),
        ("#SIGNAL [ID=0]", [20995]),
        ("#SIGNAL [ID=0.5]", [20995]),
        ("#WAIT [ID=1.5]", [20995]),
        ("#SIGNAL READ [ID=2.5]", [20995]),
        ("#SIGNAL REMOVE [ID=2147483646.5]", [20995]),
        ("#SIGNAL [ID=1 CH=1.5]", [20996]),
        ("#SIGNAL [ID=1 CH=31]", [20996]),
        ("#SIGNAL [ID=1 CH=3]", [250008]),
        ("#SIGNAL [ID=1 COUNT=0]", [901501]),
        ("#SIGNAL [ID=1 P[12]=1]", [901502]),
        ("#WAIT [ID=1 P[0]=5]", [901503]),
        ("#WAIT SYN [ID=1 P[0]=P1 CH=2]", [21344]),
        ("#SIGNAL READ SYN [ID=1]", [21344]),
        ("#SIGNAL [ID=P1 CH=2]", [20995]),
        ("#WAIT [ID=1 NOW CH=2]", [21220]),
        ("#SIGNAL REMOVE [IDMIN=3 IDMAX=2]", [901530]),
        ("#WAIT FOR", [900233]),
        ("#WAIT INDP [Q]", [21220]),
    ],
)
def test_mistakes_are_reported_with_their_numbers(line: str, expected: list[int]) -> None:
    """Pages 253191563, 253195915, 253204619, 253326475, 254292619, 266560907 of the diagnosis."""
    found = run(["P1 = -1", line], [])
    assert found.state == "error"
    assert numbers(found) == expected


def test_a_value_that_was_not_sent() -> None:
    """21549: the target of P[1] would get nothing."""
    found = run(["#WAIT [ID=1 P[1]=P1 CH=2]"], ["#SIGNAL [ID=1 P[0]=3 CH=1]"])
    assert numbers(found) == [21549]


@pytest.mark.parametrize("mode", ["", " SYN"])
def test_signals_of_one_sender_are_taken_in_their_order(mode: str) -> None:
    """250002 (page 266543499); AHEAD takes them in any order, which a note reports once."""
    sends = ["#SIGNAL SYN [ID=1 CH=1]", "#SIGNAL SYN [ID=2 CH=1]"]
    wrong = [f"#WAIT{mode} [ID=2 CH=2]", f"#WAIT{mode} [ID=1 CH=2]"]
    found = run(["G04 0.01", *wrong], sends)
    assert numbers(found) == [250002]
    ahead = [line.replace("CH=2]", "CH=2 AHEAD]") for line in wrong]
    found = run(["G04 0.01", *ahead], sends)
    assert (found.state, [one.id for one in found.diagnostics]) == ("ended", [901504])


def test_the_board_is_bounded() -> None:
    """250001: 256 signals may be open."""
    sends = ["$FOR P1 = 1, 257, 1", "#SIGNAL [ID=1 CH=2]", "$ENDFOR"]
    assert numbers(run(sends, [])) == [250001]
    sends[1] = "#SIGNAL SYN [ID=1 CH=2]"
    assert numbers(run(sends, [])) == [250001]
    assert run([sends[0].replace("257", "256"), *sends[1:]], []).state == "ended"


def test_several_channels_and_a_count() -> None:
    """CH CH is two signals; COUNT=2 lets each be taken twice, the third wait is in vain."""
    sends = ["#SIGNAL [ID=1 COUNT=2 CH=1 CH=2]", *2 * ["#WAIT SYN [ID=1 CH=1]"]]
    takes = 2 * ["#WAIT SYN [ID=1 CH=1]"]
    assert run(sends, takes).state == "ended"
    assert numbers(run(sends, [*takes, takes[0]])) == [901506]


def test_signals_are_removed() -> None:
    """A single one, or a range; broadcasts without CH (page 207414923)."""
    sends = ["#SIGNAL [ID=5]", "#SIGNAL [ID=5]", "#SIGNAL [ID=6 CH=2]", "#SIGNAL [ID=7 CH=2]"]
    controller = Controller(MACHINE)
    run([*sends, "#SIGNAL REMOVE [ID=5]"], [], controller)
    signals = machine_of(controller).kernel.signals
    assert [one[:3] for one in signals.open_signals()] == [(5, 1, 0), (6, 1, 2), (7, 1, 2)]
    run(["#SIGNAL REMOVE SYN [IDMIN=1 IDMAX=6 CH=2]"], [], controller)
    assert [one[:3] for one in signals.open_signals()] == [(5, 1, 0), (7, 1, 2)]


def test_a_reset_clears_what_is_addressed_to_its_channel() -> None:
    """Page 207414923; the program's end clears nothing."""
    controller = Controller(MACHINE)
    run(["#SIGNAL [ID=5]", "#SIGNAL [ID=6 CH=2]", "#SIGNAL [ID=7 CH=1]"], [], controller)
    signals = machine_of(controller).kernel.signals
    assert signals.count == 3
    controller.reset(channel=2)
    assert [one[:3] for one in signals.open_signals()] == [(5, 1, 0), (7, 1, 1)]


def test_wait_for_reads_again_in_later_ticks() -> None:
    """Channel 2 writes in tick 3. A synchronous variable is read at the end of a tick (RC-005),
    here of 0, 2 and 4: the decoder waits one tick between two reads; the message is taken in 5."""
    found = run(["#WAIT FOR V.E.SHARED > 1", '#MSG ["on"]'], ["G04 0.003", "V.E.SHARED = 2"])
    assert [(one.tick, one.text) for one in found.events if one.kind == "message"] == [(5, "on")]


def test_a_signal_that_nobody_sends_is_reported_before_the_first_tick() -> None:
    """Numbers that are computed may fit any."""
    assert numbers(run(["#WAIT [ID=1 CH=2]"], ["#SIGNAL [ID=2 CH=1]"])) == [901505, 901506]
    assert numbers(run(["#WAIT [ID=1 CH=2]"], ["P1 = 1", "#SIGNAL [ID=P1 CH=1]"])) == []
    assert numbers(run(["#WAIT [ID=1]"], ["#SIGNAL [ID=1 CH=1]"])) == [901505, 901506]


def test_who_can_be_freed_from_outside_waits_to_the_limit() -> None:
    """With a PLC the run continues, and a note shows the reason at its end."""

    class Idle:
        def cycle(self, _hli: object) -> None:
            pass

    found = Controller(MACHINE).run(text("one", "#WAIT [ID=1 CH=2]"), plc=Idle(), ticks=5)
    assert (found.state, found.ticks) == ("limit", 5)
    assert "signal 1 of channel 2 (since 0.000000 s)" in found.diagnostics[-1].text("en")


# --- deadlocks in every order ---------------------------------------------------------------------

#: A step of a program: S1 sends signal 1 to the other channel, W1 waits for it.
STEPS = ("S1", "S2", "W1", "W2")
Program = tuple[str, ...]


def outcome(programs: tuple[Program, Program]) -> str:
    """What comes of two programs: ended, order (250002) or deadlock. No time is in it."""
    ways: tuple[deque[str], deque[str]] = (deque(), deque())
    at = [0, 0]
    moved = True
    while moved:
        moved = False
        for channel, program in enumerate(programs):
            while at[channel] < len(program):
                step, number = program[at[channel]]
                if step == "S":
                    ways[1 - channel].append(number)
                elif number not in ways[channel]:
                    break
                elif ways[channel][0] != number:
                    return "order"
                else:
                    ways[channel].popleft()
                at[channel] += 1
                moved = True
    return "ended" if at == [len(program) for program in programs] else "deadlock"


def written(program: Program, other: int, modes: random.Random) -> list[str]:
    """The blocks of a program, with and without SYN, with dwells of up to 2 ms in between."""
    lines = []
    for step, number in program:
        lines.append(f"G04 {modes.choice(('0', '0.001', '0.002'))}")
        word = "SIGNAL" if step == "S" else "WAIT"
        lines.append(f"#{word} {modes.choice(('', 'SYN'))} [ID={number} CH={other}]")
    return lines


def all_pairs(length: int) -> list[tuple[Program, Program]]:
    """Both programs, each of all programs of this many steps."""
    own = list(itertools.product(STEPS, repeat=length))
    return list(itertools.product(own, own))


def result(found: Run) -> str:
    """The outcome of a run, in the words of ``outcome``."""
    if found.state == "ended":
        return "ended"
    return "order" if 250002 in numbers(found) else "deadlock"


@pytest.mark.parametrize("seed", all_seeds(3, 1))
def test_each_pair_of_programs_ends_as_its_order_says(seed: int) -> None:
    """Where all steps have SYN, the times of the steps change nothing but the time of the end."""
    chance = random.Random(seed)
    pairs = chance.sample(all_pairs(2), 24)
    for pair in pairs:
        modes = random.Random(chance.random())
        lines = [written(program, 2 - i, modes) for i, program in enumerate(pair)]
        lines = [
            [line.replace("L  [", "L SYN [").replace("T  [", "T SYN [") for line in own]
            for own in lines
        ]
        assert result(run(*lines)) == outcome(pair), pair


@pytest.mark.parametrize("seed", all_seeds(3, 1))
def test_mixed_levels_end_the_same_each_time(seed: int) -> None:
    """With and without SYN: no run reaches its limit, and the same programs give the same bytes."""
    chance = random.Random(1000 + seed)
    for pair in chance.sample(all_pairs(2), 8):
        modes = random.Random(chance.random())
        one, two = (written(program, 2 - i, modes) for i, program in enumerate(pair))
        first, second = run(one, two), run(one, two)
        assert first.state in ("ended", "error")
        assert [str(event) for event in first.events] == [str(event) for event in second.events]
        if outcome(pair) == "ended":
            assert result(first) in ("ended", "order")


def test_wait_indp_waits_for_the_axes_that_cycles_move() -> None:
    """The cycle moves X by 1 mm (500 mm/s at most): the message comes when it is there."""
    cycle = [
        "#RT CYCLE [SCOPE=PROG]",
        "$IF ONCE V.RTA.ACS.ACT_POS.X == 0",
        "X[INDP G90 G00 POS=1]",
        "$ENDIF",
        "#RT CYCLE END",
        "G04 0.002",
    ]
    found = Controller().run(text("one", *cycle, "#WAIT INDP [X]", '#MSG ["there"]'))
    assert found.state == "ended", found.diagnostics
    (tick,) = [one.tick for one in found.events if one.kind == "message"]
    (end,) = [one.tick for one in found.events if one.text == "X done"]
    assert tick == end + 1


def test_a_picture_has_a_lane_for_each_channel_and_an_arrow_for_each_signal() -> None:
    """Channel 2 waits for 3 ms; its decoder's wait is in its own lane."""
    found = run(
        ["G04 0.003", "#SIGNAL SYN [ID=1 CH=2]", "#WAIT [ID=2 CH=2]"],
        ["#WAIT SYN [ID=1 CH=1]", "#SIGNAL SYN [ID=2 CH=1]"],
    )
    timeline = timeline_of(
        found.events,
        None,
        cycle_time_us=1000,
        first_tick=0,
        ticks=found.ticks,
        line_at=lambda _: "",
    )
    rows = {track.label: track.slices for track in timeline.of("channel")}
    assert list(rows) == ["CH1", "CH1 decoder", "CH2"]
    shown = {
        label: [(one.name, one.begin_us, one.end_us) for one in own] for label, own in rows.items()
    }
    assert shown == {
        "CH1": [("1 → CH2", 3000, 3000)],
        "CH1 decoder": [("2 ← CH2", 0, 4000)],
        "CH2": [("1 ← CH1", 0, 3000), ("2 → CH1", 3000, 3000)],
    }
    arrows = [
        (one.name, one.sender, one.sent_us, one.receiver, one.taken_us) for one in timeline.signals
    ]
    assert arrows == [("1", "CH1", 3000, "CH2", 3000), ("2", "CH2", 3000, "CH1 decoder", 4000)]
    programs = {
        track.label: [(one.begin_us, one.end_us) for one in track.slices]
        for track in timeline.of("program")
    }
    assert programs == {"CH1": [(0, 4000)], "CH2": [(0, 3000)]}


def test_the_example_runs_as_its_comments_say() -> None:
    """0.6 s, 0.4 s and a tick to channel 1, 0.6 s back: the message comes at 1.601 s."""
    folder = Path(__file__).parents[2] / "examples" / "channels"
    found = Controller(folder / "machine").run(
        folder / "load.nc", channels={2: [folder / "unload.nc"]}
    )
    assert [one.tick for one in found.events if one.kind == "message"] == [1601]
    assert found.state == "ended"


def test_signals_and_waits_are_part_of_a_snapshot() -> None:
    """Everything with SYN is in the queues; put back, the ticks are the same again."""
    controller = Controller(MACHINE)
    controller.start(text("one", "G04 0.005", "#SIGNAL SYN [ID=1 CH=2]", "#WAIT SYN [ID=2 CH=2]"))
    controller.start(
        text("two", "#SIGNAL SYN [ID=3]", "#WAIT SYN [ID=1 CH=1]", "#SIGNAL SYN [ID=2 CH=1]"),
        channel=2,
    )
    controller.step(2)
    machine = machine_of(controller)
    kept = Snapshot(machine.realtime)
    first = [str(event) for event in controller.step(4).events]
    assert machine.kernel.signals.count == 2
    kept.put_back()
    assert machine.kernel.signals.count == 1
    assert [str(event) for event in controller.step(4).events] == first
    assert "CH2 signal 1 taken CH1 5000" in first


def test_signals_wait_in_realtime_loops() -> None:
    """Each pass sends and takes one: page 783727499 permits both with SYN, else 22073."""
    lines = [
        "V.RTG.LOOP.ENABLED = TRUE",
        "#RT CYCLE [SCOPE=PROG]",
        "$IF V.RTG.LOOP.COUNT >= 2",
        "V.RTG.LOOP.ENABLED = FALSE",
        "$ENDIF",
        "#RT CYCLE END",
        "G01 F6000",
        "#RT WHILE",
        "G02 X20 R10",
        "#SIGNAL SYN [ID=3 CH=1]",
        "G02 X0 R10",
        "#WAIT SYN [ID=3 CH=1]",
        "#RT ENDWHILE",
    ]
    found = Controller().run(text("one", *lines))
    assert found.state == "ended", found.diagnostics
    words = [one.text.split()[1] for one in found.events if one.kind == "signal"]
    assert words == 3 * ["sent", "taken"]
    lines[11] = "#WAIT [ID=3 CH=1]"
    assert numbers(Controller().run(text("one", *lines))) == [22073]
