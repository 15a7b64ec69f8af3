# SPDX-License-Identifier: MIT
"""Measuring with a touch probe (G100, #MEAS, G101, V.A.MESS): docs/conformance/measuring.md."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.decided import numbers, perform, reported

from nctakt.lists.machine.machine import load_machine
from nctakt.lists.machine.measuring import AxisMeasuring
from nctakt.messages.programs.checked_blocks import EXCLUSIVE_WORDS
from nctakt.plc.loading import load_plc
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller

#: 100 mm with 10 mm/s from 0 at 4000 mm/s²: 2.5 ms to the speed, 12.5 µm after it.
BLOCK = "G100 X100 F600\n"


def probe(time: str, value: float = 1.0) -> Stimulus:
    """HLI.PROBE at this time."""
    return Stimulus(time, "HLI.PROBE", value)


def machine(*simulated: AxisMeasuring, **channel_values: Any) -> Controller:
    """The demo machine with these simulated probes of its first axes, and channel parameters."""
    demo = load_machine(None)
    (channel,) = demo.channels
    axes = list(demo.axes)
    for index, measuring in enumerate(simulated):
        axes[index] = replace(axes[index], measuring=measuring)
    measuring = replace(channel.parameters.measuring, **channel_values)
    parameters = replace(channel.parameters, measuring=measuring)
    return Controller(
        replace(demo, axes=tuple(axes), channels=(replace(channel, parameters=parameters),))
    )


def values_of(
    text: str, *names: str, controller: Controller | None = None, **how: Any
) -> list[str]:
    """What a program reads of these variables after its text."""
    formats = " ".join("%.6f" for _ in names)
    text = f'{text}#MSG ["{formats}", {", ".join(names)}]\nM30'
    run = perform(text, controller, **how)
    assert run.state == "ended", run.diagnostics
    return run.messages[-1].text.split()


def test_the_signal_latches_the_position_and_drops_the_rest() -> None:
    """206171147: at 1 s the axis is 9.9875 mm away, and it brakes with 4000 mm/s²."""
    names = ["V.A.MESS.X", "V.A.MOFFS.X", "V.A.MERF.X", "V.A.ABS.X", "V.G.MEAS_TYPE"]
    latched, deviation, touched, stands, type_ = values_of(BLOCK, *names, at=[probe("1 s")])
    assert (float(latched), float(deviation)) == (9.9875, -90.0125)
    assert (float(touched), float(type_)) == (1.0, 1.0)
    assert float(stands) == pytest.approx(9.9875 + 0.0125, abs=1e-6)


def test_the_event_says_how_far_the_block_has_come() -> None:
    """``touch`` with the length from the start of the block."""
    run = perform(f"{BLOCK}M30", at=[probe("1 s")])
    assert reported(run, "touch") == ["1000 touch 9.9875"]


def test_without_a_signal_the_block_ends_at_its_target() -> None:
    """V.A.MERF is 0; an error where P-CHAN-00176 or #MEAS says so, and with type 2 always."""
    assert values_of(BLOCK, "V.A.MERF.X", "V.A.ABS.X") == ["0.000000", "100.000000"]
    assert numbers(perform(f"{BLOCK}M30", machine(needs_signal=True))) == [901700]
    assert numbers(perform(f"#MEAS [TYPE=1]\n{BLOCK}M30")) == [901700]
    assert numbers(perform(f"#MEAS [TYPE=1 ERR_NO_SIGNAL=0]\n{BLOCK}M30")) == []
    assert numbers(perform(f"#MEAS MODE [2]\n{BLOCK}M30")) == [901700]


def test_type_2_has_the_speed_and_the_travel_beyond_the_target_of_the_list() -> None:
    """206177803: P-AXIS-00215 instead of F, P-AXIS-00114 after the target."""
    slow = AxisMeasuring(takes_part=True, speed=5.0, overtravel=2.0)
    text = "#MEAS MODE [2]\nG100 X10 F600\n"
    found = values_of(
        text, "V.A.MESS.X", "V.A.MOFFS.X", controller=machine(slow), at=[probe("2.2 s")]
    )
    assert float(found[0]) == pytest.approx(5.0 * 2.2 - 5.0 * 5.0 / 8000.0, abs=1e-9)
    assert float(found[1]) == pytest.approx(float(found[0]) - 10.0, abs=1e-9)


def test_type_3_goes_on_to_the_target_with_g106() -> None:
    """206185227."""
    text = "#MEAS MODE [3]\nG100 G106 X20 F600\n"
    found = values_of(text, "V.A.MESS.X", "V.A.ABS.X", at=[probe("1 s")])
    assert found == ["9.987500", "20.000000"]
    assert numbers(perform("G100 G106 X20 F600\nM30")) == [20772]
    assert numbers(perform("G106 X20 F600\nM30")) == [901705]


