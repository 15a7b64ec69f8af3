# SPDX-License-Identifier: MIT
"""A kinematic of the lists and the active tool -> the row of its map, or why there is none."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.decoder.kinematics.chain import Chain, map_values
from nctakt.decoder.kinematics.fixed_types import (
    FIXED_TYPES,
    fixed_chain,
    has_tube_head,
    universal_chain,
)
from nctakt.kernel.kinematics import map_rows
from nctakt.lists.declared.tools import Tool
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.transformations.kinematics import TRIPODS, Entry, Kinematic
from nctakt.lists.machine.transformations.universal_kinematic import (
    PARAMETERS,
    DefinitionReader,
    UnusableKinematicError,
)

_TUBE_HEADS = 90
_PLANES = (13, 14, 15)

#: Why no position of the axes leads to a position of the tool, by the answer of a map.
REASONS = {
    map_rows.OUT_OF_REACH: Text(
        "the rotary axes cannot turn the tool into this direction",
        "die Rundachsen können das Werkzeug nicht in diese Richtung drehen",
    ),
    map_rows.NO_DIRECTION: Text(
        "the vector along the tool is zero", "der Vektor längs des Werkzeugs ist null"
    ),
    map_rows.SINGULAR: Text(
        "linear axes have come to lie in one plane", "Linearachsen sind in eine Ebene geraten"
    ),
}


@dataclass(frozen=True, slots=True)
class ChannelAxes:
    """The axes of a channel: their names, their numbers in the machine, which are rotary.

    -1 as a number: the place is free. ``limits``: their software limits, infinite without any.
    """

    names: tuple[str, ...]
    members: tuple[int, ...]
    are_rotary: tuple[bool, ...]
    limits: tuple[tuple[float, float], ...]


def refusal(kinematic: Kinematic, axes: ChannelAxes) -> Text | None:
    """Return why a kinematic cannot be active in a channel; ``None`` if it can."""
    if kinematic.defect is not None:
        return kinematic.defect
    if kinematic.universal is not None:
        return _refused_axes(universal_chain(kinematic.universal, axes.names), axes)
    if kinematic.type not in FIXED_TYPES:
        return _refused_type(kinematic.type)
    if kinematic.type == _TUBE_HEADS and not has_tube_head(kinematic.parameters):
        return Text(
            "HD13 names a head whose geometry is not published",
            "HD13 nennt einen Kopf, dessen Geometrie nicht veröffentlicht ist",
        )
    return _refused_axes(fixed_chain(kinematic.type, kinematic.parameters), axes)


def _refused_type(type_: int) -> Text:
    """Return why there is no kinematic of a type."""
    if type_ in TRIPODS:
        return Text(
            f"type {type_} is a tripod, whose arrangement of struts is not published",
            f"Typ {type_} ist ein Tripod, dessen Anordnung der Streben nicht veröffentlicht ist",
        )
    if type_ in _PLANES:
        return Text(
            f"type {type_} belongs to #FACE or #CYL and is selected by these",
            f"Typ {type_} gehört zu #FACE oder #CYL und wird damit angewählt",
        )
    return Text(f"type {type_} is not simulated", f"Typ {type_} wird nicht simuliert")


def _refused_axes(chain: Chain, axes: ChannelAxes) -> Text | None:
    """Return why a chain does not fit the axes of the channel."""
    for joint in chain.joints:
        if joint.axis >= len(axes.names) or axes.members[joint.axis] < 0:
            return Text(
                f"it needs an axis at index {joint.axis}, and the channel has {len(axes.names)}",
                f"sie braucht eine Achse am Index {joint.axis}, der Kanal hat {len(axes.names)}",
            )
        if joint.is_rotary and not axes.are_rotary[joint.axis]:
            name = axes.names[joint.axis]
            return Text(
                f"axis {name} at index {joint.axis} is not a rotary axis",
                f"die Achse {name} am Index {joint.axis} ist keine Rundachse",
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

    def set_base(self, kinematic: Kinematic, index: int, value: float) -> None:
        """Change an offset that only coupling kinematics use."""
        base = {**kinematic.base, index: value}
        self._kinematics[0][kinematic.id] = replace(kinematic, base=base)

    def set_entry(self, kinematic: Kinematic, entry: Entry, value: float) -> None:
        """Change a number of a kinematic of type 91 for the next activation in step 0."""
        entries = {**kinematic.entries, entry: value}
        self._kinematics[0][kinematic.id] = self._defined(kinematic, entries)

    def _defined(self, kinematic: Kinematic, entries: Mapping[Entry, float]) -> Kinematic:
        """Return a kinematic of type 91 with other numbers, which may not be usable."""
        reader = DefinitionReader(
            lambda entry: entries.get(entry, 0.0),
            len(self.axes.names),
            self.transformations.rotation_angle,
        )
        try:
            universal = reader.read()
        except UnusableKinematicError as error:
            key = f"V.G.KIN[{kinematic.id}].{error.name.upper()}"
            values = {"key": key, "id": kinematic.id, **error.values}
            text = error.message.text
            defect = Text(text.en.format(**values), text.de.format(**values))
            return replace(kinematic, entries=entries, defect=defect)
        return replace(kinematic, universal=universal, entries=entries, defect=None)

    def with_tool(self, kinematic: Kinematic, tool: Tool) -> Kinematic:
        """Return a kinematic of step 0 with a tool's additions to its parameters (P-TOOL-00009)."""
        more = tool.kinematic_parameters
        if not any(more.values()):
            return kinematic
        if kinematic.universal is None:
            return replace(kinematic, parameters=added(kinematic.parameters, more))
        entries = dict(kinematic.entries)
        for index, value in more.items():
            if index < len(PARAMETERS):
                entry = PARAMETERS[index]
                entries[entry] = entries.get(entry, 0.0) + value
        return self._defined(kinematic, entries)

    def refusal(self, kinematic: Kinematic) -> Text | None:
        """Return why a kinematic cannot be active in the channel; ``None`` if it can."""
        return refusal(kinematic, self.axes)

    def map_values(self, step: int, kinematic: Kinematic, tool: Tool) -> list[float]:
        """Return the row of a kinematic that is not refused, for ``KinematicMaps.add``.

        The tool's additions to the parameters count in step 0 only.
        """
        chain = self.chain(kinematic if step else self.with_tool(kinematic, tool))
        return map_values(chain, self.axes.members, tool.length)

    def chain(self, kinematic: Kinematic) -> Chain:
        """Return the chain of a kinematic that is not refused."""
        if kinematic.universal is not None:
            return universal_chain(kinematic.universal, self.axes.names)
        return fixed_chain(kinematic.type, kinematic.parameters)


def added(values: Mapping[int, float], more: Mapping[int, float]) -> dict[int, float]:
    """Return parameters with the additions of a tool."""
    return {
        index: values.get(index, 0.0) + more.get(index, 0.0) for index in sorted({*values, *more})
    }
