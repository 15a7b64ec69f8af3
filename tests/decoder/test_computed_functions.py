# SPDX-License-Identifier: MIT
"""Functions whose numbers and values are computed: ``M[P1]``, ``M110=P1`` (nc-programs, words)."""

from __future__ import annotations

from dataclasses import replace

import pytest

from nctakt.lists.machine.machine import load_machine
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView


def events(text: str) -> list[str]:
    """The reports of a program without errors."""
    run = Controller().run(NcText("p.nc", text))
    assert not run.errors, run.errors
    return [f"{event.tick} {event}" for event in run.events]


@pytest.mark.parametrize(
    ("block", "reported"),
    [
        ("M[P1]", "0 output M 100"),
        ("MP1", "0 output M 100"),
        ("M=P1", "0 output M 100"),
        ("M[P1 + 0.4]=P2", "0 output M 100 = -3"),
        ("H[P1]=-2.5", "0 output H 100 = -2"),
        ("M100=2147483647", "0 output M 100 = 2147483647"),
        ("M100=-2147483648", "0 output M 100 = -2147483648"),
    ],
)
def test_numbers_and_values_are_rounded(block: str, reported: str) -> None:
    """As for any integer of the language: half to even (RC-307)."""
    assert events(f"P1=100 P2=-3\n{block}\nM30") == [reported, "0 end p.nc"]


def test_a_computed_number_counts_as_if_it_were_written() -> None:
    """G functions, spindles, calls and ends of programs among them."""
    run = Controller().run(NcText("p.nc", "P1=91 G[P1] G[P1-90] X5 F6000\nX5\nM[P1-61]\nX100"))
    assert not run.errors
    assert run.trace is not None
    assert run.trace["X.ACS.ACT_POS"][-1] == 10.0
    assert events("P1=3\nM[P1] S600\nM30")[0] == "0 spindle S M3 600"
    assert events("LL SUB\nM30\n%L SUB\nP1=17 M[P1]\nM100") == ["0 end p.nc"]
    assert events("P1=100\nM[P1] LL SUB\nM30\n%L SUB\nM17")[0] == "0 output M 100"


@pytest.mark.parametrize(
    ("block", "error"),
    [
        ("M[P1 - 200]", 20154),
        ("M[P1 + 400]", 20157),
        ("H[P1 + 400]", 20162),
        ("G[P1 + 136]", 900200),
        ("G[P1 + 400]", 20131),
        ("M[P1 - 83]", 20376),
        ("M100=[P1 * 1000000000]", 21494),
        ("M[P1 / 0]", 20396),
        ("G[P1 - 100] G[P1 - 99] X1", 20108),
    ],
)
def test_a_computed_number_that_is_none_ends_the_program(block: str, error: int) -> None:
    """Reported with its own number when the block is decoded, in both languages."""
    run = Controller().run(NcText("p.nc", f"P1=100\n{block}\nM30"))
    (found,) = run.errors
    assert (found.id, found.span.line if found.span else 0) == (error, 2)
    assert found.render("de")


def test_the_plc_finds_the_value_beside_the_function() -> None:
    """Facts 5: the value goes to the PLC together with the function; 0 without one."""

    class Observer:
        """Notes what waits."""

        def __init__(self) -> None:
            self.seen: list[tuple[str, int]] = []

        def cycle(self, hli: PlcView) -> None:
            """Called after each tick."""
            for entry in hli.functions():
                self.seen.append((entry.name, entry.value))
                hli.acknowledge(entry)

    plc = Observer()
    Controller().run(NcText("p.nc", "M111=-7\nM111\nM30"), plc=plc)
    assert plc.seen == [("M111", -7), ("M111", 0)]


def test_functions_of_the_controller_go_out_where_the_list_says_so() -> None:
    """M00, M17 and M30 are put out with an entry of the channel list only (P-CHAN-00041)."""
    assert events("M30=5") == ["0 end p.nc"]
    demo = load_machine(None)
    (channel,) = demo.channels
    own = dict(channel.parameters.m_functions)
    for number in (0, 17, 30):
        own[number] = replace(own[100], number=number)
    parameters = replace(channel.parameters, m_functions=own)
    controller = Controller(replace(demo, channels=(replace(channel, parameters=parameters),)))
    text = "LL SUB\nM00=1\nM30=5\n%L SUB\nM17"
    run = controller.run(NcText("p.nc", text), at=[Stimulus("3 ms", "HLI.START", 1.0)])
    assert [f"{event.tick} {event}" for event in run.events] == [
        "0 output M 17",
        "0 output M 0 = 1",
        "0 paused line 2",
        "3 output M 30 = 5",
        "3 end p.nc",
    ]


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ('V.P.T = "n = %d"\n#MSG [V.P.T, 5]', "n = 5"),
        ('V.E.TEXT = "%s!"\n#MSG [V.E.TEXT, V.E.TEXT]', "%s!!"),
        ('V.P.T = "x"\n#MSG [V.P.T + "%f", 1]', "x1.000000"),
    ],
)
def test_the_format_of_a_message_may_be_a_variable(text: str, shown: str) -> None:
    """nc-programs, #MSG: the format is what the variable holds when the block is decoded."""
    assert [line.split("message ")[1] for line in events(text + "\nM30")[:-1]] == [shown]


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ('V.P.T = "%d"\n#MSG [V.P.T]', 20721),
        ("V.P.T = 5\n#MSG [V.P.T]", 21460),
        ('V.P.T = "%y"\n#MSG [V.P.T, 1]', 20721),
    ],
)
def test_a_format_that_does_not_fit_ends_the_program(text: str, error: int) -> None:
    """What only the run shows is reported where the message is decoded."""
    run = Controller().run(NcText("p.nc", text + "\nM30"))
    assert [found.id for found in run.errors] == [error]