def test_axes_are_checked() -> None:
    """P-AXIS-00118; one axis with type 2, main axes with type 4."""
    assert numbers(perform(f"{BLOCK}M30", machine(AxisMeasuring()))) == [50059]
    assert numbers(perform("#MEAS MODE [2]\nG100 X1 Y1 F600\nM30")) == [50061]
    assert numbers(perform("#MEAS MODE [4]\nG100 X1 A1 F600\nM30")) == [50061]
    assert numbers(perform("#MEAS MODE [8]\nM30")) == [20437]
    assert numbers(perform("#MEAS MODE [7]\nG100 X1 F600\nM30")) == [901701]


def test_a_way_is_needed() -> None:
    """50067, unless P-CHAN-00313 is 0."""
    assert numbers(perform("G100 X0 F600\nM30")) == [50067]
    assert numbers(perform("G100 X0 F600\nM30", machine(needs_travel=False))) == []


def test_a_pressed_probe_is_an_error_or_the_end() -> None:
    """50052, or with P-CHAN-00312 measured where the block begins."""
    pressed = [probe("0 s")]
    assert numbers(perform(f"{BLOCK}M30", at=pressed)) == [50052]
    allowed = machine(may_be_pressed=True)
    names = ("V.A.MERF.X", "V.A.MESS.X", "V.A.ABS.X")
    assert values_of(BLOCK, *names, controller=allowed, at=pressed) == [
        "1.000000", "0.000000", "0.000000",
    ]  # fmt: skip


def test_the_falling_edge_is_a_signal() -> None:
    """``#MEAS [EDGE=NEG]``: HLI.PROBE from 1 to 0."""
    text = f"#MEAS [EDGE=NEG]\n{BLOCK}"
    at = [probe("0 s"), probe("1 s", 0.0)]
    assert values_of(text, "V.A.MESS.X", at=at) == ["9.987500"]


@pytest.mark.parametrize(
    ("simulated", "position"),
    [
        (AxisMeasuring(True, simulation=1, first=123_456), 12.3456),
        (AxisMeasuring(True, simulation=3, first=25), 75.0),
        (AxisMeasuring(True, simulation=4), 100.0),
        (AxisMeasuring(True, simulation=5), 100.0),
        (AxisMeasuring(True, simulation=6, first=400_000, second=500_000), 40.0),
        (AxisMeasuring(True, simulation=2, first=1000), 9.9875),
    ],
    ids=lambda value: str(getattr(value, "simulation", "")),
)
def test_simulated_probes(simulated: AxisMeasuring, position: float) -> None:
    """118162699: P-AXIS-00112 with its parameters; the place is exact, whatever the tick."""
    (found,) = values_of(BLOCK, "V.A.MESS.X", controller=machine(simulated))
    assert float(found) == pytest.approx(position, abs=1e-6)


def test_simu_offset_lies_before_the_target() -> None:
    """Only with P-AXIS-00112 = 4."""
    text = f"#MEAS [TYPE=1 SIMU_OFFSET=2.5]\n{BLOCK}"
    assert numbers(perform(f"{text}M30")) == [901707]
    at_target = machine(AxisMeasuring(True, simulation=4))
    assert values_of(text, "V.A.MESS.X", controller=at_target) == ["97.500000"]


def test_the_offset_is_included_until_g102() -> None:
    """206208011: G101 takes deviation times factor, with the next absolute word."""
    at_75 = machine(AxisMeasuring(True, simulation=3, first=25))
    text = f"{BLOCK}G101 X0.5\nG01 X0\n"
    names = ("V.A.MEIN.X", "V.A.ABS.X", "V.A.PROG.X")
    assert values_of(text, *names, controller=at_75) == ["-12.500000", "-12.500000", "0.000000"]
    assert values_of(f"{text}G102 X1\nX0\n", *names, controller=at_75) == ["0.000000"] * 3
    assert values_of("G01 X1\n", *names, controller=at_75)[0] == "0.000000"
    assert numbers(perform(f"{BLOCK}G101 X1\nM30")) == [901706]


def test_offsets_lie_between_the_measured_values() -> None:
    """MESS with all offsets, MEAS.PCS.VALUE as programmed, MEAS.ACS.VALUE of the axis."""
    at_40 = machine(AxisMeasuring(True, simulation=1, first=400_000))
    names = ("V.A.MESS.X", "V.A.MEAS.ACS.VALUE.X", "V.A.MEAS.PCS.VALUE.X")
    assert values_of(f"G92 X10\n{BLOCK}", *names, controller=at_40) == [
        "40.000000", "40.000000", "30.000000",
    ]  # fmt: skip


