# SPDX-License-Identifier: MIT
"""Articles about everyday words that people look up: waiting, override, expectations.

In: a word or the words of a question, in English or German. Out: the articles of the subjects that
it names; each leads on to the words of the language.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.reference.article import Article, Fact, Topic, fact
from nctakt.reference.time_words import TIME_WORDS, TimeWord

_KIND = Text("subject", "Thema")
_EXAMPLES = ("Examples", "Beispiele")
_FURTHER = ("See also", "Siehe auch")
_OF_TIME = Text("word of nctakt time", "Wort von nctakt time")

#: Guides that also exist in German.
GERMAN_GUIDES = frozenset(("checking", "machine-folders", "running", "tutorial", "why"))
_GUIDE = re.compile(rf"docs/({'|'.join(sorted(GERMAN_GUIDES))})\.md")


@dataclass(frozen=True, slots=True)
class _Concept:
    """A subject and its names; ``begins``: the start of its longer names."""

    names: tuple[str, ...]
    article: Article
    begins: tuple[str, ...] = ()

    def is_called(self, folded: str) -> bool:
        """Return whether words in small letters are one of its names."""
        return any(folded == name.casefold() for name in self.names) or any(
            begin and folded.startswith(f"{begin.casefold()} ") for begin in self.begins
        )


def _concept(names: str, meaning: Text, *facts: Fact) -> _Concept:
    """Return a subject; ``names``: its name, then other names; after ``;`` in German."""
    english, german = (part.split(", ") for part in names.split("; "))
    article = Article(english[0], _KIND, meaning, tuple(map(_with_guides, facts)), german[0])
    return _Concept((*english, *german), article)


def _with_guides(one: Fact) -> Fact:
    """Return a fact that leads to the German guides in German."""
    return Fact(one.label, Text(one.value.en, _GUIDE.sub(r"docs/\1.de.md", one.value.de)))


def _of_time(words: TimeWord) -> _Concept:
    """Return the subject of a word that ``nctakt time`` prints."""
    names = words.name.en, words.name.de
    further = fact(*_FURTHER, "nctakt time part.nc; docs/time.md")
    article = Article(names[0], _OF_TIME, words.meaning, (further,), names[1])
    return _Concept(names, article, (words.begin.en, words.begin.de))


#: Words of a question that say nothing about its subject.
SMALL_WORDS = frozenset(
    "a an and are be by can come comes do does for from get how i if in is it mean means my no "
    "not of on one or should that the there to until what when where which who why with am an auf "
    "aus bedeutet bei bis das dem den der des die ein eine einem einen einer es für geht hat ich "
    "im ist kann kein keine kommt man mein meine meinem meinen meiner mit muss nach nicht sich "
    "sind soll um und von wann warum was welche welcher welches wenn wie wird wo womit worauf zu "
    "zum zur".split()
)

_CONCEPTS = (
    _concept(
        "axis letters, X, Y, Z, A, B, C, U, V, W, axis, axes; Achse, Achsen, Koordinate",
        Text(
            "A letter with a value moves an axis of the channel: its end point with G90, its way "
            "with G91; the letters are the names of the axes in the channel list",
            "Ein Buchstabe mit einem Wert bewegt eine Achse des Kanals: mit G90 ihr Endpunkt, mit "
            "G91 ihr Weg; die Buchstaben sind die Namen der Achsen in der Kanalliste",
        ),
        fact(
            *_EXAMPLES,
            "G01 X100 Y-5.5 F6000\nG91 Z=V.E.DEPTH\n"
            "#RT CYCLE [ID=1 SCOPE=PROG]\n  Z[INDP G90 POS=50 FEED=500]\n#RT CYCLE END",
        ),
        fact(*_FURTHER, "G90, G91, INDP, V.RTA.ACS.ACT_POS.X, Z.ACS.ACT_POS (--signals)"),
    ),
    _concept(
        "reaction, react, reactions, gate, clamp, door, guard; Reaktion, Reaktionen, Tor, Tür, "
        "Schutztür, Spannmittel",
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
        "realtime cycle, realtime cycles, real-time cycle, cycles; Echtzeit-Zyklus, "
        "Echtzeit-Zyklen, Echtzeitzyklus, Echtzeitzyklen, Zyklus, Zyklen",
        Text(
            "Conditions and actions that the controller runs through in each tick beside the "
            "path, without waiting for the PLC; SCOPE says how long they live",
            "Bedingungen und Aktionen, die die Steuerung neben der Bahn in jedem Takt durchläuft, "
            "ohne auf die SPS zu warten; SCOPE sagt, wie lange sie leben",
        ),
        fact(
            *_EXAMPLES,
            "#RT CYCLE [ID=1 SCOPE=PROG]\n  $IF ONCE V.RTA.ACS.ACT_POS.X > 200\n    M100\n"
            "  $ENDIF\n#RT CYCLE END",
        ),
        fact(*_FURTHER, "#RT CYCLE, SCOPE, $IF, ONCE, EDGE, V.RTG, V.RTA, reaction; docs/why.md"),
    ),
    _concept(
        "spindle, spindles; Spindel, Spindeln, Drehzahl",
        Text(
            "M3 and M4 turn the main spindle with the speed S, M5 stops it, M19 positions it; "
            "S[…] commands any spindle by its name",
            "M3 und M4 drehen die Hauptspindel mit der Drehzahl S, M5 hält sie an, M19 "
            "positioniert sie; S[…] gibt jeder Spindel unter ihrem Namen Aufträge",
        ),
        fact(*_EXAMPLES, "M3 S1000\nS[M3 REV1000]\nM19 S.POS90"),
        fact(*_FURTHER, "S, M3, M4, M5, M19, G96, G97, G63, G33"),
    ),
    _concept(
        "single block; Einzelsatz, Einzelsatzbetrieb",
        Text(
            "The program stops after each block and continues with START; the debugger and the "
            "page step by blocks in the same manner",
            "Das Programm hält nach jedem Satz und geht mit START weiter; Debugger und Seite "
            "gehen ebenso satzweise weiter",
        ),
        fact(*_EXAMPLES, "nctakt run part.nc --set HLI.SINGLE_BLOCK=1"),
        fact(*_FURTHER, "HLI.SINGLE_BLOCK, HLI.START, #SINGLE STEP, M00, M01"),
    ),
    _concept(
        "override; Override, Vorschubbeeinflussung, Potentiometer",
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
        "waiting, wait, waits, standstill, hang, hangs, stuck, stops; Warten, warten, warte, "
        "wartet, Wartezeit, Stillstand, hängt, stehen, steht, bleibt",
        Text(
            "A program that does not continue waits for the PLC's acknowledgement of a function, "
            "for an axis or a spindle, for START, for a signal of another channel, or for a time",
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
        "expect, given, expectation, expectations, test, tests, testing, assert; Erwartung, "
        "Erwartungen, erwarten, testen, teste, Tests",
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
        fact(
            "Branch",
            "Zweig",
            Text(
                "fired: the branch in this line of a realtime cycle becomes true; fired 17: one of "
                "cycle 17; fired 17 line 5: that in line 5",
                "fired: der Zweig in dieser Zeile eines Echtzeit-Zyklus wird wahr; fired 17: einer "
                "von Zyklus 17; fired 17 line 5: der in Zeile 5",
            ),
        ),
        fact(
            "In plans",
            "In Plänen",
            "max X < 300\nX < 50 within 100 ms\nX < 50 within 100 ms after M100\n"
            'M100 before M101\nM100 once\nmessage "done" before 2 s\nended',
        ),
        fact(*_FURTHER, "docs/testing.md, docs/studies.md; pytest part.nc"),
    ),
    _concept(
        "speed, velocity, rapid; Geschwindigkeit, Vorschub, Eilgang",
        Text(
            "F is the speed of the path in mm/min (G94), per revolution with G95; G00 moves at "
            "rapid traverse",
            "F ist die Bahngeschwindigkeit in mm/min (G94), mit G95 je Umdrehung; G00 fährt im "
            "Eilgang",
        ),
        fact(*_FURTHER, "F, G00, G01, G94, G95, PATH.SPEED (--signals), override"),
    ),
    _concept(
        "acknowledgement, acknowledge; Quittung, quittieren, quittiert",
        Text(
            "The PLC's answer that an M or H function is done; the kind of synchronisation in the "
            "channel list says whether the program waits for it",
            "Die Antwort der SPS, dass eine M- oder H-Funktion erledigt ist; die Art der "
            "Synchronisation in der Kanalliste sagt, ob das Programm darauf wartet",
        ),
        fact(*_FURTHER, "M, H, MVS_SVS, MNS_SNS, P-CHAN-00041, waiting"),
    ),
    _concept(
        "variable; Variable, Variablen",
        Text(
            "P are parameters of the program, V.P and V.L its own variables, V.E and V.CH those of "
            "the machine's lists, V.A and V.G those of the controller, V.RTA and V.RTG the values "
            "of each tick",
            "P sind Parameter des Programms, V.P und V.L seine Variablen, V.E und V.CH die der "
            "Listen der Maschine, V.A und V.G die der Steuerung, V.RTA und V.RTG die Werte jedes "
            "Takts",
        ),
        fact(*_EXAMPLES, "nctakt run part.nc --set V.E.COUNT=5 --at 200ms V.E.COUNT=7"),
        fact(*_FURTHER, "V.E, V.CH, V.P, V.L, P; nctakt explain variables"),
    ),
    _concept(
        "feed hold, feedhold, hold; Vorschubhalt, Vorschub-Halt, anhalten",
        Text(
            "The operator stops the path: it brakes to a standstill and continues from there once "
            "the hold is lifted",
            "Der Bediener hält die Bahn an: Sie bremst bis zum Stillstand und geht von dort "
            "weiter, sobald der Halt aufgehoben ist",
        ),
        fact(
            *_EXAMPLES, "nctakt run part.nc --at 200ms HLI.FEED_HOLD=1 --at 500ms HLI.FEED_HOLD=0"
        ),
        fact(*_FURTHER, "HLI.FEED_HOLD, HLI.START, HLI.RESET, V.RTG.OVERRIDE.VEL.CYCLE, override"),
    ),
    _concept(
        "arc, arcs, circle, helix; Kreisbogen, Kreis, Bogen",
        Text(
            "G02 moves clockwise, G03 counter-clockwise, with I, J, K for the centre or R for the "
            "radius; a third axis makes it a helix",
            "G02 fährt im Uhrzeigersinn, G03 dagegen, mit I, J, K für den Mittelpunkt oder R für "
            "den Radius; eine dritte Achse macht daraus eine Helix",
        ),
        fact(*_EXAMPLES, "G17 G02 X20 Y0 I10 J0 F3000\nG03 X0 Y0 R10"),
        fact(*_FURTHER, "G02, G03, G17, G161, G162, G163, I, J, K, R"),
    ),
    _concept(
        "subprogram, subprograms, call; Unterprogramm, Unterprogramme, aufrufen",
        Text(
            "L calls a program in another file, LL a part of this file; M17 or M29 ends it",
            "L ruft ein Programm in einer anderen Datei auf, LL einen Teil dieser Datei; M17 "
            "oder M29 beendet es",
        ),
        fact(*_FURTHER, "L, LL, M17, M29, L CYCLE"),
    ),
    _concept(
        "tools, tool, radius; Werkzeuge, Werkzeug, Werkzeugradius, Radiuskorrektur",
        Text(
            "T names a tool of the tool list, D selects its offsets; G41 and G42 lead the path "
            "beside the contour, by its radius",
            "T nennt ein Werkzeug der Werkzeugliste, D wählt seine Korrekturen an; G41 und G42 "
            "führen die Bahn um seinen Radius versetzt an der Kontur entlang",
        ),
        fact(*_FURTHER, "T, D, G40, G41, G42; docs/tools.md"),
    ),
    _concept(
        "zero offset, zero offsets; Nullpunktverschiebung, Nullpunkt, Nullpunkte",
        Text(
            "G54 … G59 and G159 move the zero point of the program by a group of the list of "
            "zero offsets; G53 deselects it",
            "G54 … G59 und G159 verschieben den Nullpunkt des Programms um eine Gruppe der "
            "Nullpunktliste; G53 wählt sie ab",
        ),
        fact(*_FURTHER, "G53, G54, G159, G92"),
    ),
    _concept(
        "measuring, measure, probe, probing; Messen, Messtaster, messen",
        Text(
            "A motion that a probe stops, and whose position the program reads then",
            "Eine Bewegung, die ein Taster anhält und deren Position das Programm danach liest",
        ),
        fact(*_FURTHER, "G100, G310, MEAS_DELTA (--signals)"),
    ),
    _concept(
        "tick, ticks, cycle time, CNC cycle; Takt, Takte, Zykluszeit",
        Text(
            "The period of the interpolator: in each tick inputs are read, then realtime cycles "
            "run, then the path continues; cycle_time in rtconf.lis, 1 ms without it",
            "Die Periode des Interpolators: In jedem Takt werden Eingaben gelesen, dann laufen die "
            "Echtzeit-Zyklen, dann geht die Bahn weiter; cycle_time in rtconf.lis, sonst 1 ms",
        ),
        fact(*_FURTHER, "--ticks, P-RTCF-00001; nctakt schedule show rtconf.lis"),
    ),
    _concept(
        "trace, traces, record, recording, picture, plot, signals; Aufzeichnung, aufzeichnen, "
        "Bild, Signal, Signale",
        Text(
            "A run as a file: each tick with the signals that you name, or as a picture",
            "Ein Lauf als Datei: jeder Takt mit den Signalen, die man nennt, oder als Bild",
        ),
        fact(
            *_EXAMPLES,
            "nctakt run part.nc --trace out.csv --signals X.ACS.ACT_POS,BLOCK\n"
            "nctakt run part.nc --plot run.html",
        ),
        fact(*_FURTHER, "docs/traces.md; nctakt live part.nc --open"),
    ),
    _concept(
        "block search; Satzvorlauf",
        Text(
            "A run that begins in the middle of the program: what is before is decoded, not moved",
            "Ein Lauf, der mitten im Programm beginnt: Was davor steht, wird dekodiert, nicht "
            "gefahren",
        ),
        fact(*_EXAMPLES, "nctakt run part.nc --from-line 40\nnctakt run part.nc --from-block 120"),
        fact(*_FURTHER, "#BLOCKSEARCH; docs/running.md"),
    ),
    _concept(
        "breakpoint, breakpoints, debugger; Haltepunkt, Haltepunkte",
        Text(
            "A line at which the debugger stops the run; it also goes back in time",
            "Eine Zeile, an der der Debugger den Lauf anhält; er geht auch in der Zeit zurück",
        ),
        fact(*_EXAMPLES, "nctakt dap\nnctakt live part.nc --dap 4711"),
        fact(*_FURTHER, "docs/debugger.md"),
    ),
    _concept(
        "machining time, duration, slow; Bearbeitungszeit, dauert, Dauer, langsam",
        Text(
            "How long a program takes on the machine, and what limits each block",
            "Wie lange ein Programm auf der Maschine dauert und was jeden Satz begrenzt",
        ),
        fact(*_EXAMPLES, "nctakt time part.nc"),
        fact(*_FURTHER, "docs/time.md, override, speed"),
    ),
    _concept(
        "lists, machine folder, start-up list; Listen, Hochlaufliste, Maschinenordner, Maschine",
        Text(
            "A machine is a folder with a start-up list (hochlauf.lis) that names the lists of "
            "channels and axes",
            "Eine Maschine ist ein Ordner mit einer Hochlaufliste (hochlauf.lis), die die Listen "
            "der Kanäle und Achsen nennt",
        ),
        fact(
            *_EXAMPLES,
            "nctakt check lists\nnctakt run part.nc --machine lists\nnctakt new mymachine",
        ),
        fact(*_FURTHER, "docs/machine-folders.md; nctakt explain parameters"),
    ),
    _concept(
        "interface, PLC, HMI, gpCh, gpAx; Schnittstelle, SPS",
        Text(
            "What CNC and PLC exchange in each tick: commands of the operator, states, functions "
            "with their acknowledgement, variables",
            "Was CNC und SPS in jedem Takt austauschen: Befehle des Bedieners, Zustände, "
            "Funktionen mit ihrer Quittung, Variablen",
        ),
        fact(
            *_EXAMPLES,
            "nctakt run part.nc --set HLI.OVERRIDE=50\nnctakt explain 'gpCh[]^.bahn_state'",
        ),
        fact(*_FURTHER, "docs/hli.md, docs/plc.md; nctakt explain hli"),
    ),
    _concept(
        "connection, connections, connect, ADS, OPC UA, OPC-UA, OPCUA, MTConnect, MQTT, TwinCAT; "
        "Verbindung, Verbindungen, verbinden, verbinde, anbinden",
        Text(
            "A run that PLCs, HMIs and dashboards reach on the network as they reach a machine",
            "Ein Lauf, den SPSen, HMIs und Dashboards im Netz erreichen wie eine Maschine",
        ),
        fact(*_EXAMPLES, "nctakt serve part.nc --ads --opcua"),
        fact(*_FURTHER, "docs/serve.md, docs/ads.md, docs/opcua.md, docs/mqtt.md, interface"),
    ),
    _concept(
        "homing, home, reference run; Referenzfahrt, Referenzpunktfahrt, referenzieren, Referenz",
        Text(
            "G74 moves axes to their reference points, one after the other as their values say",
            "G74 fährt Achsen auf ihre Referenzpunkte, in der Reihenfolge ihrer Werte",
        ),
        fact(*_EXAMPLES, "G74 X1 Y2 Z1"),
        fact(*_FURTHER, "G74, V.A.RERF"),
    ),
    _concept(
        "loop, loops, repeat; Schleife, Schleifen, wiederholen",
        Text(
            "$FOR counts, $WHILE asks at its head, $REPEAT at its end; $BREAK leaves them",
            "$FOR zählt, $WHILE fragt am Kopf, $REPEAT am Ende; $BREAK verlässt sie",
        ),
        fact(*_EXAMPLES, "$FOR P1 = 1, 3, 1\n  G91 X10 F1000\n$ENDFOR"),
        fact(*_FURTHER, "$FOR, $WHILE, $REPEAT, $DO, $BREAK, $CONTINUE, #RT WHILE"),
    ),
    _concept(
        "message; Meldung, Meldungen",
        Text(
            "#MSG sends a text of the program to the operator; a run shows it with its time",
            "#MSG sendet dem Bediener einen Text des Programms; ein Lauf zeigt ihn mit seiner Zeit",
        ),
        fact(*_EXAMPLES, '#MSG ["X is at %f", V.A.ABS.X]'),
        fact(*_FURTHER, "#MSG, #ERROR; nctakt explain 22009 explains a message of nctakt"),
    ),
    _concept(
        "comment, comments; Kommentar, Kommentare",
        Text(
            "A text in round brackets or after a semicolon; #COMMENT over several lines",
            "Ein Text in runden Klammern oder nach einem Semikolon; #COMMENT über mehrere Zeilen",
        ),
        fact(*_EXAMPLES, "G01 X10 (to the gate) F1000\nM30 ; the end"),
        fact(*_FURTHER, "#COMMENT, expect"),
    ),
    *map(_of_time, TIME_WORDS),
)


def find_concepts(words: str) -> tuple[Article, ...]:
    """Return the articles of the subjects that one of the words of a text names, or all of it."""
    asked = {word.strip("?!.,;:").casefold() for word in words.split()}
    if len(asked) > 1:
        asked -= SMALL_WORDS
    whole = " ".join(words.split()).casefold()
    return tuple(
        concept.article
        for concept in _CONCEPTS
        if asked & {name.casefold() for name in concept.names} or is_subject(whole, concept)
    )


def is_subject(words: str, concept: _Concept | None = None) -> bool:
    """Return whether words are together a name of a subject: ``feed hold``."""
    folded = " ".join(words.split()).casefold()
    concepts = _CONCEPTS if concept is None else (concept,)
    return any(one.is_called(folded) for one in concepts)


def _find(word: str) -> tuple[Article, ...]:
    return find_concepts(word) if " " not in word.strip() or is_subject(word) else ()


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
