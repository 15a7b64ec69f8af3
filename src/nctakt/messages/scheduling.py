# SPDX-License-Identifier: MIT
"""Messages of scheduling: profiles, load, simulation, analysis, pictures (900600 … 900679)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, NOTE, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

# --- the list under a profile ---------------------------------------------------------------------

_add(
    900600,
    WARNING,
    "interrupt_source {value} is taken as {meaning_en}",
    "interrupt_source {value} gilt als {meaning_de}",
    remedy_en="Sources disagree about 1 and 2; choose with --convention if this is not meant.",
    remedy_de="Über 1 und 2 sind die Quellen uneins; ist es anders gemeint, --convention angeben.",
    parameters={
        "value": "the number in the list",
        "meaning_en": "interrupt, convention and reason in English",
        "meaning_de": "the same in German",
    },
)
_add(
    900601,
    NOTE,
    "time_slice cannot be set with {profile}",
    "time_slice ist bei {profile} nicht einstellbar",
    remedy_en="Write the period that the system's timer has.",
    remedy_de="Die Periode schreiben, die der Timer des Systems hat.",
    parameters={
        "profile": "the operating system",
    },
)
_add(
    900602,
    NOTE,
    "windows_time ({value} µs) is ignored: no time is guaranteed to Windows",
    "windows_time ({value} µs) wird ignoriert: für Windows ist keine Zeit garantiert",
    remedy_en="Set windows_time to 0 where there is no Windows.",
    remedy_de="windows_time auf 0 setzen, wo es kein Windows gibt.",
    parameters={
        "value": "windows_time, in µs",
    },
)
_add(
    900603,
    WARNING,
    "{key}: {value} lies outside {low} … {high} of {profile}; 0 is used",
    "{key}: {value} liegt außerhalb {low} … {high} von {profile}; es gilt 0",
    remedy_en="Choose the operating system with --os, or correct the priority.",
    remedy_de="Das Betriebssystem mit --os wählen oder die Priorität berichtigen.",
    parameters={
        "key": "the parameter's name",
        "value": "the priority in the list",
        "low": "the lowest number",
        "high": "the highest number",
        "profile": "the operating system",
    },
)
_add(
    900604,
    WARNING,
    "{key} is missing or defective; 0 is used, the lowest priority of {profile}",
    "{key} fehlt oder ist fehlerhaft; es gilt 0, die niedrigste Priorität von {profile}",
    remedy_en="Set the priority.",
    remedy_de="Die Priorität setzen.",
    parameters={
        "key": "the parameter's name",
        "profile": "the operating system",
    },
)
_add(
    900614,
    WARNING,
    "{key} is missing or defective; 0 is used, the highest priority of {profile}",
    "{key} fehlt oder ist fehlerhaft; es gilt 0, die höchste Priorität von {profile}",
    remedy_en="Set the priority.",
    remedy_de="Die Priorität setzen.",
    parameters={
        "key": "the parameter's name",
        "profile": "the operating system",
    },
)
_add(
    900605,
    WARNING,
    "{key}: {profile} needs priority {value} for itself",
    "{key}: {profile} braucht die Priorität {value} selbst",
    remedy_en="Choose a priority further away from the end of the range.",
    remedy_de="Eine Priorität weiter weg vom Ende des Bereichs wählen.",
    parameters={
        "key": "the parameter's name",
        "value": "the priority",
        "profile": "the operating system",
    },
)
_add(
    900606,
    WARNING,
    "{key}: {other} has priority {value} already; who is released first runs first",
    "{key}: {other} hat bereits die Priorität {value}; wer zuerst freigegeben wird, läuft zuerst",
    remedy_en="Use different priorities.",
    remedy_de="Verschiedene Prioritäten verwenden.",
    parameters={
        "key": "the parameter's name",
        "other": "the parameter with the same priority",
        "value": "the priority",
    },
)
_add(
    900607,
    WARNING,
    "thread[{other}] comes before thread[{thread}], the realtime thread, on {profile}",
    "thread[{other}] kommt bei {profile} vor thread[{thread}], dem Echtzeit-Thread",
    remedy_en="Check the operating system (--os): some count priorities downwards.",
    remedy_de="Das Betriebssystem prüfen (--os): manche zählen Prioritäten abwärts.",
    parameters={
        "thread": "index of the realtime thread",
        "other": "index of the thread that comes before it",
        "profile": "the operating system",
    },
)
_add(
    900608,
    NOTE,
    "{key}: the comment says {word}, but it is not",
    "{key}: laut Kommentar {word}, was nicht stimmt",
    remedy_en="Correct the comment or the priority.",
    remedy_de="Kommentar oder Priorität berichtigen.",
    parameters={
        "key": "the parameter's name",
        "word": "the comment's word",
    },
)
_add(
    900609,
    ERROR,
    "time_slice ({slice} µs) is not the period of the HAL timer ({hal} µs)",
    "time_slice ({slice} µs) ist nicht die Periode des HAL-Timers ({hal} µs)",
    remedy_en="Set both to the same time in the RTX properties and in the list.",
    remedy_de="In den RTX-Einstellungen und in der Liste dieselbe Zeit setzen.",
    parameters={
        "slice": "time_slice, in µs",
        "hal": "the period that RTX is set to, in µs",
    },
)
_add(
    900610,
    WARNING,
    "external_object_name is no name of a semaphore; it is not used",
    "external_object_name ist kein Name eines Semaphors; er wird nicht verwendet",
    remedy_en="Use at most {limit} characters and no '/' but the first.",
    remedy_de="Höchstens {limit} Zeichen und außer dem ersten kein '/' verwenden.",
    parameters={
        "limit": "the greatest length",
    },
)
_add(
    900611,
    WARNING,
    "channel {channel}: {key} {context} has no thread with that context and {function}",
    "Kanal {channel}: {key} {context} hat keinen Thread mit diesem Kontext und {function}",
    remedy_en="Give such a thread context_info {context}.",
    remedy_de="Einem solchen Thread context_info {context} geben.",
    parameters={
        "channel": "the channel's number",
        "key": "the channel's parameter",
        "context": "the context",
        "function": "the function that a thread must have",
    },
)
_add(
    900612,
    ERROR,
    "the list has no thread; nothing is scheduled",
    "die Liste hat keinen Thread; es wird nichts eingeplant",
    remedy_en="Write at least thread[0] with the function task_int.",
    remedy_de="Mindestens thread[0] mit der Funktion task_int schreiben.",
)
_add(
    900613,
    WARNING,
    "windows_time ({value} µs) can make RTX unstable",
    "windows_time ({value} µs) kann RTX instabil machen",
    remedy_en="Make windows_time 500 µs.",
    remedy_de="windows_time auf 500 µs setzen.",
    parameters={
        "value": "windows_time, in µs",
    },
)
_add(
    900615,
    ERROR,
    "windows_time ({value} µs) is shorter than time_slice ({slice} µs): it is off",
    "windows_time ({value} µs) ist kürzer als time_slice ({slice} µs): es ist aus",
    remedy_en="Write a multiple of time_slice, or 0 to guarantee nothing.",
    remedy_de="Ein Vielfaches von time_slice schreiben oder 0, um nichts zu garantieren.",
    parameters={
        "value": "windows_time as written, in µs",
        "slice": "time_slice, in µs",
    },
)

# --- the load -------------------------------------------------------------------------------------

_add(
    900620,
    ERROR,
    "{file}: no load in TOML: {reason}",
    "{file}: keine Last in TOML: {reason}",
    remedy_en="Correct the text.",
    remedy_de="Den Text berichtigen.",
    parameters={
        "file": "the file",
        "reason": "what the reader says",
    },
)
_add(
    900621,
    WARNING,
    "load: {name} is called by no thread of the list; its time is not used",
    "Last: {name} ruft kein Thread der Liste; die Zeit wird nicht verwendet",
    remedy_en="The list calls {names}.",
    remedy_de="Die Liste ruft {names}.",
    parameters={
        "name": "the name in the load",
        "names": "the names of the list",
    },
)
_add(
    900622,
    ERROR,
    "load: the execution time of {name} is missing",
    "Last: die Ausführungszeit von {name} fehlt",
    remedy_en="Write '{entry} = ' with a time in µs.",
    remedy_de="'{entry} = ' mit einer Zeit in µs schreiben.",
    parameters={
        "name": "the function or external thread",
        "entry": "how the load names it",
    },
)
_add(
    900623,
    ERROR,
    "load: {key}: {value} is not {expected_en}",
    "Last: {key}: {value} ist nicht {expected_de}",
    remedy_en="Correct the entry.",
    remedy_de="Den Eintrag berichtigen.",
    parameters={
        "key": "the entry",
        "value": "its value",
        "expected_en": "what it should be, in English",
        "expected_de": "the same in German",
    },
)
_add(
    900624,
    ERROR,
    "load: {key} is no entry of a load",
    "Last: {key} ist kein Eintrag einer Last",
    remedy_en="Entries there are {names}.",
    remedy_de="Einträge sind dort {names}.",
    parameters={
        "key": "the entry",
        "names": "what can stand there",
    },
)
_add(
    900625,
    NOTE,
    "no load is given; the execution times are assumed",
    "keine Last angegeben; die Ausführungszeiten sind angenommen",
    remedy_en="Give your own times with --load.",
    remedy_de="Eigene Zeiten mit --load angeben.",
)
_add(
    900627,
    WARNING,
    "load: interrupt.{key} has no effect: the timer starts the NC cycles",
    "Last: interrupt.{key} bleibt ohne Wirkung: der Timer löst die NC-Takte aus",
    remedy_en="Delete the entry, or choose what interrupt_source means with --convention.",
    remedy_de="Den Eintrag löschen oder mit --convention wählen, was interrupt_source bedeutet.",
    parameters={
        "key": "the entry",
    },
)
_add(
    900628,
    ERROR,
    "{thread}: {count} calls in one activation cannot be simulated",
    "{thread}: {count} Aufrufe je Aktivierung sind nicht simulierbar",
    remedy_en="Set calls_per_cycle so that there are at most {limit}.",
    remedy_de="calls_per_cycle so setzen, dass es höchstens {limit} sind.",
    parameters={
        "thread": "the thread",
        "count": "its calls",
        "limit": "the most calls",
    },
)

# --- what a simulation or an analysis shows -------------------------------------------------------

_add(
    1000180,
    ERROR,
    "{thread}: CPU {cpu} does not exist; the operating system places the thread",
    "{thread}: CPU {cpu} gibt es nicht; das Betriebssystem platziert den Thread",
    remedy_en="Choose a CPU from 1 to {cpus}, or simulate more with [machine] cpus.",
    remedy_de="Eine CPU von 1 bis {cpus} wählen oder mit [machine] cpus mehr simulieren.",
    parameters={
        "thread": "the thread",
        "cpu": "its CPU, from 1",
        "cpus": "how many there are",
    },
)
_add(
    1000181,
    ERROR,
    "{thread}: it cannot be assigned to CPU {cpu}: {reason_en}",
    "{thread}: die Zuweisung an CPU {cpu} ist nicht möglich: {reason_de}",
    remedy_en="Make the CPU available, or choose another one.",
    remedy_de="Die CPU verfügbar machen oder eine andere wählen.",
    parameters={
        "thread": "the thread",
        "cpu": "its CPU, from 1",
        "reason_en": "the reason in English",
        "reason_de": "the same in German",
    },
)
_add(
    900630,
    ERROR,
    "{thread}: it was still busy when it was due again: {count} overflows, first at {time} µs",
    "{thread}: nicht fertig, als er wieder fällig war: {count} Überläufe, zuerst bei {time} µs",
    remedy_en="Shorten its functions, call them less often, or lengthen its cycle.",
    remedy_de="Seine Funktionen verkürzen, seltener rufen oder seinen Takt verlängern.",
    parameters={
        "thread": "the thread",
        "count": "how often",
        "time": "when it happened first, in µs of the simulation",
    },
)
_add(
    900631,
    WARNING,
    "{count} of {cycles} NC cycles ended before threads are suspended: Windows has no guarantee",
    "{count} von {cycles} NC-Takten endeten vor der Suspendierung: Windows ist nichts garantiert",
    remedy_en="The NC interrupt must not come earlier than each cycle_time.",
    remedy_de="Der NC-Interrupt darf nicht früher kommen als alle cycle_time.",
    parameters={
        "count": "how many cycles",
        "cycles": "of how many",
    },
)
_add(
    900632,
    WARNING,
    "CPU {cpu}: Windows got less than {windows} µs in {count} of {cycles} NC cycles ({who})",
    "CPU {cpu}: Windows bekam in {count} von {cycles} NC-Takten weniger als {windows} µs ({who})",
    remedy_en="Shorten what runs in Windows' time, or the threads before it.",
    remedy_de="Verkürzen, was in der Zeit von Windows läuft, oder die Threads davor.",
    parameters={
        "cpu": "the processor",
        "windows": "windows_time, in µs",
        "count": "how many cycles",
        "cycles": "of how many",
        "who": "what ran in Windows' time, in how many cycles",
    },
)
_add(
    900633,
    WARNING,
    "windows_time is 0, and {what_en}",
    "windows_time ist 0, und {what_de}",
    remedy_en="Set windows_time, or make sure that all threads finish within the cycle.",
    remedy_de="windows_time setzen oder dafür sorgen, dass alle Threads im Takt fertig werden.",
    parameters={
        "what_en": "what shows that it is not sensible, in English",
        "what_de": "the same in German",
    },
)
_add(
    900634,
    ERROR,
    "{library} is missing, which {what} needs",
    "{library} fehlt, das {what} braucht",
    remedy_en="Install what pictures need, in the checkout: pip install '.[plot]'",
    remedy_de="Installieren, was Bilder brauchen, im Checkout: pip install '.[plot]'",
    parameters={
        "library": "the library",
        "what": "the option",
    },
)
_add(
    900635,
    ERROR,
    "{file}: a picture ends in .svg, .png or .html",
    "{file}: ein Bild endet auf .svg, .png oder .html",
    remedy_en="Name the file so.",
    remedy_de="Die Datei so nennen.",
    parameters={
        "file": "the file",
    },
)
_add(
    900637,
    WARNING,
    "CPU {cpu}: the suspendable threads need {demand} % of its time and can have {supply} %",
    "CPU {cpu}: suspendierbare Threads brauchen {demand} % der Zeit und haben höchstens {supply} %",
    remedy_en="Shorten their functions, call them less often, or shorten windows_time.",
    remedy_de="Ihre Funktionen verkürzen, seltener rufen oder windows_time verkürzen.",
    parameters={
        "cpu": "the processor",
        "demand": "the demand of all threads, in percent",
        "supply": "what is left beside Windows, in percent",
    },
)
_add(
    900638,
    WARNING,
    "{thread} can overflow: its response is {response}, its cycle {cycle} µs",
    "{thread} kann überlaufen: Antwortzeit {response}, Takt {cycle} µs",
    remedy_en="Shorten its functions or those of the threads before it.",
    remedy_de="Seine Funktionen oder die der Threads davor verkürzen.",
    parameters={
        "thread": "the thread",
        "response": "the longest response",
        "cycle": "its cycle, in µs",
    },
)
_add(
    900640,
    WARNING,
    "CPU {cpu}: Windows has less than {windows} µs in a cycle when all run as long as they can",
    "CPU {cpu}: laufen alle, solange sie können, hat Windows im Takt weniger als {windows} µs",
    remedy_en="Shorten what cannot be suspended: {who}.",
    remedy_de="Verkürzen, was nicht suspendiert werden kann: {who}.",
    parameters={
        "cpu": "the processor",
        "windows": "windows_time, in µs",
        "who": "the threads that cannot be suspended",
    },
)
