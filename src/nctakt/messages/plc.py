# SPDX-License-Identifier: MIT
"""Messages about the PLC's side: scripted PLCs, partners in other processes, recorded inputs."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

PLC_CLASS_MISSING = error(
    900520,
    en="{file} has no class with a method cycle(self, hli)",
    de="{file} hat keine Klasse mit einer Methode cycle(self, hli)",
    remedy_en="Define one class whose method cycle is called after each tick.",
    remedy_de="Eine Klasse definieren, deren Methode cycle nach jedem Takt aufgerufen wird.",
    file=("the PLC's file", "die Datei der SPS"),
)
PLC_CLASS_AMBIGUOUS = error(
    900521,
    en="{file} has several classes with a method cycle: {names}",
    de="{file} hat mehrere Klassen mit einer Methode cycle: {names}",
    remedy_en="Keep one; put an underscore in front of the names of the others.",
    remedy_de="Eine behalten; den Namen der anderen einen Unterstrich voranstellen.",
    file=("the PLC's file", "die Datei der SPS"),
    names=("the classes", "die Klassen"),
)
PLC_LOAD_FAILED = error(
    900522,
    en="the PLC's file fails while it is loaded: {reason}\n{traceback}",
    de="die Datei der SPS scheitert beim Laden: {reason}\n{traceback}",
    remedy_en="Correct the file at the line that stands last.",
    remedy_de="Die Datei an der zuletzt genannten Zeile berichtigen.",
    reason=("the exception", "die Ausnahme"),
    traceback=(
        "the way to it, in the user's files",
        "der Weg dorthin, in den Dateien des Anwenders",
    ),
)
PLC_FAILED = error(
    900523,
    en="the PLC fails after tick {tick}: {reason}\n{traceback}",
    de="die SPS scheitert nach Takt {tick}: {reason}\n{traceback}",
    remedy_en="Correct the PLC's file at the line that stands last.",
    remedy_de="Die Datei der SPS an der zuletzt genannten Zeile berichtigen.",
    tick=("the tick that had just been run", "der Takt, der gerade lief"),
    reason=("the exception", "die Ausnahme"),
    traceback=(
        "the way to it, in the user's files",
        "der Weg dorthin, in den Dateien des Anwenders",
    ),
)
NO_PLC_AT_HLI = error(
    900650,
    en="no PLC has come to the HLI {name}",
    de="keine SPS ist an das HLI {name} gekommen",
    remedy_en="Start the program that writes 1 into plc_present of hli_command, and wait for it.",
    remedy_de="Das Programm starten, das 1 in plc_present von hli_command schreibt.",
    name=("the name of the shared memory", "der Name des gemeinsamen Speichers"),
)
PLC_NOT_ANSWERING = error(
    900651,
    en="the PLC at the HLI does not answer after tick {tick}",
    de="die SPS am HLI antwortet nach Takt {tick} nicht",
    remedy_en="Let it write turn of hli_header into turn of hli_link after each tick.",
    remedy_de="Sie muss nach jedem Takt turn von hli_header in turn von hli_link schreiben.",
    tick=("the tick that had just been run", "der Takt, der gerade lief"),
)
PLC_LEFT_HLI = error(
    900652,
    en="the PLC has left the HLI after tick {tick}",
    de="die SPS hat das HLI nach Takt {tick} verlassen",
    remedy_en="Let it stay until ready of hli_header is 0.",
    remedy_de="Sie muss bleiben, bis ready von hli_header 0 ist.",
    cause_en="It has withdrawn plc_present, or its process, whose ID it has written into process "
    "of hli_link, has ended.",
    cause_de="Sie hat plc_present zurückgenommen, oder ihr Prozess, dessen Nummer sie in process "
    "von hli_link geschrieben hat, ist zu Ende.",
    tick=("the tick that had just been run", "der Takt, der gerade lief"),
)
PLC_AND_HLI_OPTIONS = error(
    900653,
    en="--plc and --hli exclude each other: one PLC answers the CNC",
    de="--plc und --hli schließen sich aus: eine SPS antwortet der CNC",
    remedy_en="Leave one of them out.",
    remedy_de="Eine der beiden Angaben weglassen.",
)
INPUT_CELL_COUNT = error(
    900654,
    en="{file}, line {line}: {count} cells, {expected} are needed",
    de="{file}, Zeile {line}: {count} Zellen, {expected} sind nötig",
    remedy_en="Give each column a cell; an empty one leaves its variable as it is.",
    remedy_de="Jeder Spalte eine Zelle geben; eine leere lässt ihre Variable, wie sie ist.",
    file=("the file of inputs", "die Datei der Eingaben"),
    line=("the line in it", "die Zeile darin"),
    count=("cells of the row", "Zellen der Zeile"),
    expected=("columns of the first row", "Spalten der ersten Zeile"),
)
INPUT_HEADER_MISSING = error(
    900655,
    en="{file}, line {line}: the first row does not name time and variables",
    de="{file}, Zeile {line}: die erste Zeile nennt nicht Zeit und Variablen",
    remedy_en="Write time, then variables: time,V.E.DOOR,HLI.OVERRIDE",
    remedy_de="Zuerst time schreiben, dann Variablen: time,V.E.DOOR,HLI.OVERRIDE",
    file=("the file of inputs", "die Datei der Eingaben"),
    line=("the line in it", "die Zeile darin"),
)
UNKNOWN_PLC_AXIS = error(
    900656,
    en="there is no axis {name}",
    de="es gibt keine Achse {name}",
    remedy_en="Name one of: {known}",
    remedy_de="Eine von diesen nennen: {known}",
    name=("the name", "der Name"),
    known=("the axes of the machine", "die Achsen der Maschine"),
)
INVALID_AXIS_COMMAND = error(
    900657,
    en="the axis {name} cannot be moved with the value {value} at the speed {speed}",
    de="die Achse {name} kann mit Wert {value} und Geschwindigkeit {speed} nicht fahren",
    remedy_en="Give a finite position or distance, and a speed above 0.",
    remedy_de="Eine endliche Position oder Strecke und eine Geschwindigkeit über 0 angeben.",
    name=("the axis", "die Achse"),
    value=("position or distance", "Position oder Strecke"),
    speed=("the axis' speed", "Geschwindigkeit der Achse"),
)
TOO_MANY_AXIS_COMMANDS = error(
    900658,
    en="more commands of axes in one tick than can be taken: {name} is left out",
    de="mehr Aufträge an Achsen in einem Takt, als möglich ist: {name} bleibt außen vor",
    remedy_en="Call function blocks with a rising execute in different ticks.",
    remedy_de="Funktionsbausteine mit steigendem execute in verschiedenen Takten aufrufen.",
    name=("the axis", "die Achse"),
)
STALE_ACKNOWLEDGEMENT = warning(
    900671,
    en="after tick {tick} the PLC acknowledges {name}, which no longer waits; it is ignored",
    de="nach Takt {tick} quittiert die SPS {name}, das nicht mehr wartet; das bleibt ohne Wirkung",
    remedy_en="Acknowledge what hli.functions() and hli.spindle_jobs() give in the same call.",
    remedy_de="Quittieren, was hli.functions() und hli.spindle_jobs() im selben Aufruf liefern.",
    cause_en="The function was acknowledged before, or a reset has cleared it. Another function "
    "may have its slot by now; that one still waits.",
    cause_de="Die Funktion wurde schon quittiert, oder ein Reset hat sie gelöscht. Ihren Platz "
    "kann inzwischen eine andere Funktion haben; diese wartet weiter.",
    name=("the function or spindle", "die Funktion oder Spindel"),
    tick=("the tick that had just been run", "der Takt, der gerade lief"),
)
CHANNEL_BEING_RESET = error(
    900810,
    en="the channel of the axis {axis} is being reset: it takes no command until all stands",
    de="der Kanal der Achse {axis} wird gerade zurückgesetzt: sie nimmt keinen Auftrag an, bis "
    "alles steht",
    remedy_en="Command the axis again when the reset is over.",
    remedy_de="Die Achse wieder beauftragen, wenn der Reset vorbei ist.",
    cause_en="A reset lasts until all axes of the channel stand.",
    cause_de="Ein Reset dauert, bis alle Achsen des Kanals stehen.",
    axis=("the axis", "die Achse"),
    reaction=6,
    clearing=6,
)
