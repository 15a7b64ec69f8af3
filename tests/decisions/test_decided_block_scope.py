# SPDX-License-Identifier: MIT
"""Which block a realtime cycle with scope BLOCK runs in (RC-105): waiting counts."""

from __future__ import annotations

from dataclasses import replace

import pytest
from support.decided import machine, numbers, perform, reported

from nctakt.results.run import Run
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller

CYCLE = "#RT CYCLE [ID=1 SCOPE=BLOCK]\nV.E.COUNT += 1\n#RT CYCLE END\n"


def of_block(program: str, **settings: object) -> tuple[int, int, Run]:
    """The ticks of the first and of the last run-through, and the run."""
    run = perform(f"{CYCLE}{program}\nM30", **settings)
    assert run.errors == (), run.errors
    writes = [event.tick for event in run.events if event.kind == "written" and event.cycle]
    assert writes == list(range(writes[0], writes[-1] + 1))
    assert reported(run, "ended") == [f"{writes[-1] + 1} ended 1 scope"]
    return writes[0], writes[-1], run


@pytest.mark.parametrize(
    ("program", "last"),
    [
        ("M111\nG04 0.005", 0),  # the PLC's answer counts from the next tick on
        ("#FLUSH WAIT\nG04 0.005", 0),
        ("V.E.VALUE1 = V.E.SYNC\nG04 0.005", 0),  # a synchronous read empties the channel
        ("#TIME 0.003\nG04 0.005", 2),
        ("G04 0.004\nG04 0.005", 3),
        ("N10 G00 X0.1\nG04 0.005", 9),
        ("N10 G00 X0.1 M111\nG04 0.005", 10),  # one tick for the function, ten for the motion
        ("N10 G00 X0.1 M113\nG04 0.005", 10),  # the function after the motion
        ("N10 G00 X0.1 M111 M113\nG04 0.005", 11),
        ("N10 G00 X0.1 M100\nG04 0.005", 9),
    ],
)
def test_the_block_lasts_as_long_as_it_moves_or_waits(program: str, last: int) -> None:
    """RC-105: from its first tick to that of its last increment or wait."""
    assert of_block(program)[:2] == (0, last)


@pytest.mark.parametrize(
    ("program", "last"),
    [
        ("$FOR P1 = 1, 3, 1\nN10 M111\n$ENDFOR", 0),
        ("$FOR P1 = 1, 3, 1\nN10 #FLUSH WAIT\n$ENDFOR", 0),
        ("$FOR P1 = 1, 3, 1\nN10 G04 0.002\n$ENDFOR", 1),
        ("$FOR P1 = 1, 3, 1\nN10 G91 G00 X0.1 M111\n$ENDFOR", 10),
        ("$FOR P1 = 1, 3, 1\nN10 G91 G00 X0.1 M113\n$ENDFOR", 10),
    ],
)
def test_each_execution_of_a_line_is_a_block(program: str, last: int) -> None:
    """RC-105: a loop of one line repeats the block; the cycle belongs to the first one."""
    assert of_block(program)[:2] == (0, last)


def test_a_spindle_that_is_waited_for_is_the_block() -> None:
    """RC-105: with m3_synch MVS_SVS the program waits until the spindle has its speed."""
    demo = machine()
    (channel,) = demo.channels
    main = channel.parameters.spindles[0]
    jobs = {name: replace(job, synchronisation="MVS_SVS") for name, job in main.functions.items()}
    spindles = (replace(main, functions=jobs), *channel.parameters.spindles[1:])
    parameters = replace(channel.parameters, spindles=spindles)
    changed = replace(demo, channels=(replace(channel, parameters=parameters),))
    first, last, run = of_block("M3 S600\nG04 0.005", controller=Controller(changed))
    (reached,) = [event.tick for event in run.events if event.kind == "spindle_reached"]
    assert (first, last) == (0, reached)


def test_blocks_that_take_no_time_are_reported() -> None:
    """RC-105: they do not use the cycle up; each is a note at its place (901049)."""
    first, last, run = of_block('M100\nV.E.VALUE1 = 7\n#MSG ["here"]\nG04 0.003\nM100')
    assert (first, last) == (0, 2)
    assert numbers(run) == [901049] * 3
    assert [found.span and found.span.line for found in run.diagnostics] == [4, 5, 6]


