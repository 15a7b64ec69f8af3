# SPDX-License-Identifier: MIT
"""G and M functions and words that are known, with this version's answer to each.

Data for ``support_level.py``, which looks them up. A row: name, answer (``S`` simulated, ``A``
accepted: no effect on positions here, ``R`` refused), meaning in English and German, for G
functions the group of those that exclude each other in one block.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from nctakt.base.diagnostics import Text

Code = Literal["S", "A", "R"]


class Row(NamedTuple):
    """One known name."""

    name: str
    code: Code
    meaning: Text
    group: str = ""


def known(*rows: tuple[str, Code, str, str]) -> tuple[Row, ...]:
    """Rows without a group."""
    return tuple(Row(name, code, Text(en, de)) for name, code, en, de in rows)


def _group(group: str, *rows: tuple[str, Code, str, str]) -> tuple[Row, ...]:
    return tuple(row._replace(group=group) for row in known(*rows))


def _range(first: int, last: int, en: str, de: str) -> tuple[Row, ...]:
    return known(*((f"G{number}", "R", en, de) for number in range(first, last + 1)))


G_FUNCTIONS = (
    *_group(
        "motion",
        ("G00", "S", "rapid traverse", "Eilgang"),
        ("G01", "S", "straight line with feed", "Gerade mit Vorschub"),
        ("G02", "S", "arc, clockwise", "Kreis im Uhrzeigersinn"),
        ("G03", "S", "arc, counter-clockwise", "Kreis gegen den Uhrzeigersinn"),
        ("G33", "R", "thread cutting", "Gewindeschneiden"),
        ("G63", "R", "tapping", "Gewindebohren"),
        ("G303", "R", "arc in space", "Kreis im Raum"),
        ("G331", "R", "tapping with pitch", "Gewindebohren mit Steigung"),
        ("G332", "R", "retraction from tapping", "Rückzug beim Gewindebohren"),
    ),
    *known(
        ("G04", "S", "dwell", "Verweilzeit"),
        ("G08", "R", "acceleration at the block's start", "Beschleunigen am Satzanfang"),
        ("G09", "R", "deceleration at the block's end", "Bremsen am Satzende"),
        ("G12", "R", "corner deceleration off", "Eckenverzögerung aus"),
        ("G13", "R", "corner deceleration on", "Eckenverzögerung ein"),
    ),
    *_group(
        "feed adaptation",
        ("G10", "S", "feed of the tool's centre", "Vorschub des Werkzeugmittelpunkts"),
        ("G11", "S", "feed of the contour", "Vorschub an der Kontur"),
    ),
    *_group(
        "plane",
        ("G17", "S", "plane X Y", "Ebene X Y"),
        ("G18", "S", "plane Z X", "Ebene Z X"),
        ("G19", "S", "plane Y Z", "Ebene Y Z"),
    ),
    *_group(
        "mirror",
        ("G20", "R", "mirroring off", "Spiegeln aus"),
        ("G21", "R", "mirroring", "Spiegeln"),
        ("G22", "R", "mirroring", "Spiegeln"),
        ("G23", "R", "mirroring", "Spiegeln"),
        ("G351", "R", "mirroring of named axes", "Spiegeln genannter Achsen"),
    ),
    *_group(
        "transition",
        ("G25", "S", "linear transitions of tool radius compensation", "lineare Übergänge der WRK"),
        ("G26", "S", "circular transitions of tool radius compensation", "Bogenübergänge der WRK"),
    ),
    *_group(
        "compensation",
        ("G40", "S", "tool radius compensation off", "Werkzeugradiuskorrektur aus"),
        ("G41", "S", "tool radius compensation left", "Werkzeugradiuskorrektur links"),
        ("G42", "S", "tool radius compensation right", "Werkzeugradiuskorrektur rechts"),
    ),
    *known(
        ("G51", "R", "diameter programming on", "Durchmesserprogrammierung ein"),
        ("G52", "R", "diameter programming off", "Durchmesserprogrammierung aus"),
    ),
    *_group(
        "zero offset",
        ("G53", "S", "zero offsets off", "Nullpunktverschiebungen aus"),
        ("G54", "S", "zero offset", "Nullpunktverschiebung"),
        ("G55", "S", "zero offset", "Nullpunktverschiebung"),
        ("G56", "S", "zero offset", "Nullpunktverschiebung"),
        ("G57", "S", "zero offset", "Nullpunktverschiebung"),
        ("G58", "S", "zero offset", "Nullpunktverschiebung"),
        ("G59", "S", "zero offset", "Nullpunktverschiebung"),
        ("G159", "S", "further zero offset", "weitere Nullpunktverschiebung"),
    ),
    *known(
        ("G60", "S", "exact stop for this block", "Genauhalt für diesen Satz"),
        ("G61", "S", "contouring for this block", "Überschleifen für diesen Satz"),
        ("G66", "R", "synchronising at the block's end", "Synchronisation am Satzende"),
    ),
    *_group(
        "unit",
        ("G70", "S", "lengths in inch", "Längen in Zoll"),
        ("G71", "S", "lengths in mm", "Längen in mm"),
    ),
    *known(("G74", "R", "homing", "Referenzfahrt")),
    *_range(80, 89, "implicit subprogram", "implizites Unterprogramm"),
    *_group(
        "dimension",
        ("G90", "S", "absolute dimensions", "Absolutmaße"),
        ("G91", "S", "relative dimensions", "Relativmaße"),
    ),
    *known(("G92", "S", "reference point offset", "Bezugspunktverschiebung")),
    *_group(
        "feed",
        ("G93", "S", "F is the time of the block", "F ist die Zeit des Satzes"),
        ("G94", "S", "F is feed per minute", "F ist Vorschub je Minute"),
        ("G95", "S", "F is feed per revolution", "F ist Vorschub je Umdrehung"),
        ("G194", "S", "F is a share of the highest feed", "F ist Anteil des höchsten Vorschubs"),
    ),
    *_group(
        "cutting",
        ("G96", "R", "constant cutting speed", "konstante Schnittgeschwindigkeit"),
        ("G97", "A", "constant spindle speed", "konstante Spindeldrehzahl"),
    ),
    *known(
        ("G98", "R", "negative software limit", "negativer Software-Endschalter"),
        ("G99", "R", "positive software limit", "positiver Software-Endschalter"),
        ("G100", "R", "measuring", "Messen"),
        ("G101", "R", "measuring offsets included", "Messversatz einrechnen"),
        ("G102", "R", "measuring offsets taken out", "Messversatz herausrechnen"),
        ("G106", "R", "measuring on the way to a target", "Messen auf dem Weg zum Ziel"),
    ),
    *_group(
        "edge banding",
        ("G107", "S", "edge banding off", "Kantenanleimen aus"),
        ("G108", "S", "edge banding", "Kantenanleimen"),
    ),
    *known(
        ("G112", "R", "gear change", "Getriebeschaltung"),
        ("G115", "R", "influence on look-ahead", "Einfluss auf Look-ahead"),
        ("G116", "R", "influence on look-ahead", "Einfluss auf Look-ahead"),
        ("G117", "R", "look-ahead on", "Look-ahead ein"),
        ("G127", "R", "weight of an axis' speed", "Gewichtung der Achsgeschwindigkeit"),
        ("G128", "R", "weight of the highest speed", "Gewichtung der Höchstgeschwindigkeit"),
        ("G129", "R", "weight of the rapid speed", "Gewichtung der Eilganggeschwindigkeit"),
        ("G130", "R", "weight of an axis' acceleration", "Gewichtung der Achsbeschleunigung"),
        ("G131", "R", "weight of acceleration", "Gewichtung der Beschleunigung"),
        ("G132", "R", "weight of an axis' ramp time", "Gewichtung der Rampenzeit einer Achse"),
        ("G133", "R", "weight of ramp times", "Gewichtung der Rampenzeiten"),
        ("G134", "R", "weight of geometrical ramp times", "Gewichtung geometr. Rampenzeiten"),
        ("G135", "R", "feed-forward on", "Vorsteuerung ein"),
        ("G136", "R", "weight of feed-forward", "Gewichtung der Vorsteuerung"),
        ("G137", "R", "feed-forward off", "Vorsteuerung aus"),
    ),
    *_group(
        "selection",
        ("G138", "S", "direct begin of tool radius compensation", "direkte Anwahl der WRK"),
        ("G139", "S", "indirect begin of tool radius compensation", "indirekte Anwahl der WRK"),
        ("G236", "R", "begin of compensation on the path", "Anwahl der WRK auf der Bahn"),
        ("G237", "S", "perpendicular begin of compensation", "senkrechte Anwahl der WRK"),
        (
            "G238",
            "S",
            "begin of compensation in an inner corner",
            "Anwahl der WRK in einer Innenecke",
        ),
        ("G239", "S", "end of compensation without motion", "Abwahl der WRK ohne Bewegung"),
        ("G05", "R", "tangential begin of compensation", "tangentiale Anwahl der WRK"),
    ),
    *_group(
        "masking",
        ("G140", "S", "contour masking off", "Konturausblendung aus"),
        ("G141", "S", "contour masking on", "Konturausblendung ein"),
    ),
    *known(
        ("G150", "R", "spline off", "Spline aus"),
        ("G151", "R", "spline on", "Spline ein"),
        ("G160", "R", "zero offset of named axes", "Nullpunktverschiebung genannter Achsen"),
    ),
    *_group(
        "arc centre",
        ("G161", "S", "absolute centres of arcs", "Kreismittelpunkte absolut"),
        ("G162", "S", "relative centres of arcs", "Kreismittelpunkte relativ"),
    ),
    *known(("G163", "S", "radius of arcs, as R", "Radius von Kreisen, wie R")),
    *_group(
        "centre correction",
        ("G164", "A", "correction of arc centres off", "Korrektur der Kreismittelpunkte aus"),
        ("G165", "A", "correction of arc centres on", "Korrektur der Kreismittelpunkte ein"),
    ),
    *known(
        ("G166", "S", "override 100 % for this block", "Override 100 % für diesen Satz"),
        ("G167", "A", "spindle override 100 %", "Spindel-Override 100 %"),
        ("G193", "R", "feed interpolated over the path", "Vorschub über dem Weg interpoliert"),
        ("G196", "R", "highest spindle speed", "höchste Spindeldrehzahl"),
        ("G200", "R", "manual mode", "Handbetrieb"),
        ("G201", "R", "manual mode beside the path", "Handbetrieb neben der Bahn"),
        ("G202", "R", "manual mode beside the path off", "Handbetrieb neben der Bahn aus"),
        ("G230", "R", "weight of an axis' acceleration, rapid", "Achsbeschleunigung im Eilgang"),
        ("G231", "R", "weight of acceleration, rapid", "Gewichtung der Eilgangbeschleunigung"),
        ("G232", "R", "weight of an axis' ramp time, rapid", "Rampenzeit einer Achse im Eilgang"),
        ("G233", "R", "weight of ramp times, rapid", "Gewichtung der Eilgang-Rampenzeiten"),
        ("G293", "R", "feed interpolated over time", "Vorschub über der Zeit interpoliert"),
        ("G301", "R", "chamfer", "Fase"),
        ("G302", "R", "rounding", "Rundung"),
        ("G310", "R", "interruptible block", "unterbrechbarer Satz"),
        ("G333", "R", "weight of an axis' ramp time", "Gewichtung der Rampenzeit einer Achse"),
        ("G334", "R", "weight of an axis' ramp time", "Gewichtung der Rampenzeit einer Achse"),
        ("G338", "R", "weight of deceleration", "Gewichtung der Verzögerung"),
        ("G339", "R", "weight of deceleration", "Gewichtung der Verzögerung"),
    ),
    *_group(
        "contouring",
        ("G260", "S", "contouring off", "Überschleifen aus"),
        ("G261", "S", "contouring on", "Überschleifen ein"),
    ),
    *_group(
        "exact stop",
        ("G359", "S", "exact stop off", "Genauhalt aus"),
        ("G360", "S", "exact stop on", "Genauhalt ein"),
    ),
    *_range(800, 819, "implicit subprogram", "implizites Unterprogramm"),
    *known(
        ("G900", "R", "deceleration at the block's end", "Bremsen am Satzende"),
        ("G901", "R", "deceleration at the block's end", "Bremsen am Satzende"),
    ),
)

#: M functions of the controller itself. All others are those of the channel list.
M_FUNCTIONS = known(
    ("M00", "S", "programmed stop, until START", "programmierter Halt, bis START"),
    ("M01", "S", "optional stop, with HLI.OPTIONAL_STOP", "wahlweiser Halt, mit HLI.OPTIONAL_STOP"),
    ("M02", "S", "program end", "Programmende"),
    ("M03", "S", "spindle clockwise", "Spindel im Uhrzeigersinn"),
    ("M04", "S", "spindle counter-clockwise", "Spindel gegen den Uhrzeigersinn"),
    ("M05", "S", "spindle stop", "Spindel halt"),
    ("M17", "S", "end of a subprogram", "Ende eines Unterprogramms"),
    ("M19", "S", "spindle to a position", "Spindel positionieren"),
    ("M29", "S", "end of a subprogram", "Ende eines Unterprogramms"),
    ("M30", "S", "program end", "Programmende"),
)

#: M and H functions of the channel list, by their synchronisation type (P-CHAN-00041).
TECHNOLOGY = known(
    ("NO_SYNCH", "S", "not output", "ohne Ausgabe"),
    ("MOS", "S", "output without waiting", "Ausgabe ohne Warten"),
    ("MVS_SVS", "S", "output and waiting before the motion", "Ausgabe und Warten vor der Bewegung"),
    ("MVS_SNS", "S", "output before, waiting behind it", "Ausgabe vor, Warten nach der Bewegung"),
    ("MNS_SNS", "S", "output and waiting behind the motion", "Ausgabe und Warten danach"),
    ("MNE_SNS", "S", "output at a measuring event", "Ausgabe beim Messereignis"),
    (
        "MVS_SLM",
        "S",
        "late waiting, at the next motion with feed",
        "spätes Warten, bei der nächsten Bewegung mit Vorschub",
    ),
    ("MVS_SLP", "S", "late waiting, at #EXPL SYN", "spätes Warten, bei #EXPL SYN"),
    ("MOS_TS", "S", "output with a time stamp", "Ausgabe mit Zeitstempel"),
    ("MEP_SVS", "R", "output a way before the block's end", "Ausgabe mit Weg vor dem Satzende"),
    ("MEP_MOS", "R", "output a way before the block's end", "Ausgabe mit Weg vor dem Satzende"),
    ("MET_SVS", "R", "output a time before the block's end", "Ausgabe mit Zeit vor dem Satzende"),
    ("MET_MOS", "R", "output a time before the block's end", "Ausgabe mit Zeit vor dem Satzende"),
)

#: Words of a block and what stands in front of one.
WORDS = known(
    ("%", "S", "name of a program", "Name eines Programms"),
    (
        "/",
        "S",
        "skip level; the block runs unless it is on",
        "Ausblendebene; läuft, solange sie aus ist",
    ),
    ("N", "S", "number of a block", "Satznummer"),
    ("N20:", "S", "label", "Sprungmarke"),
    ("X", "S", "position of an axis of the channel", "Position einer Achse des Kanals"),
    ("F", "S", "feed", "Vorschub"),
    ("G", "S", "G function", "G-Funktion"),
    ("M", "S", "M function of the channel list", "M-Funktion der Kanalliste"),
    ("H", "S", "H function of the channel list", "H-Funktion der Kanalliste"),
    ("D", "S", "tool offsets of the tool list", "Werkzeugkorrektur der Werkzeugliste"),
    ("E", "R", "feed at the block's end", "Vorschub am Satzende"),
    ("I", "S", "centre of an arc", "Mittelpunkt eines Kreises"),
    ("J", "S", "centre of an arc", "Mittelpunkt eines Kreises"),
    ("K", "S", "centre of an arc", "Mittelpunkt eines Kreises"),
    ("L", "S", "call of a subprogram in a file", "Aufruf eines Unterprogramms als Datei"),
    ("LL", "S", "call of a local subprogram", "Aufruf eines lokalen Unterprogramms"),
    ("R", "S", "radius of an arc", "Radius eines Kreises"),
    ("S", "S", "speed of the main spindle", "Drehzahl der Hauptspindel"),
    ("S.POS", "S", "position of the main spindle", "Position der Hauptspindel"),
    ("T", "A", "tool; D selects its offsets", "Werkzeug; D wählt seine Korrektur an"),
)

#: What takes the place of names that are refused.
INSTEAD = {
    "G05": Text(
        "For a tangential way to the contour begin it with an arc (G02, G03), and let a line with "
        "G41 or G42 lead to that; G40 with a line behind an arc leaves it so.",
        "Für eine tangentiale Anfahrt die Kontur mit einem Kreisbogen (G02, G03) beginnen, an den "
        "eine Gerade mit G41 oder G42 führt; G40 mit einer Geraden hinter einem Kreisbogen fährt "
        "so ab.",
    ),
    "G236": Text(
        "G138 leads to the contour directly, G139 around its corner, G237 across.",
        "G138 führt direkt an die Kontur, G139 um ihre Ecke, G237 quer.",
    ),
    "#TRC": Text(
        "The ways of compensation are chosen by G25 and G26, G138, G139, G237 … G239, G140 and "
        "G141.",
        "Wie korrigiert wird, wählen G25 und G26, G138, G139, G237 … G239, G140 und G141.",
    ),
}
