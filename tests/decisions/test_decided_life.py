# SPDX-License-Identifier: MIT
"""Decisions on the life of realtime cycles: scopes, management commands, reset, limits of slots."""

from __future__ import annotations

import pytest
from support.decided import left, machine, numbers, perform, reported

from nctakt.run.controller import Controller, NcText

COUNTING = """
#RT CYCLE [ID=1 SCOPE={scope}]
  V.E.COUNT += 1
#RT CYCLE END
"""


def test_a_definition_without_scope_lives_as_long_as_its_program() -> None:
    """RC-104: SCOPE omitted is PROG, neither one block nor forever."""
    run = perform(
        "#RT CYCLE [ID=1]\nV.E.COUNT += 1\n#RT CYCLE END\n#TIME 0.003\n#TIME 0.002\nM30",
        after="5 ms",
    )
    assert reported(run, "created", "ended", "end") == [
        "0 created 1 PROG",
        "5 ended 1 scope",
        "5 end part.nc",
    ]
    assert run.cycles[0].runs == 5


def test_a_block_cycle_whose_program_ends_first_never_runs() -> None:
    """RC-105: ended with the program, without a run-through, and a notice reports it (900413).

    M30 waits one tick, since the cycle was started in its tick (RC-004).
    """
    run = perform(COUNTING.format(scope="BLOCK") + "M30")
    assert reported(run, "started", "notice", "ended", "end") == [
        "0 started 1",
        "1 notice 900413",
        "1 ended 1 scope",
        "1 end part.nc",
    ]
    assert run.cycles[0].runs == 0
    assert numbers(run) == [900413]


def test_cycles_end_in_the_order_of_their_creation_before_the_program_does() -> None:
    """RC-106: at M30 each cycle reports its end, then the program does."""
    other = COUNTING.format(scope="PROG").replace("ID=1", "ID=2")
    run = perform(other + COUNTING.format(scope="PROG") + "#TIME 0.001\nM30")
    assert reported(run, "ended", "end") == ["1 ended 2 scope", "1 ended 1 scope", "1 end part.nc"]


def test_hold_and_continue_where_they_change_nothing_are_noticed() -> None:
    """RC-111: HOLD of a held cycle is 900411, CONTINUE of a running one 900412: notices."""
    run = perform(
        COUNTING.format(scope="PROG")
        + "#TIME 0.001\n#RT CYCLE CONTINUE [ID=1]\n"
        + "#RT CYCLE HOLD [ID=1]\n" * 2
        + "M30"
    )
    assert reported(run, "notice", "held") == ["1 notice 900412", "1 held 1", "1 notice 900411"]
    assert run.state == "ended"
    assert numbers(run) == [900412, 900411]
    assert [found.span and found.span.line for found in run.diagnostics] == [6, 8]


def test_a_notice_of_a_loop_is_one_diagnostic() -> None:
    """RC-603, level 2: an event for each time, a diagnostic for each place."""
    run = perform("$FOR P1 = 1, 4, 1\n#RT CYCLE DELETE [ID=7]\n$ENDFOR\nM30")
    assert reported(run, "notice") == [f"{tick} notice 900410" for tick in range(4)]
    assert numbers(run) == [900410]
    assert numbers(perform("#RT CYCLE DELETE [ID=7]\nM30", Controller())) == [900410]


def test_deleting_an_unknown_id_is_harmless() -> None:
    """RC-111: DELETE of an ID that names no cycle is a notice (900410)."""
    run = perform("#RT CYCLE DELETE [ID=7]\nM30")
    assert reported(run) == ["0 notice 900410", "1 end part.nc"]
    assert run.state == "ended"
    assert numbers(run) == [900410]


def test_abort_action_leaves_the_cycle_running() -> None:
    """RC-111: the cycle goes on with its states; only its actions would be aborted."""
    run = perform(
        COUNTING.format(scope="PROG")
        + "#TIME 0.002\n#RT CYCLE ABORT ACTION [ID=1]\n#TIME 0.002\nM30"
    )
    assert reported(run, "aborted") == ["2 aborted 1"]
    assert run.cycles[0].runs == 4


def test_a_reset_deletes_all_but_global_cycles_and_nothing_runs_in_it() -> None:
    """RC-007: at least one tick without a run-through; GLOBAL cycles keep states and go on."""
    controller = Controller()
    text = COUNTING.format(scope="GLOBAL") + COUNTING.format(scope="PROG").replace(
        "ID=1", "ID=2"
    ).replace("COUNT", "COUNT_POS")
    controller.start(NcText("part.nc", text + "#TIME 10\nM30"))
    controller.step(3)
    assert (controller.read("V.E.COUNT"), controller.read("V.E.COUNT_POS")) == (3, 3)
    before = controller.tick
    controller.reset()
    assert controller.tick == before + 1
    assert controller.state == "ready"
    controller.step(2)
    assert (controller.read("V.E.COUNT"), controller.read("V.E.COUNT_POS")) == (5, 3)


def test_a_reset_brakes_the_path_before_it_is_over() -> None:
    """RC-007, MO-6: X brakes with 4000 mm/s² from 400 mm/s, 100 ticks; the rest is dropped."""
    controller = Controller()
    controller.start(NcText("part.nc", "G00 X300\nM30"))
    controller.step(100)
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 20.0
    controller.reset()
    assert controller.tick == 200
    assert abs(float(controller.read("V.RTA.ACS.ACT_POS.X")) - 40.0) < 1e-9


def many_cycles(count: int) -> str:
    """A program with this many PROG cycles at once."""
    one = "#RT CYCLE [SCOPE=PROG]\nV.E.COUNT += 1\n#RT CYCLE END\n"
    return one * count + "#TIME 0.001\nM30"


def test_a_channel_holds_256_cycles_at_once() -> None:
    """50877 is the 257th; 256 run."""
    roomy = machine(memory_bytes=1_000_000)
    controller = Controller(roomy)
    assert perform(many_cycles(256), controller).state == "ended"
    assert controller.read("V.E.COUNT") == 256
    run = perform(many_cycles(257), Controller(roomy))
    assert (run.state, numbers(run)) == ("error", [50877])


def test_the_decoder_waits_for_cycles_to_end() -> None:
    """However many definitions a program executes, those that have ended give their slots back."""
    text = "$FOR P1 = 1, 600, 1\n#RT CYCLE [SCOPE=BLOCK]\nV.E.COUNT += 1\n#RT CYCLE END\n"
    assert left(text + "#TIME 0.001\n$ENDFOR\nM30", "V.E.COUNT") == 600


@pytest.mark.parametrize("command", ["#RT CYCLE [ID = {}]", "#RT CYCLE DELETE [ID = {}]"])
def test_ids_end_at_2147483647(command: str) -> None:
    """RC-103: one more is 50875, as a number and computed, however large it is."""
    end = "" if "DELETE" in command else "#RT CYCLE END\n"
    for text, errors in (
        ("2147483647", []),
        ("2147483648", [50875]),
        ("P1", [50875]),
        ("5" * 70, [50875]),
    ):
        run = perform(f"P1 = 1{'0' * 40}\n{command.format(text)}\n{end}M30")
        assert [found.id for found in run.errors] == errors, text
