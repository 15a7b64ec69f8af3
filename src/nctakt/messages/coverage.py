# SPDX-License-Identifier: MIT
"""Messages about the branch coverage of realtime cycles."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

NOTHING_TO_COVER = error(
    900800,
    en="nothing to cover: neither a program nor data of earlier runs",
    de="nichts auszuwerten: weder ein Programm noch Daten früherer Läufe",
    remedy_en="Name a program, or data with --data FILE or --merge FILE.",
    remedy_de="Ein Programm nennen, oder Daten mit --data DATEI oder --merge DATEI.",
)
INVALID_COVERAGE_DATA = error(
    900801,
    en="{file} holds no coverage data that this nctakt can read",
    de="{file} enthält keine Abdeckungsdaten, die dieses nctakt lesen kann",
    remedy_en="Name a file that --data or --format json has written, or delete it to begin anew.",
    remedy_de="Eine Datei von --data oder --format json nennen, oder sie löschen und neu beginnen.",
    file=("the path as it was given", "der Pfad, wie angegeben"),
)
COVERAGE_COUNTS_DROPPED = warning(
    900802,
    en="{file}: its realtime cycles were changed since, so the counts of earlier runs are dropped",
    de="{file}: seine Echtzeit-Zyklen wurden geändert, die Zahlen früherer Läufe entfallen",
    remedy_en="Run the earlier runs again with the new text if they shall count.",
    remedy_de="Die früheren Läufe mit dem neuen Text wiederholen, wenn sie zählen sollen.",
    file=("the program", "das Programm"),
)
COVERAGE_BELOW_MINIMUM = error(
    900803,
    en="{percent} % of the branches ran; at least {least} % is asked for",
    de="{percent} % der Zweige liefen; mindestens {least} % sind verlangt",
    remedy_en="Add runs in which the branches that are marked with ! run.",
    remedy_de="Läufe ergänzen, in denen die mit ! markierten Zweige laufen.",
    percent=("the share of branches that ran", "der Anteil der Zweige, die liefen"),
    least=("what --fail-under asks", "was --fail-under verlangt"),
)
UNKNOWN_COVERAGE_FORMAT = error(
    900804,
    en="{file}: the end of the name says no format of coverage",
    de="{file}: die Endung nennt kein Format für Abdeckung",
    remedy_en="Give the file the suffix {suffixes}.",
    remedy_de="Der Datei eine dieser Endungen geben: {suffixes}.",
    file=("the path as it was given", "der Pfad, wie angegeben"),
    suffixes=("the suffixes that are known", "die bekannten Endungen"),
)
