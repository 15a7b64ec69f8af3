# SPDX-License-Identifier: MIT
"""Messages of the PLC's side: partners in other processes, scripted PLCs (900650 … 900679)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900650,
    ERROR,
    "no PLC has come to the HLI {name}",
    "keine SPS ist an das HLI {name} gekommen",
    remedy_en="Start the program that writes 1 into plc_present of hli_command, and wait for it.",
    remedy_de="Das Programm starten, das 1 in plc_present von hli_command schreibt.",
    parameters={"name": "the name of the shared memory"},
)
_add(
    900651,
    ERROR,
    "the PLC at the HLI does not answer after tick {tick}",
    "die SPS am HLI antwortet nach Takt {tick} nicht",
    remedy_en="Let it write turn of hli_header into turn of hli_link after each tick.",
    remedy_de="Sie muss nach jedem Takt turn von hli_header in turn von hli_link schreiben.",
    parameters={"tick": "the tick that had just been run"},
)
_add(
    900652,
    ERROR,
    "the PLC has left the HLI after tick {tick}",
    "die SPS hat das HLI nach Takt {tick} verlassen",
    remedy_en="Let it stay until ready of hli_header is 0.",
    remedy_de="Sie muss bleiben, bis ready von hli_header 0 ist.",
    parameters={"tick": "the tick that had just been run"},
)
_add(
    900653,
    ERROR,
    "--plc and --hli exclude each other: one PLC answers the CNC",
    "--plc und --hli schließen sich aus: eine SPS antwortet der CNC",
    remedy_en="Leave one of them out.",
    remedy_de="Eine der beiden Angaben weglassen.",
)
_add(
    900654,
    ERROR,
    "{file}, line {line}: {count} cells, {expected} are needed",
    "{file}, Zeile {line}: {count} Zellen, {expected} sind nötig",
    remedy_en="Give each column a cell; an empty one leaves its variable as it is.",
    remedy_de="Jeder Spalte eine Zelle geben; eine leere lässt ihre Variable, wie sie ist.",
    parameters={
        "file": "the file of inputs",
        "line": "the line in it",
        "count": "cells of the row",
        "expected": "columns of the first row",
    },
)
_add(
    900655,
    ERROR,
    "{file}, line {line}: the first row does not name time and variables",
    "{file}, Zeile {line}: die erste Zeile nennt nicht Zeit und Variablen",
    remedy_en="Write time, then variables: time,V.E.DOOR,HLI.OVERRIDE",
    remedy_de="Zuerst time schreiben, dann Variablen: time,V.E.DOOR,HLI.OVERRIDE",
    parameters={"file": "the file of inputs", "line": "the line in it"},
)
_add(
    900656,
    ERROR,
    "there is no axis {name}",
    "es gibt keine Achse {name}",
    remedy_en="Name one of: {known}",
    remedy_de="Eine von diesen nennen: {known}",
    parameters={"name": "the name", "known": "the axes of the machine"},
)
_add(
    900657,
    ERROR,
    "the axis {name} cannot be moved with the value {value} at the speed {speed}",
    "die Achse {name} kann mit Wert {value} und Geschwindigkeit {speed} nicht fahren",
    remedy_en="Give a finite position or distance, and a speed above 0.",
    remedy_de="Eine endliche Position oder Strecke und eine Geschwindigkeit über 0 angeben.",
    parameters={"name": "the axis", "value": "position or distance", "speed": "the axis' speed"},
)
_add(
    900658,
    ERROR,
    "more commands of axes in one tick than can be taken: {name} is left out",
    "mehr Aufträge an Achsen in einem Takt, als möglich ist: {name} bleibt außen vor",
    remedy_en="Call function blocks with a rising execute in different ticks.",
    remedy_de="Funktionsbausteine mit steigendem execute in verschiedenen Takten aufrufen.",
    parameters={"name": "the axis"},
)
_add(
    900671,
    WARNING,
    "after tick {tick} the PLC acknowledges {name}, which no longer waits; it is ignored",
    "nach Takt {tick} quittiert die SPS {name}, das nicht mehr wartet; das bleibt ohne Wirkung",
    remedy_en="Acknowledge what hli.functions() and hli.spindle_jobs() give in the same call.",
    remedy_de="Quittieren, was hli.functions() und hli.spindle_jobs() im selben Aufruf liefern.",
    cause_en="The function was acknowledged before, or a reset has cleared it. Another function may"
    " have its slot by now; that one still waits.",
    cause_de="Die Funktion wurde schon quittiert, oder ein Reset hat sie gelöscht. Ihren Platz kann"
    " inzwischen eine andere Funktion haben; diese wartet weiter.",
    parameters={"name": "the function or spindle", "tick": "the tick that had just been run"},
)
_add(
    900660,
    ERROR,
    "'{text}' is no expectation",
    "'{text}' ist keine Erwartung",
    remedy_en='Write fired, M100, message "…", error 22009, ended, X = 1.5; see docs/testing.md.',
    remedy_de='Etwa fired, M100, message "…", error 22009, X = 1.5; siehe docs/testing.md.',
    parameters={"text": "the expectation as it stands in the comment"},
)
_add(
    900661,
    ERROR,
    "'{text}' cannot be given to a run",
    "'{text}' kann einem Lauf nicht mitgegeben werden",
    remedy_en="Write V.E.VALUE = 5, V.E.VALUE = 5 at 20ms, plc FILE, machine FOLDER, "
    "limit TIME, after TIME or start.",
    remedy_de="V.E.VALUE = 5, V.E.VALUE = 5 at 20ms, plc DATEI, machine ORDNER, limit ZEIT, "
    "after ZEIT oder start schreiben.",
    parameters={"text": "what stands in the comment"},
)
_add(
    900810,
    ERROR,
    "the channel of the axis {axis} is being reset: it takes no command until all stands",
    "der Kanal der Achse {axis} wird gerade zurückgesetzt: sie nimmt keinen Auftrag an, bis alles"
    " steht",
    remedy_en="Command the axis again when the reset is over.",
    remedy_de="Die Achse wieder beauftragen, wenn der Reset vorbei ist.",
    cause_en="A reset lasts until all axes of the channel stand.",
    cause_de="Ein Reset dauert, bis alle Achsen des Kanals stehen.",
    parameters={"axis": "the axis"},
    reaction=6,
    clearing=6,
)