def test_g100_is_a_line_whatever_is_modal() -> None:
    """Also after G00 and G02; both go on after it."""
    run = perform("G00\nG100 X1 F600\nX2\nM30")
    assert run.state == "ended"
    assert numbers(perform("G02\nG100 X1 F600\nM30")) == []
    text = "G100 G02 X1 Y1 R5 F600\nM30"
    assert [found.message.id for found in perform(text).diagnostics] == [EXCLUSIVE_WORDS.id]


def test_a_reset_ends_the_measuring() -> None:
    """Nothing touches in the next program."""
    controller = machine()
    perform(f"{BLOCK}M30", controller, at=[Stimulus("300 ms", "HLI.RESET", 1.0)])
    run = perform("G01 X60 F600\nM30", controller, at=[probe("500 ms")])
    assert reported(run, "touch") == []


def test_compensation_forbids_measuring() -> None:
    """It asks for positions: 20651."""
    text = "V.G.WZ_AKT.R = 1\nG41 G01 X10 Y10 F600\nG100 X100\nG40 X0\nM30"
    assert 20651 in numbers(perform(text))


@settings(max_examples=12, deadline=None)
@given(st.integers(-900_000, 900_000), st.integers(-50, 50))
def test_the_place_of_a_simulated_probe_is_exact(place: int, y: int) -> None:
    """The other axes are where the line crosses the place."""
    target = 100 if place > 0 else -100
    (x, found_y) = values_of(
        f"G100 X{target} Y{y} F60000\n",
        "V.A.MESS.X",
        "V.A.MESS.Y",
        controller=machine(AxisMeasuring(True, simulation=1, first=place)),
    )
    assert float(x) == pytest.approx(place / 10_000, abs=2e-6)
    assert float(found_y) == pytest.approx(y * place / 10_000 / target, abs=2e-6)


def test_the_example_finds_the_edge_of_its_workpiece() -> None:
    """The PLC sees the probe a tick later: 20 and 2 mm/s lead after 40.3 by less than that way."""
    folder = Path(__file__).parents[2] / "examples" / "probing"
    text = (folder / "probing.nc").read_text("utf-8")
    run = perform(text, plc=load_plc(folder / "workpiece.py"))
    assert run.state == "ended", run.diagnostics
    first, last = (one.text for one in run.messages)
    fast, slow = (float(word.strip(",")) for word in first.split()[1::2])
    assert 40.3 < slow <= 40.3 + 2 * 0.002
    assert 40.3 < fast <= 40.3 + 2 * 0.02
    assert float(last.removeprefix("along X")) == pytest.approx(slow + 2.0 - 8.0, abs=2e-3)


# --- G310 -----------------------------------------------------------------------------------------

JUMP = """#MEAS MODE [5]
G01 X0 Y0 F6000
G310 G01 X100 Y20 F600 $GOTO[TOUCHED]
#MSG ["past"]
$GOTO [END]
[TOUCHED] #MSG ["%.4f %.4f %d", V.A.MESS.X, V.A.ABS.Y, V.A.MERF.Y]
[END] M30
"""


def test_a_block_is_interrupted_and_jumps() -> None:
    """206197003: at the signal the path stops, its place is the target, the program jumps."""
    (text,) = [one.text for one in perform(JUMP, at=[probe("1 s")]).messages]
    measured, stands, touched = map(float, text.split())
    assert 9.7 < measured < 9.85
    assert stands == pytest.approx(measured / 5.0, abs=0.01)
    assert touched == 1.0
    assert [one.text for one in perform(JUMP).messages] == ["past"]
    assert [one.text for one in perform(f"#MEAS [TYPE=6]\n{JUMP[15:]}").messages] == ["past"]


def test_a_block_is_interrupted_at_rapid_traverse() -> None:
    """G310 G00; N labels; without a jump the next block follows."""
    text = "#MEAS MODE [6]\nG310 G00 X100 $GOTO N50\nG01 Y5 F6000\nN50: M30"
    fast = perform(text, at=[probe("0.2 s")], signals=["Y.ACS.ACT_POS"])
    assert fast.trace["Y.ACS.ACT_POS"].tolist()[-1] == 0.0
    assert fast.ticks < 500
    found = values_of("#MEAS MODE [5]\nG310 G01 X10 F600\n", "V.A.MERF.X", at=[probe("0.2 s")])
    assert found == ["1.000000"]


