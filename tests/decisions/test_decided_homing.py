# SPDX-License-Identifier: MIT
"""Homing (G74) and software limits of the program (G98, G99): docs/conformance/measuring.md."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from support.decided import numbers, perform, reported
from support.insides import machine_of

from nctakt.lists.machine.axis_configuration import AxisHoming
from nctakt.lists.machine.machine import load_machine
from nctakt.messages.programs.checked_blocks import EXCLUSIVE_WORDS
from nctakt.messages.programs.offsets import COMMAND_WITHOUT_AXIS
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller


def machine(*homing: AxisHoming, keeps_listed_limits: bool = False) -> Controller:
    """The demo machine with this homing of its first axes, and P-CHAN-00498."""
    demo = load_machine(None)
    (channel,) = demo.channels
    axes = list(demo.axes)
    for index, one in enumerate(homing):
        axes[index] = replace(axes[index], homing=one)
    parameters = replace(channel.parameters, keeps_listed_limits=keeps_listed_limits)
    channels = (replace(channel, parameters=parameters),)
    return Controller(replace(demo, axes=tuple(axes), channels=channels))


def message(program: str, controller: Controller | None = None, **how: Any) -> str:
    """The last message of a program that ends without an error."""
    run = perform(f"{program}\nM30", controller, **how)
    assert run.state == "ended", run.diagnostics
    return run.messages[-1].text


def test_the_axis_has_its_reference_position_at_the_zero_pulse() -> None:
    """206138635: it stops beyond it by its braking distance: 10² / (2 · 4000) = 0.0125."""
    homing = AxisHoming(distance=-30.0, speed=10.0, position=250.0)
    text = 'G01 X5 F6000\nG74 X1\n#MSG ["%f %f %d", V.A.ABS.X, V.A.REF.X, V.A.RERF.X]'
    run = perform(f"{text}\nM30", machine(homing))
    assert [one.text for one in run.messages] == ["249.987500 250.000000 1"]
    assert reported(run, "axis")[0].endswith("axis X begun -25.0125")


def test_the_order_of_the_values_is_that_of_the_axes() -> None:
    """Equal values together, the next ones when these are at rest."""
    slow = AxisHoming(distance=1.0, speed=10.0)
    run = perform("G74 X2 Y1 Z2\nM30", machine(slow, slow, slow))
    begun = [one.split() for one in reported(run, "axis") if "begun" in one]
    ticks = {axis: int(tick) for tick, _, axis, *_ in begun}
    assert ticks["Y"] + 100 < ticks["X"] == ticks["Z"]
    assert numbers(perform("G74 X0\nM30")) == [901710]
    assert numbers(perform("G74 X1.5\nM30")) == [901710]


def test_the_program_goes_on_from_there() -> None:
    """Positions, relative ones too, count from the reference position."""
    homing = AxisHoming(distance=0.0, position=100.0)
    text = 'G74 X1\nG91 G01 X5 F6000\n#MSG ["%f", V.A.ABS.X]'
    assert message(text, machine(homing)) == "105.000000"


def test_the_reference_outlives_program_and_reset() -> None:
    """It is kept until the controller starts anew."""
    controller = machine(AxisHoming(distance=0.0, position=7.0))
    text = '#MSG ["%d %f", V.A.RERF.X, V.A.REF.X]'
    assert message(text, controller) == "0 0.000000"
    message(f"G74 X1\n{text}", controller)
    controller.reset()
    assert message(text, controller) == "1 7.000000"


def test_what_cannot_be_homed_is_refused() -> None:
    """P-AXIS-00299, systems of the program, compensation, other functions with axis words."""
    assert numbers(perform("G74 X1\nM30", machine(AxisHoming(is_allowed=False)))) == [50686]
    assert numbers(perform("#CS ON [0, 0, 0, 0, 0, 30]\nG74 X1\nM30")) == [901711]
    found = perform("G74 G98 X1\nM30").diagnostics
    assert [one.message.id for one in found] == [EXCLUSIVE_WORDS.id]
    found = perform("G74\nM30").diagnostics
    assert [one.message.id for one in found] == [COMMAND_WITHOUT_AXIS.id]


def test_a_reset_during_homing_leaves_the_position_as_it_was() -> None:
    """The axis brakes; it is not homed."""
    controller = machine(AxisHoming(distance=-30.0, speed=10.0, position=250.0))
    run = perform("G74 X1\nM30", controller, at=[Stimulus("1 s", "HLI.RESET", 1.0)])
    assert run.state != "ended"
    text = '#MSG ["%d %f", V.A.RERF.X, V.A.ABS.X]'
    found, position = message(text, controller).split()
    assert (found, float(position)) == ("0", pytest.approx(-10.0, abs=0.1))


# --- G98, G99 --------------------------------------------------------------------------------


def test_limits_of_the_program_end_with_it() -> None:
    """566883851: modal, shown in V.A.-SWE and V.A.+SWE; a program begins with those of the list."""
    shown = '#MSG ["%f %f %f", V.A.-SWE.X, V.A.+SWE.X, V.A.+SWE_MDS.X]'
    controller = Controller()
    text = f"G98 X-20\nG99 X30\n{shown}"
    assert message(text, controller) == "-20.000000 30.000000 10000.000000"
    assert message(shown, controller) == "-10000.000000 10000.000000 10000.000000"


@pytest.mark.parametrize(
    "motion", ["G01 X31", "G00 X31\nX0", "G02 X0 Y0 I20 J20", "G90 X10\nX31\nX5", "G91 X16\nX16"]
)
def test_the_path_keeps_them(motion: str) -> None:
    """Lines, arcs between their ends, plain blocks."""
    assert numbers(perform(f"F6000\nG99 X30\n{motion}\nM30")) == [120002]


def test_independent_motions_keep_them() -> None:
    """Of realtime cycles, from the block on and until the end of the program."""
    cycle = "#RT CYCLE [ID=1 SCOPE=PROG]\nX[INDP G90 POS=40 G01 FEED6000]\n#RT CYCLE END\n"
    limited = perform(f"G99 X30\n{cycle}#TIME 1\nM30")
    assert 60158 in numbers(limited)
    text = next(str(one) for one in limited.diagnostics if one.id == 60158)
    assert "30" in text
    assert perform(f"G99 X30\nG99 X50\n{cycle}#TIME 1\nM30").state == "ended"


def test_a_reset_restores_those_of_the_list_for_the_plc() -> None:
    """The PLC may move the axis beyond the program's limit again."""

    controller = Controller()
    perform("G99 X30\nG04 X10\nM30", controller, at=[Stimulus("100 ms", "HLI.RESET", 1.0)])
    assert machine_of(controller).single_axes.limits_of(0) == (-10000.0, 10000.0)


