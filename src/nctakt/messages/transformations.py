# SPDX-License-Identifier: MIT
"""Messages about transformations: ``#KIN ID``, ``#TRAFO``, ``#RTCP`` and what belongs to them."""

from __future__ import annotations

from nctakt.messages.cases import by_limit
from nctakt.messages.catalogue import error, note

TRANSFORMED_WAY_OUTSIDE_LIMITS = error(
    120002,
    known_as=(901600, 50041, 50042),
    cases=by_limit("position", above=120002, below=120003),
    en="the transformation takes axis {axis} to {position}, outside its limits {low} … {high}",
    de="die Transformation führt die Achse {axis} auf {position}, außerhalb ihrer Grenzen {low} … "
    "{high}",
    remedy_en="Change the path or direction of the tool, or the clamping (P-AXIS-00177, -00178).",
    remedy_de="Weg oder Richtung des Werkzeugs oder die Aufspannung ändern (P-AXIS-00177, -00178).",
    axis=("name of the axis", "Name der Achse"),
    position=("a position on the block in mm or degrees", "eine Position im Satz in mm oder Grad"),
    low=("lower limit", "untere Grenze"),
    high=("upper limit", "obere Grenze"),
    reaction=2,
    clearing=3,
)
KIN_ID_DURING_TRANSFORMATION = error(
    20687,
    en="the kinematic cannot be changed while a transformation is active",
    de="die Kinematik kann nicht geändert werden, während eine Transformation aktiv ist",
    remedy_en="Program #TRAFO OFF before it.",
    remedy_de="Davor #TRAFO OFF programmieren.",
    reaction=2,
    clearing=3,
)
KINEMATIC_OF_TOOL_DIFFERS = error(
    20990,
    en="the tool needs kinematic {tool}, but kinematic {active} is active",
    de="das Werkzeug braucht die Kinematik {tool}, aktiv ist aber die Kinematik {active}",
    remedy_en="Program #TRAFO OFF before the tool is selected (P-TOOL-00011).",
    remedy_de="#TRAFO OFF programmieren, bevor das Werkzeug gewählt wird (P-TOOL-00011).",
    tool=("number of the tool's kinematic", "Nummer der Kinematik des Werkzeugs"),
    active=("number of the active kinematic", "Nummer der aktiven Kinematik"),
    reaction=2,
    clearing=3,
)
PARAMETER_DURING_TRANSFORMATION = error(
    21022,
    en="kinematic parameters of the tool cannot be changed while a transformation is active",
    de="Kinematikparameter des Werkzeugs sind bei aktiver Transformation nicht änderbar",
    remedy_en="Program #TRAFO OFF before it, and #TRAFO ON behind it.",
    remedy_de="Davor #TRAFO OFF programmieren, dahinter wieder #TRAFO ON.",
    reaction=2,
    clearing=3,
)
NO_KINEMATIC_SELECTED = error(
    901601,
    en="{command}, but no kinematic is selected",
    de="{command}, aber keine Kinematik ist gewählt",
    remedy_en="Program #KIN ID [number] before it, or set P-CHAN-00032. In the list: {known}",
    remedy_de="Davor #KIN ID [Nummer] programmieren oder P-CHAN-00032 setzen. In der Liste: "
    "{known}",
    command=("the command", "der Befehl"),
    known=("the kinematics of the channel list", "die Kinematiken der Kanalliste"),
    reaction=2,
    clearing=3,
)
UNKNOWN_KINEMATIC = error(
    901602,
    en="the channel list has no kinematic {id}",
    de="die Kanalliste hat keine Kinematik {id}",
    remedy_en="Name one of the list, or add trafo[…].id {id} to it (P-CHAN-00262). In the list: "
    "{known}",
    remedy_de="Eine der Liste angeben oder trafo[…].id {id} ergänzen (P-CHAN-00262). In der Liste: "
    "{known}",
    id=("number of the kinematic", "Nummer der Kinematik"),
    known=("the kinematics of the channel list", "die Kinematiken der Kanalliste"),
    reaction=2,
    clearing=3,
)
KINEMATIC_NOT_POSSIBLE = error(
    901603,
    en="kinematic {id} is not possible: {reason}",
    de="die Kinematik {id} ist nicht möglich: {reason}",
    remedy_en="Select another kinematic, or change trafo[…] in the channel list.",
    remedy_de="Eine andere Kinematik wählen oder trafo[…] in der Kanalliste ändern.",
    id=("number of the kinematic", "Nummer der Kinematik"),
    reason=("why", "warum"),
    reaction=2,
    clearing=3,
)
TRANSFORMATION_DURING_COMPENSATION = error(
    901604,
    en="{command} while the tool's radius is compensated",
    de="{command} während der Werkzeugradiuskorrektur",
    remedy_en="Program G40 and a motion before it.",
    remedy_de="Davor G40 und eine Bewegung programmieren.",
    command=("the command", "der Befehl"),
    reaction=2,
    clearing=3,
)
SECOND_STEP_NOT_SIMULATED = error(
    901605,
    en="a second step of transformations is not simulated",
    de="ein zweiter Schritt von Transformationen wird nicht simuliert",
    remedy_en="Select NONE as its kinematic: #KIN ID [1, NONE].",
    remedy_de="Dafür NONE wählen: #KIN ID [1, NONE].",
    reaction=2,
    clearing=3,
)
TLC_AND_RTCP = error(
    20669,
    en="{command}: #TLC and #RTCP or #TRAFO exclude each other",
    de="{command}: #TLC und #RTCP oder #TRAFO schließen einander aus",
    remedy_en="Switch the other one off before.",
    remedy_de="Vorher das andere ausschalten.",
    command=("the command", "der Befehl"),
    reaction=2,
    clearing=3,
)
TLC_DURING_COMPENSATION = error(
    20671,
    en="#TLC ON while the tool's radius is compensated",
    de="#TLC ON während der Werkzeugradiuskorrektur",
    remedy_en="Program G40 and a motion before it.",
    remedy_de="Davor G40 und eine Bewegung programmieren.",
    reaction=2,
    clearing=3,
)
PTP_DURING_COMPENSATION = error(
    21525,
    en="#PTP ON while the tool's radius is compensated",
    de="#PTP ON während der Werkzeugradiuskorrektur",
    remedy_en="Program G40 and a motion before it.",
    remedy_de="Davor G40 und eine Bewegung programmieren.",
    reaction=2,
    clearing=3,
)
PTP_WITHOUT_TRANSFORMATION = error(
    21527,
    en="#PTP ON, but no transformation is active",
    de="#PTP ON, aber keine Transformation ist aktiv",
    remedy_en="Program #TRAFO ON before it.",
    remedy_de="Davor #TRAFO ON programmieren.",
    reaction=2,
    clearing=3,
)
ARC_DURING_PTP = error(
    901606,
    en="an arc while #PTP is on",
    de="ein Kreisbogen, während #PTP ein ist",
    remedy_en="Program straight lines, or #PTP OFF before it.",
    remedy_de="Geraden programmieren oder davor #PTP OFF.",
    cause_en="With #PTP the axes go straight to the end of the block.",
    cause_de="Mit #PTP fahren die Achsen geradlinig zum Ende des Satzes.",
    reaction=2,
    clearing=3,
)
FIXED_TYPE_SIGNS = note(
    901607,
    en="kinematic {id} has the type {type}: its signs are those of plain geometry",
    de="Kinematik {id} hat den Typ {type}: ihre Vorzeichen sind die der einfachen Geometrie",
    remedy_en="No source prints its equations; docs/conformance.md says how they are read.",
    remedy_de="Keine Quelle nennt ihre Gleichungen; docs/conformance.md sagt, wie sie gelesen "
    "werden.",
    id=("number of the kinematic", "Nummer der Kinematik"),
    type=("type of the kinematic", "Typ der Kinematik"),
)
