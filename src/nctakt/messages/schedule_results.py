# SPDX-License-Identifier: MIT
"""Messages about what a simulation or an analysis of a schedule shows."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

CPU_MISSING = error(
    1000180,
    en="{thread}: CPU {cpu} does not exist; the operating system places the thread",
    de="{thread}: CPU {cpu} gibt es nicht; das Betriebssystem platziert den Thread",
    remedy_en="Choose a CPU from 1 to {cpus}, or simulate more with [machine] cpus.",
    remedy_de="Eine CPU von 1 bis {cpus} wählen oder mit [machine] cpus mehr simulieren.",
    thread=("the thread", "der Thread"),
    cpu=("its CPU, from 1", "seine CPU, ab 1"),
    cpus=("how many there are", "wie viele es gibt"),
)
CPU_NOT_ASSIGNABLE = error(
    1000181,
    en="{thread}: it cannot be assigned to CPU {cpu}: {reason}",
    de="{thread}: die Zuweisung an CPU {cpu} ist nicht möglich: {reason}",
    remedy_en="Make the CPU available, or choose another one.",
    remedy_de="Die CPU verfügbar machen oder eine andere wählen.",
    thread=("the thread", "der Thread"),
    cpu=("its CPU, from 1", "seine CPU, ab 1"),
    reason=("the reason in English", "der Grund"),
)
THREAD_OVERFLOWED = error(
    900630,
    en="{thread}: it was still busy when it was due again: {count} overflows, first at {time} µs",
    de="{thread}: nicht fertig, als er wieder fällig war: {count} Überläufe, zuerst bei {time} µs",
    remedy_en="Shorten its functions, call them less often, or lengthen its cycle.",
    remedy_de="Seine Funktionen verkürzen, seltener rufen oder seinen Takt verlängern.",
    thread=("the thread", "der Thread"),
    count=("how often", "wie oft"),
    time=("when it happened first, in µs of the simulation", "wann zuerst, in µs der Simulation"),
)
THREAD_HARDLY_COMPLETES = warning(
    900636,
    en="{thread} hardly ever finishes: {completed} of {due} times that it was due",
    de="{thread} wird kaum je fertig: {completed}-mal bei {due} Aktivierungen",
    remedy_en="Shorten its functions or those of more urgent threads, or lengthen its cycle.",
    remedy_de="Seine Funktionen oder die dringenderer Threads verkürzen oder seinen Takt "
    "verlängern.",
    thread=("the thread", "der Thread"),
    completed=("how often it finished", "wie oft er fertig wurde"),
    due=("how often it was due", "wie oft er fällig war"),
)
SUSPENSION_TOO_LATE = warning(
    900631,
    en="{count} of {cycles} NC cycles ended before threads are suspended: Windows has no guarantee",
    de="{count} von {cycles} NC-Takten endeten vor der Suspendierung: Windows ist nichts "
    "garantiert",
    remedy_en="The NC interrupt must not come earlier than each cycle_time.",
    remedy_de="Der NC-Interrupt darf nicht früher kommen als alle cycle_time.",
    count=("how many cycles", "wie viele Takte"),
    cycles=("of how many", "von wie vielen"),
)
WINDOWS_TIME_VIOLATED = warning(
    900632,
    en="CPU {cpu}: Windows got less than {windows} µs in {count} of {cycles} NC cycles ({who})",
    de="CPU {cpu}: Windows bekam in {count} von {cycles} NC-Takten weniger als {windows} µs "
    "({who})",
    remedy_en="Shorten what runs in Windows' time, or the threads before it.",
    remedy_de="Verkürzen, was in der Zeit von Windows läuft, oder die Threads davor.",
    cpu=("the processor", "der Prozessor"),
    windows=("windows_time, in µs", "windows_time, in µs"),
    count=("how many cycles", "wie viele Takte"),
    cycles=("of how many", "von wie vielen"),
    who=(
        "what ran in Windows' time, in how many cycles",
        "was in der Zeit von Windows lief, in wie vielen Takten",
    ),
)
WINDOWS_WITHOUT_GUARANTEE = warning(
    900633,
    en="windows_time is 0, and {what}",
    de="windows_time ist 0, und {what}",
    remedy_en="Set windows_time, or make sure that all threads finish within the cycle.",
    remedy_de="windows_time setzen oder dafür sorgen, dass alle Threads im Takt fertig werden.",
    what=("what shows that it is not sensible", "was zeigt, dass es nicht sinnvoll ist"),
)
LIBRARY_MISSING = error(
    900634,
    en="{library} is missing, which {what} needs",
    de="{library} fehlt, das {what} braucht",
    remedy_en="Install what pictures need, in the checkout: pip install '.[plot]'",
    remedy_de="Installieren, was Bilder brauchen, im Checkout: pip install '.[plot]'",
    library=("the library", "die Bibliothek"),
    what=("the option", "die Option"),
)
UNKNOWN_PICTURE_FORMAT = error(
    900635,
    en="{file}: a picture ends in .svg, .png or .html",
    de="{file}: ein Bild endet auf .svg, .png oder .html",
    remedy_en="Name the file so.",
    remedy_de="Die Datei so nennen.",
    file=("the file", "die Datei"),
)
CPU_DEMAND_TOO_HIGH = warning(
    900637,
    en="CPU {cpu}: the suspendable threads need {demand} % of its time and can have {supply} %",
    de="CPU {cpu}: suspendierbare Threads brauchen {demand} % der Zeit und haben höchstens "
    "{supply} %",
    remedy_en="Shorten their functions, call them less often, or shorten windows_time.",
    remedy_de="Ihre Funktionen verkürzen, seltener rufen oder windows_time verkürzen.",
    cpu=("the processor", "der Prozessor"),
    demand=("the demand of all threads, in percent", "der Bedarf aller Threads, in Prozent"),
    supply=("what is left beside Windows, in percent", "was neben Windows übrig ist, in Prozent"),
)
THREAD_CAN_OVERFLOW = warning(
    900638,
    en="{thread} can overflow: its response is {response}, its cycle {cycle} µs",
    de="{thread} kann überlaufen: Antwortzeit {response}, Takt {cycle} µs",
    remedy_en="Shorten its functions or those of the threads before it.",
    remedy_de="Seine Funktionen oder die der Threads davor verkürzen.",
    thread=("the thread", "der Thread"),
    response=("the longest response", "die längste Antwortzeit"),
    cycle=("its cycle, in µs", "sein Takt, in µs"),
)
WINDOWS_TIME_CAN_BE_VIOLATED = warning(
    900640,
    en="CPU {cpu}: Windows has less than {windows} µs in a cycle when all run as long as they can",
    de="CPU {cpu}: laufen alle, solange sie können, hat Windows im Takt weniger als {windows} µs",
    remedy_en="Shorten what cannot be suspended: {who}.",
    remedy_de="Verkürzen, was nicht suspendiert werden kann: {who}.",
    cpu=("the processor", "der Prozessor"),
    windows=("windows_time, in µs", "windows_time, in µs"),
    who=("the threads that cannot be suspended", "die nicht suspendierbaren Threads"),
)
