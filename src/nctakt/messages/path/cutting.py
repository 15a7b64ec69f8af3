# SPDX-License-Identifier: MIT
"""Messages about constant cutting speed: G96, G97, G196."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

CUTTING_START_LIMITED = warning(
    20633,
    en="G96: the start speed {speed} is limited to {limit} 1/min",
    de="G96: die Startdrehzahl {speed} wird auf {limit} 1/min begrenzt",
    remedy_en="Begin further from the centre, or raise the limit: G196, or P-AXIS-00212.",
    remedy_de="Weiter außen beginnen oder die Grenze anheben: G196 oder P-AXIS-00212.",
    speed=("the speed at this radius", "die Drehzahl bei diesem Radius"),
    limit=("the limit in 1/min", "die Grenze in 1/min"),
)
CUTTING_WITHOUT_FACE_AXIS = error(
    20634,
    known_as=(120170, 120171),
    en="constant cutting speed (G96) without a face axis in the plane G{plane}",
    de="konstante Schnittgeschwindigkeit (G96) ohne Planachse in der Ebene G{plane}",
    remedy_en="Set the bit 0x40 in kenngr.achs_mode (P-AXIS-00015) of the face axis.",
    remedy_de="Das Bit 0x40 in kenngr.achs_mode (P-AXIS-00015) der Planachse setzen.",
)
CUTTING_WITH_TWO_FACE_AXES = error(
    20064,
    classes=(0, 0),
    en="two face axes in the plane G{plane}",
    de="zwei Planachsen in der Ebene G{plane}",
    remedy_en="Leave the bit 0x40 of P-AXIS-00015 to one axis of the plane.",
    remedy_de="Das Bit 0x40 von P-AXIS-00015 nur bei einer Achse der Ebene setzen.",
)
INVALID_SPINDLE_LIMIT = error(
    120169,
    classes=(0, 0),
    en="the highest spindle speed (G196) cannot be {value}",
    de="die höchste Spindeldrehzahl (G196) kann nicht {value} sein",
    remedy_en="Program S above 0 in the block with G196.",
    remedy_de="Im Satz mit G196 ein S über 0 programmieren.",
)
CUTTING_WITH_PLC_SPINDLE = error(
    901532,
    en="constant cutting speed (G96) with spindle {spindle}, which the PLC turns",
    de="konstante Schnittgeschwindigkeit (G96) mit Spindel {spindle}, die die SPS dreht",
    remedy_en="Take a main spindle that the CNC turns (spindel[i].plc_control 0, P-CHAN-00069).",
    remedy_de="Eine Hauptspindel nehmen, die die CNC dreht (spindel[i].plc_control 0, "
    "P-CHAN-00069).",
)
CUTTING_DECIDED = note(
    901533,
    en="G96: the radius is the distance of the face axis from the program's zero at the S word",
    de="G96: der Radius ist der Abstand der Planachse vom Programmnullpunkt beim S-Wort",
    remedy_en="Program S again after a new offset; rapid motions do not change the speed.",
    remedy_de="Nach einer neuen Verschiebung S noch einmal angeben; im Eilgang ändert sich die "
    "Drehzahl nicht.",
    cause_en="The sources name the last position and the offset, but not the tick that counts.",
    cause_de="Die Quellen nennen letzte Position und Verschiebung, nicht den Takt, der gilt.",
)
DIAMETERS_WITHOUT_EFFECT = note(
    901962,
    en="G51 changes nothing: the list of {axis} has diameters neither for positions nor for "
    "distances",
    de="G51 ändert nichts: die Liste von {axis} sieht weder für Positionen noch für Wege "
    "Durchmesser vor",
    remedy_en="Set kenngr.durchm_prog_abs (P-AXIS-00058) for G90, kenngr.durchm_prog_rel "
    "(P-AXIS-00059) for G91.",
    remedy_de="kenngr.durchm_prog_abs (P-AXIS-00058) für G90, kenngr.durchm_prog_rel "
    "(P-AXIS-00059) für G91 setzen.",
    axis=("the face axis", "die Planachse"),
)
