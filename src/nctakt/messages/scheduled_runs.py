# SPDX-License-Identifier: MIT
"""Messages of a controller that a schedule gives its time (900730 … 900739)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900730,
    WARNING,
    "the tick is {cycle} µs by {file}; the list of the machine says {other} µs",
    "der Takt ist {cycle} µs nach {file}; die Liste der Maschine sagt {other} µs",
    remedy_en="Nothing to do if that is meant; else write the same cycle_time in both lists.",
    remedy_de="Ist es so gemeint, nichts tun; sonst in beiden Listen cycle_time gleich schreiben.",
    parameters={
        "file": "the scheduling list of the run",
        "cycle": "the length of a tick, in µs",
        "other": "cycle_time of the list that the start-up list names, in µs",
    },
)
_add(
    900731,
    ERROR,
    "the threads with task_int ({threads}) have different cycles: there is no common tick",
    "die Threads mit task_int ({threads}) haben verschiedene Takte: es gibt keinen gemeinsamen",
    remedy_en="Give these threads the same cycle; the channels of a machine run in lockstep.",
    remedy_de="Diesen Threads denselben Takt geben; Kanäle laufen im Gleichtakt.",
    parameters={
        "threads": "the threads",
    },
)
_add(
    900732,
    ERROR,
    "no thread calls {function}: no program can run by this list",
    "kein Thread ruft {function}: nach dieser Liste kann kein Programm laufen",
    remedy_en="Write the function in one of the threads; task_rnd decodes, task_int interpolates.",
    remedy_de="Die Funktion in einem Thread angeben; task_rnd dekodiert, task_int interpoliert.",
    parameters={
        "function": "the function that is missing",
    },
)
_add(
    900733,
    ERROR,
    "load: controller.plc: {name} is no external thread of the list",
    "Last: controller.plc: {name} ist kein externer Thread der Liste",
    remedy_en="Name one of these semaphores: {names}.",
    remedy_de="Einen dieser Semaphore nennen: {names}.",
    parameters={
        "name": "the name in the load",
        "names": "the semaphores of the list",
    },
)
_add(
    900734,
    ERROR,
    "{option} belongs to a schedule, and none is given",
    "{option} gehört zu einem Scheduling, und keines ist angegeben",
    remedy_en="Name a scheduling list with --rtconf, or leave the option out.",
    remedy_de="Mit --rtconf eine Scheduling-Liste nennen oder die Option weglassen.",
    parameters={
        "option": "the option",
    },
)
