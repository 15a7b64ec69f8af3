# SPDX-License-Identifier: MIT
"""Messages about a controller that a schedule gives its time."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

TICK_MISMATCH = warning(
    900730,
    en="the tick is {cycle} µs according to {file}; the list of the machine says {other} µs",
    de="der Takt beträgt {cycle} µs laut {file}; die Liste der Maschine sagt {other} µs",
    remedy_en="This may be intended; otherwise write the same cycle_time in both lists.",
    remedy_de="Das kann gewollt sein; sonst in beiden Listen dieselbe cycle_time schreiben.",
    file=("the scheduling list of the run", "die Liste der Echtzeitkonfiguration des Laufs"),
    cycle=("the length of a tick, in µs", "die Länge eines Takts, in µs"),
    other=(
        "cycle_time of the list named in the start-up list, in µs",
        "cycle_time der Liste, die die Hochlaufliste nennt, in µs",
    ),
)
NO_COMMON_TICK = error(
    260101,
    classes=(0, 0),
    known_as=(900731, 1000141),
    en="the threads with task_int ({threads}) have different cycles: there is no common tick",
    de="die Threads mit task_int ({threads}) haben verschiedene Takte: es gibt keinen gemeinsamen "
    "Takt",
    remedy_en="Give these threads the same cycle; the channels of a machine run in lockstep.",
    remedy_de="Diesen Threads denselben Takt geben; Kanäle laufen im Gleichtakt.",
)
REQUIRED_FUNCTION_NOT_CALLED = error(
    260102,
    classes=(0, 0),
    known_as=(900732,),
    en="no thread calls {function}: no program can run with this list",
    de="kein Thread ruft {function} auf: mit dieser Liste kann kein Programm laufen",
    remedy_en="Add the function to one of the threads; task_rnd decodes, task_int interpolates.",
    remedy_de="Die Funktion in einem der Threads angeben; task_rnd dekodiert, task_int "
    "interpoliert.",
    function=("the missing function", "die fehlende Funktion"),
)
UNKNOWN_PLC_THREAD = error(
    900733,
    en="load: controller.plc: {name} is not an external thread of the list",
    de="Last: controller.plc: {name} ist kein externer Thread der Liste",
    remedy_en="Name one of these semaphores: {names}.",
    remedy_de="Einen dieser Semaphore nennen: {names}.",
    name=("the name in the load", "der Name in der Last"),
    names=("the semaphores of the list", "die Semaphore der Liste"),
)
OPTION_WITHOUT_SCHEDULE = error(
    900734,
    en="{option} needs a schedule, but none is given",
    de="{option} braucht einen Ablaufplan, angegeben ist aber keiner",
    remedy_en="Name a scheduling list with --rtconf, or omit the option.",
    remedy_de="Mit --rtconf eine Liste der Echtzeitkonfiguration nennen oder die Option weglassen.",
)
