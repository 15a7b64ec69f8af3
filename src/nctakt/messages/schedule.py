# SPDX-License-Identifier: MIT
"""Messages of the scheduling list rtconf.lis (900030 … 900059)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, NOTE, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900030,
    ERROR,
    "interrupt_source is not configured; the timer starts the NC cycles",
    "interrupt_source ist nicht konfiguriert; der Timer löst die NC-Takte aus",
    remedy_en="Set interrupt_source to 1 (hardware interrupt), 2 (timer) or 3 (semaphore).",
    remedy_de="interrupt_source auf 1 (Hardware-Interrupt), 2 (Timer) oder 3 (Semaphor) setzen.",
    cause_en="With external scheduling (4) there is nothing that nctakt could simulate.",
    cause_de="Bei externem Scheduling (4) gibt es nichts, was nctakt simulieren könnte.",
)
_add(
    900031,
    ERROR,
    "{key} is missing or defective and has no default; {fallback} µs are used",
    "{key} fehlt oder ist fehlerhaft und hat keinen Standardwert; es gelten {fallback} µs",
    remedy_en="Set {key}.",
    remedy_de="{key} setzen.",
    parameters={
        "key": "the parameter's name",
        "fallback": "the value that is used, in µs",
    },
)
_add(
    900032,
    ERROR,
    "time_slice ({slice} µs) is longer than cycle_time ({cycle} µs)",
    "time_slice ({slice} µs) ist länger als cycle_time ({cycle} µs)",
    remedy_en="Make time_slice a third to a twentieth of cycle_time.",
    remedy_de="time_slice auf ein Drittel bis ein Zwanzigstel von cycle_time setzen.",
    parameters={
        "cycle": "cycle_time as written, in µs",
        "slice": "time_slice as written, in µs",
    },
)
_add(
    900033,
    WARNING,
    "cycle_time ({cycle} µs) is less than three times time_slice ({slice} µs)",
    "cycle_time ({cycle} µs) ist kleiner als das Dreifache von time_slice ({slice} µs)",
    remedy_en="Make time_slice a third to a twentieth of cycle_time.",
    remedy_de="time_slice auf ein Drittel bis ein Zwanzigstel von cycle_time setzen.",
    parameters={
        "cycle": "cycle_time as written, in µs",
        "slice": "time_slice as written, in µs",
    },
)
_add(
    900034,
    NOTE,
    "cycle_time ({cycle} µs) is more than twenty times time_slice ({slice} µs)",
    "cycle_time ({cycle} µs) ist größer als das Zwanzigfache von time_slice ({slice} µs)",
    remedy_en="Make time_slice a third to a twentieth of cycle_time.",
    remedy_de="time_slice auf ein Drittel bis ein Zwanzigstel von cycle_time setzen.",
    parameters={
        "cycle": "cycle_time as written, in µs",
        "slice": "time_slice as written, in µs",
    },
)
_add(
    900035,
    WARNING,
    "{key}: {value} µs is no multiple of {step} µs; {effective} µs are used",
    "{key}: {value} µs ist kein Vielfaches von {step} µs; es gelten {effective} µs",
    remedy_en="Write a multiple of {step}.",
    remedy_de="Ein Vielfaches von {step} schreiben.",
    parameters={
        "key": "the parameter's name",
        "value": "the time as written, in µs",
        "step": "what it has to be a multiple of, in µs",
        "effective": "the time that is used, in µs",
    },
)
_add(
    1000153,
    WARNING,
    "cycle_time: {value} µs is no multiple of time_slice; {effective} µs are used",
    "cycle_time: {value} µs ist kein Vielfaches von time_slice; es gelten {effective} µs",
    remedy_en="Write a multiple of time_slice.",
    remedy_de="Ein Vielfaches von time_slice schreiben.",
    cause_en="An NC cycle is made of whole time slices.",
    cause_de="Ein NC-Takt besteht aus ganzen Zeitscheiben.",
    parameters={
        "value": "the time as written, in µs",
        "effective": "the time that is used, in µs",
    },
)
_add(
    900036,
    ERROR,
    "windows_time ({value} µs) is shorter than time_slice; {slice} µs are used",
    "windows_time ({value} µs) ist kürzer als time_slice; es gelten {slice} µs",
    remedy_en="Write a multiple of time_slice, or 0 to guarantee nothing.",
    remedy_de="Ein Vielfaches von time_slice schreiben oder 0, um nichts zu garantieren.",
    parameters={
        "value": "windows_time as written, in µs",
        "slice": "time_slice, in µs",
    },
)
_add(
    900037,
    NOTE,
    "windows_time 0: no computing time is guaranteed to Windows",
    "windows_time 0: für Windows ist keine Rechenzeit garantiert",
    remedy_en="Make sure that all threads finish within every NC cycle.",
    remedy_de="Sicherstellen, dass alle Threads in jedem NC-Takt fertig werden.",
)
_add(
    900038,
    WARNING,
    "windows_time ({value} µs) takes the whole NC cycle ({cycle} µs): threads that can "
    "be suspended get nothing",
    "windows_time ({value} µs) nimmt den ganzen NC-Takt ({cycle} µs): suspendierbare "
    "Threads bekommen nichts",
    remedy_en="Shorten windows_time.",
    remedy_de="windows_time verkürzen.",
    parameters={
        "value": "windows_time, in µs",
        "cycle": "the NC cycle, in µs",
    },
)
_add(
    900039,
    WARNING,
    "windows_time ({value} µs) is short: switching to Windows and back takes much of it",
    "windows_time ({value} µs) ist kurz: der Wechsel zu Windows und zurück kostet viel davon",
    remedy_en="500 µs are usual.",
    remedy_de="Üblich sind 500 µs.",
    parameters={
        "value": "windows_time, in µs",
    },
)
_add(
    900040,
    NOTE,
    "windows_time ({value} µs) differs from time_slice ({slice} µs)",
    "windows_time ({value} µs) weicht von time_slice ({slice} µs) ab",
    remedy_en="The manual recommends equal times.",
    remedy_de="Das Handbuch empfiehlt gleiche Zeiten.",
    parameters={
        "value": "windows_time, in µs",
        "slice": "time_slice, in µs",
    },
)
_add(
    900041,
    ERROR,
    "interrupt_source is a semaphore, but external_object_name is empty",
    "interrupt_source ist ein Semaphor, aber external_object_name ist leer",
    remedy_en="Name the semaphore.",
    remedy_de="Den Semaphor benennen.",
)
_add(
    900042,
    NOTE,
    "external_object_name has no effect: interrupt_source is no semaphore",
    "external_object_name bleibt ohne Wirkung: interrupt_source ist kein Semaphor",
    remedy_en="Set interrupt_source to 3, or delete the line.",
    remedy_de="interrupt_source auf 3 setzen oder die Zeile löschen.",
)
_add(
    900044,
    WARNING,
    "{key} is 0 or missing; the thread runs in every NC cycle ({effective} µs)",
    "{key} ist 0 oder fehlt; der Thread läuft in jedem NC-Takt ({effective} µs)",
    remedy_en="Set the cycle.",
    remedy_de="Den Takt setzen.",
    parameters={
        "key": "the parameter's name",
        "effective": "the cycle that is used, in µs",
    },
)
_add(
    900045,
    WARNING,
    "{key} is empty",
    "{key} ist leer",
    remedy_en="Name the thread; a function without a name is never called.",
    remedy_de="Den Thread benennen; eine Funktion ohne Namen wird nie gerufen.",
    parameters={
        "key": "the parameter's name",
    },
)
_add(
    900047,
    WARNING,
    "{key}: {other} has the name '{value}' already",
    "{key}: {other} heißt bereits '{value}'",
    remedy_en="Use different names.",
    remedy_de="Verschiedene Namen verwenden.",
    parameters={
        "key": "the parameter's name",
        "other": "the parameter that had the name first",
        "value": "the name",
    },
)
_add(
    900048,
    WARNING,
    "{key}: '{value}' is no function of the controller; it is taken as a function of yours",
    "{key}: '{value}' ist keine Funktion der Steuerung; sie gilt als eigene Funktion",
    remedy_en="The controller's functions are {names}.",
    remedy_de="Die Funktionen der Steuerung sind {names}.",
    parameters={
        "key": "the parameter's name",
        "value": "the function's name",
        "names": "the functions that exist",
    },
)
_add(
    900049,
    NOTE,
    "{key}: {other} uses bit {value} already",
    "{key}: {other} verwendet Bit {value} bereits",
    remedy_en="Use different bits to tell the functions apart.",
    remedy_de="Verschiedene Bits verwenden, um die Funktionen zu unterscheiden.",
    parameters={
        "key": "the parameter's name",
        "other": "the parameter that used the bit first",
        "value": "the bit",
    },
)
_add(
    900050,
    NOTE,
    "the indices have a gap: {key} is not configured",
    "die Indizes haben eine Lücke: {key} ist nicht konfiguriert",
    remedy_en="Number threads and functions without gaps.",
    remedy_de="Threads und Funktionen lückenlos nummerieren.",
    parameters={
        "key": "the first element that is missing",
    },
)
_add(
    900051,
    WARNING,
    "no thread calls task_int; the thread of highest priority is taken as the realtime thread",
    "kein Thread ruft task_int; der Thread höchster Priorität gilt als Echtzeit-Thread",
    remedy_en="Give the realtime thread the function task_int.",
    remedy_de="Dem Echtzeit-Thread die Funktion task_int geben.",
)
_add(
    900052,
    ERROR,
    "{key} goes beyond {limit} µs",
    "{key} übersteigt {limit} µs",
    remedy_en="Use a shorter time.",
    remedy_de="Eine kürzere Zeit verwenden.",
    parameters={
        "key": "the parameter's name",
        "limit": "the longest time, in µs",
    },
)
_add(
    900053,
    WARNING,
    "thread[{thread}] has no function and never runs",
    "thread[{thread}] hat keine Funktion und läuft nie",
    remedy_en="Give the thread a function, or delete its lines.",
    remedy_de="Dem Thread eine Funktion geben oder seine Zeilen löschen.",
    parameters={
        "thread": "the thread's index",
    },
)
_add(
    900054,
    NOTE,
    "{function} is called {value} times per activation; that is usual for task_rnd only",
    "{function} wird je Aktivierung {value}-mal gerufen; üblich ist das nur bei task_rnd",
    remedy_en="Set calls_per_cycle to 1.",
    remedy_de="calls_per_cycle auf 1 setzen.",
    parameters={
        "function": "the function's name",
        "value": "how often it is called",
    },
)
_add(
    900055,
    ERROR,
    "external_thread[{thread}] has no semaphore and is left out",
    "external_thread[{thread}] hat keinen Semaphor und wird ausgelassen",
    remedy_en="Set its semaphore_name.",
    remedy_de="Seinen semaphore_name setzen.",
    parameters={
        "thread": "the external thread's index",
    },
)
_add(
    900057,
    NOTE,
    "thread[{thread}] is the realtime thread, and its overflow is not reported",
    "thread[{thread}] ist der Echtzeit-Thread, und sein Überlauf wird nicht gemeldet",
    remedy_en="Set error_on_overflow to 1.",
    remedy_de="error_on_overflow auf 1 setzen.",
    parameters={
        "thread": "the thread's index",
    },
)
