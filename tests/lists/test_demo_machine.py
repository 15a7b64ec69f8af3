# SPDX-License-Identifier: MIT
"""The built-in demo machine (MO-15)."""

from __future__ import annotations

import shutil
from math import inf
from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.lists.machine.axis_configuration import AxisType
from nctakt.lists.machine.external.variables import AccessRights, Leaf
from nctakt.lists.machine.machine import BUILT_IN_MACHINES, Machine, load_machine
from nctakt.run.controller import Controller, NcText


@pytest.fixture(scope="module")
def demo() -> Machine:
    """The demo machine."""
    return load_machine(None)


def leaves(demo: Machine) -> dict[str, Leaf]:
    """All V.E leaves by path."""
    (channel,) = demo.channels
    return {leaf.path: leaf for one in channel.external_variables for leaf in one.leaves()}


def test_it_loads_without_any_finding(demo: Machine) -> None:
    """The demo lists are an example: not even a note, and no entry that is not simulated."""
    assert demo.diagnostics == ()
    assert load_machine(None, detail="effects").diagnostics == ()


def test_its_lists_are_read_once_and_count_as_read_each_time(demo: Machine) -> None:
    """The package does not change while it runs; no output may replace its lists."""
    access = FileAccess()
    assert load_machine(None, access=access) is demo
    assert demo.lists[0][1] in access.read_files


def test_tick(demo: Machine) -> None:
    """MO-15: T is 1 ms."""
    assert (demo.name, demo.cycle_time_us) == ("demo", 1000)


@pytest.mark.parametrize("index", [0, 1, 2])
def test_linear_axes(demo: Machine, index: int) -> None:
    """MO-15: X Y Z, ±10 m, 500 mm/s, 4000 mm/s², trapezoid, single axis motion, exact drive."""
    axis = demo.axes[index]
    assert (axis.name, axis.type, axis.is_modulo) == ("XYZ"[index], AxisType.LINEAR, False)
    assert (axis.software_limit_low, axis.software_limit_high) == (-10_000, 10_000)
    assert (axis.rapid_speed, axis.max_speed, axis.max_acceleration) == (500, 500, 4000)
    assert (axis.dynamics.feed_acceleration, axis.dynamics.rapid_acceleration) == (4000, 4000)
    assert (axis.enable_single_axis, axis.follows_exactly) == (True, True)


def test_rotary_axis(demo: Machine) -> None:
    """MO-15: A, modulo 360°, 360 °/s, 4000 °/s²."""
    axis = demo.axes[3]
    assert (axis.name, axis.type, axis.modulo_range) == ("A", AxisType.ROTARY, 360)
    assert (axis.rapid_speed, axis.max_speed, axis.max_acceleration) == (360, 360, 4000)
    assert (axis.software_limit_low, axis.software_limit_high) == (-inf, inf)
    assert (axis.enable_single_axis, axis.follows_exactly) == (True, True)


def test_channel(demo: Machine) -> None:
    """MO-15: axes X Y Z A, spindles S, S2 and the PLC's S3, realtime cycles and V.CH memory."""
    (channel,) = demo.channels
    assert [axis.name for axis in channel.axes] == ["X", "Y", "Z", "A"]
    assert [axis.index for axis in channel.axes] == [0, 1, 2, 3]
    assert [one.name for one in channel.spindles] == ["S", "S2", "S3"]
    assert channel.main_spindle is channel.spindles[0]
    plc = channel.spindles[2].spindle
    assert (plc.plc_controlled, plc.logical_number, channel.spindles[2].index) == (True, 10, None)
    limits = channel.parameters.realtime_cycles
    assert limits.enable
    assert (limits.memory_bytes, limits.buffers) == (48_000, 5)
    assert (limits.max_duration_pct, limits.cont_steps, limits.max_steps) == (75, 100, 2**32 - 2)
    assert channel.parameters.channel_variables_bytes == 10_000
    assert channel.parameters.max_override_pct == 100


def test_program_start(demo: Machine) -> None:
    """MO-15: G00 G17 G71 G90, 1000 mm/min, exact stop after G00, trapezoid."""
    parameters = demo.channels[0].parameters
    start = parameters.program_start
    assert start.g_functions == {0: 0, 4: 17, 12: 71, 14: 90, 23: 162}
    assert (start.feed_mm_min, start.feed_unit_mm_min, start.slope_profile) == (1000, 1, 0)
    assert parameters.exact_stop_after_g00


@pytest.mark.parametrize("kind", ["m", "h"])
def test_technology_functions(demo: Machine, kind: str) -> None:
    """MO-15: 100 … 110 are MOS, then one of each synchronisation type."""
    parameters = demo.channels[0].parameters
    functions = parameters.m_functions if kind == "m" else parameters.h_functions
    assert {functions[number].synchronisation for number in range(100, 111)} == {"MOS"}
    others = [functions[number].synchronisation for number in range(111, 118)]
    assert others == [
        "MVS_SVS",
        "MVS_SNS",
        "MNS_SNS",
        "MVS_SLM",
        "MVS_SLP",
        "MNE_SNS",
        "NO_SYNCH",
    ]
    assert functions[118].modifiers == ("PLC_INFO",)


