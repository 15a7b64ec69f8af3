# SPDX-License-Identifier: MIT
"""Words of other controls that newcomers bring along, and their equivalents here.

In: nothing. Out: ``OTHER_CONTROLS``. A row applies only to a line in which parser or checker have
found a mistake: an M98 that the channel list defines is no slip.
"""

from __future__ import annotations

import re

from nctakt.base.diagnostics import Text

_FANUC, _HEIDENHAIN, _SINUMERIK = "Fanuc", "Heidenhain", "Sinumerik"
_BASIC = "BASIC"

_TOOL_LENGTH = Text("tool length compensation", "Werkzeuglängenkorrektur")
_TOOL_WORDS = Text(
    "Write D with the number of the tool, as in T1 D1; D0 takes its offsets out.",
    "D mit der Nummer des Werkzeugs schreiben, wie in T1 D1; D0 wählt die Korrektur ab.",
)
_REFERENCE = Text("the motion to the reference point", "die Fahrt zum Referenzpunkt")
_REFERENCE_WORDS = Text(
    "Take the offsets out with G53 and move with G00 to the position itself.",
    "Die Verschiebungen mit G53 abwählen und mit G00 die Position selbst anfahren.",
)
_CALL = Text("the call of a subprogram", "den Aufruf eines Unterprogramms")
_CALL_WORDS = Text(
    "Write L name.nc for a file, LL NAME for a subprogram in this one (%L NAME).",
    "L name.nc für eine Datei schreiben, LL NAME für ein Unterprogramm in dieser (%L NAME).",
)
_VARIABLE = Text("a variable", "eine Variable")
_VARIABLE_WORDS = Text(
    "Write a parameter, as in P100, or declare V.P.NAME with #VAR.",
    "Einen Parameter schreiben, wie P100, oder V.P.NAME mit #VAR deklarieren.",
)
_JUMP_WORDS = Text(
    "Write $IF condition $GOTO N10 or $GOTO [LABEL].",
    "$IF Bedingung $GOTO N10 oder $GOTO [MARKE] schreiben.",
)
_ROTATION = Text("a rotation of the coordinate system", "die Drehung des Koordinatensystems")
_ROTATION_WORDS = Text(
    "Write #CS ON [x,y,z,a,b,c] and #CS OFF.",
    "#CS ON [x,y,z,a,b,c] und #CS OFF schreiben.",
)
_ACTION = Text("a synchronised action", "eine Synchronaktion")
_ACTION_WORDS = Text(
    "Write #RT CYCLE [ID=1 SCOPE=PROG] with $IF inside, and #RT CYCLE END.",
    "#RT CYCLE [ID=1 SCOPE=PROG] mit $IF darin und #RT CYCLE END schreiben.",
)
_PROGRAM = Text("the begin of a program", "den Programmanfang")
_PROGRAM_WORDS = Text("Write %NAME in the first line.", "In die erste Zeile %NAME schreiben.")
_END_WORDS = Text("Write M30 at the end.", "Am Ende M30 schreiben.")
_LINE_WORDS = Text(
    "Write G01 X10 Y20 F1000, or G00 for FMAX.",
    "G01 X10 Y20 F1000 schreiben, oder G00 für FMAX.",
)
_LABEL_WORDS = Text(
    "Write N10: or [NAME] for a target of $GOTO, %L NAME for a subprogram.",
    "N10: oder [NAME] für ein Ziel von $GOTO, %L NAME für ein Unterprogramm schreiben.",
)

