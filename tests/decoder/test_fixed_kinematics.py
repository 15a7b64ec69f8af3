# SPDX-License-Identifier: MIT
"""Fixed types and the examples of the universal kinematic against formulas (language: 1.4, 1.5)."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from support.kinematic_chains import Map

from nctakt.decoder.kinematics.fixed_types import FIXED_TYPES, fixed_chain, universal_chain
from nctakt.lists.machine.transformations.kinematics import KinematicAxis, UniversalKinematic

LENGTH = 120.0
UNITS = 10_000.0


def about(axis: str, degrees: float) -> np.ndarray:
    """Return the rotation about a main axis."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    if axis == "X":
        return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    if axis == "Y":
        return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def formula(type_: int, hd: dict[int, float], q: list[float]) -> np.ndarray:
    """Return the tip by the written-out formula of a type; ``q``: X Y Z and two angles."""
    p, first, second = np.array(q[:3]), q[3], q[4]
    if type_ == 9:
        tool = np.array([0, hd[9], -hd[1] - LENGTH])
        arm = np.array([hd[6], hd[5], -hd[2]]) + about("X", second + hd[3]) @ tool
        return p + np.array([hd[7], hd[8], 0]) + about("Z", first + hd[4]) @ arm
    if type_ == 10:
        arm = about("X", second + hd[4]) @ np.array([0, -hd[2] - LENGTH, 0])
        arm = arm + np.array([0, 0, -hd[3]])
        return p + np.array([hd[7], hd[8], 0]) + about("Z", first + hd[5]) @ arm
    if type_ == 16:
        tool = np.array([hd[5], hd[6], -hd[1] - LENGTH])
        arm = np.array([hd[2], hd[3], -hd[4]]) + about("X", second + hd[7]) @ tool
        return p + about("Y", first + hd[8]) @ arm
    if type_ == 22:
        return p + about("X", first) @ about("Y", second) @ np.array([0, 0, -hd[1] - LENGTH])
    if type_ == 23:
        tip = p + about("X", first) @ np.array([0, 0, -hd[1] - LENGTH])
        platform = np.array([0, 0, hd[2]])
        return about("Y", -second) @ (tip + platform) - platform
    if type_ == 30:
        tool = np.array([-hd[2], -hd[3], -hd[1] - LENGTH])
        return p - np.array([hd[6], hd[7], hd[8]]) + about("X", first + hd[5]) @ tool
    if type_ == 34:
        centre = np.array([hd[2], hd[3], 0])
        return about("Z", -first) @ (p - [0, 0, LENGTH] - centre) + centre
    assert type_ == 90  # HD13 = 4: C B
    tool = np.array([hd[2], hd[3], -hd[1] - LENGTH])
    arm = np.array([hd[4], hd[5], hd[6]]) + about("Y", second + hd[18]) @ tool
    start = np.array([hd[7] - hd[4], hd[8] - hd[5], hd[9] - hd[6]])
    return p + start + about("Z", first + hd[17]) @ arm


@pytest.mark.parametrize("type_", sorted(set(FIXED_TYPES) - {33}))
def test_fixed_type_is_its_formula(type_: int) -> None:
    """The tip of a fixed type with any lengths and angle offsets, and the way back."""
    numbers = random.Random(type_)
    for _ in range(10):
        hd = {i: numbers.uniform(1.0, 90.0) for i in range(1, 21)}
        hd[13] = 4 / UNITS
        values = {number - 1: value * UNITS for number, value in hd.items()}
        mapped = Map(fixed_chain(type_, values), LENGTH)
        positions = [numbers.uniform(-300.0, 300.0) for _ in range(6)]
        forward = mapped.forward(positions)
        assert np.allclose(forward[:3], formula(type_, hd, positions), rtol=0.0, atol=1e-9)
        assert np.allclose(mapped.inverse(forward, positions), positions, rtol=0.0, atol=1e-9)


def test_negative_sign_turns_the_other_way() -> None:
    """A negative direction parameter lets the axis turn against the right hand."""
    forward = Map(fixed_chain(22, {0: 0.0, 3: -1.0}), LENGTH).forward([0, 0, 0, 30.0, 0, 0])
    assert forward[1] == pytest.approx(-LENGTH * math.sin(math.radians(30.0)))


def test_oblique_head_reaches_the_direction_of_a_head_c_a() -> None:
    """Type 33 is programmed as a head C A and moves no linear axis for it."""
    mapped = Map(fixed_chain(33, {2: 45.0 * UNITS}), LENGTH)
    programmed = [10.0, 20.0, 30.0, 25.0, 40.0, 0.0]
    axes = mapped.inverse(programmed, [0.0] * 6)
    assert axes[:3] == programmed[:3]
    wanted = about("Z", 25.0) @ about("X", 40.0) @ np.array([0, 0, 1])
    assert np.allclose(mapped.direction(axes), wanted, atol=1e-12)
    assert np.allclose(mapped.forward(axes, programmed), programmed, atol=1e-9)


def test_oblique_head_does_not_reach_beyond_twice_its_angle() -> None:
    """A head at 45° tilts the tool by 90° at most; beyond, the answer says so."""
    mapped = Map(fixed_chain(33, {2: 45.0 * UNITS}), LENGTH)
    assert mapped.answer([0, 0, 0, 0, 90.0, 0], [0.0] * 6) == 0
    assert mapped.answer([0, 0, 0, 0, 90.1, 0], [0.0] * 6) == 1


# --- the universal kinematic: published examples --------------------------------------------------

LINEAR = tuple(
    KinematicAxis(False, direction, (0.0, 0.0, 0.0))
    for direction in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
)


