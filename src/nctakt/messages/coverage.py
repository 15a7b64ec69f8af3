# SPDX-License-Identifier: MIT
"""Messages of the branch coverage of realtime cycles (900800 … 900809)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900800,
    ERROR,
    "nothing to cover: neither a program nor data of earlier runs",
    "nichts auszuwerten: weder ein Programm noch Daten früherer Läufe",
    remedy_en="Name a program, or data with --data FILE or --merge FILE.",
    remedy_de="Ein Programm nennen, oder Daten mit --data DATEI oder --merge DATEI.",
)
_add(
    900801,
    ERROR,
    "{file} holds no coverage data that this nctakt can read",
    "{file} enthält keine Abdeckungsdaten, die dieses nctakt lesen kann",
    remedy_en="Name a file that --data or --format json has written, or delete it to begin anew.",
    remedy_de="Eine Datei von --data oder --format json nennen, oder sie löschen und neu beginnen.",
    parameters={"file": "the path as it was given"},
)
_add(
    900802,
    WARNING,
    "{file}: its realtime cycles were changed since, so the counts of earlier runs are dropped",
    "{file}: seine Echtzeit-Zyklen wurden geändert, die Zahlen früherer Läufe entfallen",
    remedy_en="Run the earlier runs again with the new text if they shall count.",
    remedy_de="Die früheren Läufe mit dem neuen Text wiederholen, wenn sie zählen sollen.",
    parameters={"file": "the program"},
)
_add(
    900803,
    ERROR,
    "{percent} % of the branches ran; at least {least} % is asked for",
    "{percent} % der Zweige liefen; mindestens {least} % sind verlangt",
    remedy_en="Add runs in which the branches that are marked with ! run.",
    remedy_de="Läufe ergänzen, in denen die mit ! markierten Zweige laufen.",
    parameters={"percent": "the share of branches that ran", "least": "what --fail-under asks"},
)
_add(
    900804,
    ERROR,
    "{file}: the end of the name says no format of coverage",
    "{file}: die Endung nennt kein Format für Abdeckung",
    remedy_en="Give the file the suffix {suffixes}.",
    remedy_de="Der Datei eine dieser Endungen geben: {suffixes}.",
    parameters={"file": "the path as it was given", "suffixes": "the suffixes that are known"},
)
