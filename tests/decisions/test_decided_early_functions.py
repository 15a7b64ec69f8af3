# SPDX-License-Identifier: MIT
"""Decisions on M and H functions that go out before the path comes to their block.

P-CHAN-00041 (MEP_SVS, MEP_MOS, MET_SVS, MET_MOS), P-CHAN-00070, P-CHAN-00107;
``docs/conformance/functions.md`` says what is decided. F6000 is 100 mm/s, which the demo machine
reaches in 25 ms on 1.25 mm, so that a path from rest is at 100·(t - 12.5 ms) from then on.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from support.changed_lists import machine_with
from support.decided import machine, numbers, perform, reported

from nctakt.lists.declared.technology_functions import TechnologyFunction
from nctakt.lists.machine.machine import load_machine
from nctakt.messages.machines.lists import LEAD_WITHOUT_EARLY_TYPE
from nctakt.results.run import Run
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller

#: Added to the number of an H function.
H = 1000
#: The program of the manual's pages, with other lengths of its blocks.
PROGRAM = "N10 G01 X10 F6000\nN20 X20\nN30 X30\nN40 X40\nN50 {words}\nN55 X80\nM30"


class Plc:
    """Acknowledges each function 60 ticks after it has gone out."""

    def cycle(self, hli: object) -> None:
        for function in hli.functions():  # type: ignore[attr-defined]
            if hli.time_us - function.time_us >= 60_000:  # type: ignore[attr-defined]
                hli.acknowledge(function)  # type: ignore[attr-defined]


def run_of(functions: list[TechnologyFunction], program: str, **settings: object) -> Run:
    demo = machine()
    (channel,) = demo.channels
    m = {one.number: one for one in functions if one.number < H}
    h = {one.number - H: replace(one, number=one.number - H) for one in functions[len(m) :]}
    parameters = channel.parameters
    parameters = replace(
        parameters,
        m_functions={**parameters.m_functions, **m},
        h_functions={**parameters.h_functions, **h},
    )
    changed = replace(demo, channels=(replace(channel, parameters=parameters),))
    return perform(program, Controller(changed), **settings)


def outputs(run: Run) -> list[str]:
    assert numbers(run) == []
    return reported(run, "output")


def x_at(run: Run, tick: int) -> float:
    assert run.trace is not None
    return float(run.trace["X.ACS.ACT_POS"][tick])


def early(synchronisation: str, lead: float, number: int = 300) -> list[TechnologyFunction]:
    """A function with a lead in mm or s; numbers from ``H`` on are those of H functions."""
    return [TechnologyFunction(number, synchronisation, (), 0.0, "", lead)]


def test_a_distance_before_the_block() -> None:
    """Page 286019467: 25 mm before X40 the path is at 15 mm, after 162.5 ms."""
    run = run_of(early("MEP_SVS", 25.0), PROGRAM.format(words="M300"))
    assert outputs(run) == ["163 output M 300"]
    assert x_at(run, 161) == pytest.approx(14.95)
    assert x_at(run, 424) == pytest.approx(40.0)  # the path is at 425 ms


def test_a_time_before_the_block() -> None:
    """Page 286026507: with a ramp to rest the path is there at 425 ms; 300 ms before is 125 ms."""
    run = run_of(early("MET_SVS", 0.3), PROGRAM.format(words="M300"))
    assert outputs(run) == ["125 output M 300"]


@pytest.mark.parametrize(("kind", "lead", "tick"), [("MEP", 25.0, 163), ("MET", 0.3, 113)])
def test_without_waiting_the_path_passes(kind: str, lead: float, tick: int) -> None:
    """Page 148946059: the path passes X40 at 412.5 ms with its speed."""
    words = "H300"
    run = run_of(early(f"{kind}_MOS", lead, H + 300), PROGRAM.format(words=words))
    assert outputs(run) == [f"{tick} output H 300"]
    assert x_at(run, 412) == pytest.approx(40.05)


def test_the_path_waits_for_a_late_acknowledgement() -> None:
    """1 mm before is in the ramp, √(2·1/4000) s = 22.4 ms before 425 ms: answered in tick 463."""
    lists = early("MEP_SVS", 1.0)
    run = run_of(lists, PROGRAM.format(words="M300"), plc=Plc())
    assert outputs(run) == ["403 output M 300"]
    assert x_at(run, 463) == pytest.approx(40.0)
    assert x_at(run, 464) == pytest.approx(40.002)


def test_the_path_begins_at_once_when_it_is_acknowledged_in_time() -> None:
    """10 mm before: answered in tick 373, long before the path is at 425 ms."""
    lists = early("MEP_SVS", 10.0)
    run = run_of(lists, PROGRAM.format(words="M300"), plc=Plc())
    assert outputs(run) == ["313 output M 300"]
    assert x_at(run, 424) == pytest.approx(40.0)
    assert x_at(run, 425) == pytest.approx(40.002)


def test_a_lead_longer_than_the_path() -> None:
    """It goes out as soon as the path begins, and in the block's own motion before it."""
    run = run_of(early("MEP_SVS", 900.0), PROGRAM.format(words="M300 X60"))
    assert outputs(run) == ["0 output M 300"]


