# SPDX-License-Identifier: MIT
"""The coordinate systems in the values of channel lists."""

from __future__ import annotations

from collections.abc import Mapping

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.values import Values

#: The parts of a coordinate system, as entries name them: along and about the main axes.
_COMPONENTS = (
    "translation.t1", "translation.t2", "translation.t3",
    "rotation.a1", "rotation.a2", "rotation.a3",
)  # fmt: skip
#: The second axis of an effector's coordinate system: its plane's name -> the main axes in it.
_EFFECTOR_PLANES = {"XY": (0, 1), "ZX": (2, 0), "YZ": (1, 2)}


@dataclass(frozen=True, slots=True)
class ListedSystems:
    """Six components (mm, degrees) by name in upper case, P-CHAN-00490 … 496.

    ``is_rotation_fixed``: P-CHAN-00393. ``has_own_offsets``: P-CHAN-00397. ``effector_plane``: the
    axes of P-CHAN-00050; ``has_first_effector_axis``: X of ``#ECS`` lies in it, not Y.
    """

    systems: Mapping[str, tuple[float, ...]]
    is_rotation_fixed: bool
    has_own_offsets: bool
    effector_plane: tuple[int, int]
    has_first_effector_axis: bool


def listed_systems(values: Values) -> ListedSystems:
    """Return the coordinate systems of a channel list; those without a name do not count.

    Of two paths in a channel the first counts.
    """
    systems = {}
    for index in values.indices("coordinate_system.def[]"):
        name = values.text("coordinate_system.def[].id", index).upper()
        keys = [f"coordinate_system.def[].path[].{component}" for component in _COMPONENTS]
        components = tuple(values.real(key, index, 0) for key in keys)
        if name:
            systems[name] = components
    return ListedSystems(
        systems,
        values.flag("coordinate_system.rotation_mode_fixed"),
        values.flag("coordinate_system.axes_offsets_layer_specific"),
        _EFFECTOR_PLANES[values.text("mach_plane_of_2nd_ecs_ax").upper()],
        values.text("kind_of_2nd_ecs_ax").upper() == "X",
    )
