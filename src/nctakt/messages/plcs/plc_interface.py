# SPDX-License-Identifier: MIT
"""Messages about PLC code that does not fit the lists of its machine."""

from __future__ import annotations

from nctakt.messages.catalogue import note, warning

INTERFACE_INDEX_OUTSIDE = warning(
    902361,
    en="{name}[{index}]: the machine has {count} of them, counted from 0",
    de="{name}[{index}]: die Maschine hat davon {count}, ab 0 gezählt",
    remedy_en="Correct the index, or the machine's start-up list.",
    remedy_de="Den Index oder die Hochlaufliste der Maschine berichtigen.",
    index=("the index", "der Index"),
    count=("the number of channels or axes", "die Anzahl der Kanäle oder Achsen"),
)
NOTHING_ACKNOWLEDGES = warning(
    902362,
    en="the PLC announces itself for the channel, and nothing sets done_w: functions wait forever",
    de="die SPS meldet sich für den Kanal an, und nichts setzt done_w: Funktionen warten endlos",
    remedy_en="Set done_w of each unit of techno_unit_std_sync[], after please_rw is TRUE.",
    remedy_de="done_w jeder Einheit von techno_unit_std_sync[] setzen, sobald please_rw TRUE ist.",
)
FUNCTION_NOT_ACKNOWLEDGED = warning(
    902363,
    en="the channel list has functions for which no code sets done_w: {functions}",
    de="die Kanalliste hat Funktionen, für die kein Code done_w setzt: {functions}",
    remedy_en="Add labels for them or an ELSE, or synchronise them with MOS in the list.",
    remedy_de="Marken dafür oder ein ELSE ergänzen; oder sie in der Liste mit MOS synchronisieren.",
    functions=("the functions", "die Funktionen"),
)
CODE_KNOWS_UNLISTED_FUNCTION = note(
    902364,
    en="no channel list has a function M{number} or H{number}: it never comes",
    de="keine Kanalliste hat eine Funktion M{number} oder H{number}: sie kommt nie",
    remedy_en="Add it to the channel list (P-CHAN-00041, P-CHAN-00027), or remove the label.",
    remedy_de="Sie in die Kanalliste aufnehmen (P-CHAN-00041, P-CHAN-00027) oder die Marke "
    "entfernen.",
)
SEMAPHORE_NEVER_SET = warning(
    902365,
    en="a command is written, and nothing sets command_semaphor_rw of {kind}: it is never taken",
    de="ein Befehl wird geschrieben, und nichts setzt command_semaphor_rw von {kind}: er wird nie "
    "übernommen",
    remedy_en="Set command_semaphor_rw after the command, when it is FALSE.",
    remedy_de="command_semaphor_rw nach dem Befehl setzen, wenn es FALSE ist.",
    kind=("the type of the control unit", "der Typ der Control Unit"),
)
LATE_UNITS_SEEN_LATE = note(
    902981,
    en="the fastest task runs each {cycle}, realtime cycles output functions in each tick of "
    "{tick}",
    de="die schnellste Task läuft alle {cycle}, Echtzeit-Zyklen geben Funktionen in jedem Takt von "
    "{tick} aus",
    remedy_en="Let a task with the cycle time of the CNC handle the functions of realtime cycles.",
    remedy_de="Die Funktionen von Echtzeit-Zyklen in einer Task mit der Zykluszeit der CNC "
    "behandeln.",
    cycle=("the cycle time of the task", "die Zykluszeit der Task"),
    tick=("the cycle time of the CNC", "die Zykluszeit der CNC"),
)
VARIABLE_DIFFERS = warning(
    902366,
    en="{name} of type {type} is at byte {offset} of {root}; the lists have there: {other}",
    de="{name} vom Typ {type} liegt bei Byte {offset} von {root}; dort haben die Listen: {other}",
    remedy_en="Lay the structure out as the lists do (P-STUP-00145); fill gaps with arrays of "
    "bytes.",
    remedy_de="Die Struktur wie die Listen anordnen (P-STUP-00145); Lücken mit Byte-Feldern "
    "füllen.",
    offset=("the number of bytes from the first variable on", "die Bytes ab der ersten Variablen"),
    root=("the pointer of the interface", "der Zeiger der Schnittstelle"),
    other=("the variable that lies there", "die Variable, die dort liegt"),
)
