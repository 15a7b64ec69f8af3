# SPDX-License-Identifier: MIT
"""Messages about the load of a schedule."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

INVALID_LOAD_FILE = error(
    900620,
    en="the load is not valid TOML: {reason}",
    de="die Last ist kein gültiges TOML: {reason}",
    remedy_en="Correct the text; entries look like this: task_int = 400",
    remedy_de="Den Text berichtigen; Einträge sehen so aus: task_int = 400",
    reason=("the error of the TOML reader", "der Fehler beim Lesen von TOML"),
)
LOAD_OF_UNUSED_FUNCTION = warning(
    900621,
    en="load: no thread of the list calls {name}; its time is not used",
    de="Last: kein Thread der Liste ruft {name} auf; die Zeit wird nicht verwendet",
    remedy_en="The list calls {names}.",
    remedy_de="Die Liste ruft {names} auf.",
    name=("the name in the load", "der Name in der Last"),
    names=("the names of the list", "die Namen der Liste"),
)
EXECUTION_TIME_MISSING = note(
    900622,
    en="the load has no time for '{name}'; {time} µs are assumed",
    de="die Last hat keine Zeit für '{name}'; angenommen sind {time} µs",
    remedy_en="Write '{entry} = ' with a time in µs.",
    remedy_de="'{entry} = ' mit einer Zeit in µs schreiben.",
    name=("the function or external thread", "die Funktion oder der externe Thread"),
    time=("the assumed execution time, in µs", "die angenommene Ausführungszeit in µs"),
    entry=("the name of its entry in the load", "der Name des Eintrags in der Last"),
)
INVALID_LOAD_VALUE = error(
    900623,
    en="load: {key}: {value} is not {expected}",
    de="Last: {key}: {value} ist nicht {expected}",
    remedy_en="Correct the entry.",
    remedy_de="Den Eintrag berichtigen.",
)
UNKNOWN_LOAD_ENTRY = error(
    900624,
    en="load: unknown entry {key}",
    de="Last: unbekannter Eintrag {key}",
    remedy_en="Possible entries: {names}.",
    remedy_de="Mögliche Einträge: {names}.",
    names=("the possible entries", "die möglichen Einträge"),
)
LOAD_ASSUMED = note(
    900625,
    en="no load is given; assumed execution times are used",
    de="es ist keine Last angegeben; es gelten angenommene Ausführungszeiten",
    remedy_en="Give times with --load.",
    remedy_de="Eigene Zeiten mit --load angeben.",
)
LOAD_INTERRUPT_WITHOUT_EFFECT = warning(
    900627,
    en="load: interrupt.{key} has no effect: the timer starts the NC cycles",
    de="Last: interrupt.{key} hat keine Wirkung: der Timer startet die NC-Takte",
    remedy_en="Delete the entry, or use --convention to choose what interrupt_source means.",
    remedy_de="Den Eintrag löschen oder mit --convention festlegen, was interrupt_source bedeutet.",
)
CALL_COUNT_NOT_SIMULATED = error(
    900628,
    en="{thread}: {count} calls in one activation cannot be simulated",
    de="{thread}: {count} Aufrufe je Aktivierung sind nicht simulierbar",
    remedy_en="Set calls_per_cycle so that there are at most {limit}.",
    remedy_de="calls_per_cycle so setzen, dass es höchstens {limit} sind.",
    count=("the number of its calls", "die Anzahl seiner Aufrufe"),
    limit=("the maximum number of calls", "die größte Anzahl von Aufrufen"),
)
