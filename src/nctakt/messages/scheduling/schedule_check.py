# SPDX-License-Identifier: MIT
"""Messages about the scheduling list under a profile."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

INTERRUPT_SOURCE_ASSUMED = warning(
    900600,
    en="interrupt_source {value} is taken as {meaning}",
    de="interrupt_source {value} gilt als {meaning}",
    remedy_en="Sources disagree about 1 and 2; use --convention if something else is meant.",
    remedy_de="Über 1 und 2 sind die Quellen uneins; ist etwas anderes gemeint, --convention "
    "angeben.",
    value=("the number in the list", "die Zahl in der Liste"),
    meaning=("interrupt, convention and reason", "Interrupt, Konvention und Grund"),
)
TIME_SLICE_NOT_SETTABLE = note(
    900601,
    en="time_slice cannot be set on {profile}",
    de="time_slice ist unter {profile} nicht einstellbar",
    remedy_en="Write the period of the system's timer.",
    remedy_de="Die Periode des System-Timers schreiben.",
)
WINDOWS_TIME_IGNORED = note(
    900602,
    en="windows_time ({value} µs) is ignored: no time is guaranteed to Windows",
    de="windows_time ({value} µs) wird ignoriert: für Windows ist keine Zeit garantiert",
    remedy_en="Set windows_time to 0 if there is no Windows.",
    remedy_de="windows_time auf 0 setzen, wenn es kein Windows gibt.",
    value=("windows_time, in µs", "windows_time, in µs"),
)
PRIORITY_OUT_OF_RANGE = warning(
    900603,
    en="{key}: {value} is outside {low} … {high} of {profile}; 0 is used",
    de="{key}: {value} liegt außerhalb {low} … {high} von {profile}; es gilt 0",
    remedy_en="Choose the operating system with --os, or correct the priority.",
    remedy_de="Das Betriebssystem mit --os wählen oder die Priorität berichtigen.",
    value=("the priority in the list", "die Priorität in der Liste"),
    low=("the lowest number", "die kleinste Zahl"),
    high=("the highest number", "die größte Zahl"),
)
LOWEST_PRIORITY_ASSUMED = warning(
    900604,
    en="{key} is missing or invalid; 0 is used, the lowest priority of {profile}",
    de="{key} fehlt oder ist ungültig; es gilt 0, die niedrigste Priorität von {profile}",
    remedy_en="Set the priority.",
    remedy_de="Die Priorität setzen.",
)
HIGHEST_PRIORITY_ASSUMED = warning(
    900614,
    en="{key} is missing or invalid; 0 is used, the highest priority of {profile}",
    de="{key} fehlt oder ist ungültig; es gilt 0, die höchste Priorität von {profile}",
    remedy_en="Set the priority.",
    remedy_de="Die Priorität setzen.",
)
PRIORITY_RESERVED = warning(
    900605,
    en="{key}: {profile} needs priority {value} for itself",
    de="{key}: {profile} braucht die Priorität {value} selbst",
    remedy_en="Choose a priority further away from the end of the range.",
    remedy_de="Eine Priorität wählen, die weiter vom Rand des Bereichs entfernt ist.",
    value=("the priority", "die Priorität"),
)
DUPLICATE_PRIORITY = warning(
    900606,
    en="{key}: {other} already has priority {value}; the thread that is released first runs first",
    de="{key}: {other} hat bereits die Priorität {value}; der zuerst freigegebene Thread läuft "
    "zuerst",
    remedy_en="Use different priorities.",
    remedy_de="Verschiedene Prioritäten verwenden.",
    other=("the parameter with the same priority", "der Parameter mit derselben Priorität"),
    value=("the priority", "die Priorität"),
)
THREAD_BEFORE_REALTIME_THREAD = warning(
    900607,
    en="thread[{other}] has priority over thread[{thread}], the realtime thread, on {profile}",
    de="thread[{other}] hat unter {profile} Vorrang vor thread[{thread}], dem Echtzeit-Thread",
    remedy_en="Check the operating system (--os): some count priorities downwards.",
    remedy_de="Das Betriebssystem prüfen (--os): manche zählen Prioritäten abwärts.",
    thread=("index of the realtime thread", "Index des Echtzeit-Threads"),
    other=("index of the thread that has priority", "Index des Threads, der Vorrang hat"),
)
COMMENT_CONTRADICTS_ENTRY = note(
    900608,
    en="{key}: the comment says {word}, which is wrong",
    de="{key}: der Kommentar sagt {word}, was nicht stimmt",
    remedy_en="Correct the comment or the priority.",
    remedy_de="Kommentar oder Priorität berichtigen.",
    word=("the comment's word", "das Wort des Kommentars"),
)
TIME_SLICE_NOT_HAL_PERIOD = error(
    900609,
    en="time_slice ({slice} µs) is not the period of the HAL timer ({hal} µs)",
    de="time_slice ({slice} µs) ist nicht die Periode des HAL-Timers ({hal} µs)",
    remedy_en="Set both to the same time in the RTX properties and in the list.",
    remedy_de="In den RTX-Einstellungen und in der Liste dieselbe Zeit setzen.",
    hal=("the period set in RTX, in µs", "die in RTX eingestellte Periode, in µs"),
)
INVALID_SEMAPHORE_NAME = warning(
    900610,
    en="external_object_name is not a valid name of a semaphore; it is ignored",
    de="external_object_name ist kein gültiger Name eines Semaphors; er wird ignoriert",
    remedy_en="Use at most {limit} characters, and '/' only as the first.",
    remedy_de="Höchstens {limit} Zeichen verwenden, und '/' nur als erstes.",
    limit=("the maximum length", "die größte Länge"),
)
CHANNEL_CONTEXT_WITHOUT_THREAD = warning(
    260102,
    known_as=(900611,),
    en="channel {channel}: {key} {context}: no thread has this context and {function}",
    de="Kanal {channel}: {key} {context}: kein Thread hat diesen Kontext und {function}",
    remedy_en="Give such a thread context_info {context}.",
    remedy_de="Einem solchen Thread context_info {context} geben.",
    key=("the channel's parameter", "der Parameter des Kanals"),
    context=("the context", "der Kontext"),
    function=("the function that a thread must have", "die Funktion, die ein Thread haben muss"),
)
THREAD_CONTEXT_WITHOUT_CHANNEL = warning(
    260103,
    en="{key}: no channel has the context {context}",
    de="{key}: kein Kanal hat den Kontext {context}",
    remedy_en="Give a channel this context (schedule.context.geo, .sda or .com), or remove it.",
    remedy_de="Einem Kanal diesen Kontext geben (schedule.context.geo, .sda oder .com) oder ihn "
    "entfernen.",
    key=("the thread's parameter", "der Parameter des Threads"),
    context=("the context", "der Kontext"),
)
SCHEDULE_WITHOUT_THREADS = error(
    900612,
    known_as=(260102,),
    en="the list has no threads; nothing is scheduled",
    de="die Liste hat keine Threads; es wird nichts eingeplant",
    remedy_en="Write at least thread[0] with the function task_int.",
    remedy_de="Mindestens thread[0] mit der Funktion task_int schreiben.",
)
WINDOWS_TIME_UNSTABLE = warning(
    900613,
    en="windows_time ({value} µs) can make RTX unstable",
    de="windows_time ({value} µs) kann RTX instabil machen",
    remedy_en="Set windows_time to 500 µs.",
    remedy_de="windows_time auf 500 µs setzen.",
    value=("windows_time, in µs", "windows_time, in µs"),
)
WINDOWS_TIME_OFF = error(
    900615,
    en="windows_time ({value} µs) is shorter than time_slice ({slice} µs) and is switched off",
    de="windows_time ({value} µs) ist kürzer als time_slice ({slice} µs) und wird abgeschaltet",
    remedy_en="Write a multiple of time_slice, or 0 to guarantee nothing.",
    remedy_de="Ein Vielfaches von time_slice schreiben oder 0, um nichts zu garantieren.",
    value=("windows_time as written, in µs", "windows_time, wie geschrieben, in µs"),
)
LIST_REWRITTEN = note(
    900619,
    en="{file}: {corrected} entries corrected, {commented} commented out, {added} lines added",
    de="{file}: {corrected} Einträge berichtigt, {commented} auskommentiert, {added} Zeilen "
    "ergänzt",
    remedy_en="Nothing to do; the findings that remain need a decision.",
    remedy_de="Nichts zu tun; die übrigen Befunde brauchen eine Entscheidung.",
    file=("the list", "die Liste"),
    corrected=("entries with another value or name", "Einträge mit anderem Wert oder Namen"),
    commented=("entries that did not count", "Einträge, die nicht galten"),
    added=("lines that were missing", "Zeilen, die fehlten"),
)