@pytest.mark.parametrize(
    ("path", "type_", "synchronous", "scope"),
    [
        ("VALUE", "REAL64", True, "GLOBAL"),
        ("VALUE1", "REAL64", True, "GLOBAL"),
        ("VALUE2", "REAL64", True, "CHANNEL"),
        ("COUNT_POS", "SGN32", True, "CHANNEL"),
        ("COUNT_NEG", "SGN32", True, "CHANNEL"),
        ("COUNT_NULL", "SGN32", True, "CHANNEL"),
        ("CONDITION", "SGN32", True, "CHANNEL"),
        ("TRIGGER", "SGN32", True, "GLOBAL"),
        ("SYNC", "REAL64", True, "CHANNEL"),
        ("ASYNC", "REAL64", False, "CHANNEL"),
        ("COUNT", "UNS32", True, "CHANNEL"),
        ("LIST[9]", "REAL64", True, "CHANNEL"),
        ("FLAG", "BOOLEAN", True, "CHANNEL"),
        ("TEXT", "STRING", True, "CHANNEL"),
        ("LEVEL_1_A[0].REAL64", "REAL64", True, "CHANNEL"),
        ("LEVEL_1_A[2].FROZEN", "REAL64", False, "CHANNEL"),
        ("LEVEL_1_A[1].LEVEL_2_A[1].LIST[3]", "SGN32", True, "CHANNEL"),
    ],
)
def test_variables(demo: Machine, path: str, type_: str, synchronous: bool, scope: str) -> None:
    """MO-15: the variables of the manuals' examples, and some of each type."""
    leaf = leaves(demo)[path]
    assert (leaf.type, leaf.synchronous, leaf.scope.value) == (type_, synchronous, scope)


def test_variables_have_each_type_and_right(demo: Machine) -> None:
    """Every basic type but VSTRING, and every access right."""
    found = leaves(demo)
    assert {leaf.rights for leaf in found.values()} == set(AccessRights)
    expected = {"BOOLEAN", "SGN08", "UNS08", "SGN16", "UNS16", "SGN32", "UNS32", "REAL64", "STRING"}
    assert {leaf.type for leaf in found.values()} == expected


def test_channel_variables(demo: Machine) -> None:
    """V.CH.VarTest1 of the manual is asynchronous."""
    found = {one.name: one for one in demo.channels[0].channel_variables}
    assert not found["VarTest1"].node.synchronous
    assert found["Total"].node.synchronous


@pytest.mark.parametrize("name", BUILT_IN_MACHINES)
def test_each_built_in_machine_has_a_name(name: str) -> None:
    """It loads by its name without any finding; a folder of that name counts before it."""
    machine = load_machine(name)
    assert (machine.name, machine.diagnostics) == (name, ())
    assert load_machine(name, detail="effects").diagnostics == ()


def test_five_axes() -> None:
    """X, Y, Z, C modulo 360° and A within ±110°, a head C A, and a program that moves them."""
    machine = load_machine("demo5")
    assert [axis.name for axis in machine.axes] == ["X", "Y", "Z", "C", "A", "S"]
    c, a = machine.axes[3:5]
    assert (a.type, a.software_limit_low, a.software_limit_high) == (AxisType.ROTARY, -110, 110)
    assert (c.is_modulo, c.modulo_range) == (True, 360)
    transformations = machine.channels[0].parameters.transformations
    assert (transformations.default_ids[0], list(transformations.steps[0])) == (91, [91, 13, 15])
    assert machine.diagnostics == load_machine("demo").diagnostics == ()
    controller = Controller(machine)
    run = controller.run(NcText("p.nc", "T1 D1\nM6\nS1000 M3\nG01 X10 A90 C450 F6000\nM9\nM30\n"))
    assert run.state == "ended", run.diagnostics
    axes = [controller.read(f"V.RTA.ACS.ACT_POS.{name}") for name in "XAC"]
    assert axes == pytest.approx([10, 90, 90])
    outside = controller.run(NcText("p.nc", "G00 A111\nM30\n"))
    assert outside.state == "error"


def test_a_folder_counts_before_a_built_in_machine(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """``demo5`` in the working directory is a folder of the user's."""
    shutil.copytree(Path(load_machine(None).folder), tmp_path / "demo5")
    monkeypatch.chdir(tmp_path)
    assert [axis.name for axis in load_machine("demo5").axes][3] == "A"


def test_a_machine_that_is_not_there() -> None:
    """The remedy names the built-in ones."""
    with pytest.raises(Failure) as failure:
        load_machine("demo6")
    assert failure.value.diagnostics[0].remedy("en").endswith("demo, demo5")


def test_functions_of_usual_machines(demo: Machine) -> None:
    """Tool change, coolant, gear steps and the first H functions are defined, spindles have M3."""
    parameters = demo.channels[0].parameters
    assert {6, 7, 8, 9, 10, 11, 40, 41, 42, 43, 44, 45} <= parameters.m_functions.keys()
    assert set(range(1, 10)) <= parameters.h_functions.keys()
    program = "M6\nM8\nS1000 M3\nM40\nH1 H9\nM5\nM19 S.POS=90\nM9\nM30\n"
    assert Controller(demo).run(NcText("p.nc", program)).state == "ended"
