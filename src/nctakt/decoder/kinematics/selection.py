# SPDX-License-Identifier: MIT
"""A kinematic of the lists and the active tool -> the row of its map, or why there is none."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.decoder.kinematics.chain import Chain, map_values
from nctakt.decoder.kinematics.fixed_types import FIXED_TYPES, fixed_chain, has_tube_head
from nctakt.decoder.kinematics.universal import universal_chain
from nctakt.lists.declared.tools import Tool
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.kinematics import Kinematic

#: Types whose signs no source settles: a note says that plain geometry decides.
DECIDED_TYPES = frozenset(FIXED_TYPES)
_TUBE_HEADS = 90


@dataclass(frozen=True, slots=True)
class ChannelAxes:
    """The axes of a channel: their names, their numbers in the machine, which are rotary."""

    names: tuple[str, ...]
    members: tuple[int, ...]
    are_rotary: tuple[bool, ...]


def refusal(kinematic: Kinematic, axes: ChannelAxes) -> Text | None:
    """Return why a kinematic cannot be active in a channel; ``None``: it can."""
    if kinematic.universal is not None:
        return _refused_axes(universal_chain(kinematic.universal, axes.names), axes)
    if kinematic.type not in FIXED_TYPES:
        return Text(
            f"type {kinematic.type} is not simulated",
            f"Typ {kinematic.type} wird nicht simuliert",
        )
    if kinematic.type == _TUBE_HEADS and not has_tube_head(kinematic.parameters):
        return Text(
            "HD13 names a head whose geometry is not published",
            "HD13 nennt einen Kopf, dessen Geometrie nicht veröffentlicht ist",
        )
    return _refused_axes(fixed_chain(kinematic.type, kinematic.parameters), axes)


def _refused_axes(chain: Chain, axes: ChannelAxes) -> Text | None:
    """Return why a chain does not fit the axes of the channel."""
    for joint in chain.joints:
        if joint.axis >= len(axes.names):
            return Text(
                f"it needs an axis at index {joint.axis}, and the channel has {len(axes.names)}",
                f"sie braucht eine Achse am Index {joint.axis}, der Kanal hat {len(axes.names)}",
            )
        if joint.is_rotary and not axes.are_rotary[joint.axis]:
            name = axes.names[joint.axis]
            return Text(
                f"axis {name} at index {joint.axis} is not a rotary axis",
                f"die Achse {name} am Index {joint.axis} ist keine Drehachse",
            )
        if not joint.is_rotary and axes.are_rotary[joint.axis]:
            name = axes.names[joint.axis]
            return Text(
                f"axis {name} at index {joint.axis} is not a linear axis",
                f"die Achse {name} am Index {joint.axis} ist keine Linearachse",
            )
    return None


class ChannelKinematics:
    """The kinematics that the programs of a channel can select."""

    def __init__(self, parameters: ChannelParameters, axes: ChannelAxes) -> None:
        self.transformations = parameters.transformations
        self._kinematics = [dict(step) for step in parameters.transformations.steps]
        self.axes = axes

    def default_id(self, step: int) -> int:
        """Return the ID of the default kinematic of step 0 or 1; 0: none."""
        return self.transformations.default_ids[step]

    def id_of_tool(self, tool: Tool) -> int:
        """Return the ID of the kinematic that a tool preselects; 0: none."""
        return tool.kinematic_id

    def find(self, step: int, id_: int) -> Kinematic | None:
        """Return a usable kinematic of step 0 or 1 by its ID."""
        return self._kinematics[step].get(id_)

    def set_parameter(self, kinematic: Kinematic, index: int, value: float) -> None:
        """Change a parameter, in the units of the lists, for the next activation in step 0."""
        parameters = {**kinematic.parameters, index: value}
        self._kinematics[0][kinematic.id] = replace(kinematic, parameters=parameters)

    def refusal(self, kinematic: Kinematic) -> Text | None:
        """Return why a kinematic cannot be active in the channel; ``None``: it can."""
        return refusal(kinematic, self.axes)

    def map_values(
        self, step: int, kinematic: Kinematic, tool: Tool, length_difference: float
    ) -> list[float]:
        """Return the row of a kinematic that is not refused, for ``KinematicMaps.add``.

        The tool counts in the first step: its length in mm with the difference of #TLC, and what
        it adds to the parameters.
        """
        length, more = (0.0, {}) if step else (tool.length, tool.kinematic_parameters)
        chain = self.chain(kinematic, more)
        return map_values(chain, self.axes.members, length + length_difference)

    def chain(self, kinematic: Kinematic, more: Mapping[int, float]) -> Chain:
        """Return the chain of a kinematic that is not refused, ``more`` added to its parameters."""
        if kinematic.universal is not None:
            return universal_chain(kinematic.universal, self.axes.names)
        return fixed_chain(kinematic.type, added(kinematic.parameters, more))


def added(values: Mapping[int, float], more: Mapping[int, float]) -> dict[int, float]:
    """Return parameters with what a tool adds to them."""
    return {
        index: values.get(index, 0.0) + more.get(index, 0.0) for index in sorted({*values, *more})
    }