#: Where the word is (group ``wrong``), the control, its meaning there, what to write here.
OTHER_CONTROLS: tuple[tuple[re.Pattern[str], str, Text, Text], ...] = tuple(
    (re.compile(pattern, re.IGNORECASE), control, meaning, instead)
    for pattern, control, meaning, instead in (
        (r"(?<!\w)(?P<wrong>G4[349](?:\.\d)?)(?![\d.])", _FANUC, _TOOL_LENGTH, _TOOL_WORDS),
        (r"(?<!\w)(?P<wrong>G(?:28|30))(?![\d.])", _FANUC, _REFERENCE, _REFERENCE_WORDS),
        (
            r"(?<!\w)(?P<wrong>G54(?:\.1)?\s*P\d+)",
            _FANUC,
            Text("a further zero offset", "eine weitere Nullpunktverschiebung"),
            Text("Write G159 with its number, as in G159=3.", "G159 mit der Nummer, wie G159=3."),
        ),
        (r"(?<!\w)(?P<wrong>(?:G6[5-7]|M98)(?:\s*P\d+)?)(?![\d.])", _FANUC, _CALL, _CALL_WORDS),
        (
            r"(?<!\w)(?P<wrong>M99)(?!\d)",
            _FANUC,
            Text("the end of a subprogram", "das Ende eines Unterprogramms"),
            Text("Write M17.", "M17 schreiben."),
        ),
        (
            r"(?<!\w)(?P<wrong>G73|G76)(?![\d.])",
            _FANUC,
            Text("a drilling cycle", "einen Bohrzyklus"),
            Text(
                "Call a program for it: L CYCLE [NAME=drill.cyc @P1=…], or G80 … G89 of the list.",
                "Ein Programm aufrufen: L CYCLE [NAME=bohren.cyc @P1=…] oder G80 … G89 der Liste.",
            ),
        ),
        (r"^\s*(?P<wrong>O\d+)\s*(?:[;(].*)?$", _FANUC, _PROGRAM, _PROGRAM_WORDS),
        (
            r"^\s*(?P<wrong>O(?:\d+|<\w+>)\s*(?:SUB|ENDSUB|CALL|IF|ENDIF|WHILE|ENDWHILE)\b)",
            "LinuxCNC",
            Text("structures and subprograms", "Strukturen und Unterprogramme"),
            Text(
                "Write $IF … $ENDIF, $WHILE … $ENDWHILE, and %L NAME … M17 for a subprogram.",
                "$IF … $ENDIF, $WHILE … $ENDWHILE und für ein Unterprogramm %L NAME … M17.",
            ),
        ),
        (r"(?<!\[)(?P<wrong>#\s*(?:\d+|<\w+>))", _FANUC, _VARIABLE, _VARIABLE_WORDS),
        (r"(?<!\w)(?P<wrong>(?:L?BL|LBL)\s+\d+)", _HEIDENHAIN, _CALL, _LABEL_WORDS),
        (
            r"(?<!\w)(?P<wrong>TOOL\s+(?:CALL|DEF)).*$",
            _HEIDENHAIN,
            Text("the tool change", "den Werkzeugwechsel"),
            Text("Write T1 D1 M6.", "T1 D1 M6 schreiben."),
        ),
        (r"^\s*\d*\s*(?P<wrong>BEGIN\s+PGM).*$", _HEIDENHAIN, _PROGRAM, _PROGRAM_WORDS),
        (
            r"^\s*\d*\s*(?P<wrong>END\s+PGM).*$",
            _HEIDENHAIN,
            Text("the end of a program", "das Programmende"),
            _END_WORDS,
        ),
        (
            r"^\s*\d*\s*(?P<wrong>BLK\s+FORM).*$",
            _HEIDENHAIN,
            Text("the blank", "das Rohteil"),
            Text(
                "Remove it: programs do not describe a blank.",
                "Entfernen: ein Rohteil gibt es in Programmen nicht.",
            ),
        ),
        (
            r"^\s*\d*\s*(?P<wrong>CYCL\s+(?:DEF|CALL)).*$",
            _HEIDENHAIN,
            Text("a machining cycle", "einen Bearbeitungszyklus"),
            Text(
                "Call a program: L CYCLE [NAME=file.cyc @P1=…].",
                "Ein Programm aufrufen: L CYCLE [NAME=datei.cyc @P1=…].",
            ),
        ),
        (
            r"^\s*\d*\s*(?P<wrong>FN\s*\d+\s*:).*$",
            _HEIDENHAIN,
            Text("computing with parameters", "das Rechnen mit Parametern"),
            _VARIABLE_WORDS,
        ),
        (r"(?<!\w)(?P<wrong>Q\d+)\s*=", _HEIDENHAIN, _VARIABLE, _VARIABLE_WORDS),
        (
            r"(?<!\w)(?P<wrong>L\s+[XYZABCUVW][+-]?[\d.]+).*$",
            _HEIDENHAIN,
            Text("a straight line", "eine Gerade"),
            _LINE_WORDS,
        ),
        (
            r"(?<!\w)(?P<wrong>CC\s+[XYZ][+-]?[\d.]+).*$",
            _HEIDENHAIN,
            Text("the centre of an arc", "den Mittelpunkt eines Kreisbogens"),
            Text("Write G02 or G03 with I, J, K.", "G02 oder G03 mit I, J, K schreiben."),
        ),
        (
            r"(?<!\w)(?P<wrong>FMAX)(?!\w)",
            _HEIDENHAIN,
            Text("rapid traverse", "den Eilgang"),
            Text("Write G00.", "G00 schreiben."),
        ),
        (
            r"(?<!\w)(?P<wrong>R[LR])(?!\w)",
            _HEIDENHAIN,
            Text("tool radius compensation", "die Werkzeugradiuskorrektur"),
            Text(
                "Write G41 (left) or G42 (right), and G40 to end it.",
                "G41 (links) oder G42 (rechts) schreiben und zum Beenden G40.",
            ),
        ),
        (r"(?<!\w)(?P<wrong>R\d+)\s*=", _SINUMERIK, _VARIABLE, _VARIABLE_WORDS),
        (
            r"(?<!\w)(?P<wrong>GOTO[FBS])(?!\w)",
            _SINUMERIK,
            Text("a jump", "einen Sprung"),
            _JUMP_WORDS,
        ),
        (
            r"(?:^|\s)(?P<wrong>(?:IDS?\s*=\s*\d+\s+)?(?:WHEN|WHENEVER|EVERY|FROM)\s).*\bDO\b.*$",
            _SINUMERIK,
            _ACTION,
            _ACTION_WORDS,
        ),
        (
            r"(?P<wrong>\$(?:AA|AC|A|AN|VA)_\w+(?:\[\w+\])?)",
            _SINUMERIK,
            Text("a value of the controller", "einen Wert der Steuerung"),
            Text(
                "Write a variable of V.RTA or V.A, as V.RTA.ACS.ACT_POS.X.",
                "Eine Variable aus V.RTA oder V.A schreiben, wie V.RTA.ACS.ACT_POS.X.",
            ),
        ),
        (
            r"^\s*(?:N\d+\s*)?(?P<wrong>DEF\s+(?:REAL|INT|BOOL|CHAR|STRING|AXIS)).*$",
            _SINUMERIK,
            Text("a declaration", "eine Deklaration"),
            Text(
                "Write #VAR, V.P.NAME = 0 and #ENDVAR in lines of their own.",
                "#VAR, V.P.NAME = 0 und #ENDVAR in eigenen Zeilen schreiben.",
            ),
        ),
        (
            r"^\s*(?:N\d+\s*)?(?P<wrong>(?:PROC|EXTERN)\s+\w+).*$",
            _SINUMERIK,
            Text("a subprogram", "ein Unterprogramm"),
            _CALL_WORDS,
        ),
        (
            r"(?<!\w)(?P<wrong>STOPRE)(?!\w)",
            _SINUMERIK,
            Text("the stop of preprocessing", "den Vorlaufstopp"),
            Text(
                "Write #FLUSH WAIT in a block of its own.",
                "#FLUSH WAIT in einen eigenen Satz schreiben.",
            ),
        ),
        (
            r"(?<!\w)(?P<wrong>SUPA)(?!\w)",
            _SINUMERIK,
            Text("a block without offsets", "einen Satz ohne Verschiebungen"),
            _REFERENCE_WORDS,
        ),
        (r"(?<!\w)(?P<wrong>A?(?:TRANS|ROT))(?!\w)", _SINUMERIK, _ROTATION, _ROTATION_WORDS),
        (
            r"(?<!\w)(?P<wrong>G5(?:00|0[5-9]|[1-9]\d))(?![\d.])",
            _SINUMERIK,
            Text("a zero offset", "eine Nullpunktverschiebung"),
            Text(
                "Write G54 … G59 or G159=7; G53 takes them out.",
                "G54 … G59 oder G159=7 schreiben; G53 wählt sie ab.",
            ),
        ),
        (
            r"(?<![\w#])(?P<wrong>\$?RETURN)(?!\w)",
            _BASIC,
            Text("the end of a subprogram", "das Ende eines Unterprogramms"),
            Text("Write M17.", "M17 schreiben."),
        ),
        (
            r"(?<![\w#])(?P<wrong>\$?(?:END|EXIT))\s*$",
            _BASIC,
            Text("the end of a program", "das Programmende"),
            _END_WORDS,
        ),
        (
            r"(?<![\w])(?P<wrong>[$#]?(?:STOP|PAUSE))\s*$",
            _BASIC,
            Text("a halt of the program", "einen Halt des Programms"),
            Text("Write M00.", "M00 schreiben."),
        ),
        (
            r"(?<![\w#])(?P<wrong>\$?(?:WAIT|DELAY|SLEEP))\s+[\d.]+.*$",
            _BASIC,
            Text("a dwell", "eine Verweilzeit"),
            Text("Write #TIME 0.5 with the seconds.", "#TIME 0.5 mit den Sekunden schreiben."),
        ),
    )
)
