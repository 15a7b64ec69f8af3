# SPDX-License-Identifier: MIT
"""Kinematic transformations of a channel (P-CHAN-00262 ff.), as its list describes them."""

from __future__ import annotations

from collections.abc import Mapping

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Text

#: The parameters that a kinematic can have.
MAX_PARAMETERS = 74

#: The type of the universal kinematic.
UNIVERSAL = 91
#: Types whose struts are not published.
TRIPODS = (12, 19)
#: Programming modes of the universal kinematic (P-CHAN-00288).
POINT_VECTOR, DIRECT, CONFORMAL = 10, 12, 13
#: The mode that passes the programmed angles on unchanged (P-CHAN-00112); as DIRECT.
HANDED_ON = -1
#: Modes with two angles of an ideal chain, in the order of their rotary axes.
CLASSIC_MODES = {14: "AB", 15: "BA", 16: "AC", 17: "CA", 18: "BC", 19: "CB"}
PROGRAMMING_MODES = (POINT_VECTOR, DIRECT, CONFORMAL, *CLASSIC_MODES)

Vector = tuple[float, float, float]
#: A number in the definition of a kinematic: its entry, and the indices there.
Entry = tuple[str, tuple[int, ...]]


@dataclass(frozen=True, slots=True)
class KinematicAxis:
    """An axis of the universal kinematic; ``direction`` of any length, ``point`` in mm."""

    is_rotary: bool
    direction: Vector
    point: Vector


@dataclass(frozen=True, slots=True)
class UniversalKinematic:
    """The chain of a kinematic of type 91; lengths in mm.

    ``axes``: by their index in the channel. ``chain``: these indices from the workpiece to the
    tool. ``programming_mode``: 0 where neither P-CHAN-00288 nor P-CHAN-00112 names one.
    ``linkage``: three rows of a matrix and a shift between the linear axes and the chain; empty:
    none.
    """

    zero_orientation: Vector
    zero_position: Vector
    is_rtcp: bool
    programming_mode: int
    axes: tuple[KinematicAxis, ...]
    chain: tuple[int, ...]
    linkage: tuple[Vector, ...] = ()

    @property
    def rotary(self) -> tuple[int, ...]:
        """The indices of the rotary axes, in the order of the chain."""
        return tuple(index for index in self.chain if self.axes[index].is_rotary)


@dataclass(frozen=True, slots=True)
class Kinematic:
    """A kinematic that programs select by its ID.

    ``parameters``: index of P-CHAN-00263 -> value in 0.1 µm or 1e-4°; missing ones are 0. ``base``:
    the same of P-CHAN-00446. ``universal``: of type 91 only; ``entries``: its numbers, missing ones
    are 0. ``defect``: why a definition that a program has changed cannot be used.
    """

    id: int
    type: int
    parameters: Mapping[int, float]
    base: Mapping[int, float] = field(default_factory=dict)
    universal: UniversalKinematic | None = None
    entries: Mapping[Entry, float] = field(default_factory=dict)
    defect: Text | None = None


@dataclass(frozen=True, slots=True)
class Transformations:
    """The transformations of a channel.

    ``default_ids``: those of both steps (P-CHAN-00032, P-CHAN-00264), 0 for none. ``steps``: the
    usable kinematics of each step by their ID. ``orientation_mode``: the name in P-CHAN-00177.
    ``tool_axis``, ``solution``: P-CHAN-00188 and P-CHAN-00189, of #TOOL ORI CS.
    ``is_face_of_milling_machine``: #FACE leaves the tool off the centre line (P-CHAN-00008).
    ``rotation_angle``: P-CHAN-00112. ``has_vector_in_system``: a vector along the tool is one of
    the active coordinate system (P-CHAN-00247). ``is_on_at_start``, ``is_off_at_end``: programs
    begin with the default kinematics active, end with none (P-CHAN-00151, P-CHAN-00152).
    """

    default_ids: tuple[int, int]
    steps: tuple[Mapping[int, Kinematic], ...]
    orientation_mode: str
    tool_axis: int
    solution: int
    is_face_of_milling_machine: bool = False
    rotation_angle: int = 0
    has_vector_in_system: bool = False
    is_on_at_start: bool = False
    is_off_at_end: bool = False
