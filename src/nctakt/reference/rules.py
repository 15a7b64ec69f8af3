# SPDX-License-Identifier: MIT
"""Articles about the rules of realtime cycles, by the numbers that documents and tests cite."""

from __future__ import annotations

import re
from collections.abc import Iterator

from nctakt.base.diagnostics import Text
from nctakt.reference.article import Article, Topic, fact, same

#: What each rule says, in a line.
RULES: dict[int, str] = {
    1: "ticks count from the controller's start; tick n begins at n cycle times and stamps events",
    2: "order of a tick: inputs, actual values, commands, realtime cycles, path, axes, PLC, record",
    3: "commands are taken until one takes time or has to wait; moves of no length take no tick",
    4: "each started cycle runs at least once before program end, DELETE or HOLD is taken",
    5: "flush, synchronous read and position request are answered when the path stands; dwells",
    6: "program end does not wait for axes and spindles; a run does, as far as they have an end",
    7: "a reset deletes BLOCK and PROG cycles and aborts motions; GLOBAL ones go on behind it",
    101: "form of a definition: keywords, blanks, block numbers; 21985, 22005",
    102: "without DEF defined and started at once, with DEF by START",
    103: "ID: an expression from 1 on; needed with DEF and GLOBAL; without one a number of its own",
    104: "SCOPE: BLOCK, PROG, GLOBAL; PROG where it is left out",
    105: "BLOCK: in each tick whose cycle phase finds the next block current",
    106: "PROG: ends with the main program, without a run in that tick",
    107: "GLOBAL: lives on after program ends until DELETE or restart",
    108: "an ID that lives already: 50900",
    109: "one ordered queue: a cycle begins exactly between the blocks where it stands",
    110: "END_ACTION: what becomes of axis motions when their cycle ends",
    111: "START, HOLD, CONTINUE, ABORT ACTION, DELETE; unknown IDs",
    112: "all active cycles run once in each tick, in order of creation",
    113: "what is written is read by the next statement and by later cycles of the tick",
    114: "P-CHAN-00406 switches realtime cycles on; 21982",
    201: "$IF, $ELSEIF, $ELSE, nested to any depth",
    202: "a condition is true from a magnitude of one half on",
    203: "ONCE, EDGE, ALWAYS; 22021, 22022",
    204: "a qualified $IF that is not reached neither evaluates nor forgets",
    205: "assignments: =, +=, -=, *=, /=",
    206: "operators, functions, precedence; degrees",
    207: "faults in expressions: 50879, nothing assigned; decoder: 20396, 20398, 20399, 21241",
    208: "what may stand in a cycle: 22001, 22002, 22004, 21981",
    301: "only synchronous variables may be written: 22009; Vs.",
    302: "asynchronous variables are frozen when the definition is decoded",
    303: "rights of V.RTG and V.RTA in programs and cycles: 21993",
    304: "positions of V.RTA: systems, unit, exact comparison",
    305: "overrides of a cycle: 100 % at each tick's start, the last writer wins, products",
    306: "timers, diagnosis level, measuring, loops, fixed stop: types and rights",
    307: "values for integer variables are rounded; ranges, indices: 50892, 50893, 50895, 50929",
    308: "the decoder's accesses to synchronous variables empty the channel; writes travel with it",
    309: "V.CH: memory of P-CHAN-00424, lifetime, not for the PLC; 22079",
    310: "structures, arrays, inheritance of synchronisation, alignment",
    311: "a variable alone is a block",
    401: "#TIMER in cycles: a bank of 128, V.RTG.TIMER",
    402: "#ERROR in cycles: warning, or error state and braking",
    403: "M and H functions of cycles: MOS, numbered in the tick, slots of the HLI",
    404: "spindles: endless, position, stop; 50954, 60331",
    405: "single axes: INDP with its keywords, ABORTING, BUFFERED, STOP",
    406: "P-AXIS-00457, limits of axes, targets",
    407: "OFFSET: which offsets are added",
    408: "P-CHAN-00480: actions that are open at once; 51028",
    409: "position request before a block moves an axis that a cycle has moved",
    410: "unit of a cycle: that of its definition",
    501: "what an elementary instruction is, and how they are counted",
    502: "P-CHAN-00427: instructions of a tick; 50854",
    503: "P-CHAN-00425, 00426: share of the tick's time; 50939",
    504: "P-CHAN-00407: memory; 50855, 50857",
    505: "what a fault of a cycle does to channel, path and the other cycles",
    601: "diagnosis data: form, columns, languages",
    602: "one source of each message: number, class, texts, cause, remedy",
    603: "ring of messages, V.RTG.CYCLES.DIAG_LEVEL",
    801: "the controller's numbers where they are known, else ours from 900000 on",
}

_KIND = Text("rule of realtime cycles", "Regel der Echtzeit-Zyklen")
_NUMBER = re.compile(r"RC[- ]?([0-9]{1,3})", re.IGNORECASE)


def _article(number: int) -> Article:
    proof = fact("Tests", "Tests", "docs/rules.md")
    decisions = fact("Decisions", "Entscheidungen", "docs/conformance.md")
    return Article(f"RC-{number:03}", _KIND, same(RULES[number]), (proof, decisions))


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
