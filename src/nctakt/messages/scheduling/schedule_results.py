# SPDX-License-Identifier: MIT
"""Messages about the results of a simulation or analysis of a schedule."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

CPU_MISSING = error(
    1000180,
    classes=(0, 0),
    en="{thread}: CPU {cpu} does not exist; the operating system places the thread",
    de="{thread}: CPU {cpu} gibt es nicht; das Betriebssystem platziert den Thread",
    remedy_en="Choose a CPU from 1 to {cpus}, or simulate more CPUs with [machine] cpus.",
    remedy_de="Eine CPU von 1 bis {cpus} wählen oder mit [machine] cpus mehr simulieren.",
    cpu=("its CPU, from 1", "seine CPU, ab 1"),
    cpus=("the number of CPUs", "die Anzahl der CPUs"),
)
CPU_NOT_ASSIGNABLE = error(
    1000181,
    classes=(0, 0),
    en="{thread} cannot be assigned to CPU {cpu}: {reason}",
    de="{thread} kann CPU {cpu} nicht zugewiesen werden: {reason}",
    remedy_en="Make the CPU available, or choose another.",
    remedy_de="Die CPU verfügbar machen oder eine andere wählen.",
    cpu=("its CPU, from 1", "seine CPU, ab 1"),
)
THREAD_OVERFLOWED = error(
    900630,
    en="{thread} was still busy when it was due again; overflows: {count}, the first at {time} µs",
    de="{thread} war nicht fertig, als er wieder fällig war; Überläufe: {count}, der erste bei "
    "{time} µs",
    remedy_en="Shorten its functions, call them less often, or lengthen its cycle.",
    remedy_de="Seine Funktionen verkürzen, seltener aufrufen oder seinen Takt verlängern.",
    count=("the number of overflows", "die Anzahl der Überläufe"),
    time=(
        "the time of the first one, in µs of the simulation",
        "der Zeitpunkt des ersten, in µs der Simulation",
    ),
)
THREAD_HARDLY_COMPLETES = warning(
    900636,
    en="{thread} hardly ever finishes: {completed} times out of the {due} times it was due",
    de="{thread} wird kaum je fertig: {completed}-mal bei {due} Aktivierungen",
    remedy_en="Shorten its functions or those of threads with higher priority, or lengthen its "
    "cycle.",
    remedy_de="Seine Funktionen oder die von Threads höherer Priorität verkürzen oder seinen Takt "
    "verlängern.",
    completed=("the number of times it finished", "wie oft er fertig wurde"),
    due=("the number of times it was due", "wie oft er fällig war"),
)
THREAD_FALLS_BEHIND = warning(
    901471,
    en="{thread} cannot keep up: {waiting} of {due} activations still wait at the end",
    de="{thread} kommt nicht nach: {waiting} von {due} Aktivierungen warten am Ende noch",
    remedy_en="Shorten its functions or those of threads with higher priority, or lengthen its "
    "cycle.",
    remedy_de="Seine Funktionen oder die von Threads höherer Priorität verkürzen oder seinen Takt "
    "verlängern.",
    waiting=("the number of activations that wait", "wie viele Aktivierungen warten"),
    due=("the number of times it was due", "wie oft er fällig war"),
)
SUSPENSION_TOO_LATE = warning(
    900631,
    en="{count} of {cycles} NC cycles ended before the suspension of threads: no time is "
    "guaranteed to Windows",
    de="{count} von {cycles} NC-Takten endeten vor der Suspendierung: für Windows ist keine Zeit "
    "garantiert",
    remedy_en="NC interrupts must not come at shorter intervals than cycle_time.",
    remedy_de="NC-Interrupts dürfen nicht in kürzerem Abstand als cycle_time kommen.",
    count=("the number of such cycles", "die Anzahl dieser Takte"),
)
WINDOWS_TIME_VIOLATED = warning(
    900632,
    en="CPU {cpu}: Windows got less than {windows} µs in {count} of {cycles} NC cycles ({who})",
    de="CPU {cpu}: Windows bekam in {count} von {cycles} NC-Takten weniger als {windows} µs "
    "({who})",
    remedy_en="Shorten the threads that run in the time of Windows, or those before them.",
    remedy_de="Die Threads kürzen, die in der Zeit von Windows laufen, oder die davor.",
    count=("the number of such cycles", "die Anzahl dieser Takte"),
    who=(
        "what ran in the time of Windows, with the number of cycles",
        "was in der Zeit von Windows lief, mit der Anzahl der Takte",
    ),
)
WINDOWS_WITHOUT_GUARANTEE = warning(
    900633,
    en="windows_time is 0, but {what}",
    de="windows_time ist 0, aber {what}",
    remedy_en="Set windows_time, or make sure that all threads finish within the cycle.",
    remedy_de="windows_time setzen oder sicherstellen, dass alle Threads im Takt fertig werden.",
    what=("the reason why this is a problem", "der Grund, warum das ein Problem ist"),
)
LIBRARY_MISSING = error(
    900634,
    en="{what} needs {library}, which is not installed",
    de="{what} braucht {library}, das nicht installiert ist",
    remedy_en="Install it: {install}",
    remedy_de="Installieren: {install}",
    install=("the command that installs it", "der Befehl, der sie installiert"),
    library=("the library", "die Bibliothek"),
    what=("the option", "die Option"),
)
UNKNOWN_PICTURE_FORMAT = error(
    900635,
    en="{file}: the name of a picture must end in .svg, .png or .html",
    de="{file}: der Name eines Bilds muss auf .svg, .png oder .html enden",
    remedy_en="Choose one of these suffixes.",
    remedy_de="Eine dieser Endungen wählen.",
)
CPU_DEMAND_TOO_HIGH = warning(
    900637,
    en="CPU {cpu}: the suspendable threads need {demand} % of its time, but can have only {supply} "
    "%",
    de="CPU {cpu}: suspendierbare Threads brauchen {demand} % der Zeit, verfügbar sind {supply} %",
    remedy_en="Shorten their functions, call them less often, or shorten windows_time.",
    remedy_de="Ihre Funktionen verkürzen, seltener aufrufen oder windows_time verkürzen.",
    demand=("the demand of all threads, in percent", "der Bedarf aller Threads, in Prozent"),
    supply=(
        "the time left beside Windows, in percent",
        "die neben Windows verfügbare Zeit, in Prozent",
    ),
)
THREAD_CAN_OVERFLOW = warning(
    900638,
    en="{thread} can overflow: its response time is {response}, its cycle {cycle} µs",
    de="{thread} kann überlaufen: Antwortzeit {response}, Takt {cycle} µs",
    remedy_en="Shorten its functions or those of the threads before it.",
    remedy_de="Seine Funktionen oder die der Threads davor verkürzen.",
    response=("the longest response time", "die längste Antwortzeit"),
    cycle=("its cycle, in µs", "sein Takt, in µs"),
)
WINDOWS_TIME_CAN_BE_VIOLATED = warning(
    900640,
    en="CPU {cpu}: in the worst case Windows has less than {windows} µs in a cycle",
    de="CPU {cpu}: im ungünstigsten Fall hat Windows in einem Takt weniger als {windows} µs",
    remedy_en="Shorten threads that cannot be suspended: {who}.",
    remedy_de="Threads verkürzen, die nicht suspendiert werden können: {who}.",
    who=("the threads that cannot be suspended", "die nicht suspendierbaren Threads"),
)


NOTHING_SUGGESTED = error(
    900647,
    en="no values were found that give each thread the requested slack",
    de="es wurden keine Werte gefunden, mit denen jeder Thread die verlangte Reserve hat",
    remedy_en="Ask for less with --slack, allow more CPUs with --cpus, or shorten the functions.",
    remedy_de="Mit --slack weniger verlangen, mit --cpus mehr CPUs erlauben oder die Funktionen "
    "verkürzen.",
)
INVALID_SLACK = error(
    900648,
    en="'{text}' is not a slack",
    de="'{text}' ist keine Reserve",
    remedy_en="Write a percentage from 0 to below 100, alone or as THREAD=PERCENT. Threads are "
    "{names}.",
    remedy_de="Einen Prozentwert ab 0 und unter 100 schreiben, allein oder als THREAD=PROZENT. "
    "Threads sind {names}.",
    names=("the names of the threads", "die Namen der Threads"),
)
