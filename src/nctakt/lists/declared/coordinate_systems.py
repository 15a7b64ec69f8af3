# SPDX-License-Identifier: MIT
"""Channel lists (P-CHAN): coordinate systems that programs find defined, and how they act."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, ValueType

#: The six components of a system: the ends of their IDs and names.
COMPONENTS = (
    ("491", "translation.t1", "Shift along the first main axis", "Verschiebung erste Hauptachse"),
    ("492", "translation.t2", "Shift along the second main axis", "Verschiebung zweite Hauptachse"),
    ("493", "translation.t3", "Shift along the third main axis", "Verschiebung dritte Hauptachse"),
    ("494", "rotation.a1", "Angle about the first main axis", "Winkel um die erste Hauptachse"),
    ("495", "rotation.a2", "Angle about the second main axis", "Winkel um die zweite Hauptachse"),
    ("496", "rotation.a3", "Angle about the third main axis", "Winkel um die dritte Hauptachse"),
)

#: The planes of P-CHAN-00050: their axes.
EFFECTOR_PLANES = {"XY": (0, 1), "ZX": (2, 0), "YZ": (1, 2)}

COORDINATE_SYSTEMS = (
    Parameter(
        "P-CHAN-00031",
        "kind_of_2nd_ecs_ax",
        ValueType.NAME,
        "X",
        Text(
            "Which axis of #ECS lies in the plane of P-CHAN-00050",
            "Welche Achse von #ECS in der Ebene von P-CHAN-00050 liegt",
        ),
        names=dict.fromkeys("XxYy"),
    ),
    Parameter(
        "P-CHAN-00050",
        "mach_plane_of_2nd_ecs_ax",
        ValueType.NAME,
        "XY",
        Text(
            "Plane of the machine in which the axis of P-CHAN-00031 lies",
            "Ebene der Maschine, in der die Achse von P-CHAN-00031 liegt",
        ),
        names=dict.fromkeys((*EFFECTOR_PLANES, *map(str.lower, EFFECTOR_PLANES))),
    ),
    Parameter(
        "P-CHAN-00393",
        "coordinate_system.rotation_mode_fixed",
        ValueType.BOOLEAN,
        False,
        Text(
            "Rotates a coordinate system about the axes as they were before its rotations",
            "Dreht ein Koordinatensystem um die Achsen, wie sie vor seinen Drehungen waren",
        ),
    ),
    Parameter(
        "P-CHAN-00397",
        "coordinate_system.axes_offsets_layer_specific",
        ValueType.BOOLEAN,
        True,
        Text(
            "Tracking axes have offsets of their own in each coordinate system",
            "Mitschleppachsen haben in jedem Koordinatensystem eigene Verschiebungen",
        ),
    ),
    Parameter(
        "P-CHAN-00490",
        "coordinate_system.def[0..9].id",
        ValueType.STRING,
        "",
        Text(
            "Name by which #CS ON, #ACS ON and #BCS ON find a coordinate system",
            "Name, unter dem #CS ON, #ACS ON und #BCS ON ein Koordinatensystem finden",
        ),
        high=7,
    ),
    *(
        Parameter(
            f"P-CHAN-00{number}",
            f"coordinate_system.def[0..9].path[0..1].{name}",
            ValueType.REAL64,
            0.0,
            Text(en, de),
            unit="mm" if name.startswith("t") else "°",
        )
        for number, name, en, de in COMPONENTS
    ),
)
