# SPDX-License-Identifier: MIT
"""Messages about the branch coverage of realtime cycles."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

NOTHING_TO_COVER = error(
    900800,
    en="nothing to evaluate: neither a program nor data of earlier runs",
    de="nichts auszuwerten: weder ein Programm noch Daten früherer Läufe",
    remedy_en="Name a program, or data with --data FILE or --merge FILE.",
    remedy_de="Ein Programm nennen, oder Daten mit --data DATEI oder --merge DATEI.",
)
INVALID_COVERAGE_DATA = error(
    900801,
    en="{file} contains no coverage data that this nctakt can read",
    de="{file} enthält keine Abdeckungsdaten, die dieses nctakt lesen kann",
    remedy_en="Name a file written by --data or --format json, or delete it to start again.",
    remedy_de="Eine Datei von --data oder --format json nennen, oder sie löschen und neu beginnen.",
)
COVERAGE_COUNTS_DROPPED = warning(
    900802,
    en="{file}: its realtime cycles have changed, so the counts of earlier runs are dropped",
    de="{file}: die Echtzeit-Zyklen haben sich geändert, die Zahlen früherer Läufe entfallen",
    remedy_en="Repeat the earlier runs with the new text if they should count.",
    remedy_de="Die früheren Läufe mit dem neuen Text wiederholen, wenn sie zählen sollen.",
    file=("the program", "das Programm"),
)
COVERAGE_BELOW_MINIMUM = error(
    900803,
    en="{percent} % of the branches ran; at least {minimum} % are required",
    de="{percent} % der Zweige sind gelaufen; mindestens {minimum} % sind verlangt",
    remedy_en="Add runs in which the branches marked with ! run.",
    remedy_de="Läufe ergänzen, in denen die mit ! markierten Zweige laufen.",
    percent=("the share of branches that ran", "der Anteil der Zweige, die liefen"),
    minimum=("the value of --fail-under", "der Wert von --fail-under"),
)
UNKNOWN_COVERAGE_FORMAT = error(
    900804,
    en="{file}: the suffix is not a known format of coverage data",
    de="{file}: die Endung nennt kein bekanntes Format für die Abdeckung",
    remedy_en="Use one of these suffixes: {suffixes}.",
    remedy_de="Eine dieser Endungen verwenden: {suffixes}.",
    suffixes=("the known suffixes", "die bekannten Endungen"),
)
COUNT_INTERRUPTED = warning(
    902984,
    en="the run was interrupted after {time}: only what ran until then is counted",
    de="der Lauf wurde nach {time} unterbrochen: gezählt ist nur, was bis dahin lief",
    remedy_en="Let it run to its end, or set a limit (--until, --ticks).",
    remedy_de="Ihn zu Ende laufen lassen oder eine Grenze setzen (--until, --ticks).",
    time=("how long the run lasted", "die Dauer des Laufs"),
)
COUNT_LIMITED = note(
    902985,
    en="the run ended at its limit, after {time}: only what ran until then is counted",
    de="der Lauf endete an seiner Grenze, nach {time}: gezählt ist nur, was bis dahin lief",
    remedy_en="Set another limit (--until, --ticks) if the program runs longer.",
    remedy_de="Eine andere Grenze setzen (--until, --ticks), wenn das Programm länger läuft.",
    time=("how long the run lasted", "die Dauer des Laufs"),
)
