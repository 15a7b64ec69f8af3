# SPDX-License-Identifier: MIT
"""What is decided about realtime loops (``#RT WHILE``): docs/conformance/cycles.md."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.decided import numbers, perform, reported

from nctakt.lists.machine.machine import load_machine
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller

#: Ends the loop when this many passes are counted.
COUNTED = """\
V.RTG.LOOP.ENABLED = TRUE
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF V.RTG.LOOP.COUNT >= {count}
    V.RTG.LOOP.ENABLED = FALSE
  $ENDIF
#RT CYCLE END
"""
CIRCLE = "#RT WHILE\nN10 G02 X20 R10\nN20 G02 X0 R10\n#RT ENDWHILE\n"
SIGNALS = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "PATH.SPEED", "LOOP.COUNT", "HLI.INSIDE_RT_LOOP"]


def test_passes_follow_each_other_without_a_stop() -> None:
    """A circle of two arcs at 100 mm/s: three passes of 62.8 mm at one speed."""
    text = f"{COUNTED.format(count=2)}G01 F6000\n{CIRCLE}M30"
    run = perform(text, signals=SIGNALS)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    speed = np.asarray(run.trace["PATH.SPEED"])
    moving = np.flatnonzero(speed)
    assert len(moving) == moving[-1] - moving[0] + 1  # one motion without a stop
    assert speed[moving[0] + 30 : moving[-1] - 30].min() == 100.0
    assert moving[-1] - moving[0] == pytest.approx(3 * 20 * np.pi / 100 / 0.001 + 25, abs=2)
    assert run.trace["LOOP.COUNT"][-1] == 3.0


def test_passes_follow_each_other_with_the_jerk_limited_slope() -> None:
    """The same circle: one motion without a stop between the passes (MO-3)."""
    slope = "#SLOPE [TYPE=TRAPEZ]\nG01 F6000\n"
    run = perform(f"{COUNTED.format(count=2)}{slope}{CIRCLE}M30", signals=SIGNALS)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    moving = np.flatnonzero(np.asarray(run.trace["PATH.SPEED"]))
    assert len(moving) == moving[-1] - moving[0] + 1
    assert run.trace["LOOP.COUNT"][-1] == 3.0


def test_a_loop_whose_condition_does_not_hold_is_passed_over() -> None:
    """FALSE where the loop is entered: not one pass."""
    run = perform(f"G01 F6000\n{CIRCLE}G00 X5\nM30", signals=SIGNALS)
    assert run.state == "ended"
    assert reported(run, "loop") == ["0 loop skipped"]
    assert run.trace is not None
    assert max(run.trace["X.ACS.ACT_POS"]) == 5.0
    assert run.ticks < 100


def test_a_loop_goes_on_until_its_condition_is_taken_away() -> None:
    """From outside, by a synchronous variable that a GLOBAL cycle copies."""
    text = (
        "#RT CYCLE [ID = 1 SCOPE = GLOBAL]\nV.RTG.LOOP.ENABLED = V.E.VALUE < 1\n#RT CYCLE END\n"
        f"#TIME 0.01\nG01 F6000\n{CIRCLE}M30"
    )
    run = perform(text, signals=SIGNALS, at=[Stimulus("5 s", "V.E.VALUE", 1.0)])
    assert run.state == "ended"
    assert run.trace is not None
    assert 7 <= run.trace["LOOP.COUNT"][-1] <= 10


@pytest.mark.parametrize(
    ("false_ms", "left_ms", "passes"),
    [(3500, 4000, 1), (3900, 4000, 1), (4500, 5000, 1), (5200, 6000, 2)],
)
@pytest.mark.parametrize("slope", ["", "#SLOPE [TYPE=TRAPEZ]\n"])
def test_single_block_looks_at_the_condition_after_each_pass(
    slope: str, false_ms: int, left_ms: int, passes: int
) -> None:
    """MO-6, RC-306: in single block each pass ends with a stop, so none is entered for nothing.

    START comes each second; a circle of 62.8 mm at 100 mm/s is one block, and takes 655 ms, a
    little more with a limit of the jerk. The STARTs up to 2 s let the dwell and the loop begin, the
    one of 3 s the first pass, that of 4 s counts it, that of 5 s lets the second one begin, if the
    condition holds.
    """
    text = (
        "#RT CYCLE [ID = 1 SCOPE = GLOBAL]\nV.RTG.LOOP.ENABLED = V.E.VALUE < 1\n#RT CYCLE END\n"
        f"#TIME 0.01\n{slope}G01 F6000\n#RT WHILE\nN10 G02 I10\n#RT ENDWHILE\nM30"
    )
    presses = [Stimulus(i, "HLI.START", 1.0) for i in range(1, 8)]
    run = perform(
        text,
        signals=SIGNALS,
        set={"HLI.SINGLE_BLOCK": 1.0},
        at=[*presses, Stimulus(f"{false_ms} ms", "V.E.VALUE", 1.0)],
        ticks=8000,
    )
    assert run.state == "ended", run.diagnostics
    assert reported(run, "loop") == ["2000 loop begun", f"{left_ms} loop left"]
    assert run.trace is not None
    assert run.trace["LOOP.COUNT"][-1] == passes


def test_backward_motion_goes_over_the_passes() -> None:
    """Back from the third pass into the first one, and forward again: the same end."""
    text = f"{COUNTED.format(count=2)}G01 F6000\n{CIRCLE}M30"
    plain = perform(text, signals=SIGNALS)
    changes = [
        Stimulus("1.5 s", "HLI.BACKWARD_MOTION", 1.0),
        Stimulus("2.6 s", "HLI.BACKWARD_MOTION", 0.0),
    ]
    run = perform(text, signals=SIGNALS, at=changes)
    assert run.state == plain.state == "ended"
    assert run.trace is not None
    assert plain.trace is not None
    for name in SIGNALS[:2]:
        assert run.trace[name][-1] == plain.trace[name][-1]
    assert run.trace["LOOP.COUNT"][-1] == 3.0
    assert [event.split(" ", 1)[1] for event in reported(run, "retrace")] == [
        "retrace backward",
        "retrace forward",
        "retrace front",
    ]


@pytest.mark.parametrize(
    ("body", "number"),
    [
        ("G00 X10", 50991),
        ("G01 F600\nV.E.COUNT = 1", 900883),
        ("G91 G00 X10", 22073),
    ],
)
def test_what_makes_no_loop(body: str, number: int) -> None:
    """A pass that ends elsewhere, one without a way, and what does not belong in it."""
    run = perform(f"V.RTG.LOOP.ENABLED = 1\n#RT WHILE\n{body}\n#RT ENDWHILE\nM30")
    assert run.state == "error"
    assert numbers(run) == [number]
    assert run.trace is not None
    assert max(run.trace["X.ACS.ACT_POS"], default=0.0) == 0.0


def test_a_loop_needs_the_history_of_the_path_and_compensation_off() -> None:
    """No memory of backward motion, too little for the body, tool radius compensation."""
    demo = load_machine(None)
    (channel,) = demo.channels

    def with_memory(size: int) -> Controller:
        startup = replace(channel.startup, backward_memory_bytes=size)
        return Controller(replace(demo, channels=(replace(channel, startup=startup),)))

    assert numbers(perform(f"G01 F6000\n{CIRCLE}M30", with_memory(0))) == [51029]
    blocks = "\n".join(f"G01 X{i % 2}" for i in range(1, 201))
    long_body = f"G01 F600\n#RT WHILE\n{blocks}\n#RT ENDWHILE\nM30"
    assert numbers(perform(long_body, with_memory(16384))) == [51027]
    active = f"V.G.WZ_AKT.R = 1\nG01 F6000\nG41 X1\n{CIRCLE}G40 X0\nM30"
    assert numbers(perform(active))[0] == 22158


def test_a_reset_leaves_the_loop() -> None:
    """Nothing of the loop is left for the next program."""
    controller = Controller()
    text = f"V.RTG.LOOP.ENABLED = TRUE\nG01 F6000\n{CIRCLE}M30"
    perform(text, controller, at=[Stimulus("900 ms", "HLI.RESET", 1.0)])
    assert controller.read("HLI.INSIDE_RT_LOOP") is False
    run = perform("G00 X1\nM30", controller)
    assert run.state == "ended"
