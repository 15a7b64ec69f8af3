# SPDX-License-Identifier: MIT
"""Messages about stopping in a PLC in Structured Text, and about its variables there."""

from __future__ import annotations

from nctakt.messages.catalogue import error

NO_STRUCTURED_TEXT = error(
    902810,
    en="{what} needs a PLC in Structured Text, and this session has none",
    de="{what} braucht eine SPS in Strukturiertem Text; diese Sitzung hat keine",
    remedy_en="Name the PLC: plc, --plc, or plc in nctakt.toml.",
    remedy_de="Die SPS nennen: plc, --plc oder plc in nctakt.toml.",
    what=("what was asked for", "was verlangt war"),
)
NO_STATEMENT_THERE = error(
    902811,
    en="no statement of the PLC begins in line {line} of {file}",
    de="in Zeile {line} von {file} beginnt keine Anweisung der SPS",
    remedy_en="Name a line in which a statement of the project itself begins.",
    remedy_de="Eine Zeile nennen, in der eine Anweisung des Projekts selbst beginnt.",
    file=("the file", "die Datei"),
)
UNKNOWN_PLC_VARIABLE = error(
    902812,
    en="the PLC knows no variable {name} here",
    de="die SPS kennt hier keine Variable {name}",
    remedy_en="Name a variable that this statement sees, or a global path: MAIN.fbGate.bOpen.",
    remedy_de="Eine Variable nennen, die diese Anweisung sieht, oder einen globalen Pfad: "
    "MAIN.fbGate.bOpen.",
)
REFERS_TO_NOTHING = error(
    902813,
    en="{name} refers to nothing: it is null, or leads out of the PLC's memory",
    de="{name} verweist auf nichts: null oder außerhalb des Speichers der SPS",
    remedy_en="Look at the pointer itself; the code sets it.",
    remedy_de="Den Zeiger selbst ansehen; der Code setzt ihn.",
)
NOT_EVALUATED = error(
    902814,
    en="the debugger does not evaluate this: {what}",
    de="das wertet der Debugger nicht aus: {what}",
    remedy_en="Use variables, operators, conversions and functions that only compute.",
    remedy_de="Variablen, Operatoren, Konvertierungen und Funktionen verwenden, die nur rechnen.",
    what=("the part of the expression", "der Teil des Ausdrucks"),
)
POINTER_FROM_OUTSIDE = error(
    902815,
    en="{name} is of the type {type}: from outside it can only be set to 0",
    de="{name} ist vom Typ {type}: von außen lässt es sich nur auf 0 setzen",
    remedy_en="Let the code of the PLC set it.",
    remedy_de="Es vom Code der SPS setzen lassen.",
)
NOT_SET_FROM_OUTSIDE = error(
    902816,
    en="{name} cannot be set: {reason}",
    de="{name} lässt sich nicht setzen: {reason}",
    remedy_en="Set a variable of an instance, a program or a global list; it takes effect in the "
    "next tick.",
    remedy_de="Eine Variable einer Instanz, eines Programms oder einer Liste setzen; sie wirkt ab "
    "dem nächsten Takt.",
)
CONDITION_IS_NO_TRUTH = error(
    902817,
    en="a condition must be BOOL, but {text} is of the type {type}",
    de="eine Bedingung muss BOOL sein, {text} ist aber vom Typ {type}",
    remedy_en="Compare the value: n > 0.",
    remedy_de="Den Wert vergleichen: n > 0.",
    text=("the condition", "die Bedingung"),
)
PLC_HAS_STOPPED = error(
    902818,
    en="a fault has stopped the PLC: there is no next statement",
    de="ein Fehler hat die SPS angehalten: es gibt keine nächste Anweisung",
    remedy_en="Go back, or start again.",
    remedy_de="Zurückgehen oder neu beginnen.",
)
