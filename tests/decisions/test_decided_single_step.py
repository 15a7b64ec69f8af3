# SPDX-License-Identifier: MIT
"""#SINGLE STEP: parts of a program that single block runs through; docs/conformance.md."""

from __future__ import annotations

from decided import perform, told

from nctakt.messages.motion import COMMAND_WORD_NOT_SIMULATED
from nctakt.run.controller import Controller
from nctakt.run.stimuli import Stimulus

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


def pauses(text: str, controller: Controller | None = None) -> list[int]:
    """The lines in front of which single block stops; START follows at once."""
    at = [Stimulus("0 s", "HLI.SINGLE_BLOCK", 1.0)]
    at += [Stimulus(f"{500 * n} ms", "HLI.START", 1.0) for n in range(1, 12)]
    run = perform(text, controller, at=at)
    assert run.state == "ended", run.diagnostics
    return [event.span.line for event in run.events if event.kind == "paused" and event.span]


def test_a_part_is_run_through() -> None:
    """207618443: subprograms included, a second DISABLE changes nothing."""
    assert pauses(f"{SUB}{PROGRAM}") == [7, 12]
    without = "\n".join(line for line in PROGRAM.splitlines() if "STEP" not in line)
    assert pauses(f"{SUB}{without}\n") == [7, 2, 3, 9]


def test_it_ends_with_its_program() -> None:
    """The next program has single block again, also behind a reset."""
    controller = Controller()
    assert pauses("#SINGLE STEP [DISABLE]\nG00 X1\nX2\nM30\n", controller) == []
    assert pauses("G00 X1\nX2\nM30\n", controller) == [2]


def test_without_single_block_it_changes_nothing() -> None:
    """The path does not stop at it."""
    text = "G01 F6000 G261\nX10\n{}\nX20 Y1\nM30"
    ticks = [
        told(perform(text.format(word)), "end")[-1].split()[0]
        for word in ("#SINGLE STEP [DISABLE]", "#SINGLE STEP [ENABLE]", "")
    ]
    assert len(set(ticks)) == 1


def test_the_distance_of_blocks_is_refused() -> None:
    """RESOLUTION by name, others as misspelt."""
    found = perform("#SINGLE STEP [RESOLUTION=10]\nM30").diagnostics
    assert [one.message.id for one in found] == [COMMAND_WORD_NOT_SIMULATED.id]
    assert perform("#SINGLE STEP [DISABEL]\nM30").state != "ended"
    assert perform("#SINGLE STEP\nM30").state != "ended"