@pytest.mark.parametrize(
    "empty",
    [
        "G04 X0",
        "G04 0",
        "#TIME 0",
        "G00 X0",
        "G01 X0 F1000",
        "G91 X0 F1000\nG90",
        "X0 M100",
    ],
)
def test_a_motion_or_dwell_of_no_tick_is_passed_over_and_reported(empty: str) -> None:
    """RC-105: a block that stays where the path is, or waits for no time, is not the block."""
    first, last, run = of_block(f"{empty}\nG04 0.003\nG00 X0")
    assert (first, last) == (0, 2)
    assert numbers(run) == [901049]
    assert [found.span and found.span.line for found in run.diagnostics] == [4]


def test_an_empty_motion_with_a_function_that_waits_is_the_block() -> None:
    """RC-105: what is on one line is one block; after it nothing is passed over."""
    first, last, run = of_block("X0 M111\nG00 X0\nG04 0.003")
    assert (first, last) == (0, 0)
    assert numbers(run) == []


def test_a_started_cycle_passes_over_empty_blocks_too() -> None:
    """RC-105: START arms a cycle that was defined with DEF."""
    text = (
        CYCLE.replace("[ID=1", "DEF [ID=1") + "G04 0\n#RT CYCLE START [ID=1]\nG04 0\nG04 0.002\nM30"
    )
    run = perform(text)
    assert numbers(run) == [901049]
    assert [found.span and found.span.line for found in run.diagnostics] == [6]


def test_a_cycle_that_is_held_meanwhile_leaves_its_block_like_the_others() -> None:
    """RC-105, RC-111: an ID that is free again after a wait can be used in the next line."""
    again = CYCLE.replace("+= 1", "+= 10")
    run = perform(f"{CYCLE}M111\n{again}G04 0.002\nM30")
    assert run.errors == ()
    assert reported(run, "written") == [
        "0 written V.E.COUNT 1",
        "1 written V.E.COUNT 11",
        "2 written V.E.COUNT 21",
    ]


def test_managing_cycles_is_no_block_of_theirs() -> None:
    """RC-105: DELETE and its position request take a tick, but the block is the dwell."""
    other = "#RT CYCLE [ID=2]\nV.E.VALUE = 1\n#RT CYCLE END\n"
    run = perform(f"{other}{CYCLE}#RT CYCLE DELETE [ID=2]\nG04 0.003\nM30")
    counts = [line for line in reported(run, "written") if "COUNT" in line]
    assert [line.split()[-1] for line in counts] == ["1", "2", "3"]
    assert run.errors == ()


@pytest.mark.parametrize("fault", range(1, 11))
def test_a_block_that_brakes_to_its_end_is_over_after_a_fault(fault: int) -> None:
    """RC-105, RC-505, MO-14: G00 X0.1 takes ten ticks, the last five of which brake.

    A fault in the first five stops the path within the block, whose cycle stays. From the sixth on
    the path has stopped at the block's end with its tenth tick: the cycle ends in the next one.
    """
    faulty = "#RT CYCLE [ID=2]\nV.E.VALUE1 = 6 / [V.E.TRIGGER - 2]\n#RT CYCLE END\n"
    run = perform(
        f"{faulty}{CYCLE}G00 X0.1\nG04 0.01\nM30",
        at=[Stimulus(f"{fault - 1} ms", "V.E.TRIGGER", 2)],
        after="20 ms",
    )
    ended = ["10 ended 1 scope"] if fault > 5 else []
    of_fault = [f"{fault - 1} ended 2 error"]
    assert reported(run, "ended") == sorted(of_fault + ended, key=lambda line: int(line.split()[0]))


@pytest.mark.parametrize("end", ["M30", "X999999\nM30", "#FLUSH WAIT\nG04 10\nM30"])
@pytest.mark.parametrize("start", ["", "#RT CYCLE START [ID=1]\n"])
def test_no_block_cycle_outlives_its_program(start: str, end: str) -> None:
    """RC-105, RC-007: neither its end, nor an error and reset, nor a limit leaves one behind."""
    controller = Controller()
    defined = CYCLE.replace("[ID=1", "DEF [ID=1")
    perform(f"{defined}{start}{end}", controller, until=0.005)
    assert numbers(perform("#RT CYCLE START [ID=1]\nG04 0\nM30", controller)) == [50858]
