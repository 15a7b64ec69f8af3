# SPDX-License-Identifier: MIT
"""Words of a block, and the synchronisation types of M and H functions, with their support.

G functions and the M functions of the controller: ``functions.py``.
"""

from __future__ import annotations

from nctakt.nc.vocabulary.entries import ACCEPTED, SIMULATED, Kind, table

#: M and H functions of the channel list, by their synchronisation type (P-CHAN-00041).
TECHNOLOGY = table(
    Kind.TECHNOLOGY,
    ("NO_SYNCH", SIMULATED, "not output", "ohne Ausgabe"),
    ("MOS", SIMULATED, "output without waiting", "Ausgabe ohne Warten"),
    (
        "MVS_SVS",
        SIMULATED,
        "output and waiting before the motion",
        "Ausgabe und Warten vor der Bewegung",
    ),
    (
        "MVS_SNS",
        SIMULATED,
        "output before, waiting after it",
        "Ausgabe vor, Warten nach der Bewegung",
    ),
    ("MNS_SNS", SIMULATED, "output and waiting after the motion", "Ausgabe und Warten danach"),
    ("MNE_SNS", SIMULATED, "output at a measuring event", "Ausgabe beim Messereignis"),
    (
        "MVS_SLM",
        SIMULATED,
        "late waiting, at the next motion with feed",
        "spätes Warten, bei der nächsten Bewegung mit Vorschub",
    ),
    ("MVS_SLP", SIMULATED, "late waiting, at #EXPL SYN", "spätes Warten, bei #EXPL SYN"),
    ("MOS_TS", SIMULATED, "output with a time stamp", "Ausgabe mit Zeitstempel"),
    (
        "MEP_SVS",
        SIMULATED,
        "output a distance before its block, waiting at it",
        "Ausgabe einen Weg vor dem Satz, Warten dort",
    ),
    (
        "MEP_MOS",
        SIMULATED,
        "output a distance before its block, without waiting",
        "Ausgabe einen Weg vor dem Satz, ohne Warten",
    ),
    (
        "MET_SVS",
        SIMULATED,
        "output a time before its block, waiting at it",
        "Ausgabe eine Zeit vor dem Satz, Warten dort",
    ),
    (
        "MET_MOS",
        SIMULATED,
        "output a time before its block, without waiting",
        "Ausgabe eine Zeit vor dem Satz, ohne Warten",
    ),
)

#: Words of a block and of its head.
WORDS = table(
    Kind.WORD,
    ("%", SIMULATED, "name of a program", "Name eines Programms"),
    (
        "/",
        SIMULATED,
        "skip level; the block runs unless it is on",
        "Ausblendebene; läuft, solange sie aus ist",
    ),
    ("N", SIMULATED, "number of a block", "Satznummer"),
    ("N20:", SIMULATED, "label", "Sprungmarke"),
    ("X", SIMULATED, "position of an axis of the channel", "Position einer Achse des Kanals"),
    ("F", SIMULATED, "feed", "Vorschub"),
    ("G", SIMULATED, "G function", "G-Funktion"),
    ("M", SIMULATED, "M function of the channel list", "M-Funktion der Kanalliste"),
    ("H", SIMULATED, "H function of the channel list", "H-Funktion der Kanalliste"),
    ("D", SIMULATED, "tool offsets of the tool list", "Werkzeugkorrektur der Werkzeugliste"),
    ("E", SIMULATED, "feed at the block's end", "Vorschub am Satzende"),
    ("I", SIMULATED, "centre of an arc; pitch", "Mittelpunkt eines Kreises; Steigung"),
    ("J", SIMULATED, "centre of an arc; pitch", "Mittelpunkt eines Kreises; Steigung"),
    ("K", SIMULATED, "centre of an arc; pitch", "Mittelpunkt eines Kreises; Steigung"),
    ("L", SIMULATED, "call of a subprogram in a file", "Aufruf eines Unterprogramms als Datei"),
    ("LL", SIMULATED, "call of a local subprogram", "Aufruf eines lokalen Unterprogramms"),
    ("R", SIMULATED, "radius of an arc", "Radius eines Kreises"),
    ("S", SIMULATED, "speed of the main spindle", "Drehzahl der Hauptspindel"),
    ("S.POS", SIMULATED, "position of the main spindle", "Position der Hauptspindel"),
    ("S.OFFSET", SIMULATED, "start angle of a thread (G33)", "Startwinkel eines Gewindes (G33)"),
    ("#CHR", SIMULATED, "chamfer, by its width", "Fase mit dieser Breite"),
    ("#CHF", SIMULATED, "chamfer, by its length", "Fase mit dieser Länge"),
    ("#RND", SIMULATED, "rounding of a corner", "Rundung einer Ecke"),
    ("#FRC", SIMULATED, "feed of a chamfer or rounding", "Vorschub einer Fase oder Rundung"),
    ("#ANG", SIMULATED, "line at this angle", "Gerade unter diesem Winkel"),
    ("#SPLINE ON", SIMULATED, "spline on", "Spline ein"),
    ("#SPLINE OFF", SIMULATED, "spline off", "Spline aus"),
    ("#SET SPLINE ON", SIMULATED, "spline on", "Spline ein"),
    ("#SET SPLINE OFF", SIMULATED, "spline off", "Spline aus"),
    ("#AKIMA STARTVECTOR", SIMULATED, "direction at a spline's start", "Richtung am Splineanfang"),
    ("#AKIMA ENDVECTOR", SIMULATED, "direction at a spline's end", "Richtung am Splineende"),
    ("#SET ASPLINE STARTTANG", SIMULATED, "as #AKIMA STARTVECTOR", "wie #AKIMA STARTVECTOR"),
    ("#SET ASPLINE ZIELTANG", SIMULATED, "as #AKIMA ENDVECTOR", "wie #AKIMA ENDVECTOR"),
    ("T", ACCEPTED, "tool; D selects its offsets", "Werkzeug; D wählt seine Korrektur an"),
)
