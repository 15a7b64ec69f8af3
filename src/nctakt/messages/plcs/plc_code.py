# SPDX-License-Identifier: MIT
"""Messages about the run of a PLC in Structured Text (ST-560)."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

_VALUES = (
    "values of the statement's variables, if known",
    "Werte der Variablen der Anweisung, falls bekannt",
)
_CALLS = ("where it was called from, if it was", "woher sie aufgerufen wurde, falls sie es wurde")
_TIME = ("time of the PLC's cycle", "Zeit des SPS-Zyklus")

DIVISION_BY_ZERO = error(
    902265,
    en="the PLC stops at {time}: division by zero{values}{calls}",
    de="die SPS stoppt bei {time}: Division durch null{values}{calls}",
    remedy_en="Check for zero before the division.",
    remedy_de="Vor der Division auf null prüfen.",
    values=_VALUES,
    calls=_CALLS,
    time=_TIME,
)
PLC_INDEX_OUTSIDE = error(
    902266,
    en="the PLC stops at {time}: index {index} is outside of its array [{bounds}]{values}{calls}",
    de="die SPS stoppt bei {time}: Index {index} liegt außerhalb seines Felds [{bounds}]{values}"
    "{calls}",
    remedy_en="Keep the index within the bounds of the array.",
    remedy_de="Den Index in den Grenzen des Felds halten.",
    index=("the index", "der Index"),
    bounds=("lowest and highest index", "kleinster und größter Index"),
    values=_VALUES,
    calls=_CALLS,
    time=_TIME,
)
POINTER_OUTSIDE = error(
    902267,
    en="the PLC stops at {time}: a pointer, reference or interface is null or points outside"
    "{values}{calls}",
    de="die SPS stoppt bei {time}: Zeiger, Referenz oder Schnittstelle ist null oder zeigt nach "
    "außen{values}{calls}",
    remedy_en="Assign it first; check for 0, or with __ISVALIDREF.",
    remedy_de="Vorher zuweisen; auf 0 oder mit __ISVALIDREF prüfen.",
    values=_VALUES,
    calls=_CALLS,
    time=_TIME,
)
AXIS_NOT_RELEASED = error(
    902340,
    en="the axis takes no command: MC_Power has not released it, or MC_Stop holds it",
    de="die Achse nimmt keinen Befehl an: MC_Power hat sie nicht freigegeben, oder MC_Stop hält "
    "sie",
    remedy_en="Call MC_Power with Enable TRUE first, and set Execute of MC_Stop to FALSE.",
    remedy_de="Vorher MC_Power mit Enable TRUE aufrufen und Execute von MC_Stop auf FALSE setzen.",
)
AXIS_MOVES = error(
    902860,
    en="the axis moves: it can be homed only at rest",
    de="die Achse bewegt sich: referenzieren kann man sie nur im Stillstand",
    remedy_en="Wait for Done of its last motion, or stop it with MC_Halt first.",
    remedy_de="Done der letzten Bewegung abwarten oder die Achse vorher mit MC_Halt anhalten.",
)
UNKNOWN_FACTOR = error(
    902861,
    en="acceleration and jerk have no override: AccFactor and JerkFactor are 0 or 1",
    de="Beschleunigung und Ruck haben keinen Override: AccFactor und JerkFactor sind 0 oder 1",
    remedy_en="Leave AccFactor and JerkFactor out.",
    remedy_de="AccFactor und JerkFactor weglassen.",
)
UNKNOWN_AXIS_PARAMETER = error(
    902862,
    en="no parameter has this number; there are only 1, 2, 3, 8, 9 and 12 to 17",
    de="kein Parameter hat diese Nummer; es gibt nur 1, 2, 3, 8, 9 und 12 bis 17",
    remedy_en="Read positions with MC_ReadActualPosition, states with MC_ReadStatus.",
    remedy_de="Positionen mit MC_ReadActualPosition lesen, Zustände mit MC_ReadStatus.",
)
UNKNOWN_HOMING_MODE = error(
    902863,
    en="this homing mode does not exist, or MC_Direct has no Position",
    de="diesen HomingMode gibt es nicht, oder MC_Direct hat keine Position",
    remedy_en="Use MC_DefaultHoming, MC_ForceCalibration, or MC_Direct with a Position.",
    remedy_de="MC_DefaultHoming, MC_ForceCalibration oder MC_Direct mit Position verwenden.",
)
AXIS_REFERENCE_UNBOUND = error(
    902341,
    en="{path} names no axis of this machine; its axes: {known}",
    de="{path} nennt keine Achse dieser Maschine; ihre Achsen: {known}",
    remedy_en="Give the variable the name of the axis, or pass the axis by the variable's path.",
    remedy_de="Die Variable wie die Achse nennen oder die Achse unter dem Pfad der Variablen "
    "angeben.",
    path=("the variable of the type AXIS_REF", "die Variable vom Typ AXIS_REF"),
    known=("axes of the machine", "Achsen der Maschine"),
)
STACK_FULL = error(
    902268,
    en="the PLC stops at {time}: its stack is full after {depth} nested calls{calls}",
    de="die SPS stoppt bei {time}: ihr Stapel ist nach {depth} geschachtelten Aufrufen voll{calls}",
    remedy_en="End the recursion, or make local arrays smaller.",
    remedy_de="Die Rekursion beenden oder lokale Felder verkleinern.",
    depth=("number of open calls", "Zahl der offenen Aufrufe"),
    calls=_CALLS,
    time=_TIME,
)
TOO_MANY_INSTRUCTIONS = error(
    902269,
    en="the PLC stops at {time}: more than {limit} instructions in a cycle{values}{calls}",
    de="die SPS stoppt bei {time}: mehr als {limit} Anweisungen in einem Zyklus{values}{calls}",
    remedy_en="Let the loop end, or spread its work over several cycles.",
    remedy_de="Die Schleife enden lassen oder ihre Arbeit auf mehrere Zyklen verteilen.",
    limit=("highest number of elementary instructions", "Höchstzahl elementarer Anweisungen"),
    values=_VALUES,
    calls=_CALLS,
    time=_TIME,
)
CONVERSION_OUTSIDE = error(
    902270,
    en="the PLC stops at {time}: a real number does not fit into the integer type{values}{calls}",
    de="die SPS stoppt bei {time}: eine reelle Zahl passt nicht in den ganzzahligen Typ"
    "{values}{calls}",
    remedy_en="Limit the value before its conversion.",
    remedy_de="Den Wert vor der Umwandlung begrenzen.",
    values=_VALUES,
    calls=_CALLS,
    time=_TIME,
)
STEP_ZERO = error(
    902271,
    en="the PLC stops at {time}: the step of FOR is 0{values}{calls}",
    de="die SPS stoppt bei {time}: die Schrittweite von FOR ist 0{values}{calls}",
    remedy_en="Give a step that is not 0.",
    remedy_de="Eine Schrittweite ungleich 0 angeben.",
    values=_VALUES,
    calls=_CALLS,
    time=_TIME,
)
INVALID_OPERATION = error(
    902260,
    en="the PLC stops at {time}: invalid operation with real numbers{values}{calls}",
    de="die SPS stoppt bei {time}: ungültige Operation mit reellen Zahlen{values}{calls}",
    remedy_en="Check the range of the operands first: no root of a negative number.",
    remedy_de="Vorher den Bereich der Operanden prüfen: keine Wurzel aus negativen Zahlen.",
    values=_VALUES,
    calls=_CALLS,
    time=_TIME,
)
EXCEPTION_RAISED = error(
    902360,
    en="the PLC stops at {time}: exception {code} of F_RaiseException{values}{calls}",
    de="die SPS stoppt bei {time}: Ausnahme {code} von F_RaiseException{values}{calls}",
    remedy_en="Correct the reason for it, or remove the call.",
    remedy_de="Die Ursache beheben oder den Aufruf entfernen.",
    code=("the number of the exception", "die Nummer der Ausnahme"),
    values=_VALUES,
    calls=_CALLS,
    time=_TIME,
)
NOT_TRANSLATED = error(
    902261,
    en="{what} does not run here yet",
    de="{what} läuft hier noch nicht",
    remedy_en="Use something else, or give a stub of that name in a .st file.",
    remedy_de="Etwas anderes verwenden oder einen Ersatz dieses Namens in einer .st-Datei angeben.",
    what=("a construct or a library's function", "ein Konstrukt oder eine Bibliotheksfunktion"),
)
PLC_VALUE_REFUSED = error(
    902262,
    en="{name} of type {type} cannot hold {value}",
    de="{name} vom Typ {type} kann {value} nicht aufnehmen",
    remedy_en="Did you mean {nearest}? Give a value of that type.",
    remedy_de="War {nearest} gemeint? Einen Wert dieses Typs angeben.",
    nearest=("the most similar item of an enumeration", "der ähnlichste Wert einer Aufzählung"),
)
NO_PART = error(
    902962,
    en="there is no {name}: {part} is {type}",
    de="{name} gibt es nicht: {part} ist {type}",
    remedy_en="Keep to the bounds and members of the type.",
    remedy_de="Grenzen und Elemente des Typs einhalten.",
    part=("the variable that has no such part", "die Variable, die kein solches Teil hat"),
)
NO_NUMBER = error(
    902963,
    en="{name} is {type}, but a signal must be a number or BOOL",
    de="{name} ist {type}, ein Signal muss aber eine Zahl oder BOOL sein",
    remedy_en="Name an element or a member of it: MAIN.aList[1], MAIN.fbGate.nCount.",
    remedy_de="Ein Element davon nennen: MAIN.aList[1], MAIN.fbGate.nCount.",
)
CONSTANT_FROM_OUTSIDE = error(
    902964,
    en="{name} is a constant, which nothing sets",
    de="{name} ist eine Konstante, die sich nicht setzen lässt",
    remedy_en="Change it in the declaration, or declare it without CONSTANT.",
    remedy_de="Sie in der Deklaration ändern, oder sie ohne CONSTANT deklarieren.",
)
NO_TASK = error(
    902263,
    en="{file} has no program that a task calls",
    de="{file} hat kein Programm, das eine Task aufruft",
    remedy_en="Declare a PROGRAM MAIN, or a task with its programs.",
    remedy_de="Ein PROGRAM MAIN deklarieren oder eine Task mit ihren Programmen.",
)
SEVERAL_PLC_PROJECTS = error(
    902264,
    en="{file} has several PLC projects: {names}",
    de="{file} hat mehrere SPS-Projekte: {names}",
    remedy_en="Name the .plcproj of one of them.",
    remedy_de="Die .plcproj eines davon angeben.",
    names=("the projects", "die Projekte"),
)
NO_PLC_THAT_RETAINS = error(
    902501,
    en="--retain keeps variables of a PLC in Structured Text, but there is none",
    de="--retain behält Variablen einer SPS in Strukturiertem Text, aber es gibt keine",
    remedy_en="Name its project: --plc Cell.plcproj.",
    remedy_de="Ihr Projekt angeben: --plc Cell.plcproj.",
)
RETAINED_UNREADABLE = error(
    902502,
    en="{file} does not contain retained variables: {reason}",
    de="{file} enthält keine remanenten Variablen: {reason}",
    remedy_en="Correct or delete the file; without it the variables begin with their initial "
    "values.",
    remedy_de="Die Datei berichtigen oder löschen; ohne sie beginnen die Variablen mit ihren "
    "Anfangswerten.",
    reason=("what is wrong", "was falsch ist"),
)
RETAINED_SKIPPED = warning(
    902503,
    en="{name} of {file} is not a retained variable of the PLC or has another type; it is skipped",
    de="{name} aus {file} ist keine remanente Variable der SPS oder hat einen anderen Typ: "
    "übergangen",
    remedy_en="Declare it RETAIN or PERSISTENT, or let the file be written again.",
    remedy_de="Sie als RETAIN oder PERSISTENT deklarieren oder die Datei neu schreiben lassen.",
)
CYCLE_TOO_LONG = warning(
    902632,
    en="at {time} a cycle of the task {task} took {length} of {cycle}: due times in it are lost",
    de="bei {time} dauerte ein Zyklus der Task {task} {length} von {cycle}: Fälligkeiten in dieser "
    "Zeit entfallen",
    remedy_en="Shorten the code, or give the task a longer cycle; this is reported once per task.",
    remedy_de="Den Code kürzen oder der Task einen längeren Zyklus geben; das wird je Task einmal "
    "gemeldet.",
    task=("the task", "die Task"),
    time=_TIME,
    length=("how long the cycle took", "die Dauer des Zyklus"),
    cycle=("the cycle of the task", "der Zyklus der Task"),
)
IGNORED_EXECUTE = warning(
    902710,
    en="{block}: Execute rose while the block was Busy, which has no effect ({count} ×)",
    de="{block}: Execute stieg, während der Baustein Busy war; das hat keine Wirkung ({count} ×)",
    remedy_en="Set Execute again after Done, or use another instance for the next command.",
    remedy_de="Execute erst nach Done wieder setzen oder eine weitere Instanz verwenden.",
    block=("the path of the block", "der Pfad des Bausteins"),
    count=("how often", "wie oft"),
)
