# SPDX-License-Identifier: MIT
"""Messages about the path: arcs, slope, contouring."""

from __future__ import annotations

from nctakt.messages.cases import by_beginning, by_limit
from nctakt.messages.catalogue import error, note

ARC_WITHOUT_CENTRE = error(
    20036,
    known_as=(900700,),
    en="the arc has neither a centre nor a radius",
    de="der Kreisbogen hat weder Mittelpunkt noch Radius",
    remedy_en="Program the centre with I, J or K, or a radius R other than 0.",
    remedy_de="Den Mittelpunkt mit I, J oder K programmieren oder einen Radius R ungleich 0.",
    cause_en="G02 and G03 need a centre other than the start point; the radius may be programmed "
    "in an earlier block.",
    cause_de="G02 und G03 brauchen einen Mittelpunkt, der nicht der Startpunkt ist; der Radius "
    "darf aus einem früheren Satz stammen.",
)
ARC_RADIUS_TOO_SMALL = error(
    20033,
    known_as=(900701, 20034),
    en="no arc of radius {radius} leads to this target; it must be at least {minimum}",
    de="kein Kreisbogen mit Radius {radius} führt zu diesem Ziel; nötig ist mindestens {minimum}",
    remedy_en="Program a larger radius, or the centre. A full circle needs its centre.",
    remedy_de="Einen größeren Radius oder den Mittelpunkt programmieren. Ein Vollkreis braucht "
    "seinen Mittelpunkt.",
    minimum=("half the distance to the target in mm", "der halbe Abstand zum Ziel in mm"),
)
POINTS_ON_A_LINE = error(
    901892,
    en="no arc leads through this interim point to the target: the three points are on a line",
    de="kein Kreisbogen führt über diesen Zwischenpunkt zum Ziel: die drei Punkte liegen auf einer "
    "Geraden",
    remedy_en="With I, J, K, program a point between start and target of the arc. A full circle is "
    "two arcs.",
    remedy_de="Mit I, J, K einen Punkt zwischen Start und Ziel des Bogens programmieren. Ein "
    "Vollkreis sind zwei Bögen.",
    classes=(2, 3),
)
ARC_IN_SPACE_DURING_COMPENSATION = error(
    22081,
    en="G303 while tool radius compensation is active",
    de="G303 bei aktiver Werkzeugradiuskorrektur",
    remedy_en="Program the arc after G40 and the motion that leaves the contour.",
    remedy_de="Den Kreisbogen nach G40 und der Bewegung programmieren, die die Kontur verlässt.",
)
ARC_CENTRE_TOO_FAR_OFF = error(
    20035,
    known_as=(900702, 21758, 120025),
    en="the target is off the circle: its centre would have to move {shift} mm (at most {allowed})",
    de="das Ziel liegt neben dem Kreis: der Mittelpunkt müsste um {shift} mm wandern (höchstens "
    "{allowed})",
    remedy_en="Correct the target or the centre; centres are absolute with G161, relative to the "
    "start with G162.",
    remedy_de="Ziel oder Mittelpunkt berichtigen; Mittelpunkte sind mit G161 absolut, mit G162 "
    "relativ zum Start.",
    cause_en="The centre is moved to the nearest point that is equally far from both ends, at most "
    "by P-CHAN-00059 (2 mm) and by P-CHAN-00060 (50 per mille) of the radius.",
    cause_de="Der Mittelpunkt wird an den nächsten Ort verschoben, der von beiden Enden gleich "
    "weit entfernt ist, höchstens um P-CHAN-00059 (2 mm) und um P-CHAN-00060 (50 Promille) des "
    "Radius.",
    shift=("the distance in mm", "die Strecke in mm"),
    allowed=("the limit in mm", "die Grenze in mm"),
)
PLANE_AXIS_MISSING = error(
    20938,
    known_as=(900703, 50008, 120023),
    en="the channel has no axis for a direction of plane G{plane}",
    de="dem Kanal fehlt eine Achse der Ebene G{plane}",
    remedy_en="Choose another plane with G17, G18 or G19, or add the axis to the channel list.",
    remedy_de="Mit G17, G18 oder G19 eine andere Ebene wählen oder die Achse in die Kanalliste "
    "aufnehmen.",
    plane=("number of the G function", "Nummer der G-Funktion"),
)
CENTRE_NOT_IN_PLANE = error(
    900704,
    known_as=(20758,),
    en="{word} is not a centre coordinate of plane G{plane}",
    de="{word} ist keine Mittelpunktkoordinate der Ebene G{plane}",
    remedy_en="Program I and J in G17, K and I in G18, J and K in G19.",
    remedy_de="Bei G17 I und J programmieren, bei G18 K und I, bei G19 J und K.",
    plane=("number of the G function", "Nummer der G-Funktion"),
    classes=(2, 3),
)
ARC_OUTSIDE_LIMITS = error(
    120002,
    known_as=(900705, 50041, 50042),
    cases=by_limit("position", above=120002, below=120003),
    en="the arc takes axis {axis} to {position}, outside its software limits {low} … {high}",
    de="der Kreisbogen führt die Achse {axis} auf {position}, außerhalb ihrer Software-Endschalter "
    "{low} … {high}",
    remedy_en="Program an arc within the limits (P-AXIS-00177, P-AXIS-00178).",
    remedy_de="Einen Kreisbogen innerhalb der Grenzen programmieren (P-AXIS-00177, P-AXIS-00178).",
    position=(
        "the farthest position on the arc in mm",
        "die entfernteste Position auf dem Bogen in mm",
    ),
)
COMMAND_WORD_NOT_SIMULATED = error(
    900706,
    en="{word} of {command} is not simulated",
    de="{word} von {command} wird nicht simuliert",
    remedy_en="Remove it, or use a simulated word: {names}",
    remedy_de="Entfernen oder ein simuliertes Wort verwenden: {names}",
    cause_en="It may change positions or times in a way that nctakt does not model.",
    cause_de="Es kann Positionen oder Zeiten in einer Weise ändern, die nctakt nicht nachbildet.",
    names=("the keywords that are simulated", "die Schlüsselwörter, die simuliert werden"),
    classes=(2, 3),
)
INVALID_CONTOUR_DEVIATION = error(
    21401,
    known_as=(900707,),
    en="the deviation {value} for contouring must be above 0",
    de="die Abweichung {value} beim Überschleifen muss größer als 0 sein",
    remedy_en="Program a PATH_DEV above 0, or switch contouring off with G260.",
    remedy_de="Ein PATH_DEV über 0 programmieren oder das Überschleifen mit G260 ausschalten.",
)
FILTER_NOT_SIMULATED = error(
    901875,
    en="#FILTER: axis {axis} has a FIR filter of type {type}, which is not simulated",
    de="#FILTER: die Achse {axis} hat einen FIR-Filter vom Typ {type}, der nicht simuliert wird",
    remedy_en="Set vib_guard.type (P-AXIS-00586) to 0 for a run without filters.",
    remedy_de="vib_guard.type (P-AXIS-00586) für einen Lauf ohne Filter auf 0 setzen.",
    type=("the type of its filter", "der Typ ihres Filters"),
)
CURVE_OUTSIDE_LIMITS = error(
    901873,
    en="the curve of #CONTOUR MODE takes axis {axis} to {position}, outside {low} … {high}",
    de="die Kurve von #CONTOUR MODE führt Achse {axis} auf {position}, außerhalb {low} … {high}",
    remedy_en="Move the interim point or the corner away from the limit (P-AXIS-00177, -00178).",
    remedy_de="Zwischenpunkt oder Ecke von der Grenze weg verlegen (P-AXIS-00177, -00178).",
    position=(
        "a position on the curve in mm or degrees",
        "eine Position der Kurve in mm oder Grad",
    ),
)
CONTOUR_MODE_WHILE_ON = error(
    120698,
    en="{mode} after {before} while contouring is on",
    de="{mode} nach {before} bei eingeschaltetem Überschleifen",
    remedy_en="Write G260 before the change, and G261 after it.",
    remedy_de="Vor dem Wechsel G260 schreiben und danach G261.",
    mode=("the new mode", "der neue Modus"),
    before=("the mode before", "der Modus davor"),
    classes=(2, 6),
)
CONTOUR_SHARE_OUT_OF_RANGE = error(
    901870,
    en="{word} {value} of #CONTOUR MODE is not within 0 … {highest}",
    de="{word} {value} von #CONTOUR MODE liegt nicht in 0 … {highest}",
    remedy_en="Give a value in this range: REMAIN_PART in percent, MAX_ANGLE in degrees.",
    remedy_de="Einen Wert in diesem Bereich angeben: REMAIN_PART in Prozent, MAX_ANGLE in Grad.",
    classes=(2, 3),
)
INVALID_VECTOR_LIMIT = error(
    21205,
    cases=by_beginning("word", {"ACC": 21206, "DEC": 21546, "RADIAL_ACC": 21945}),
    en="{word} of #VECTOR LIMIT is {value}, but must be above 0",
    de="{word} von #VECTOR LIMIT ist {value}, muss aber größer als 0 sein",
    remedy_en="Program a limit above 0, or switch it off: #VECTOR LIMIT OFF [{word}]",
    remedy_de="Eine Grenze über 0 programmieren oder sie ausschalten: #VECTOR LIMIT OFF [{word}]",
)
UNKNOWN_SLOPE = error(
    21304,
    en="slope {value} does not exist: 0 … {highest}",
    de="das Beschleunigungsprofil {value} gibt es nicht: 0 … {highest}",
    remedy_en="Choose 0 (STEP), 1 (TRAPEZ), 2 (SIN2) or 3 (HSC).",
    remedy_de="0 (STEP), 1 (TRAPEZ), 2 (SIN2) oder 3 (HSC) wählen.",
    value=("the number", "die Nummer"),
)
SIMPLIFIED = note(
    901551,
    en="{command} is simulated as follows: {meaning}",
    de="{command} wird so simuliert: {meaning}",
    remedy_en="Nothing to do if that suffices; this is reported once per program.",
    remedy_de="Nichts zu tun, wenn das genügt; das wird einmal je Programm gemeldet.",
    cause_en="No public source says exactly what the controller does.",
    cause_de="Keine öffentliche Quelle sagt genau, was die Steuerung tut.",
    meaning=("what nctakt does", "was nctakt tut"),
)
UNKNOWN_COMMAND_KEYWORD = error(
    21220,
    classes=(0, 0),
    known_as=(900900,),
    cases=by_beginning("command", {"#CS TRACK": 21855, "#CS SHIFT": 21857, "#MSG": 21711}),
    en="{command} has no keyword {word}",
    de="{command} hat kein Schlüsselwort {word}",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
)
ARC_WITH_CENTRE_AND_RADIUS = error(
    21024,
    known_as=(900904,),
    en="the arc has a centre and a radius",
    de="der Kreisbogen hat Mittelpunkt und Radius",
    remedy_en="Program the centre (I, J, K) or the radius R, not both.",
    remedy_de="Den Mittelpunkt (I, J, K) oder den Radius R programmieren, nicht beides.",
    cause_en="Each of them alone fixes the circle; together they need not agree.",
    cause_de="Jeder von beiden legt den Kreis fest; gemeinsam müssen sie nicht zueinander passen.",
)
