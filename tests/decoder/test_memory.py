# SPDX-License-Identifier: MIT
"""P-CHAN-00407: what realtime cycles take of their memory, and what happens when it is used up."""

from __future__ import annotations

import dataclasses

import pytest

from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText

#: 64 for the cycle, 5 places of 16, two statements of 24, nine nodes of 8: the comparison and its
#: two sides, the target, the sum and its left side, the product and its two sides.
CYCLE = """#RT CYCLE [ID = {id} SCOPE = PROG]
  $IF V.E.VALUE > 5
    V.E.VALUE1 = V.E.VALUE + 2 * V.E.VALUE2
  $ENDIF
#RT CYCLE END
"""
BYTES = 64 + 5 * 16 + 2 * 24 + 9 * 8


def machine(memory_bytes: int) -> Machine:
    """The demo machine with another memory for realtime cycles."""
    demo = load_machine(None)
    channel = demo.channels[0]
    limits = dataclasses.replace(channel.parameters.realtime_cycles, memory_bytes=memory_bytes)
    parameters = dataclasses.replace(channel.parameters, realtime_cycles=limits)
    return dataclasses.replace(
        demo, channels=(dataclasses.replace(channel, parameters=parameters),)
    )


def run(memory_bytes: int, *ids: int) -> Run:
    """Define this many cycles, one a tick."""
    text = "#TIME 0.001\n".join(CYCLE.format(id=identity) for identity in ids)
    return Controller(machine(memory_bytes)).run(NcText("memory.nc", text + "M30\n"))


@pytest.mark.parametrize(
    ("memory_bytes", "numbers"), [(2 * BYTES - 1, [50855]), (2 * BYTES, []), (2 * BYTES + 1, [])]
)
def test_memory_of_two_cycles(memory_bytes: int, numbers: list[int]) -> None:
    """RC-504: cycles fit up to the last byte of P-CHAN-00407; one more is 50855."""
    found = run(memory_bytes, 1, 2)
    assert [error.id for error in found.errors] == numbers


def test_the_message_names_needed_and_free_bytes() -> None:
    """RC-504: 50855 says how many bytes are needed and how many are free."""
    (error,) = run(BYTES + 10, 1, 2).errors
    assert error.values == {"needed": BYTES, "free": 10}


@pytest.mark.parametrize(("memory_bytes", "numbers"), [(BYTES - 1, [50857]), (BYTES, [])])
def test_memory_of_a_single_cycle(memory_bytes: int, numbers: list[int]) -> None:
    """RC-504: a cycle that is larger than the whole memory is 50857."""
    assert [error.id for error in run(memory_bytes, 1).errors] == numbers


def test_memory_is_free_again_after_delete() -> None:
    """RC-111, RC-504: a deleted cycle gives its memory back."""
    text = CYCLE.format(id=1) + "#RT CYCLE DELETE [ID = 1]\n" + CYCLE.format(id=2) + "M30\n"
    found = Controller(machine(BYTES)).run(NcText("memory.nc", text))
    assert found.errors == ()
