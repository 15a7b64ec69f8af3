# SPDX-License-Identifier: MIT
"""Messages about transformations: ``#KIN ID``, ``#TRAFO``, ``#RTCP`` and related commands."""

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
    position=("a position on the block in mm or degrees", "eine Position im Satz in mm oder Grad"),
)
KIN_ID_DURING_TRANSFORMATION = error(
    20687,
    en="the kinematic cannot be changed while a transformation is active",
    de="die Kinematik kann nicht geändert werden, während eine Transformation aktiv ist",
    remedy_en="Program #TRAFO OFF before it.",
    remedy_de="Davor #TRAFO OFF programmieren.",
)
KINEMATIC_OF_TOOL_DIFFERS = error(
    20990,
    en="the tool needs kinematic {tool}, but kinematic {active} is active",
    de="das Werkzeug braucht die Kinematik {tool}, aktiv ist aber die Kinematik {active}",
    remedy_en="Program #TRAFO OFF before the tool is selected (P-TOOL-00011).",
    remedy_de="#TRAFO OFF programmieren, bevor das Werkzeug gewählt wird (P-TOOL-00011).",
    tool=("number of the tool's kinematic", "Nummer der Kinematik des Werkzeugs"),
    active=("number of the active kinematic", "Nummer der aktiven Kinematik"),
)
PARAMETER_DURING_TRANSFORMATION = error(
    21022,
    en="kinematic parameters of the tool cannot be changed while a transformation is active",
    de="Kinematikparameter des Werkzeugs sind bei aktiver Transformation nicht änderbar",
    remedy_en="Program #TRAFO OFF before it, and #TRAFO ON after it.",
    remedy_de="Davor #TRAFO OFF programmieren, danach wieder #TRAFO ON.",
)
NO_KINEMATIC_SELECTED = error(
    901601,
    en="{command}, but no kinematic is selected",
    de="{command}, aber keine Kinematik ist gewählt",
    remedy_en="Program #KIN ID [number] before it, or set P-CHAN-00032. In the list: {known}",
    remedy_de="Davor #KIN ID [Nummer] programmieren oder P-CHAN-00032 setzen. In der Liste: "
    "{known}",
    known=("the kinematics of the channel list", "die Kinematiken der Kanalliste"),
    classes=(2, 3),
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
    classes=(2, 3),
)
KINEMATIC_NOT_POSSIBLE = error(
    901603,
    en="kinematic {id} is not possible: {reason}",
    de="die Kinematik {id} ist nicht möglich: {reason}",
    remedy_en="Select another kinematic, or change trafo[…] in the channel list.",
    remedy_de="Eine andere Kinematik wählen oder trafo[…] in der Kanalliste ändern.",
    id=("number of the kinematic", "Nummer der Kinematik"),
    classes=(2, 3),
)
TRANSFORMATION_DURING_COMPENSATION = error(
    901604,
    en="{command} during tool radius compensation",
    de="{command} während der Werkzeugradiuskorrektur",
    remedy_en="Program G40 and a motion before it.",
    remedy_de="Davor G40 und eine Bewegung programmieren.",
    classes=(2, 3),
)
TLC_AND_RTCP = error(
    20669,
    en="{command}: #TLC and #RTCP or #TRAFO exclude each other",
    de="{command}: #TLC und #RTCP oder #TRAFO schließen einander aus",
    remedy_en="Switch the other one off first.",
    remedy_de="Vorher das andere ausschalten.",
)
TLC_DURING_COMPENSATION = error(
    20671,
    en="#TLC ON during tool radius compensation",
    de="#TLC ON während der Werkzeugradiuskorrektur",
    remedy_en="Program G40 and a motion before it.",
    remedy_de="Davor G40 und eine Bewegung programmieren.",
)
PTP_DURING_COMPENSATION = error(
    21525,
    en="#PTP ON during tool radius compensation",
    de="#PTP ON während der Werkzeugradiuskorrektur",
    remedy_en="Program G40 and a motion before it.",
    remedy_de="Davor G40 und eine Bewegung programmieren.",
)
MCS_DURING_PTP = error(
    21531,
    en="{command} switches to machine coordinates while #PTP is on",
    de="{command} schaltet auf Maschinenkoordinaten, während #PTP ein ist",
    remedy_en="Program #PTP OFF before it.",
    remedy_de="Davor #PTP OFF programmieren.",
)
COORDINATE_SYSTEM_DURING_PTP = error(
    21550,
    en="{command} changes the coordinate system while #PTP is on",
    de="{command} ändert das Koordinatensystem, während #PTP ein ist",
    remedy_en="Program #PTP OFF before it.",
    remedy_de="Davor #PTP OFF programmieren.",
)
CONVERSION_DURING_TRANSFORMATION = error(
    21236,
    en="{command} while a transformation or a coordinate system is active",
    de="{command}, während eine Transformation oder ein Koordinatensystem aktiv ist",
    remedy_en="Program #TRAFO OFF and #CS OFF ALL before it; [CS 1 KIN] converts with them.",
    remedy_de="Davor #TRAFO OFF und #CS OFF ALL programmieren; [CS 1 KIN] rechnet mit ihnen um.",
)
NOT_IN_MACHINE_COORDINATES = error(
    901760,
    en="{command} between #MCS ON and #MCS OFF",
    de="{command} zwischen #MCS ON und #MCS OFF",
    remedy_en="Program #MCS OFF before it.",
    remedy_de="Davor #MCS OFF programmieren.",
    classes=(2, 3),
)
POSITION_NOT_REACHED = error(
    901761,
    en="the axes have no position for this: {reason}",
    de="die Achsen haben dafür keine Position: {reason}",
    remedy_en="Program another direction of the tool, or select another kinematic.",
    remedy_de="Eine andere Richtung des Werkzeugs programmieren oder eine andere Kinematik wählen.",
    classes=(2, 3),
)
PTP_WITHOUT_TRANSFORMATION = error(
    21527,
    en="#PTP ON, but no transformation is active",
    de="#PTP ON, aber keine Transformation ist aktiv",
    remedy_en="Program #TRAFO ON before it.",
    remedy_de="Davor #TRAFO ON programmieren.",
)
NO_TOOL_ORIENTATION = error(
    292006,
    en="#TOOL ORI CS is not possible with kinematic {id}: it does not have two rotary axes",
    de="#TOOL ORI CS ist mit der Kinematik {id} nicht möglich: sie hat keine zwei Rundachsen",
    remedy_en="Select a kinematic with two rotary axes.",
    remedy_de="Eine Kinematik mit zwei Rundachsen wählen.",
    id=("number of the kinematic", "Nummer der Kinematik"),
)
TRANSFORMATION_DURING_PTP = error(
    21552,
    en="{command} while #PTP is on",
    de="{command}, während #PTP ein ist",
    remedy_en="Program #PTP OFF before it.",
    remedy_de="Davor #PTP OFF programmieren.",
)
ARC_DURING_PTP = error(
    901606,
    en="an arc while #PTP is on",
    de="ein Kreisbogen, während #PTP ein ist",
    remedy_en="Program straight lines, or #PTP OFF before it.",
    remedy_de="Geraden programmieren oder davor #PTP OFF.",
    cause_en="With #PTP the axes go straight to the end of the block.",
    cause_de="Mit #PTP fahren die Achsen geradlinig zum Ende des Satzes.",
    classes=(2, 3),
)
DIRECTION_OUT_OF_REACH = error(
    901618,
    en="the axes have no position for a point of this block",
    de="für einen Punkt dieses Satzes haben die Achsen keine Stellung",
    remedy_en="Change the direction of the tool, or the path.",
    remedy_de="Die Richtung des Werkzeugs oder den Weg ändern.",
    classes=(2, 3),
)
WAY_THROUGH_POLE = error(
    901619,
    en="the block leads through a pole of the transformation: axis {axis} would jump by {angle}°",
    de="der Satz führt durch einen Pol der Transformation: die Achse {axis} müsste um {angle}° "
    "springen",
    remedy_en="Lead the path past the pole, or turn the axis there before #TRAFO ON.",
    remedy_de="Den Weg am Pol vorbeiführen oder die Achse vor #TRAFO ON drehen.",
    classes=(2, 3),
)
NOT_OF_KINEMATIC = error(
    901819,
    en="{name} is a number of type 91, and kinematic {id} has the type {type}",
    de="{name} ist eine Zahl des Typs 91, die Kinematik {id} hat den Typ {type}",
    remedy_en="Name a kinematic of type 91, or use V.G.KIN[{id}].PARAM.",
    remedy_de="Eine Kinematik des Typs 91 nennen oder V.G.KIN[{id}].PARAM verwenden.",
    id=("number of the kinematic", "Nummer der Kinematik"),
    classes=(2, 3),
)
PARAMETER_NOT_PUBLIC = error(
    901820,
    en="the meaning of parameter {index} of kinematic {id} is not published",
    de="die Bedeutung von Parameter {index} der Kinematik {id} ist nicht veröffentlicht",
    remedy_en="Use its name: V.G.KIN[{id}].CHAIN[0], RTCP, PROGRAMMING_MODE, LINKAGE.",
    remedy_de="Seinen Namen verwenden: V.G.KIN[{id}].CHAIN[0], RTCP, PROGRAMMING_MODE, LINKAGE.",
    index=("index of the parameter", "Index des Parameters"),
    id=("number of the kinematic", "Nummer der Kinematik"),
    classes=(2, 3),
)
FIXED_TYPE_SIGNS = note(
    901607,
    en="kinematic {id} has the type {type}: its signs are those of plain geometry",
    de="Kinematik {id} hat den Typ {type}: ihre Vorzeichen sind die der einfachen Geometrie",
    remedy_en="No source prints its equations; docs/conformance/transformations.md says how they "
    "are read.",
    remedy_de="Keine Quelle nennt ihre Gleichungen; docs/conformance/transformations.md sagt, wie "
    "sie gelesen werden.",
    id=("number of the kinematic", "Nummer der Kinematik"),
    type=("type of the kinematic", "Typ der Kinematik"),
)
