# SPDX-License-Identifier: MIT
"""Modal calls: where they end, and what they do not follow (nc-programs, calls)."""

from __future__ import annotations

import pytest

from nctakt.run.controller import Controller, NcText

CALL = "LL CYCLE [NAME=SUB MODAL_{kind}]\n"
SUB = '%L SUB\n#MSG ["s"]\nM17\n'


def messages(text: str) -> str:
    """The messages of a program without errors, one after the other."""
    run = Controller().run(NcText("p.nc", text), ticks=2000)
    assert not run.errors, run.errors
    assert run.state == "ended"
    return " ".join(event.text for event in run.events if event.kind == "message")


@pytest.mark.parametrize(
    ("kind", "block", "calls"),
    [
        ("MOVE", "X1", 2),
        ("MOVE", "G02 I1 F6000", 2),
        ("MOVE", "X0", 2),
        ("MOVE", "G92 X1", 1),
        ("MOVE", "F100 M100", 1),
        ("MOVE", "#TIME 0.001", 1),
        ("MOVE", '"A" = "X1"\n"A"', 2),
        ("MOVE", '"A" = "X1 P1=2"\n"A"', 2),
        ("MOVE", "; X1\n\n(X1)", 1),
        ("BLOCK", "; X1\n\n(X1)", 1),
        ("BLOCK", "F100", 2),
        ("BLOCK", "P1=1 P2=2 X1", 2),
        ("BLOCK", "#TIME 0.001", 2),
        ("BLOCK", '#FLUSH WAIT\n#MSG ["m"]', 3),
        ("BLOCK", "$GOTO [A]\nX1\n[A] X2", 2),
        ("BLOCK", "$FOR P1 = 1, 3, 1\nX=P1\n$ENDFOR", 4),
        ("MOVE", "$FOR P1 = 1, 3, 1\nX=P1\n$ENDFOR", 4),
        ("BLOCK", "LL OTHER", 1),
        ("MOVE", "X1 LL OTHER", 1),
        ("MOVE", "X1\n#DISABLE MODAL CYCLE\nX2", 2),
        ("BLOCK", "X1\n#DISABLE MODAL CYCLE\nX2", 2),
    ],
)
def test_a_call_follows_what_the_manual_names(kind: str, block: str, calls: int) -> None:
    """The call itself once; then after motions or blocks, not after calls and control words."""
    text = f"{SUB}%L OTHER\nX5\nM17\n%MAIN\nG00\n{CALL.format(kind=kind)}{block}\nM30"
    assert messages(text).split().count("s") == calls


def test_a_modal_call_ends_with_its_program() -> None:
    """M17 ends it; the caller's own is in force again (#DISABLE MODAL CYCLE, M17)."""
    other = '%L OTHER\nX1\nLL CYCLE [NAME=INNER MODAL]\nX2\nM17\n%L INNER\n#MSG ["i"]\nM17\n'
    text = f"{SUB}{other}%MAIN\nG00\n{CALL.format(kind='MOVE')}LL OTHER\nX3\nM30"
    assert messages(text) == "s i i s"


def test_another_modal_call_takes_the_place_of_the_first() -> None:
    """One program has one modal call; a call without MODAL leaves it as it is."""
    other = '%L OTHER\n#MSG ["o @%d", @P1]\nM17\n'
    call = "LL CYCLE [NAME=OTHER MODAL_MOVE @P1=4]\n"
    text = f"{SUB}{other}%MAIN\nG00\n{CALL.format(kind='MOVE')}X1\n{call}X2\nLL SUB\nX3\nM30"
    assert messages(text) == "s s o @4 o @4 s o @4"


def test_the_values_of_a_call_are_not_changed_by_its_runs() -> None:
    """Each run gets what the call has handed over when it was decoded."""
    sub = '%L SUB\n#MSG ["%d", @P1]\n@P1 = @P1 + 1\n#MSG ["%d", @P1]\nM17\n'
    text = f"{sub}%MAIN\nP1=1\nLL CYCLE [NAME=SUB MODAL_MOVE @P1=P1]\nP1=5\nG00 X1\nM30"
    assert messages(text) == "1 2 1 2"


def test_m17_of_a_modal_cycle_may_jump() -> None:
    """A return with a label goes on there in the program that has called."""
    sub = '%L SUB\n#MSG ["s"]\nP1 = P1 + 1\n$IF P1 == 2\nM17 [LAST]\n$ENDIF\nM17\n'
    text = f"{sub}%MAIN\nG00\n{CALL.format(kind='MOVE')}X1\nX2\nX3\n[LAST]\nM30"
    assert messages(text) == "s s"


def test_a_program_that_ends_after_a_motion_without_m30() -> None:
    """The end of the text is the end of the program: the last motion has its call."""
    assert messages(f"{SUB}%MAIN\nG00\n{CALL.format(kind='MOVE')}X1\n") == "s s"
