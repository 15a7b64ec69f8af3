# SPDX-License-Identifier: MIT
"""Messages about the scheduling list rtconf.lis."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

INTERRUPT_SOURCE_MISSING = error(
    900030,
    known_as=(1000086,),
    en="interrupt_source is not configured; the timer starts the NC cycles",
    de="interrupt_source ist nicht konfiguriert; der Timer startet die NC-Takte",
    remedy_en="Set interrupt_source to 1 (hardware interrupt), 2 (timer), 3 (semaphore) or 4 "
    "(external scheduling).",
    remedy_de="interrupt_source auf 1 (Hardware-Interrupt), 2 (Timer), 3 (Semaphor) oder 4 "
    "(externes Scheduling) setzen.",
)
SCHEDULE_TIME_MISSING = error(
    900031,
    known_as=(1000086,),
    en="{key} is missing or invalid and has no default; {fallback} µs are used",
    de="{key} fehlt oder ist ungültig und hat keinen Standardwert; es gelten {fallback} µs",
    remedy_en="Set {key}.",
    remedy_de="{key} setzen.",
    fallback=("the value that is used, in µs", "der Wert, der gilt, in µs"),
)
TIME_SLICE_ABOVE_CYCLE_TIME = error(
    900032,
    known_as=(1000086,),
    en="time_slice ({slice} µs) is longer than cycle_time ({cycle} µs)",
    de="time_slice ({slice} µs) ist länger als cycle_time ({cycle} µs)",
    remedy_en="Set time_slice to between a third and a twentieth of cycle_time.",
    remedy_de="time_slice auf ein Drittel bis ein Zwanzigstel von cycle_time setzen.",
    cycle=("cycle_time as written, in µs", "cycle_time, wie geschrieben, in µs"),
    slice=("time_slice as written, in µs", "time_slice, wie geschrieben, in µs"),
)
CYCLE_TIME_SHORT = warning(
    900033,
    en="cycle_time ({cycle} µs) is less than three times time_slice ({slice} µs)",
    de="cycle_time ({cycle} µs) ist kleiner als das Dreifache von time_slice ({slice} µs)",
    remedy_en="Set time_slice to between a third and a twentieth of cycle_time.",
    remedy_de="time_slice auf ein Drittel bis ein Zwanzigstel von cycle_time setzen.",
    cycle=("cycle_time as written, in µs", "cycle_time, wie geschrieben, in µs"),
    slice=("time_slice as written, in µs", "time_slice, wie geschrieben, in µs"),
)
CYCLE_TIME_LONG = note(
    900034,
    en="cycle_time ({cycle} µs) is more than twenty times time_slice ({slice} µs)",
    de="cycle_time ({cycle} µs) ist größer als das Zwanzigfache von time_slice ({slice} µs)",
    remedy_en="Set time_slice to between a third and a twentieth of cycle_time.",
    remedy_de="time_slice auf ein Drittel bis ein Zwanzigstel von cycle_time setzen.",
    cycle=("cycle_time as written, in µs", "cycle_time, wie geschrieben, in µs"),
    slice=("time_slice as written, in µs", "time_slice, wie geschrieben, in µs"),
)
TIME_NOT_A_MULTIPLE = warning(
    900035,
    en="{key}: {value} µs is not a multiple of {step} µs; {effective} µs are used",
    de="{key}: {value} µs ist kein Vielfaches von {step} µs; es gelten {effective} µs",
    remedy_en="Write a multiple of {step}.",
    remedy_de="Ein Vielfaches von {step} schreiben.",
    value=("the time as written, in µs", "die Zeit, wie geschrieben, in µs"),
    step=(
        "the time of which it must be a multiple, in µs",
        "die Zeit, deren Vielfaches es sein muss, in µs",
    ),
    effective=("the time that is used, in µs", "die Zeit, die gilt, in µs"),
)
CYCLE_TIME_NOT_A_MULTIPLE = warning(
    1000153,
    en="cycle_time: {value} µs is not a multiple of time_slice; {effective} µs are used",
    de="cycle_time: {value} µs ist kein Vielfaches von time_slice; es gelten {effective} µs",
    remedy_en="Write a multiple of time_slice.",
    remedy_de="Ein Vielfaches von time_slice schreiben.",
    cause_en="An NC cycle consists of whole time slices.",
    cause_de="Ein NC-Takt besteht aus ganzen Zeitscheiben.",
    value=("the time as written, in µs", "die Zeit, wie geschrieben, in µs"),
    effective=("the time that is used, in µs", "die Zeit, die gilt, in µs"),
)
WINDOWS_TIME_BELOW_TIME_SLICE = error(
    900036,
    en="windows_time ({value} µs) is shorter than time_slice; {slice} µs are used",
    de="windows_time ({value} µs) ist kürzer als time_slice; es gelten {slice} µs",
    remedy_en="Write a multiple of time_slice, or 0 to guarantee nothing.",
    remedy_de="Ein Vielfaches von time_slice schreiben oder 0, um nichts zu garantieren.",
    value=("windows_time as written, in µs", "windows_time, wie geschrieben, in µs"),
)
WINDOWS_TIME_ZERO = note(
    900037,
    en="windows_time is 0: no computing time is guaranteed to Windows",
    de="windows_time ist 0: für Windows ist keine Rechenzeit garantiert",
    remedy_en="Make sure that all threads finish within every NC cycle.",
    remedy_de="Sicherstellen, dass alle Threads in jedem NC-Takt fertig werden.",
)
WINDOWS_TIME_TAKES_WHOLE_CYCLE = warning(
    900038,
    en="windows_time ({value} µs) takes the whole NC cycle ({cycle} µs): threads that can be "
    "suspended get no time",
    de="windows_time ({value} µs) belegt den ganzen NC-Takt ({cycle} µs): suspendierbare Threads "
    "bekommen keine Zeit",
    remedy_en="Shorten windows_time.",
    remedy_de="windows_time verkürzen.",
    value=("windows_time, in µs", "windows_time, in µs"),
    cycle=("the NC cycle, in µs", "der NC-Takt, in µs"),
)
WINDOWS_TIME_SHORT = warning(
    900039,
    en="windows_time ({value} µs) is short: switching to Windows and back takes much of it",
    de="windows_time ({value} µs) ist kurz: der Wechsel zu Windows und zurück kostet viel davon",
    remedy_en="500 µs are usual.",
    remedy_de="Üblich sind 500 µs.",
    value=("windows_time, in µs", "windows_time, in µs"),
)
WINDOWS_TIME_DIFFERS = note(
    900040,
    en="windows_time ({value} µs) differs from time_slice ({slice} µs)",
    de="windows_time ({value} µs) weicht von time_slice ({slice} µs) ab",
    remedy_en="The manual recommends equal times.",
    remedy_de="Das Handbuch empfiehlt gleiche Zeiten.",
    value=("windows_time, in µs", "windows_time, in µs"),
)
SEMAPHORE_NAME_MISSING = note(
    900041,
    en="external_object_name is empty: the program that starts the controller creates the "
    "semaphore",
    de="external_object_name ist leer: das Programm, das die Steuerung startet, legt den Semaphor "
    "an",
    remedy_en="To run the list in real time, give the name with --semaphore NAME.",
    remedy_de="Um die Liste in Echtzeit auszuführen, den Namen mit --semaphore NAME angeben.",
)
EXTERNAL_SCHEDULING = note(
    900618,
    en="interrupt_source 4, external scheduling: another program calls the tasks",
    de="interrupt_source 4, externes Scheduling: ein anderes Programm ruft die Tasks auf",
    remedy_en="Nothing to do; a schedule treats it as an external interrupt.",
    remedy_de="Nichts zu tun; ein Ablaufplan behandelt es als externen Interrupt.",
    cause_en="The manual does not list this value; comments in shipped lists do.",
    cause_de="Das Handbuch kennt diesen Wert nicht; Kommentare ausgelieferter Listen nennen ihn.",
)
SEMAPHORE_NAME_WITHOUT_EFFECT = note(
    900042,
    en="external_object_name has no effect: interrupt_source is not a semaphore",
    de="external_object_name hat keine Wirkung: interrupt_source ist kein Semaphor",
    remedy_en="Set interrupt_source to 3, or delete the line.",
    remedy_de="interrupt_source auf 3 setzen oder die Zeile löschen.",
)
THREAD_CYCLE_MISSING = warning(
    900044,
    en="{key} is 0 or missing; the thread runs in every NC cycle ({effective} µs)",
    de="{key} ist 0 oder fehlt; der Thread läuft in jedem NC-Takt ({effective} µs)",
    remedy_en="Set the cycle.",
    remedy_de="Den Takt setzen.",
    effective=("the cycle that is used, in µs", "der Takt, der gilt, in µs"),
)
SCHEDULE_TEXT_EMPTY = warning(
    900045,
    en="{key} is empty",
    de="{key} ist leer",
    remedy_en="Name the thread; a function without a name is never called.",
    remedy_de="Den Thread benennen; eine Funktion ohne Namen wird nie aufgerufen.",
)
DUPLICATE_THREAD_NAME = warning(
    900047,
    en="{key}: {other} already has the name '{value}'",
    de="{key}: {other} heißt bereits '{value}'",
    remedy_en="Use different names.",
    remedy_de="Verschiedene Namen verwenden.",
    other=("the parameter that had the name first", "der Parameter, der den Namen zuerst hatte"),
    value=("the name", "der Name"),
)
USER_THREAD_FUNCTIONS = note(
    900048,
    en="functions that do not belong to the controller are taken as your own: {names}",
    de="Funktionen, die nicht zur Steuerung gehören, gelten als eigene: {names}",
    remedy_en="Nothing to do if they are; --function NAME makes them known.",
    remedy_de="Nichts zu tun, wenn das stimmt; --function NAME macht sie bekannt.",
    names=("the functions of the controller", "die Funktionen der Steuerung"),
)
MISSPELLED_THREAD_FUNCTION = warning(
    900616,
    en="{key}: unknown function '{value}'; did you mean {name}?",
    de="{key}: unbekannte Funktion '{value}'; war {name} gemeint?",
    remedy_en="Correct the name, or declare it as your own with --function {value}.",
    remedy_de="Den Namen berichtigen oder ihn mit --function {value} als eigenen angeben.",
    value=("the function's name", "der Name der Funktion"),
    name=("the most similar function of the controller", "die ähnlichste Funktion der Steuerung"),
)
INDEX_BEYOND_MANUAL = note(
    900617,
    en="{key}: the manual goes up to index {last}; the actual limit depends on the controller",
    de="{key}: das Handbuch geht bis Index {last}; die tatsächliche Grenze hängt von der Steuerung "
    "ab",
    remedy_en="Make sure that your controller accepts it.",
    remedy_de="Prüfen, ob die eigene Steuerung ihn annimmt.",
    key=("the element", "das Element"),
    last=("the last index in the manual", "der letzte Index im Handbuch"),
)
DUPLICATE_THREAD_BIT = note(
    900049,
    en="{key}: {other} already uses bit {value}",
    de="{key}: {other} verwendet Bit {value} bereits",
    remedy_en="Use different bits to tell the functions apart.",
    remedy_de="Verschiedene Bits verwenden, um die Funktionen zu unterscheiden.",
    other=("the parameter that used the bit first", "der Parameter, der das Bit zuerst nutzte"),
    value=("the bit", "das Bit"),
)
THREAD_INDEX_GAP = note(
    900050,
    en="the indices have a gap: {key} is not configured",
    de="die Indizes haben eine Lücke: {key} ist nicht konfiguriert",
    remedy_en="Number threads and functions without gaps.",
    remedy_de="Threads und Funktionen lückenlos nummerieren.",
    key=("the first missing element", "das erste fehlende Element"),
)
REALTIME_THREAD_ASSUMED = warning(
    260102,
    known_as=(900051,),
    en="no thread calls task_int; the thread with the highest priority is taken as the realtime "
    "thread",
    de="kein Thread ruft task_int auf; der Thread mit der höchsten Priorität gilt als "
    "Echtzeit-Thread",
    remedy_en="Give the realtime thread the function task_int.",
    remedy_de="Dem Echtzeit-Thread die Funktion task_int geben.",
)
SCHEDULE_TIME_TOO_LONG = error(
    900052,
    en="{key} is longer than {limit} µs",
    de="{key} ist länger als {limit} µs",
    remedy_en="Use a shorter time.",
    remedy_de="Eine kürzere Zeit verwenden.",
    limit=("the longest time, in µs", "die längste Zeit, in µs"),
)
THREAD_WITHOUT_FUNCTION = warning(
    900053,
    en="thread[{thread}] has no function and never runs",
    de="thread[{thread}] hat keine Funktion und läuft nie",
    remedy_en="Give the thread a function, or delete its lines.",
    remedy_de="Dem Thread eine Funktion geben oder seine Zeilen löschen.",
)
SEVERAL_CALLS_PER_ACTIVATION = note(
    900054,
    en="{function} is called {value} times per activation; that is usual for task_rnd only",
    de="{function} wird je Aktivierung {value}-mal aufgerufen; üblich ist das nur bei task_rnd",
    remedy_en="Set calls_per_cycle to 1.",
    remedy_de="calls_per_cycle auf 1 setzen.",
    value=("the number of calls", "die Anzahl der Aufrufe"),
)
EXTERNAL_THREAD_WITHOUT_SEMAPHORE = error(
    900055,
    en="external_thread[{thread}] has no semaphore and is ignored",
    de="external_thread[{thread}] hat keinen Semaphor und wird ignoriert",
    remedy_en="Set its semaphore_name.",
    remedy_de="Seinen semaphore_name setzen.",
    thread=("the external thread's index", "der Index des externen Threads"),
)
REALTIME_OVERFLOW_NOT_REPORTED = note(
    900057,
    en="thread[{thread}] is the realtime thread, but its overflow is not reported",
    de="thread[{thread}] ist der Echtzeit-Thread, aber sein Überlauf wird nicht gemeldet",
    remedy_en="Set error_on_overflow to 1.",
    remedy_de="error_on_overflow auf 1 setzen.",
)
PROGRAM_AS_SCHEDULING_LIST = error(
    902983,
    en="{file} is an NC program, not a scheduling list",
    de="{file} ist ein NC-Programm, keine Schedulingliste",
    remedy_en="Give an rtconf.lis; nctakt run {file} --rtconf RTCONF.LIS runs the program with it.",
    remedy_de="Eine rtconf.lis angeben; nctakt run {file} --rtconf RTCONF.LIS führt das Programm "
    "damit aus.",
)
