# SPDX-License-Identifier: MIT
"""Kinematic transformations in channel lists (P-CHAN-00032, 00262 ff.): declarations.

``trafo[j]`` and ``kin_step[0].trafo[j]`` are the same; those of ``kin_step[1]`` belong to the
second step. What they yield is in ``lists/machine/kinematics.py`` and ``kinematic_lists.py``.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, Value, ValueType

MAX_KINEMATICS = 10
MAX_PARAMETERS = 74
MAX_CHAIN = 6
#: Both places of a kinematic in the list.
PREFIXES = ("trafo[]", "kin_step[].trafo[]")
_PATHS = (
    f"trafo[0..{MAX_KINEMATICS - 1}]",
    f"kin_step[0..1].trafo[0..{MAX_KINEMATICS - 1}]",
)
_LENGTH = "0.1 µm"
_CONCERN = "transformation"


def _kinematic(
    id_: str,
    name: str,
    type_: ValueType,
    default: Value,
    en: str,
    de: str,
    *,
    unit: str = "",
    page: str,
) -> tuple[Parameter, ...]:
    return tuple(
        Parameter(
            id_,
            f"{path}.{name}",
            type_,
            default,
            Text(en, de),
            unit=unit,
            concern=_CONCERN,
            page=page,
        )
        for path in _PATHS
    )


_SELECTION = (
    Parameter(
        "P-CHAN-00032",
        "kinematik_id",
        ValueType.UNS16,
        0,
        Text(
            "Kinematic transformation the channel uses unless another is chosen",
            "Kinematische Transformation des Kanals, falls keine andere gewählt wird",
        ),
        concern=_CONCERN,
        page="149237131",
    ),
    Parameter(
        "P-CHAN-00264",
        "default_id_of_kin_step[0..1]",
        ValueType.UNS16,
        0,
        Text(
            "Default kinematic type of each transformation step",
            "Standard-Kinematiktyp jeder Transformationsstufe",
        ),
        concern=_CONCERN,
        page="149244299",
    ),
    Parameter(
        "P-CHAN-00112",
        "ori_rotation_angle",
        ValueType.SGN16,
        0,
        Text(
            "How programmed orientation is read: raw axes, angle sequence or direction vector",
            "Deutung der programmierten Orientierung: Achswerte, Winkelfolge oder Richtungsvektor",
        ),
        concern=_CONCERN,
        page="149269515",
    ),
    Parameter(
        "P-CHAN-00177",
        "ori.mode",
        ValueType.NAME,
        "ANGLE",
        Text(
            "Whether A, B, C or I, J, K hold angles or a direction vector",
            "Ob A, B, C bzw. I, J, K Winkel oder einen Richtungsvektor enthalten",
        ),
        names={"ANGLE": None, "VECTOR_ABC": None, "VECTOR_IJK": None, "VECTOR_2DOF": None},
        concern=_CONCERN,
        page="149430027",
    ),
    Parameter(
        "P-CHAN-00247",
        "ori_wcs",
        ValueType.UNS16,
        0,
        Text(
            "Refers vectors along the tool to the active coordinate system instead of the machine",
            "Bezieht Vektoren längs des Werkzeugs auf das aktive Koordinatensystem statt auf die "
            "Maschine",
        ),
        high=1,
        concern=_CONCERN,
        page="149281931",
    ),
    Parameter(
        "P-CHAN-00151",
        "auto_enable_kin_trafo",
        ValueType.BOOLEAN,
        False,
        Text(
            "Switches the preset transformation on at program start",
            "Schaltet die voreingestellte Transformation bei Programmstart ein",
        ),
        concern=_CONCERN,
        page="149286667",
    ),
    Parameter(
        "P-CHAN-00152",
        "auto_disable_kin_trafo",
        ValueType.BOOLEAN,
        False,
        Text(
            "Switches the transformation off at program end",
            "Schaltet die Transformation am Programmende aus",
        ),
        concern=_CONCERN,
        page="152368011",
    ),
    Parameter(
        "P-CHAN-00008",
        "cax_face_id",
        ValueType.UNS16,
        0,
        Text(
            "#FACE: 1 on a lathe (kinematic 13), 2 on a milling machine (14); 0 as 1",
            "#FACE: 1 Drehmaschine (Kinematik 13), 2 Fräsmaschine (14); 0 wie 1",
        ),
        high=2,
        concern=_CONCERN,
        page="149146635",
    ),
    Parameter(
        "P-CHAN-00188",
        "tool_ori_cs.axis",
        ValueType.UNS16,
        0,
        Text(
            "Direction for tool alignment: X, Y or Z of the active coordinate system",
            "Richtung für das Ausrichten des Werkzeugs: X, Y oder Z des aktiven Koordinatensystems",
        ),
        high=3,
        concern=_CONCERN,
        page="149277323",
    ),
    Parameter(
        "P-CHAN-00189",
        "tool_ori_cs.mode",
        ValueType.UNS16,
        0,
        Text(
            "Which of several axis solutions is taken when aligning the tool",
            "Welche von mehreren Achslösungen beim Ausrichten des Werkzeugs gilt",
        ),
        high=4,
        concern=_CONCERN,
        page="347022219",
    ),
)

KINEMATICS = (
    *_SELECTION,
    *_kinematic(
        "P-CHAN-00262",
        "id",
        ValueType.UNS16,
        0,
        "Kinematic type to which a parameter set belongs",
        "Kinematiktyp, zu dem ein Parametersatz gehört",
        page="149247371",
    ),
    *_kinematic(
        "P-CHAN-00829",
        "type",
        ValueType.UNS32,
        0,
        "Type of kinematic",
        "Typ der Kinematik",
        page="",
    ),
    *_kinematic(
        "P-CHAN-00263",
        f"param[0..{MAX_PARAMETERS - 1}]",
        ValueType.REAL64,
        0.0,
        "Kinematic offsets of a transformation",
        "Kinematikversätze einer Transformation",
        unit="0.1 µm, 1e-4°",
        page="149248907",
    ),
    *_kinematic(
        "P-CHAN-00446",
        "base[0..5]",
        ValueType.REAL64,
        0.0,
        "Offset of a kinematic on another one in a coupling kinematic (type 210); for V.G.KIN only",
        "Versatz einer Kinematik auf einer anderen in einer Koppelkinematik (Typ 210); nur V.G.KIN",
        unit="0.1 µm, 1e-4°",
        page="654132491",
    ),
    *_kinematic(
        "P-CHAN-00285",
        "zero_orientation[0..2]",
        ValueType.REAL64,
        0.0,
        "Tool direction vector at zero axis positions",
        "Richtungsvektor des Werkzeugs in Nullstellung der Achsen",
        page="149253003",
    ),
    *_kinematic(
        "P-CHAN-00286",
        "zero_position[0..2]",
        ValueType.REAL64,
        0.0,
        "Tool position in space at zero axis positions",
        "Werkzeugposition im Raum in Nullstellung der Achsen",
        unit=_LENGTH,
        page="149254539",
    ),
    *_kinematic(
        "P-CHAN-00287",
        "rtcp",
        ValueType.REAL64,
        0.0,
        "Full transformation or RTCP for programmed angles of the universal kinematics",
        "Vollständige Transformation oder RTCP für programmierte Winkel der universellen Kinematik",
        page="149256075",
    ),
    *_kinematic(
        "P-CHAN-00288",
        "programming_mode",
        ValueType.REAL64,
        0.0,
        "Orientation by vector or by angles in the universal kinematics",
        "Orientierung über Vektor oder Winkel bei der universellen Kinematik",
        page="149257611",
    ),
    *_kinematic(
        "P-CHAN-00289",
        "number_of_axes",
        ValueType.REAL64,
        0.0,
        "How many axes form the universal kinematic chain",
        "Wie viele Achsen die universelle Kinematikkette bilden",
        page="149259147",
    ),
    *_kinematic(
        "P-CHAN-00290",
        f"chain[0..{MAX_CHAIN - 1}]",
        ValueType.REAL64,
        0.0,
        "Order of the axes along the universal kinematic chain",
        "Reihenfolge der Achsen in der universellen Kinematikkette",
        page="149260683",
    ),
    *_kinematic(
        "P-CHAN-00291",
        f"axis[0..{MAX_CHAIN - 1}].type",
        ValueType.REAL64,
        0.0,
        "Linear or rotary axis in the universal kinematic chain",
        "Linear- oder Drehachse in der universellen Kinematikkette",
        page="149263755",
    ),
    *_kinematic(
        "P-CHAN-00292",
        f"axis[0..{MAX_CHAIN - 1}].orientation[0..2]",
        ValueType.REAL64,
        0.0,
        "Direction vector of an axis in the universal kinematic chain",
        "Richtungsvektor einer Achse in der universellen Kinematikkette",
        page="149265291",
    ),
    *_kinematic(
        "P-CHAN-00293",
        f"axis[0..{MAX_CHAIN - 1}].point[0..2]",
        ValueType.REAL64,
        0.0,
        "Point through which a rotary axis of the universal chain passes",
        "Punkt, durch den eine Drehachse der universellen Kette verläuft",
        unit=_LENGTH,
        page="149266827",
    ),
    *_kinematic(
        "P-CHAN-00294",
        "linkage_mode",
        ValueType.REAL64,
        0.0,
        "Activates a linear mapping from linear axis values to Cartesian space",
        "Aktiviert eine lineare Abbildung der Linearachswerte in den kartesischen Raum",
        page="913303307",
    ),
    *_kinematic(
        "P-CHAN-00295",
        "linkage[0..3][0..2]",
        ValueType.REAL64,
        0.0,
        "Matrix and shift vector that map linear axis values to Cartesian space",
        "Matrix und Verschiebungsvektor zwischen Linearachswerten und kartesischem Raum",
        page="913307915",
    ),
)
