# SPDX-License-Identifier: MIT
"""Messages about kinematic transformations in lists: defects that make one unusable."""

from __future__ import annotations

from nctakt.messages.catalogue import warning

_ID = ("the ID of the kinematic", "die ID der Kinematik")
_KEY = ("the entry's name", "der Name des Eintrags")
_COUNT = ("the number of its axes", "die Anzahl ihrer Achsen")
_VALUE = ("the value in the list", "der Wert in der Liste")

KINEMATIC_GIVEN_TWICE = warning(
    901487,
    en="{key}: kinematic {id} is defined twice; this definition is ignored",
    de="{key}: die Kinematik {id} ist doppelt definiert; diese Definition wird ignoriert",
    remedy_en="Give each kinematic a different ID; several of them may have the same type.",
    remedy_de="Jeder Kinematik eine eigene ID geben; mehrere dürfen denselben Typ haben.",
    key=_KEY,
    id=_ID,
)
KINEMATIC_WITHOUT_ID = warning(
    901488,
    en="{key}: this kinematic has no ID and cannot be selected",
    de="{key}: diese Kinematik hat keine ID und lässt sich nicht anwählen",
    remedy_en="Give it an ID from 1 to 65535.",
    remedy_de="Ihr eine ID von 1 bis 65535 geben.",
    key=_KEY,
)
KINEMATIC_AXIS_COUNT = warning(
    901489,
    en="{key}: kinematic {id} has {value} axes; it cannot be used",
    de="{key}: die Kinematik {id} hat {value} Achsen; sie ist nicht verwendbar",
    remedy_en="A universal kinematic has 3 to 6 axes, and no more than the channel ({count}).",
    remedy_de="Eine universelle Kinematik hat 3 bis 6 Achsen und nicht mehr als der Kanal "
    "({count}).",
    key=_KEY,
    id=_ID,
    value=_VALUE,
    count=("the number of axes of the channel", "die Anzahl der Achsen des Kanals"),
)
KINEMATIC_CHAIN_INVALID = warning(
    901490,
    en="{key}: the chain {chain} of kinematic {id} does not name each of its {count} axes once",
    de="{key}: die Kette {chain} der Kinematik {id} nennt nicht jede ihrer {count} Achsen einmal",
    remedy_en="Name each axis index from 0 on once, in the order from workpiece to tool.",
    remedy_de="Jeden Achsindex ab 0 einmal nennen, in der Folge vom Werkstück zum Werkzeug.",
    key=_KEY,
    id=_ID,
    chain=("the chain in the list", "die Kette in der Liste"),
    count=_COUNT,
)
KINEMATIC_AXIS_TYPE = warning(
    901491,
    en="{key}: axis {index} of kinematic {id} cannot have the type {value}",
    de="{key}: die Achse {index} der Kinematik {id} kann nicht den Typ {value} haben",
    remedy_en="Axes 0, 1 and 2 are linear (1), all others are rotary (2).",
    remedy_de="Die Achsen 0, 1 und 2 sind linear (1), alle weiteren rotatorisch (2).",
    key=_KEY,
    id=_ID,
    index=("the index of the axis", "der Index der Achse"),
    value=_VALUE,
)
KINEMATIC_ZERO_DIRECTION = warning(
    901492,
    en="{key}: this direction vector of kinematic {id} is zero; it cannot be used",
    de="{key}: dieser Richtungsvektor der Kinematik {id} ist null; sie ist nicht verwendbar",
    remedy_en="Give at least one component, e.g. 0 0 1 for Z; the length does not matter.",
    remedy_de="Mindestens eine Komponente angeben, z. B. 0 0 1 für Z; die Länge spielt keine "
    "Rolle.",
    key=_KEY,
    id=_ID,
)
KINEMATIC_DEPENDENT_AXES = warning(
    901493,
    en="{key}: the linear axes of kinematic {id} do not span the space; it cannot be used",
    de="{key}: die Linearachsen der Kinematik {id} spannen den Raum nicht auf; nicht verwendbar",
    remedy_en="Their three directions, and the rows of a linkage matrix, must not lie in a plane.",
    remedy_de="Ihre drei Richtungen und die Zeilen einer Linkage-Matrix dürfen nicht in einer "
    "Ebene liegen.",
    key=_KEY,
    id=_ID,
)
KINEMATIC_PROGRAMMING_MODE = warning(
    901494,
    en="{key}: {value} is not a programming mode of kinematic {id}; it cannot be used",
    de="{key}: {value} ist kein Programmiermodus der Kinematik {id}; sie ist nicht verwendbar",
    remedy_en="Use 10 (vector), 12 or -1 (direct), 13 (conformal), 14 to 19 (AB BA AC CA BC CB).",
    remedy_de="10 (Vektor), 12 oder -1 (direkt), 13 (konform), 14 bis 19 (AB BA AC CA BC CB) "
    "angeben.",
    key=_KEY,
    id=_ID,
    value=_VALUE,
)
KINEMATIC_ORIENTATION_AXES = warning(
    901495,
    en="{key}: kinematic {id} cannot turn the tool in every direction; it cannot be used",
    de="{key}: die Kinematik {id} kann das Werkzeug nicht ausrichten; sie ist nicht verwendbar",
    remedy_en="A complete one needs two rotary axes that are not parallel, the second not along "
    "the tool.",
    remedy_de="Eine vollständige braucht zwei nicht parallele Rundachsen, die zweite nicht längs "
    "des Werkzeugs.",
    key=_KEY,
    id=_ID,
)
KINEMATIC_VECTOR_AXES = warning(
    901496,
    en="{key}: kinematic {id} is programmed by a vector, and the channel has {count} axes only",
    de="{key}: die Kinematik {id} wird per Vektor programmiert, der Kanal hat nur {count} Achsen",
    remedy_en="Give the channel six axes: X, Y, Z, and U, V, W for the vector.",
    remedy_de="Dem Kanal sechs Achsen geben: X, Y, Z und für den Vektor U, V, W.",
    key=_KEY,
    id=_ID,
    count=("the number of axes of the channel", "die Anzahl der Achsen des Kanals"),
)
ORIENTATION_MODE_WITHOUT_EFFECT = warning(
    901763,
    en="ori.mode {mode} has no effect: words of rotary axes are angles",
    de="ori.mode {mode} wirkt nicht: Wörter von Rundachsen sind Winkel",
    remedy_en="Use ANGLE or VECTOR_2DOF; the other modes are for six axes and not simulated.",
    remedy_de="ANGLE oder VECTOR_2DOF angeben; die übrigen sind für sechs Achsen und nicht "
    "simuliert.",
    mode=_VALUE,
)
