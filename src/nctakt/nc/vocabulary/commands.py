# SPDX-License-Identifier: MIT
"""Known ``#`` commands, control words, variables and forms with their support.

A ``#`` command is known by its first words; the longest row that fits counts. Its row is a line of
``commands.tsv``: name, support, effect if refused (``Effect``), forms, meaning, and what to use
instead.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

from nctakt.base.diagnostics import NOTHING, Text
from nctakt.nc.vocabulary.entries import (
    NOTHING_INSTEAD,
    REFUSED,
    SIMULATED,
    Effect,
    Entry,
    Kind,
    Support,
    table,
)
from nctakt.nc.vocabulary.variables.spindle_variables import SPINDLE_ROWS
from nctakt.nc.vocabulary.variables.system_names import ROWS

CONTROLS = table(
    Kind.CONTROL,
    ("$IF", SIMULATED, "condition", "Bedingung"),
    ("$FOR", SIMULATED, "loop with a counter", "Zählschleife"),
    ("$WHILE", SIMULATED, "loop, condition at its head", "Schleife, Bedingung am Kopf"),
    ("$DO", SIMULATED, "loop, condition at its end", "Schleife, Bedingung am Ende"),
    ("$REPEAT", SIMULATED, "loop until a condition holds", "Schleife, bis eine Bedingung gilt"),
    ("$SWITCH", SIMULATED, "branches by value", "Zweige nach Wert"),
    ("$BREAK", SIMULATED, "leave a loop or branch", "Schleife oder Zweig verlassen"),
    ("$CONTINUE", SIMULATED, "next pass of a loop", "nächster Durchlauf einer Schleife"),
    ("$GOTO", SIMULATED, "jump", "Sprung"),
)


def _read() -> Mapping[str, Entry]:
    """Return the rows of ``commands.tsv`` by their names."""
    text = (Path(__file__).parent / "commands.tsv").read_text("utf-8")
    entries = {}
    for line in text.splitlines()[2:]:
        cells = line.split("\t")
        name, support, effect, forms, en, de, *instead = cells
        entries[name] = Entry(
            Kind.COMMAND,
            name,
            Support(support),
            Text(en, de),
            Text(*instead) if instead else NOTHING_INSTEAD,
            Effect(effect),
            tuple(forms.split(" | ")) if forms else (),
        )
    return MappingProxyType(entries)


COMMANDS = _read()

#: The words of ``#CHANNEL INIT``, and of its old form.
INIT, OLD_INIT = INITS = (("CHANNEL", "INIT"), ("SET", "DEC", "LR", "SOLL"))

VARIABLES = table(
    Kind.VARIABLE,
    ("P", SIMULATED, "parameters P1, P2, …", "Parameter P1, P2, …"),
    ("P10[3]", SIMULATED, "arrays of parameters, by #VAR", "Felder von Parametern, durch #VAR"),
    ("PP1", SIMULATED, "the parameter whose number P1 is", "der Parameter, dessen Nummer P1 ist"),
    ("V.E", SIMULATED, "external variables", "externe Variablen"),
    ("V.CH", SIMULATED, "variables of the channel", "Variablen des Kanals"),
    ("V.RTG", SIMULATED, "realtime variables of the channel", "Echtzeit-Variablen des Kanals"),
    ("V.RTA", SIMULATED, "realtime variables of an axis", "Echtzeit-Variablen einer Achse"),
    ("@P", SIMULATED, "parameters of a call", "Parameter eines Aufrufs"),
    ("V.A", REFUSED, "other data of axes", "weitere Daten der Achsen"),
    ("V.CYC", SIMULATED, "variables of canned cycles", "Variablen von Zyklen"),
    ("V.G", REFUSED, "other data of the channel", "weitere Daten des Kanals"),
    ("V.G.LIMIT", REFUSED, "kinematics of speed limits", "Kinematiken von Grenzen"),
    ("V.G.NP", REFUSED, "whole offsets other than copied", "ganze Verschiebungen außer Kopien"),
    ("V.G.NP_AKT", REFUSED, "whole offset other than copied", "ganze Verschiebung außer Kopien"),
    ("V.G.PROG_SA", REFUSED, "type of a block, not public", "Satzart, nicht öffentlich"),
    ("V.G.RW", REFUSED, "remaining way of edge banding", "Restweg der Kantenanleimung"),
    ("V.G.WZ", REFUSED, "data of tools without effect here", "Werkzeugdaten ohne Wirkung"),
    ("V.G.WZ_AKT", REFUSED, "data of tools without effect here", "Werkzeugdaten ohne Wirkung"),
    ("V.G.VOLCOMP", REFUSED, "volumetric compensation", "volumetrische Kompensation"),
    ("V.G.NP[1].ALL", SIMULATED, "offset of all axes, copied", "Versatz aller Achsen, kopiert"),
    ("V.G.TIMER[1]", SIMULATED, "times of #TIMER in ms", "Zeiten von #TIMER in ms"),
    ("V.G.KIN[9].PARAM[0]", SIMULATED, "of a kinematic", "einer Kinematik"),
    ("V.G.KIN[91].RTCP", SIMULATED, "numbers of kinematic 91", "Zahlen der Kinematik 91"),
    ("V.G.KIN[9].BASE[0]", SIMULATED, "kept for coupling kinematics", "für Koppelkinematiken"),
    (
        "V.G.KIN",
        REFUSED,
        "other data of kinematics, as of type 210",
        "weitere Daten, wie des Typs 210",
    ),
    ("V.G.WZ_AKT.R", SIMULATED, "data of the active tool", "Daten des aktiven Werkzeugs"),
    ("V.G.WZ[1].R", SIMULATED, "data of a tool of the list", "Daten eines Werkzeugs der Liste"),
    ("V.G.T_AKT", SIMULATED, "number of the last T", "Nummer des letzten T"),
    ("V.G.D_AKT", SIMULATED, "number of the last D", "Nummer des letzten D"),
    *((row.name, SIMULATED, row.meaning.en, row.meaning.de) for row in ROWS),
    ("V.I", REFUSED, "internal variables", "interne Variablen"),
    ("V.L", SIMULATED, "local variables", "lokale Variablen"),
    ("V.P", SIMULATED, "variables of the program", "Variablen des Programms"),
    ("V.S", SIMULATED, "variables that stay", "bleibende Variablen"),
    ("V.SPDL", REFUSED, "other data of spindles", "weitere Daten der Spindeln"),
    (
        "V.SPDL.M_FCT_FREE",
        REFUSED,
        "M3, M4, M5 and M19 always turn spindles here",
        "M3, M4, M5 und M19 drehen hier immer Spindeln",
    ),
    ("V.SPDL_PROG", REFUSED, "other programmed data of spindles", "weitere programmierte Daten"),
    *((row.name, SIMULATED, row.meaning.en, row.meaning.de) for row in SPINDLE_ROWS),
    ("V.TLM", REFUSED, "other data of tool life", "weitere Daten der Standzeit"),
    ("V.TLM.TIME_FACT", SIMULATED, "weight of time in tool life", "Gewicht der Zeit, Standzeit"),
    ("V.TLM.DIST_FACT", SIMULATED, "weight of distance in it", "Gewicht des Wegs darin"),
    ("V.TOOL", REFUSED, "other data of tools", "weitere Daten der Werkzeuge"),
    ("V.TOOL.BASIC", SIMULATED, "ID of the active tool", "ID des aktiven Werkzeugs"),
    ("V.TOOL.SISTER", SIMULATED, "its number of the sister tool", "seine Schwesternummer"),
    ("V.TOOL.VARIANT", SIMULATED, "its number of the variant", "seine Variantennummer"),
)


def _of_independent_axes(form: str) -> tuple[tuple[str, Support, str, str, Text], ...]:
    """Return the rows of the keywords of an independent axis that are refused."""
    return (
        (
            f"X[{form} SLOPE_TYPE]",
            REFUSED,
            "another slope for this motion",
            "andere Rampenform für diese Bewegung",
            Text(
                "Leave it out: the motion has the slope of P-CHAN-00071.",
                "Weglassen: die Bewegung hat das Beschleunigungsprofil von P-CHAN-00071.",
            ),
        ),
        (
            f"X[{form} ACC_WEIGHT]",
            REFUSED,
            "another acceleration for this motion",
            "andere Beschleunigung für diese Bewegung",
            Text(
                "Leave it out: the motion has the acceleration of the axis list.",
                "Weglassen: die Bewegung hat die Beschleunigung der Achsliste.",
            ),
        ),
        (
            f"X[{form} DRY_RUN]",
            REFUSED,
            "test of the motion before it is made",
            "Probe der Bewegung, bevor sie ausgeführt wird",
            Text(
                "Leave it out: a target beyond the limits is refused before the axis moves.",
                "Weglassen: ein Ziel jenseits der Endschalter wird vor der Bewegung abgelehnt.",
            ),
        ),
        (
            f"X[{form} M]",
            REFUSED,
            "M or H function of an independent axis",
            "M- oder H-Funktion einer unabhängigen Achse",
            Text(
                "Write the function as a word of the block.",
                "Die Funktion als Wort des Satzes schreiben.",
            ),
        ),
        (
            f"X[{form} G100]",
            REFUSED,
            "measuring with an independent axis",
            "Messen mit einer unabhängigen Achse",
            Text(
                "Measure with the path: G100 as a word of the block.",
                "Mit der Bahn messen: G100 als Wort des Satzes.",
            ),
        ),
    )


#: Forms of the language without a name, each with an example.
FORMS = table(
    Kind.FORM,
    ("X[INDP …]", SIMULATED, "motion of one axis, in cycles", "Bewegung einer Achse, in Zyklen"),
    ("X[OVERRIDE …]", SIMULATED, "override of one axis", "Override einer Achse"),
    ("X[FIXED_STOP …]", SIMULATED, "motion to a fixed stop", "Fahren auf Festanschlag"),
    (
        "X[INDP_ASYN …]",
        SIMULATED,
        "motion of one axis beside the program, which does not wait for it",
        "Bewegung einer Achse neben dem Programm, das nicht auf sie wartet",
    ),
    (
        "X[INDP_SYN …]",
        SIMULATED,
        "motion of one axis beside the path, for whose end the block waits",
        "Bewegung einer Achse neben der Bahn, auf deren Ende der Satz wartet",
    ),
    *_of_independent_axes("INDP_SYN"),
    *_of_independent_axes("INDP_ASYN"),
    (
        "X[OSC …]",
        SIMULATED,
        "motion of one axis to and fro beside the path, between two positions",
        "Pendeln einer Achse neben der Bahn zwischen zwei Positionen",
    ),
    (
        "X[DIST_CTRL …]",
        REFUSED,
        "distance control: the axis follows a sensor",
        "Abstandsregelung: die Achse folgt einem Sensor",
        Text(
            "Leave it out: there is no surface to sense; the axis keeps its position.",
            "Weglassen: es gibt keine Oberfläche; die Achse behält ihre Position.",
        ),
    ),
    (
        "X[LIFT …]",
        REFUSED,
        "lifting an axis during a motion of the path",
        "Abheben einer Achse während einer Bahnbewegung",
        Text(
            "Write the lifting as a motion: X[INDP_ASYN G91 …] before the block.",
            "Das Abheben als Bewegung schreiben: X[INDP_ASYN G91 …] vor dem Satz.",
        ),
    ),
    (
        "X[LIFT_START …]",
        REFUSED,
        "lifting an axis over several blocks begins",
        "Abheben einer Achse über mehrere Sätze beginnt",
        Text(
            "Write X[INDP_ASYN G91 …] before the first of these blocks.",
            "X[INDP_ASYN G91 …] vor den ersten dieser Sätze schreiben.",
        ),
    ),
    (
        "X[LIFT_END …]",
        REFUSED,
        "lifting an axis over several blocks ends",
        "Abheben einer Achse über mehrere Sätze endet",
        Text(
            "Write X[INDP_SYN G91 …] after the last of these blocks.",
            "X[INDP_SYN G91 …] nach dem letzten dieser Sätze schreiben.",
        ),
    ),
    (
        "X[POLY …]",
        REFUSED,
        "motion of one axis by a polynomial",
        "Bewegung einer Achse nach einem Polynom",
        Text(
            "Write the motion as a spline (#SPLINE ON) or as lines.",
            "Die Bewegung als Spline (#SPLINE ON) oder als Geraden schreiben.",
        ),
    ),
    (
        "X[COMP …]",
        REFUSED,
        "compensations of one axis on or off",
        "Kompensationen einer Achse ein oder aus",
        Text(
            "Leave it out: the simulated axis has no errors to compensate.",
            "Weglassen: die simulierte Achse hat keine Fehler, die zu kompensieren wären.",
        ),
    ),
    (
        "X[DYNAMIC …]",
        REFUSED,
        "higher acceleration of one axis for some time",
        "zeitweise höhere Beschleunigung einer Achse",
        Text(
            "Leave it out, or write G130: percent of the acceleration, up to P-AXIS-00008.",
            "Weglassen oder G130 schreiben: Prozent der Beschleunigung bis P-AXIS-00008.",
        ),
    ),
    (
        "X[SYNC …]",
        REFUSED,
        "coupling of one axis to a moving workpiece",
        "Kopplung einer Achse an ein bewegtes Werkstück",
        Text(
            "Leave it out: the simulation has no conveyor.",
            "Weglassen: die Simulation hat kein Förderband.",
        ),
    ),
    (
        "X[M7]",
        REFUSED,
        "M or H function of one axis alone",
        "M- oder H-Funktion einer Achse allein",
        Text(
            "Write the function as a word of the block.",
            "Die Funktion als Wort des Satzes schreiben.",
        ),
    ),
    (
        "S[FEED_LINK …]",
        REFUSED,
        "feed linked to a spindle",
        "Vorschub, der an eine Spindel gekoppelt ist",
        Text(
            "Write G95: feed per revolution of the main spindle.",
            "G95 schreiben: Vorschub je Umdrehung der Hauptspindel.",
        ),
    ),
    (
        "X[CALLAX …]",
        REFUSED,
        "an axis of the path is fetched by the word of spindles",
        "eine Bahnachse wird mit dem Wort für Spindeln geholt",
        Text(
            "Write #CALL AX for an axis of the path; S[CALLAX] is for spindles.",
            "Für eine Bahnachse #CALL AX schreiben; S[CALLAX] ist für Spindeln.",
        ),
    ),
    (
        "X[PUTAX …]",
        REFUSED,
        "an axis of the path is given by the word of spindles",
        "eine Bahnachse wird mit dem Wort für Spindeln abgegeben",
        Text(
            "Write #PUT AX for an axis of the path; S[PUTAX] is for spindles.",
            "Für eine Bahnachse #PUT AX schreiben; S[PUTAX] ist für Spindeln.",
        ),
    ),
    ("X[…]", REFUSED, "command for one axis", "Befehl für eine Achse"),
    ("S2[…]", SIMULATED, "command for a spindle", "Befehl für eine Spindel"),
    ("S[CALLAX]", SIMULATED, "a spindle fetches its axis", "eine Spindel holt ihre Achse"),
    ("S[PUTAX]", SIMULATED, "a spindle gives its axis", "eine Spindel gibt ihre Achse ab"),
    (
        "S[G74]",
        REFUSED,
        "homing of a spindle",
        "Referenzfahrt einer Spindel",
    ),
    ("G74 S1", REFUSED, "homing of a spindle", "Referenzfahrt einer Spindel"),
    ("M17[…]", SIMULATED, "return with a jump", "Rücksprung mit Ziel"),
    (
        "L CYCLE [MODAL_MOVE]",
        SIMULATED,
        "call after each block with a motion; MODAL_BLOCK: after each",
        "Aufruf hinter jedem Satz mit Bewegung; MODAL_BLOCK: hinter jedem",
    ),
    ("M110=130", SIMULATED, "M or H function with a value", "M- oder H-Funktion mit Wert"),
    ("M[P1]", SIMULATED, "function with a computed number", "Funktion mit berechneter Nummer"),
    (
        "M110=130, in cycles",
        REFUSED,
        "M or H function with a value, in realtime cycles",
        "M- oder H-Funktion mit Wert, in Echtzeit-Zyklen",
        Text(
            "Leave out the value, or write the function into the program.",
            "Den Wert weglassen oder die Funktion ins Programm schreiben.",
        ),
    ),
    (
        "M[P1], in cycles",
        REFUSED,
        "function with a computed number, in realtime cycles",
        "Funktion mit berechneter Nummer, in Echtzeit-Zyklen",
        Text(
            "Write the number, or a branch for each number.",
            "Die Nummer schreiben oder einen Zweig je Nummer.",
        ),
    ),
    ("M110 X", SIMULATED, "M or H function of one axis", "M- oder H-Funktion einer Achse"),
    ("G04 S", SIMULATED, "dwell in revolutions", "Verweilzeit in Umdrehungen"),
    ('"NAME"', SIMULATED, "macro", "Makro"),
    (
        'X[2 * "NAME"]',
        SIMULATED,
        "macro as a part of an expression",
        "Makro als Teil eines Ausdrucks",
    ),
    ("V.P.A = [1, 2]", SIMULATED, "values of a program's own array", "Werte eines eigenen Feldes"),
    ('"text"', SIMULATED, "text as a value", "Text als Wert"),
    ("V.E.TEXT", SIMULATED, "variable that holds a text", "Variable, die einen Text enthält"),
    (
        "#MSG [V.E.TEXT]",
        SIMULATED,
        "format of a message in a variable",
        "Meldungsformat in Variable",
    ),
    (
        "[1, 2]",
        REFUSED,
        "values of a list's array or structure",
        "Werte von Feld oder Struktur einer Liste",
        Text("Assign each element by itself.", "Jedes Element für sich zuweisen."),
    ),
    (
        "V.E.A = V.CH.A",
        SIMULATED,
        "copy of a structure or array",
        "Kopie einer Struktur, eines Feldes",
    ),
)


def forms_of(*commands: str) -> str:
    """Return the forms of the first of these commands that has any, as one line."""
    known = (COMMANDS[name].forms for name in commands if name in COMMANDS)
    return "  |  ".join(next(filter(None, known), ())) or NOTHING