def universal(
    chain: tuple[int, ...], rotary: tuple[KinematicAxis, ...], mode: int = 17, rtcp: bool = True
) -> UniversalKinematic:
    """Return a kinematic with its tool along Z."""
    zero = (0.0, 0.0, 0.0)
    return UniversalKinematic((0.0, 0.0, 5.0), zero, rtcp, mode, LINEAR + rotary, chain)


def test_tool_is_added_against_its_direction() -> None:
    """TCP = zero position less the tool's length along the zero orientation, of any length."""
    axis = KinematicAxis(True, (0.0, 0.0, 2.0), (0.0, 0.0, 0.0))
    chain = universal_chain(universal((0, 1, 2, 3), (axis,)), "XYZC")
    assert Map(chain, LENGTH).forward([1.0, 2.0, 3.0, 50.0, 0, 0])[:3] == [1.0, 2.0, 3.0 - LENGTH]


def test_axis_through_a_point() -> None:
    """C of a table through (800, 1200, 0) turns the workpiece about that point."""
    axis = KinematicAxis(True, (0.0, 0.0, -1.0), (800.0, 1200.0, 0.0))
    mapped = Map(universal_chain(universal((3, 0, 1, 2), (axis,)), "XYZC"))
    forward = mapped.forward([800.0, 1200.0, 5.0, 77.0, 0, 0])
    assert np.allclose(forward[:3], [800.0, 1200.0, 5.0], atol=1e-12)
    forward = mapped.forward([900.0, 1200.0, 5.0, 90.0, 0, 0])
    assert np.allclose(forward[:3], [800.0, 1100.0, 5.0], atol=1e-12)


def test_table_a_c() -> None:
    """Chain C A X Y Z with negated directions: the workpiece turns under the tool."""
    zero = (0.0, 0.0, 0.0)
    rotary = (
        KinematicAxis(True, (0.0, 0.0, -1.0), zero),
        KinematicAxis(True, (-1.0, 0.0, 0.0), zero),
    )
    mapped = Map(universal_chain(universal((3, 4, 0, 1, 2), rotary), "XYZCA"))
    positions = [30.0, -20.0, 70.0, 35.0, 50.0, 0.0]
    wanted = about("Z", -35.0) @ about("X", -50.0) @ np.array(positions[:3])
    assert np.allclose(mapped.forward(positions)[:3], wanted, rtol=0.0, atol=1e-9)


@pytest.mark.parametrize(
    ("names", "mode", "first", "second"),
    [("XYZCA", 17, 3, 4), ("XYZAC", 17, 4, 3), ("XYZAC", 16, 3, 4), ("XYZUV", 16, 3, 4)],
)
def test_angles_belong_to_the_axes_of_their_names(
    names: str, mode: int, first: int, second: int
) -> None:
    """In mode CA the word C holds the first angle, wherever the axis C is."""
    zero = (0.0, 0.0, 0.0)
    rotary = (
        KinematicAxis(True, (0.0, 0.0, 1.0), zero),
        KinematicAxis(True, (1.0, 0.0, 0.0), zero),
    )
    chain = universal_chain(universal((0, 1, 2, 3, 4), rotary, mode, rtcp=False), names)
    assert chain.angles is not None
    assert (chain.angles.first, chain.angles.second) == (first, second)


def test_pole_keeps_the_present_angle() -> None:
    """With the tool along the first axis any of its angles will do: it stays where it is."""
    zero = (0.0, 0.0, 0.0)
    rotary = (
        KinematicAxis(True, (0.0, 0.0, 1.0), zero),
        KinematicAxis(True, (1.0, 0.0, 0.0), zero),
    )
    chain = universal_chain(universal((0, 1, 2, 3, 4), rotary, rtcp=False), "XYZCA")
    mapped = Map(chain)
    near = [0.0, 0.0, 0.0, 77.0, 0.0, 0.0]
    assert mapped.inverse([0, 0, 0, 10.0, 0.0, 0], near)[3:5] == [77.0, 0.0]
    assert mapped.inverse([0, 0, 0, 370.0, 20.0, 0], near)[3:5] == pytest.approx([10.0, 20.0])
    near[3] = 200.0
    assert mapped.inverse([0, 0, 0, 10.0, 20.0, 0], near)[3:5] == pytest.approx([190.0, -20.0])


def test_linkage_is_between_axes_and_chain() -> None:
    """A linkage matrix with a shift maps the linear axes before the chain does."""
    plain = universal((0, 1, 2), ())
    half = math.sqrt(0.5)
    linkage = ((half, -half, 0.0), (half, half, 0.0), (0.0, 0.0, 2.0), (1.0, 2.0, 3.0))
    kinematic = UniversalKinematic(
        plain.zero_orientation, plain.zero_position, True, 0, plain.axes, plain.chain, linkage
    )
    mapped = Map(universal_chain(kinematic, "XYZ"))
    forward = mapped.forward([10.0, 10.0, 10.0, 0, 0, 0])
    assert np.allclose(forward[:3], [1.0, 2.0 + 20.0 * half, 23.0], atol=1e-12)
    assert np.allclose(mapped.inverse(forward, [0.0] * 6)[:3], [10.0] * 3, atol=1e-12)


def test_vector_that_is_zero_has_no_direction() -> None:
    """A vector of zero length is reported, not guessed."""
    zero = (0.0, 0.0, 0.0)
    rotary = (
        KinematicAxis(True, (0.0, 0.0, 1.0), zero),
        KinematicAxis(True, (1.0, 0.0, 0.0), zero),
    )
    chain = universal_chain(universal((0, 1, 2, 3, 4), rotary, 10), "XYZUVW")
    assert Map(chain).answer([0, 0, 0, 0, 0, 0], [0.0] * 6) == 2
