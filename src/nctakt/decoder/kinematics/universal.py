# SPDX-License-Identifier: MIT
"""Type 91, the universal kinematic -> its chain."""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.decoder.kinematics.chain import DIRECTIONS, Chain, Joint, ProgrammedAngles, unit
from nctakt.lists.machine.transformations.kinematics import (
    CLASSIC_MODES,
    POINT_VECTOR,
    UniversalKinematic,
)


def universal_chain(kinematic: UniversalKinematic, axis_names: Sequence[str]) -> Chain:
    """Return the chain of a kinematic of type 91; ``axis_names``: those of the channel's axes."""
    joints = tuple(
        Joint(index, axis.is_rotary, unit(axis.direction), axis.point)
        for index in kinematic.chain
        for axis in (kinematic.axes[index],)
    )
    return Chain(
        joints,
        kinematic.zero_position,
        unit(kinematic.zero_orientation),
        programmed_angles(kinematic, axis_names),
        kinematic.programming_mode == POINT_VECTOR,
        kinematic.linkage,
    )


def programmed_angles(
    kinematic: UniversalKinematic, axis_names: Sequence[str]
) -> ProgrammedAngles | None:
    """Return the words programmed for the tool's direction; ``None``: the rotary axes themselves.

    The angles are those of the rotary axes whose names begin with the letters of the mode; without
    such names they go by the index of the axis.
    """
    letters = CLASSIC_MODES.get(kinematic.programming_mode, "")
    rotary = sorted(kinematic.rotary)
    if kinematic.is_rtcp or not letters or len(rotary) < 2:
        return None
    places = {axis_names[index][:1].upper(): index for index in rotary}
    if sorted(places) == sorted(letters):
        rotary = [places[letter] for letter in letters]
    first, second = (DIRECTIONS[letter] for letter in letters)
    return ProgrammedAngles(rotary[0], rotary[1], first, second)