def test_a_relative_limit_is_added_to_the_limit_in_force() -> None:
    """The programming manual; the limit manual adds to the list. Reported once (901551)."""
    run = perform('G99 X30\nG91\nG99 X-2\nG99 X-2\n#MSG ["%f", V.A.+SWE.X]\nM30')
    assert [one.text for one in run.messages] == ["26.000000"]
    assert numbers(run) == [901551]


def test_limits_cannot_cross() -> None:
    """21649, 21878."""
    assert numbers(perform("G99 X30\nG98 X30\nM30")) == [21649]
    assert numbers(perform("G98 X-30\nG99 X-31\nM30")) == [21878]


def test_limits_beyond_those_of_the_list() -> None:
    """Allowed, or with P-CHAN-00498 ignored with a warning: 21648, 21650."""
    shown = '\n#MSG ["%f %f", V.A.-SWE.X, V.A.+SWE.X]\nM30'
    run = perform(f"G98 X-20000\nG99 X20000{shown}")
    assert [one.text for one in run.messages] == ["-20000.000000 20000.000000"]
    run = perform(f"G98 X-20000\nG99 X20000{shown}", machine(keeps_listed_limits=True))
    assert [one.text for one in run.messages] == ["-10000.000000 10000.000000"]
    assert numbers(run) == [21648, 21650]


def test_inches() -> None:
    """G70: 1 inch is 25.4 mm."""
    assert message('G70\nG99 X1\nG71\n#MSG ["%f", V.A.+SWE.X]') == "25.400000"