def test_what_comes_first_in_the_program_goes_out_first() -> None:
    """Page 148936331: M300 bounds M301, which alone would go out at 17 mm; not in one block."""
    lists = early("MEP_SVS", 5.0) + early("MEP_SVS", 25.0, number=301)
    program = "N10 G01 X32 F6000\nN20 M300\nN30 X42\nN40 M301\nN50 X80\nM30"
    run = run_of(lists, program)
    assert outputs(run) == ["283 output M 300", "283 output M 301"]


def test_in_one_block_none_bounds_the_other() -> None:
    """Page 148936331."""
    lists = early("MEP_SVS", 5.0) + early("MEP_SVS", 25.0, number=301)
    run = run_of(lists, PROGRAM.format(words="M300 M301"))
    assert outputs(run) == ["163 output M 301", "363 output M 300"]


def test_what_waits_for_something_else_bounds_the_lead() -> None:
    """A dwell before the path: nothing goes out before it is over (choice)."""
    program = "N10 G01 X10 F6000\nN20 G04 0.1\nN30 X20\nN40 M300\nN50 X40\nM30"
    run = run_of(early("MEP_MOS", 20.0), program)
    # The path is at 10 mm after 125 ms, the dwell lasts up to 225 ms.
    assert outputs(run) == ["225 output M 300"]


def test_the_override_counts_in_a_time() -> None:
    """At 50 % the speed is 50 mm/s: 0.3 s with its ramp are 14.6875 mm."""
    half = [Stimulus("0 ticks", "HLI.OVERRIDE", 50.0)]
    run = run_of(early("MET_SVS", 0.3), PROGRAM.format(words="M300"), at=half)
    # 40 mm and a ramp at each end take 812.5 ms.
    assert outputs(run) == ["513 output M 300"]


def test_no_function_goes_out_in_a_feed_hold() -> None:
    """It stops on 14 mm, 1 mm before M300 would go out."""
    hold = [Stimulus("140 ticks", "HLI.FEED_HOLD", True), Stimulus("0.5 s", "HLI.FEED_HOLD", False)]
    run = run_of(early("MEP_SVS", 25.0), PROGRAM.format(words="M300"), at=hold)
    (output,) = outputs(run)
    assert int(output.split()[0]) > 500


def test_a_reset_forgets_what_has_not_gone_out() -> None:
    reset = [Stimulus("100 ticks", "HLI.RESET", True)]
    run = run_of(early("MEP_SVS", 25.0), PROGRAM.format(words="M300"), at=reset)
    assert reported(run, "output") == []


def test_the_list_gives_the_lead(tmp_path: Path) -> None:
    """P-CHAN-00070 in 0.1 µm or µs; page 148946059: with other types it is a licensed option."""
    entries = [("MEP_SVS", 250_000), ("MET_MOS", 40_000), ("MVS_SVS", 1)]
    lists = "\n".join(
        f"m_synch[{300 + i}] {kind}\nm_pre_outp[{300 + i}] {lead}"
        for i, (kind, lead) in enumerate(entries)
    )
    found = load_machine(machine_with(tmp_path / "m", sda_mds1=lists))
    assert [one.id for one in found.diagnostics] == [LEAD_WITHOUT_EARLY_TYPE.id]
    parameters = found.channels[0].parameters
    assert [parameters.m_functions[300 + i].lead for i in range(3)] == [25.0, 0.04, 0.0]
    assert parameters.blocks_ahead == 50
