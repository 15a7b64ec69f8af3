# SPDX-License-Identifier: MIT
"""Articles about the rules of realtime cycles, by the numbers that documents and tests cite."""

from __future__ import annotations

import re
from collections.abc import Iterator

from nctakt.base.diagnostics import Text
from nctakt.reference.article import Article, Topic, fact

#: What each rule says, in a line.
RULES: dict[int, Text] = {
    1: Text(
        "ticks count from the controller's start; tick n begins at n cycle times and stamps events",
        "Takte zählen ab dem Start der Steuerung; Takt n beginnt nach n Taktzeiten und stempelt "
        "die Ereignisse",
    ),
    2: Text(
        "order of a tick: inputs, actual values, commands, realtime cycles, path, axes, PLC, "
        "record",
        "Reihenfolge im Takt: Eingänge, Istwerte, Befehle, Echtzeit-Zyklen, Bahn, Achsen, SPS, "
        "Aufzeichnung",
    ),
    3: Text(
        "commands are taken until one takes time or has to wait; moves of no length take no tick",
        "Befehle werden genommen, bis einer Zeit braucht oder warten muss; Wege der Länge null "
        "brauchen keinen Takt",
    ),
    4: Text(
        "each started cycle runs at least once before program end, DELETE or HOLD is taken",
        "jeder gestartete Zyklus läuft mindestens einmal, bevor Programmende, DELETE oder HOLD "
        "genommen wird",
    ),
    5: Text(
        "flush, synchronous read and position request are answered when the path stands; dwells",
        "Kanal leeren, synchrones Lesen und Positionsanforderung werden beantwortet, wenn die "
        "Bahn steht; Verweilzeiten",
    ),
    6: Text(
        "program end does not wait for axes and spindles; a run does, as far as they have an end",
        "das Programmende wartet nicht auf Achsen und Spindeln; ein Lauf wartet, soweit sie ein "
        "Ende haben",
    ),
    7: Text(
        "a reset deletes BLOCK and PROG cycles and aborts motions; GLOBAL ones go on behind it",
        "ein Reset löscht BLOCK- und PROG-Zyklen und bricht Bewegungen ab; GLOBAL-Zyklen laufen "
        "danach weiter",
    ),
    101: Text(
        "form of a definition: keywords, blanks, block numbers; 21985, 22005",
        "Form einer Definition: Schlüsselwörter, Leerzeichen, Satznummern; 21985, 22005",
    ),
    102: Text(
        "without DEF defined and started at once, with DEF by START",
        "ohne DEF wird der Zyklus definiert und gleich gestartet, mit DEF durch START",
    ),
    103: Text(
        "ID: an expression from 1 on; needed with DEF and GLOBAL; without one a number of its own",
        "ID: ein Ausdruck ab 1; bei DEF und GLOBAL nötig; ohne sie bekommt der Zyklus eine "
        "eigene Nummer",
    ),
    104: Text(
        "SCOPE: BLOCK, PROG, GLOBAL; PROG where it is left out",
        "SCOPE: BLOCK, PROG, GLOBAL; PROG, wenn es fehlt",
    ),
    105: Text(
        "BLOCK: in each tick whose cycle phase finds the next block current",
        "BLOCK: in jedem Takt, dessen Zyklusphase den nächsten Satz aktiv findet",
    ),
    106: Text(
        "PROG: ends with the main program, without a run in that tick",
        "PROG: endet mit dem Hauptprogramm, ohne in diesem Takt zu laufen",
    ),
    107: Text(
        "GLOBAL: lives on after program ends until DELETE or restart",
        "GLOBAL: überlebt Programmenden bis zu DELETE oder Neustart",
    ),
    108: Text(
        "an ID that lives already: 50900",
        "eine ID, die schon vergeben ist: 50900",
    ),
    109: Text(
        "one ordered queue: a cycle begins exactly between the blocks where it stands",
        "eine geordnete Warteschlange: ein Zyklus beginnt genau zwischen den Sätzen, zwischen "
        "denen er steht",
    ),
    110: Text(
        "END_ACTION: what becomes of axis motions when their cycle ends",
        "END_ACTION: was aus Achsbewegungen wird, wenn ihr Zyklus endet",
    ),
    111: Text(
        "START, HOLD, CONTINUE, ABORT ACTION, DELETE; unknown IDs",
        "START, HOLD, CONTINUE, ABORT ACTION, DELETE; unbekannte IDs",
    ),
    112: Text(
        "all active cycles run once in each tick, in order of creation",
        "alle aktiven Zyklen laufen einmal je Takt, in der Reihenfolge ihrer Definition",
    ),
    113: Text(
        "what is written is read by the next statement and by later cycles of the tick",
        "Geschriebenes lesen die nächste Anweisung und spätere Zyklen desselben Takts",
    ),
    114: Text(
        "P-CHAN-00406 switches realtime cycles on; 21982",
        "P-CHAN-00406 schaltet Echtzeit-Zyklen ein; 21982",
    ),
    201: Text(
        "$IF, $ELSEIF, $ELSE, nested to any depth",
        "$IF, $ELSEIF, $ELSE, beliebig tief geschachtelt",
    ),
    202: Text(
        "a condition is true from a magnitude of one half on",
        "eine Bedingung ist ab dem Betrag einhalb wahr",
    ),
    203: Text(
        "ONCE, EDGE, ALWAYS; 22021, 22022",
        "ONCE, EDGE, ALWAYS; 22021, 22022",
    ),
    204: Text(
        "a qualified $IF that is not reached neither evaluates nor forgets",
        "ein $IF mit Häufigkeit, das nicht erreicht wird, wertet nicht aus und vergisst nichts",
    ),
    205: Text(
        "assignments: =, +=, -=, *=, /=",
        "Zuweisungen: =, +=, -=, *=, /=",
    ),
    206: Text(
        "operators, functions, precedence; degrees",
        "Operatoren, Funktionen, Rangfolge; Grad",
    ),
    207: Text(
        "faults in expressions: 50879, nothing assigned; decoder: 20396, 20398, 20399, 21241",
        "Fehler in Ausdrücken: 50879, nichts wird zugewiesen; Dekoder: 20396, 20398, 20399, 21241",
    ),
    208: Text(
        "what may stand in a cycle: 22001, 22002, 22004, 21981",
        "was in einem Zyklus stehen darf: 22001, 22002, 22004, 21981",
    ),
    301: Text(
        "only synchronous variables may be written: 22009; Vs.",
        "nur synchrone Variablen dürfen geschrieben werden: 22009; Vs.",
    ),
    302: Text(
        "asynchronous variables are frozen when the definition is decoded",
        "asynchrone Variablen werden beim Dekodieren der Definition eingefroren",
    ),
    303: Text(
        "rights of V.RTG and V.RTA in programs and cycles: 21993",
        "Rechte von V.RTG und V.RTA in Programmen und Zyklen: 21993",
    ),
    304: Text(
        "positions of V.RTA: systems, unit, exact comparison",
        "Positionen von V.RTA: Systeme, Einheit, exakter Vergleich",
    ),
    305: Text(
        "overrides of a cycle: 100 % at each tick's start, the last writer wins, products",
        "Override eines Zyklus: 100 % am Anfang jedes Takts, der letzte Schreiber gilt, Produkte",
    ),
    306: Text(
        "timers, diagnosis level, measuring, loops, fixed stop: types and rights",
        "Zeitgeber, Diagnosestufe, Messen, Schleifen, Festanschlag: Typen und Rechte",
    ),
    307: Text(
        "values for integer variables are rounded; ranges, indices: 50892, 50893, 50895, 50929",
        "Werte für ganzzahlige Variablen werden gerundet; Bereiche, Indizes: 50892, 50893, "
        "50895, 50929",
    ),
    308: Text(
        "the decoder's accesses to synchronous variables empty the channel; writes travel with it",
        "Zugriffe des Dekoders auf synchrone Variablen leeren den Kanal; Schreiben reist mit ihm",
    ),
    309: Text(
        "V.CH: memory of P-CHAN-00424, lifetime, not for the PLC; 22079",
        "V.CH: Speicher von P-CHAN-00424, Lebensdauer, für die SPS unsichtbar; 22079",
    ),
    310: Text(
        "structures, arrays, inheritance of synchronisation, alignment",
        "Strukturen, Felder, Vererbung der Synchronisierung, Ausrichtung",
    ),
    311: Text(
        "a variable alone is a block",
        "eine Variable allein ist ein Satz",
    ),
    401: Text(
        "#TIMER in cycles: a bank of 128, V.RTG.TIMER",
        "#TIMER in Zyklen: eine Bank von 128, V.RTG.TIMER",
    ),
    402: Text(
        "#ERROR in cycles: warning, or error state and braking",
        "#ERROR in Zyklen: Warnung, oder Fehlerzustand und Bremsen",
    ),
    403: Text(
        "M and H functions of cycles: MOS, numbered in the tick, slots of the HLI",
        "M- und H-Funktionen von Zyklen: MOS, im Takt nummeriert, Plätze des HLI",
    ),
    404: Text(
        "spindles: endless, position, stop; 50954, 60331",
        "Spindeln: endlos, Position, Halt; 50954, 60331",
    ),
    405: Text(
        "single axes: INDP with its keywords, ABORTING, BUFFERED, STOP",
        "Einzelachsen: INDP mit seinen Schlüsselwörtern, ABORTING, BUFFERED, STOP",
    ),
    406: Text(
        "P-AXIS-00457, limits of axes, targets",
        "P-AXIS-00457, Grenzen der Achsen, Ziele",
    ),
    407: Text(
        "OFFSET: which offsets are added",
        "OFFSET: welche Verschiebungen addiert werden",
    ),
    408: Text(
        "P-CHAN-00480: actions that are open at once; 51028",
        "P-CHAN-00480: gleichzeitig offene Aktionen; 51028",
    ),
    409: Text(
        "position request before a block moves an axis that a cycle has moved",
        "Positionsanforderung, bevor ein Satz eine Achse bewegt, die ein Zyklus bewegt hat",
    ),
    410: Text(
        "unit of a cycle: that of its definition",
        "Einheit eines Zyklus: die seiner Definition",
    ),
    501: Text(
        "what an elementary instruction is, and how they are counted",
        "was eine elementare Instruktion ist und wie gezählt wird",
    ),
    502: Text(
        "P-CHAN-00427: instructions of a tick; 50854",
        "P-CHAN-00427: Instruktionen eines Takts; 50854",
    ),
    503: Text(
        "P-CHAN-00425, 00426: share of the tick's time; 50939",
        "P-CHAN-00425, 00426: Anteil an der Taktzeit; 50939",
    ),
    504: Text(
        "P-CHAN-00407: memory; 50855, 50857",
        "P-CHAN-00407: Speicher; 50855, 50857",
    ),
    505: Text(
        "what a fault of a cycle does to channel, path and the other cycles",
        "was ein Fehler eines Zyklus mit Kanal, Bahn und den anderen Zyklen macht",
    ),
    601: Text(
        "diagnosis data: form, columns, languages",
        "Diagnosedaten: Form, Spalten, Sprachen",
    ),
    602: Text(
        "one source of each message: number, class, texts, cause, remedy",
        "eine Quelle jeder Meldung: Nummer, Klasse, Texte, Ursache, Abhilfe",
    ),
    603: Text(
        "ring of messages, V.RTG.CYCLES.DIAG_LEVEL",
        "Ringspeicher der Meldungen, V.RTG.CYCLES.DIAG_LEVEL",
    ),
    801: Text(
        "the controller's numbers where they are known, else ours from 900000 on",
        "die Nummern der Steuerung, wo sie bekannt sind, sonst eigene ab 900000",
    ),
}

_KIND = Text("rule of realtime cycles", "Regel der Echtzeit-Zyklen")
_NUMBER = re.compile(r"RC[- ]?([0-9]{1,3})", re.IGNORECASE)


def _article(number: int) -> Article:
    proof = fact("Tests", "Tests", "docs/rules.md")
    decisions = fact("Decisions", "Entscheidungen", "docs/conformance/index.md")
    return Article(f"RC-{number:03}", _KIND, RULES[number], (proof, decisions))


def _all() -> Iterator[Article]:
    return map(_article, RULES)


def _find(word: str) -> tuple[Article, ...]:
    match = _NUMBER.fullmatch(word)
    number = 0 if match is None else int(match[1])
    return (_article(number),) if number in RULES else ()


def _names() -> Iterator[str]:
    return (f"RC-{number:03}" for number in RULES)


RULES_TOPIC = Topic(
    "rules",
    Text("Rules of realtime cycles", "Regeln der Echtzeit-Zyklen"),
    ("RC-105", "RC-203"),
    _all,
    _find,
    _names,
)
