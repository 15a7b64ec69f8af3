# SPDX-License-Identifier: MIT
"""Articles about what people ask for by a word of their own: waiting, override, expectations.

In: a word or the words of a question, in English or German. Out: the articles of the subjects that
it names; each leads on to the words of the language.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.reference.article import Article, Fact, Topic, fact

_KIND = Text("subject", "Thema")
_EXAMPLES = ("Examples", "Beispiele")
_FURTHER = ("See also", "Siehe auch")


@dataclass(frozen=True, slots=True)
class _Concept:
    """A subject, and what people call it."""

    names: tuple[str, ...]
    article: Article


def _concept(names: str, meaning: Text, *facts: Fact) -> _Concept:
    """Return a subject; ``names``: its name, then what else it is called."""
    first, *others = names.split(", ")
    return _Concept((first, *others), Article(first, _KIND, meaning, facts))


_CONCEPTS = (
    _concept(
        "axis letters, X, Y, Z, A, B, C, U, V, W, axis, axes, Achse, Achsen, Koordinate",
        Text(
            "A letter with a value moves an axis of the channel: its end point with G90, its way "
            "with G91; the letters are the names of the axes in the channel list",
            "Ein Buchstabe mit einem Wert bewegt eine Achse des Kanals: mit G90 ihr Endpunkt, mit "
            "G91 ihr Weg; die Buchstaben sind die Namen der Achsen in der Kanalliste",
        ),
        fact(*_EXAMPLES, "G01 X100 Y-5.5 F6000\nG91 Z=V.E.DEPTH\nZ[INDP POS=50 FEED=500]"),
        fact(*_FURTHER, "G90, G91, INDP, V.RTA.ACS.ACT_POS.X, Z.ACS.ACT_POS (--signals)"),
    ),
    _concept(
        "reaction, react, reactions, gate, clamp, door, Reaktion, Reaktionen, Tor, Tür, "
        "Spannmittel",
        Text(
            "What a realtime cycle does in the tick in which its condition becomes true: a gate "
            "closes by M100 as soon as an axis has passed a position",
            "Was ein Echtzeit-Zyklus in dem Takt tut, in dem seine Bedingung wahr wird: Ein Tor "
            "schließt mit M100, sobald eine Achse eine Position passiert hat",
        ),
        fact(
            *_EXAMPLES,
            "#RT CYCLE [ID=1 SCOPE=PROG]\n  $IF ONCE V.RTA.ACS.ACT_POS.X > 200\n    M100\n"
            "  $ENDIF\n#RT CYCLE END",
        ),
        fact(*_FURTHER, "#RT CYCLE, $IF, ONCE, EDGE, M; nctakt why part.nc"),
    ),
    _concept(
        "override, Vorschubbeeinflussung, Potentiometer",
        Text(
            "The factor on programmed speeds in percent: the operator's on the interface to the "
            "PLC, that of a realtime cycle in a variable",
            "Der Faktor auf programmierte Geschwindigkeiten in Prozent: der des Bedieners an der "
            "Schnittstelle zur SPS, der eines Echtzeit-Zyklus in einer Variable",
        ),
        fact(
            *_EXAMPLES,
            "nctakt run part.nc --set HLI.OVERRIDE=50 --at 2s HLI.OVERRIDE=100",
        ),
        fact(*_FURTHER, "HLI.OVERRIDE, V.RTG.OVERRIDE.VEL.CYCLE, hli_command.override, G166"),
    ),
    _concept(
        "waiting, wait, waits, warten, wartet, Wartezeit, Stillstand, standstill, hang, hangs, "
        "stuck, hängt",
        Text(
            "A program that does not go on waits for the PLC's acknowledgement of a function, for "
            "an axis or a spindle, for START, for a signal of another channel, or for a time",
            "Ein Programm, das nicht weitergeht, wartet auf die Quittung einer Funktion durch die "
            "SPS, auf eine Achse oder Spindel, auf START, auf ein Signal eines anderen Kanals oder "
            "auf eine Zeit",
        ),
        fact(
            "Find out",
            "Herausfinden",
            "nctakt run part.nc --until 10s (900820)\nnctakt live part.nc --open",
        ),
        fact(*_FURTHER, "902000, 900820, #WAIT, #WAIT FOR, G04, M, HLI.START, #FLUSH WAIT"),
    ),
    _concept(
        "expect, given, expectation, expectations, test, tests, assert, Erwartung, Erwartungen, "
        "erwarten, prüfen",
        Text(
            "Comments of a program that make it a test for pytest: given: is an input of the run, "
            "expect: what must come of it, about the line if it follows a block",
            "Kommentare eines Programms, die es zu einem Test für pytest machen: given: ist eine "
            "Eingabe des Laufs, expect: was dabei herauskommen muss, nach einem Satz für die Zeile",
        ),
        fact(
            "Inputs",
            "Eingaben",
            "; given: V.E.VALUE = 5\n; given: V.E.DOOR = 1 at 20ms\n"
            "; given: plc cell_plc.py; given: machine ../machine\n"
            "; given: until 2s; given: after 100ms; given: start; given: channel 2 unload.nc\n"
            "; given: skip 1,2; given: ticks 500; given: from line 40",
        ),
        fact(
            "Results",
            "Ergebnisse",
            "; expect: fired    ; expect: fired 17 line 5 at 463ms\n"
            "; expect: M100 at 463ms    ; expect: H7 never    ; expect: T5 3 times\n"
            '; expect: message "done" before 2s\n'
            "; expect: X = 200.25 within 0.1 at 463ms    ; expect: V.E.COUNT = 5 at end\n"
            "; expect: error 22009    ; expect: warning 20824    ; expect: ended",
        ),
        fact(
            "When",
            "Wann",
            Text(
                "at TIME (several with commas), before TIME, after TIME, never, once, N times",
                "at ZEIT (mehrere mit Kommas), before ZEIT, after ZEIT, never, once, N times",
            ),
        ),
        fact("In plans", "In Plänen", 'expect = ["time < 1.5 s", "X.ACS.ACT_POS < 50 within 1s"]'),
        fact(*_FURTHER, "docs/testing.md, docs/studies.md; pytest part.nc"),
    ),
    _concept(
        "speed, Vorschub, Geschwindigkeit, velocity, Eilgang, rapid",
        Text(
            "F is the speed of the path in mm/min (G94), per revolution with G95; G00 moves at "
            "rapid traverse",
            "F ist die Bahngeschwindigkeit in mm/min (G94), mit G95 je Umdrehung; G00 fährt im "
            "Eilgang",
        ),
        fact(*_FURTHER, "F, G00, G01, G94, G95, PATH.SPEED (--signals), override"),
    ),
    _concept(
        "acknowledgement, acknowledge, quittieren, Quittung, quittiert",
        Text(
            "The PLC's answer that an M or H function is done; the kind of synchronisation in the "
            "channel list says whether the program waits for it",
            "Die Antwort der SPS, dass eine M- oder H-Funktion erledigt ist; die Art der "
            "Synchronisation in der Kanalliste sagt, ob das Programm darauf wartet",
        ),
        fact(*_FURTHER, "M, H, MVS_SVS, MNS_SNS, P-CHAN-00041, waiting"),
    ),
    _concept(
        "variable, Variablen",
        Text(
            "P are parameters of the program, V.P and V.L its own variables, V.E and V.CH those of "
            "the machine's lists, V.A and V.G those of the controller, V.RTA and V.RTG the values "
            "of each tick",
            "P sind Parameter des Programms, V.P und V.L seine Variablen, V.E und V.CH die der "
            "Listen der Maschine, V.A und V.G die der Steuerung, V.RTA und V.RTG die Werte jedes "
            "Takts",
        ),
        fact(*_FURTHER, "V.E, V.CH, V.P, V.L, P; nctakt explain variables"),
    ),
)


def find_concepts(words: str) -> tuple[Article, ...]:
    """Return the articles of the subjects that one of the words of a text names, or all of it."""
    asked = {word.strip("?!.,;:").casefold() for word in words.split()}
    whole = " ".join(words.split()).casefold()
    return tuple(
        concept.article
        for concept in _CONCEPTS
        if asked & {name.casefold() for name in concept.names}
        or whole in {name.casefold() for name in concept.names}
    )


def _find(word: str) -> tuple[Article, ...]:
    return find_concepts(word) if " " not in word.strip() or word.strip() == "axis letters" else ()


def _names() -> Iterator[str]:
    return (name for concept in _CONCEPTS for name in concept.names)


CONCEPTS = Topic(
    "subjects",
    Text("Subjects: waiting, tests, reactions", "Themen: Warten, Tests, Reaktionen"),
    ("waiting", "expect", "override", "Quittung"),
    lambda: (concept.article for concept in _CONCEPTS),
    _find,
    _names,
)
