# SPDX-License-Identifier: MIT
"""#SINGLE STEP: parts of a program that single block runs through; docs/conformance/backward.md."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from support.decided import perform, reported

from nctakt.lists.machine.channel_configuration import ALL_LINES, EFFECTIVE_BLOCKS, ONLY_MOTIONS
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.messages.programs.checked_blocks import (
    INVALID_COMMAND_FORM,
    UNKNOWN_COMMAND_OPTION,
    WORD_VALUE_MISSING,
)
from nctakt.messages.programs.single_steps import NEGATIVE_RESOLUTION, SINGLE_STEP_WORDS
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller

PROGRAM = """G00 X1
#SINGLE STEP [DISABLE]
X2
#SINGLE STEP [DISABLE]
LL SUB
#SINGLE STEP [ENABLE]
X4
M30
"""
SUB = "%L SUB\nX3\nX2\nM17\n%MAIN\n"


def pauses(text: str, controller: Controller | None = None, **options: Any) -> list[int]:
    """The lines before which single block stops; START follows at once."""
    at = [Stimulus("0 s", "HLI.SINGLE_BLOCK", 1.0)]
    at += [Stimulus(f"{500 * n} ms", "HLI.START", 1.0) for n in range(1, 12)]
    run = perform(text, controller, at=at, **options)
    assert run.state == "ended", run.diagnostics
    return [event.span.line for event in run.events if event.kind == "paused" and event.span]


def test_a_part_is_run_through() -> None:
    """207618443: subprograms included, a second DISABLE changes nothing."""
    assert pauses(f"{SUB}{PROGRAM}") == [7, 12]
    without = "\n".join(line for line in PROGRAM.splitlines() if "STEP" not in line)
    assert pauses(f"{SUB}{without}\n") == [7, 2, 3, 9]


def test_it_ends_with_its_program() -> None:
    """The next program has single block again, also after a reset."""
    controller = Controller()
    assert pauses("#SINGLE STEP [DISABLE]\nG00 X1\nX2\nM30\n", controller) == []
    assert pauses("G00 X1\nX2\nM30\n", controller) == [2]


def test_without_single_block_it_changes_nothing() -> None:
    """The path does not stop at it."""
    text = "G01 F6000 G261\nX10\n{}\nX20 Y1\nM30"
    ticks = [
        reported(perform(text.format(word)), "end")[-1].split()[0]
        for word in ("#SINGLE STEP [DISABLE]", "#SINGLE STEP [ENABLE]", "")
    ]
    assert len(set(ticks)) == 1


def machine_that_stops(where: int) -> Machine:
    """The demo machine with another P-CHAN-00015."""
    demo = load_machine(None)
    (channel,) = demo.channels
    parameters = replace(channel.parameters, single_block=where)
    return replace(demo, channels=(replace(channel, parameters=parameters),))


LINES = """N10 G01 X1 F6000
N20 P1 = 3
(a comment)
/N25 P1 = 4
N30 $IF P1 == 3
N40 M8
N50 $ENDIF
N60 M9 X2
N70 G04 0.01
N80 #MSG ["a"]
M30
"""


@pytest.mark.parametrize(
    ("where", "lines"),
    [(ONLY_MOTIONS, [8]), (EFFECTIVE_BLOCKS, [6, 8, 9, 10]), (ALL_LINES, [2, 5, 6, 8, 9, 10, 11])],
)
def test_blocks_that_count(where: int, lines: list[int]) -> None:
    """P-CHAN-00015: before motions alone, of what does something, of all but comments."""
    controller = Controller(machine_that_stops(where))
    assert pauses(LINES, controller, skip=(1,)) == lines


@pytest.mark.parametrize("where", [ONLY_MOTIONS, EFFECTIVE_BLOCKS, ALL_LINES])
def test_events_of_blocks_change_nothing(where: int) -> None:
    """A run with an event for each block stops where it stops without them."""
    expected = pauses(LINES, Controller(machine_that_stops(where)))
    assert pauses(LINES, Controller(machine_that_stops(where)), blocks=True) == expected


def test_all_lines_count_around_a_corner() -> None:
    """Where the decoder holds motions back for the tool's radius, each line is stopped at, too."""
    text = "G41 G01 X10 F6000 D1\nX20\nP1 = 1\nY10\nG40 X0\nM30\n"
    assert pauses(text, Controller(machine_that_stops(ALL_LINES))) == [2, 3, 4, 5, 6]


NUMBERED = """N10 G01 X10 F6000
N11 X20
N12 Y10
X30
N20 X40
N21 M8
N22 X50
N30 #SINGLE STEP [RESOLUTION={}]
N31 X60
N40 X70
M30
"""


@pytest.mark.parametrize(
    ("first", "then", "lines"),
    [
        (10, 1, [2, 6, 9, 10, 11]),
        (11, 10, [3, 8, 11]),
        (1, 0, [2, 3, 4, 6, 7, 8, 9, 10, 11]),
        (0, 20, [2, 3, 4, 5, 6, 7, 8, 9, 11]),
    ],
)
def test_numbers_of_blocks_that_count(first: int, then: int, lines: list[int]) -> None:
    """207618443: multiples of RESOLUTION, from the next block on; 1: all numbers, 0: all blocks."""
    text = f"#SINGLE STEP [RESOLUTION={first}]\n{NUMBERED.format(then)}"
    assert pauses(text) == lines


def test_the_path_runs_through_other_numbers() -> None:
    """Between two blocks that count the path does not stop."""
    text = "N10 #SINGLE STEP [RESOLUTION=10]\nG01 G261 F6000\n{}\nN30 Y10\nM30"
    rounded = "N11 X10\nN12 X20\nN13 X30"
    at = [Stimulus("0 s", "HLI.SINGLE_BLOCK", 1.0), Stimulus("1 s", "HLI.START", 1.0)]
    ticks = [
        next(event.tick for event in perform(text.format(way), at=at).events if str(event))
        for way in (rounded, "N11 X30")
    ]
    assert ticks[0] == ticks[1]


def test_resolution_ends_with_its_program() -> None:
    """The next program stops at each block again."""
    controller = Controller()
    assert pauses("N1 #SINGLE STEP [RESOLUTION=10]\nG00 X1\nX2\nM30\n", controller) == []
    assert pauses("G00 X1\nX2\nM30\n", controller) == [2]


@pytest.mark.parametrize(
    ("words", "number"),
    [
        ("[RESOLUTION=-1]", NEGATIVE_RESOLUTION.id),
        ("[RESOLUTION=P1-2]", NEGATIVE_RESOLUTION.id),
        ("[RESOLUTION]", WORD_VALUE_MISSING.id),
        ("[DISABLE RESOLUTION=10]", SINGLE_STEP_WORDS.id),
        ("[DISABEL]", UNKNOWN_COMMAND_OPTION.id),
        ("[]", INVALID_COMMAND_FORM.id),
        ("", INVALID_COMMAND_FORM.id),
    ],
)
def test_mistakes(words: str, number: int) -> None:
    """21743 for several keywords (255872395); no block number is a multiple of one below 0."""
    run = perform(f"P1 = 1\n#SINGLE STEP {words}\nM30")
    assert [one.message.id for one in run.diagnostics] == [number]
