# SPDX-License-Identifier: MIT
"""Measuring the edge joint (G108, V.RTG.MEAS_DELTA): docs/conformance/measuring.md."""

from __future__ import annotations

from dataclasses import replace

from support.decided import numbers, perform, reported

from nctakt.lists.machine.machine import load_machine
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller

PROBE = [Stimulus("500 ms", "HLI.PROBE", 1.0)]
BLOCK = "G108\nG01 X100 F6000 M116\n"


def machine(residual_mm: float, *, across_blocks: bool = False) -> Controller:
    """The demo machine with this residual path (P-CHAN-00030) and P-CHAN-00029."""
    demo = load_machine(None)
    (channel,) = demo.channels
    parameters = replace(
        channel.parameters, residual_path_mm=residual_mm, edge_across_blocks=across_blocks
    )
    return Controller(replace(demo, channels=(replace(channel, parameters=parameters),)))


def test_a_block_that_finds_no_edge_is_an_error() -> None:
    """After the block: 50891, and the function does not go out."""
    run = perform(f"{BLOCK}M30")
    assert numbers(run) == [50891]
    assert reported(run, "output") == []


def test_a_joint_beyond_the_end_is_that_of_the_end() -> None:
    """The residual path is longer than the block: its function goes out at its end."""
    controller = machine(80.0)
    run = perform(f"{BLOCK}G00 X110\nM30", controller, at=PROBE)
    assert run.state == "ended", run.diagnostics
    assert reported(run, "output") == ["1025 output M 116"]
    assert controller.read("V.RTG.MEAS_DELTA") == 100.0 - 48.75 - 80.0


def test_measuring_is_over_with_its_block_and_with_g107() -> None:
    """G108 counts for one block with a function of its type; G107 takes it back."""
    run = perform(f"{BLOCK}G01 X50 M116\nM30", machine(5.0), at=PROBE)
    assert run.state == "ended", run.diagnostics
    assert len(reported(run, "probe")) == 1
    run = perform("G108\nG107\nG01 X100 F6000 M116\nM30", at=PROBE)
    assert run.state == "ended"
    assert reported(run, "probe") == []


def test_measuring_across_blocks_is_refused() -> None:
    """P-CHAN-00029: 900884 at G108."""
    assert numbers(perform(f"{BLOCK}M30", machine(5.0, across_blocks=True))) == [900884]


def test_the_program_reads_and_writes_the_delta() -> None:
    """V.RTG.MEAS_DELTA keeps its value until the next edge, or until the program writes it."""
    controller = machine(5.0)
    text = f"{BLOCK}V.E.VALUE = V.RTG.MEAS_DELTA\nV.RTG.MEAS_DELTA = 1.5\nM30"
    run = perform(text, controller, at=PROBE)
    assert run.state == "ended"
    assert controller.read("V.E.VALUE") == 46.25
    assert controller.read("V.RTG.MEAS_DELTA") == 1.5


def test_a_reset_ends_the_measuring() -> None:
    """Nothing is looked for any more."""
    controller = machine(5.0)
    perform(f"{BLOCK}M30", controller, at=[Stimulus("300 ms", "HLI.RESET", 1.0)])
    run = perform("G00 X60\nM30", controller, at=PROBE)
    assert run.state == "ended"
    assert reported(run, "probe") == []


def test_no_edge_is_found_on_the_way_back() -> None:
    """MO-7: the probe is looked at where the block goes forward."""
    switched = [(500, "BACKWARD_MOTION", 1.0), (700, "PROBE", 1.0), (710, "PROBE", 0.0)]
    switched.append((900, "BACKWARD_MOTION", 0.0))
    stimuli = [Stimulus(f"{time} ms", f"HLI.{name}", value) for time, name, value in switched]
    run = perform(f"G00 X-50\n{BLOCK}M30", machine(5.0), at=stimuli)
    assert numbers(run) == [50891]
    assert reported(run, "probe") == []
