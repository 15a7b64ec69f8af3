# SPDX-License-Identifier: MIT
"""Messages about the lines of the realtime cycles' diagnosis data."""

from __future__ import annotations

from nctakt.messages.catalogue import note

LOG_MANAGER_INITIALISED = note(
    900550,
    en="Realtime cycle manager was initialised",
    de="Echtzeit-Zyklen-Manager wurde initialisiert",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus.",
)
LOG_MANAGER_CAPACITY = note(
    900551,
    en="Realtime cycle manager: {count} cycles",
    de="Echtzeit-Zyklen-Manager: {count} Zyklen",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus.",
    count=("the maximum number of cycles", "die größte Anzahl von Zyklen"),
)
LOG_CYCLE_CREATED = note(
    900552,
    en="Cycle {cycle} was created with {scope} validity",
    de="Zyklus {cycle} mit Gueltigkeit {scope} wurde angelegt",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus.",
    scope=("BLOCK, PROG or GLOBAL", "BLOCK, PROG oder GLOBAL"),
)
LOG_CYCLE_STARTED = note(
    900553,
    en="Cycle {cycle} was started",
    de="Zyklus {cycle} wurde gestartet",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus.",
)
LOG_CYCLE_HELD = note(
    900554,
    en="Cycle {cycle} was put on hold",
    de="Zyklus {cycle} wurde angehalten",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus.",
)
LOG_CYCLE_CONTINUED = note(
    900555,
    en="Cycle {cycle} was continued",
    de="Zyklus {cycle} wurde fortgesetzt",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus.",
)
LOG_CYCLE_ABORTED = note(
    900556,
    en="The actions of cycle {cycle} were aborted",
    de="Die Aktionen von Zyklus {cycle} wurden abgebrochen",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus.",
)
LOG_CYCLE_ENDED_WITH_SCOPE = note(
    900557,
    en="Cycle {cycle} ended with its validity",
    de="Zyklus {cycle} endete mit seiner Gueltigkeit",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus.",
)
LOG_CYCLE_DELETED = note(
    900558,
    en="Cycle {cycle} was deleted",
    de="Zyklus {cycle} wurde geloescht",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus.",
)
LOG_CYCLE_ENDED_BY_RESET = note(
    900559,
    en="Cycle {cycle} was ended by a reset",
    de="Zyklus {cycle} wurde durch einen Reset beendet",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus.",
)
LOG_CYCLE_ENDED_BY_ERROR = note(
    900560,
    en="Cycle {cycle} was ended by an error",
    de="Zyklus {cycle} wurde durch einen Fehler beendet",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus.",
)
LOG_BRANCH_RUNS = note(
    900561,
    en="Cycle {cycle}: the branch in line {line} runs",
    de="Zyklus {cycle}: der Zweig in Zeile {line} laeuft",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
    line=("the line of the branch", "die Zeile des Zweigs"),
)
LOG_VARIABLE_WRITTEN = note(
    900562,
    en="Cycle {cycle}: {variable} = {value}",
    de="Zyklus {cycle}: {variable} = {value}",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
    value=("its new value", "ihr neuer Wert"),
)
LOG_FUNCTION_OUTPUT = note(
    900563,
    en="Cycle {cycle}: {function} was output, number {sequence} of the tick",
    de="Zyklus {cycle}: {function} wurde ausgegeben, Nummer {sequence} im Takt",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
    function=("the M or H function", "die M- oder H-Funktion"),
    sequence=("its number within the tick, from 1", "ihre Nummer im Takt, ab 1"),
)
LOG_AXIS_MOVES = note(
    900456,
    en="Cycle {cycle}: axis {axis} moves to {position}",
    de="Zyklus {cycle}: Achse {axis} faehrt auf {position}",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
    position=("its target in ACS, in mm or degrees", "ihr Ziel in ACS, in mm oder Grad"),
)
LOG_AXIS_MOVES_ENDLESSLY = note(
    900457,
    en="Cycle {cycle}: axis {axis} moves endlessly in {direction} direction",
    de="Zyklus {cycle}: Achse {axis} faehrt endlos in {direction} Richtung",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
    direction=("positive or negative", "positiv oder negativ"),
)
LOG_MOTION_STATE = note(
    900458,
    en="Cycle {cycle}: the motion of axis {axis} {state}",
    de="Zyklus {cycle}: die Bewegung der Achse {axis} {state}",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
    state=("its new state", "ihr neuer Zustand"),
)
LOG_SPINDLE_TURNS = note(
    901042,
    en="Cycle {cycle}: spindle {spindle}: {function} with {speed} 1/min",
    de="Zyklus {cycle}: Spindel {spindle}: {function} mit {speed} 1/min",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
    function=("M3, M4 or M19", "M3, M4 oder M19"),
    speed=("its speed", "ihre Drehzahl"),
)
LOG_SPINDLE_STOPS = note(
    901043,
    en="Cycle {cycle}: spindle {spindle}: M5",
    de="Zyklus {cycle}: Spindel {spindle}: M5",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
)
LOG_SPINDLE_POSITION = note(
    901044,
    en="Cycle {cycle}: spindle {spindle} is positioned at {position} degrees",
    de="Zyklus {cycle}: Spindel {spindle} wird auf {position} Grad positioniert",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
    position=("its position", "ihre Position"),
)
LOG_SPINDLE_REACHED = note(
    901045,
    en="Cycle {cycle}: the job of spindle {spindle} is done",
    de="Zyklus {cycle}: der Auftrag der Spindel {spindle} ist erledigt",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
)
LOG_TIMER = note(
    901046,
    en="Cycle {cycle}: #TIMER {action} of timer {timer}",
    de="Zyklus {cycle}: #TIMER {action} des Timers {timer}",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
    action=("START, STOP or CLEAR", "START, STOP oder CLEAR"),
    timer=("0 … 127", "0 … 127"),
)
LOG_TIMER_READ = note(
    901047,
    en="Cycle {cycle}: #TIMER READ of timer {timer}: {value} ms",
    de="Zyklus {cycle}: #TIMER READ des Timers {timer}: {value} ms",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
    timer=("0 … 127", "0 … 127"),
    value=("the time that it has counted", "die Zeit, die er gezählt hat"),
)
LOG_USER_ERROR = note(
    901048,
    en="Cycle {cycle}: #ERROR with ID {id} and RC {rc}",
    de="Zyklus {cycle}: #ERROR mit ID {id} und RC {rc}",
    remedy_en="V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data.",
    remedy_de="V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus.",
    id=("the error's number", "die Nummer des Fehlers"),
    rc=("its reaction", "seine Reaktion"),
)
