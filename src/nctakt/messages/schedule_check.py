# SPDX-License-Identifier: MIT
"""Messages about the scheduling list under a profile."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

INTERRUPT_SOURCE_ASSUMED = warning(
    900600,
    en="interrupt_source {value} is taken as {meaning}",
    de="interrupt_source {value} gilt als {meaning}",
    remedy_en="Sources disagree about 1 and 2; choose with --convention if this is not meant.",
    remedy_de="Über 1 und 2 sind die Quellen uneins; ist es anders gemeint, --convention angeben.",
    value=("the number in the list", "die Zahl in der Liste"),
    meaning=("interrupt, convention and reason in English", "Interrupt, Konvention und Grund"),
)
TIME_SLICE_NOT_SETTABLE = note(
    900601,
    en="time_slice cannot be set with {profile}",
    de="time_slice ist bei {profile} nicht einstellbar",
    remedy_en="Write the period that the system's timer has.",
    remedy_de="Die Periode schreiben, die der Timer des Systems hat.",
    profile=("the operating system", "das Betriebssystem"),
)
WINDOWS_TIME_IGNORED = note(
    900602,
    en="windows_time ({value} µs) is ignored: no time is guaranteed to Windows",
    de="windows_time ({value} µs) wird ignoriert: für Windows ist keine Zeit garantiert",
    remedy_en="Set windows_time to 0 where there is no Windows.",
    remedy_de="windows_time auf 0 setzen, wo es kein Windows gibt.",
    value=("windows_time, in µs", "windows_time, in µs"),
)
PRIORITY_OUT_OF_RANGE = warning(
    900603,
    en="{key}: {value} lies outside {low} … {high} of {profile}; 0 is used",
    de="{key}: {value} liegt außerhalb {low} … {high} von {profile}; es gilt 0",
    remedy_en="Choose the operating system with --os, or correct the priority.",
    remedy_de="Das Betriebssystem mit --os wählen oder die Priorität berichtigen.",
    key=("the parameter's name", "der Name des Parameters"),
    value=("the priority in the list", "die Priorität in der Liste"),
    low=("the lowest number", "die kleinste Zahl"),
    high=("the highest number", "die größte Zahl"),
    profile=("the operating system", "das Betriebssystem"),
)
LOWEST_PRIORITY_ASSUMED = warning(
    900604,
    en="{key} is missing or defective; 0 is used, the lowest priority of {profile}",
    de="{key} fehlt oder ist fehlerhaft; es gilt 0, die niedrigste Priorität von {profile}",
    remedy_en="Set the priority.",
    remedy_de="Die Priorität setzen.",
    key=("the parameter's name", "der Name des Parameters"),
    profile=("the operating system", "das Betriebssystem"),
)
HIGHEST_PRIORITY_ASSUMED = warning(
    900614,
    en="{key} is missing or defective; 0 is used, the highest priority of {profile}",
    de="{key} fehlt oder ist fehlerhaft; es gilt 0, die höchste Priorität von {profile}",
    remedy_en="Set the priority.",
    remedy_de="Die Priorität setzen.",
    key=("the parameter's name", "der Name des Parameters"),
    profile=("the operating system", "das Betriebssystem"),
)
PRIORITY_RESERVED = warning(
    900605,
    en="{key}: {profile} needs priority {value} for itself",
    de="{key}: {profile} braucht die Priorität {value} selbst",
    remedy_en="Choose a priority further away from the end of the range.",
    remedy_de="Eine Priorität weiter weg vom Ende des Bereichs wählen.",
    key=("the parameter's name", "der Name des Parameters"),
    value=("the priority", "die Priorität"),
    profile=("the operating system", "das Betriebssystem"),
)
DUPLICATE_PRIORITY = warning(
    900606,
    en="{key}: {other} has priority {value} already; who is released first runs first",
    de="{key}: {other} hat bereits die Priorität {value}; wer zuerst freigegeben wird, läuft "
    "zuerst",
    remedy_en="Use different priorities.",
    remedy_de="Verschiedene Prioritäten verwenden.",
    key=("the parameter's name", "der Name des Parameters"),
    other=("the parameter with the same priority", "der Parameter mit derselben Priorität"),
    value=("the priority", "die Priorität"),
)
THREAD_BEFORE_REALTIME_THREAD = warning(
    900607,
    en="thread[{other}] comes before thread[{thread}], the realtime thread, on {profile}",
    de="thread[{other}] kommt bei {profile} vor thread[{thread}], dem Echtzeit-Thread",
    remedy_en="Check the operating system (--os): some count priorities downwards.",
    remedy_de="Das Betriebssystem prüfen (--os): manche zählen Prioritäten abwärts.",
    thread=("index of the realtime thread", "Index des Echtzeit-Threads"),
    other=("index of the thread that comes before it", "Index des Threads, der davor kommt"),
    profile=("the operating system", "das Betriebssystem"),
)
COMMENT_CONTRADICTS_ENTRY = note(
    900608,
    en="{key}: the comment says {word}, but it is not",
    de="{key}: laut Kommentar {word}, was nicht stimmt",
    remedy_en="Correct the comment or the priority.",
    remedy_de="Kommentar oder Priorität berichtigen.",
    key=("the parameter's name", "der Name des Parameters"),
    word=("the comment's word", "das Wort des Kommentars"),
)
TIME_SLICE_NOT_HAL_PERIOD = error(
    900609,
    en="time_slice ({slice} µs) is not the period of the HAL timer ({hal} µs)",
    de="time_slice ({slice} µs) ist nicht die Periode des HAL-Timers ({hal} µs)",
    remedy_en="Set both to the same time in the RTX properties and in the list.",
    remedy_de="In den RTX-Einstellungen und in der Liste dieselbe Zeit setzen.",
    slice=("time_slice, in µs", "time_slice, in µs"),
    hal=("the period that RTX is set to, in µs", "die Periode, auf die RTX gestellt ist, in µs"),
)
INVALID_SEMAPHORE_NAME = warning(
    900610,
    en="external_object_name is no name of a semaphore; it is not used",
    de="external_object_name ist kein Name eines Semaphors; er wird nicht verwendet",
    remedy_en="Use at most {limit} characters and no '/' but the first.",
    remedy_de="Höchstens {limit} Zeichen und außer dem ersten kein '/' verwenden.",
    limit=("the greatest length", "die größte Länge"),
)
CHANNEL_CONTEXT_WITHOUT_THREAD = warning(
    900611,
    en="channel {channel}: {key} {context} has no thread with that context and {function}",
    de="Kanal {channel}: {key} {context} hat keinen Thread mit diesem Kontext und {function}",
    remedy_en="Give such a thread context_info {context}.",
    remedy_de="Einem solchen Thread context_info {context} geben.",
    channel=("the channel's number", "die Nummer des Kanals"),
    key=("the channel's parameter", "der Parameter des Kanals"),
    context=("the context", "der Kontext"),
    function=("the function that a thread must have", "die Funktion, die ein Thread haben muss"),
)
SCHEDULE_WITHOUT_THREADS = error(
    900612,
    en="the list has no thread; nothing is scheduled",
    de="die Liste hat keinen Thread; es wird nichts eingeplant",
    remedy_en="Write at least thread[0] with the function task_int.",
    remedy_de="Mindestens thread[0] mit der Funktion task_int schreiben.",
)
WINDOWS_TIME_UNSTABLE = warning(
    900613,
    en="windows_time ({value} µs) can make RTX unstable",
    de="windows_time ({value} µs) kann RTX instabil machen",
    remedy_en="Make windows_time 500 µs.",
    remedy_de="windows_time auf 500 µs setzen.",
    value=("windows_time, in µs", "windows_time, in µs"),
)
WINDOWS_TIME_OFF = error(
    900615,
    en="windows_time ({value} µs) is shorter than time_slice ({slice} µs): it is off",
    de="windows_time ({value} µs) ist kürzer als time_slice ({slice} µs): es ist aus",
    remedy_en="Write a multiple of time_slice, or 0 to guarantee nothing.",
    remedy_de="Ein Vielfaches von time_slice schreiben oder 0, um nichts zu garantieren.",
    value=("windows_time as written, in µs", "windows_time, wie geschrieben, in µs"),
    slice=("time_slice, in µs", "time_slice, in µs"),
)