def test_types_of_g100_and_g310() -> None:
    """20138, 20956; other motions, G100 in the same block, no axis, no label."""
    assert numbers(perform("#MEAS MODE [5]\nG100 X1 F600\nM30")) == [20138]
    assert numbers(perform("G310 G01 X1 F600\nM30")) == [20956]
    assert 900210 in numbers(perform("#MEAS MODE [5]\nG310 G02 X1 R5 F600\nM30"))
    assert 900210 in numbers(perform("#MEAS MODE [5]\nG100 G310 X1 F600\nM30"))
    assert numbers(perform("#MEAS MODE [5]\nG310 $GOTO[A]\n[A] M30")) == [20797]
    assert numbers(perform("#MEAS MODE [5]\nG01 X1 F600 $GOTO[A]\n[A] M30")) == [20797]
    assert numbers(perform("#MEAS MODE [5]\nG310 X1 F600 $GOTO[B]\n[A] M30")) == [20840]


def test_a_block_without_way_or_skipped_does_not_jump() -> None:
    """Whatever an earlier block has measured."""
    controller = machine(needs_travel=False)
    text = '#MEAS MODE [5]\nG310 G01 X10 F600 $GOTO[A]\n[A] Z1\n{}\n#MSG ["past"]\n[B] M30'
    for block in ("G310 G01 G91 X0 $GOTO[B]", "/G310 G01 X20 $GOTO[B]"):
        run = perform(
            text.format(block), controller, at=[probe("0.2 s"), probe("0.3 s", 0.0)], skip=[1]
        )
        assert [one.text for one in run.messages] == ["past"]


# --- further parameters of the channel ------------------------------------------------------------


@pytest.mark.parametrize(
    ("block", "adds_radius", "shift"),
    [
        ("G100 X100 F600", True, 3.0),
        ("G100 X-100 F600", True, -3.0),
        ("G100 X100 F600", False, 0.0),
    ],
)
def test_the_radius_of_the_probe(block: str, adds_radius: bool, shift: float) -> None:
    """P-CHAN-00311: V.A.MEAS.PCS.VALUE is the touched place, V.A.MESS the probe's centre."""
    controller = machine(adds_radius=adds_radius)
    names = ("V.A.MEAS.PCS.VALUE.X", "V.A.MESS.X", "V.A.MEAS.ACS.VALUE.X")
    found = values_of(
        f"V.G.WZ_AKT.R = 3\n{block}\n", *names, controller=controller, at=[probe("1 s")]
    )
    pcs, mess, acs = map(float, found)
    assert pcs - mess == pytest.approx(shift)
    assert mess == acs


def test_the_radius_of_the_probe_acts_along_the_way() -> None:
    """5 mm along (3, 4): 3 mm in X, 4 mm in Y."""
    names = [f"V.A.{name}.{axis}" for axis in "XY" for name in ("MEAS.PCS.VALUE", "MESS")]
    text = "V.G.WZ_AKT.R = 5\nG100 X30 Y40 F600\n"
    x, mess_x, y, mess_y = map(float, values_of(text, *names, at=[probe("1 s")]))
    assert (x - mess_x, y - mess_y) == (pytest.approx(3.0), pytest.approx(4.0))


def test_measuring_ends_at_a_software_limit() -> None:
    """P-CHAN-00268: the way is shortened as a whole; without it 120002."""
    text = "G98 Y-20\nG99 X10\nG100 X40 Y-80 F6000\n"
    assert numbers(perform(f"{text}M30")) == [120002]
    names = ("V.A.MERF.X", "V.A.ABS.X", "V.A.ABS.Y")
    found = values_of(text, *names, controller=machine(shortens_travel=True))
    assert [float(value) for value in found] == [0.0, 10.0, -20.0]
    found = values_of("G99 X10\nG100 X-5 F6000\n", *names, controller=machine(shortens_travel=True))
    assert float(found[1]) == -5.0


@pytest.mark.parametrize("of_all_axes", [False, True])
def test_all_axes_of_a_system_are_measured(of_all_axes: bool) -> None:
    """P-CHAN-00327: Y moves under X, its values are there; without a system X alone."""
    controller = machine(of_all_axes=of_all_axes)
    names = ("V.A.MERF.Y", "V.A.MEAS.ACS.VALUE.Y")
    for word in ("#CS ON [0, 0, 0, 0, 0, 90]", "#ROTATION ON [ANGLE=90]"):
        found = values_of(
            f"{word}\n{BLOCK}", *names, controller=controller, at=[probe("1 s"), probe("2 s", 0.0)]
        )
        if of_all_axes:
            assert float(found[0]) == 1.0
            assert abs(float(found[1])) > 5.0
        else:
            assert found == ["0.000000", "0.000000"]
        controller = machine(of_all_axes=of_all_axes)
    assert values_of(BLOCK, *names, controller=controller, at=[probe("1 s")])[0] == "0.000000"


def test_nothing_else_watches_the_block() -> None:
    """A fixed stop or an edge joint in a measuring block is an error, not left out."""
    assert numbers(perform("X[FIXED_STOP ON] G100 X10 F600\nM30")) == [900210]
    assert numbers(perform("G108\nG100 X10 F600 M116\nM30")) == [900210]
