# SPDX-License-Identifier: MIT
"""The keywords of realtime cycles in words (RC-101 … RC-111, RC-203, RC-405, RC-407).

Data for explanation and documentation; parser and checker have their own lists, and a test compares
the two.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text


@dataclass(frozen=True, slots=True)
class KeywordMeaning:
    """A keyword, its meaning, and an example."""

    name: str
    meaning: Text
    example: str


def _rows(*rows: tuple[str, str, str, str]) -> Mapping[str, KeywordMeaning]:
    return MappingProxyType(
        {name: KeywordMeaning(name, Text(en, de), example) for name, en, de, example in rows}
    )


KEYWORDS = _rows(
    (
        "ONCE",
        "the body runs once, at the first true evaluation, and not again until START",
        "der Inhalt läuft einmal, bei der ersten wahren Auswertung, und erst nach START wieder",
        "$IF ONCE V.RTA.ACS.ACT_POS.X > 200",
    ),
    (
        "EDGE",
        "the body runs each time the condition becomes true",
        "der Inhalt läuft jedes Mal, wenn die Bedingung wahr wird",
        "$IF EDGE V.RTA.ACS.ACT_POS.X > 200",
    ),
    (
        "ALWAYS",
        "from the first true evaluation on the body runs in every tick that reaches it",
        "ab der ersten wahren Auswertung läuft der Inhalt in jedem Takt, der ihn erreicht",
        "$IF ALWAYS V.RTA.ACS.ACT_POS.X > 200",
    ),
    (
        "DEF",
        "the cycle is only defined; #RT CYCLE START starts it",
        "der Zyklus wird nur definiert; #RT CYCLE START startet ihn",
        "#RT CYCLE DEF [ID=1]",
    ),
    (
        "ID",
        "number of a realtime cycle, a whole one from 1 on",
        "Nummer eines Echtzeit-Zyklus, eine ganze ab 1",
        "#RT CYCLE [ID=1]",
    ),
    (
        "SCOPE",
        "how long a realtime cycle lives: BLOCK, PROG (unless given) or GLOBAL",
        "wie lange ein Echtzeit-Zyklus lebt: BLOCK, PROG (ohne Angabe) oder GLOBAL",
        "#RT CYCLE [ID=1 SCOPE=GLOBAL]",
    ),
    (
        "BLOCK",
        "the cycle runs while the next block that takes time is current",
        "der Zyklus läuft, solange der nächste Satz, der Zeit braucht, aktuell ist",
        "#RT CYCLE [SCOPE=BLOCK]",
    ),
    (
        "PROG",
        "the cycle lives until the end of the main program",
        "der Zyklus lebt bis zum Ende des Hauptprogramms",
        "#RT CYCLE [SCOPE=PROG]",
    ),
    (
        "GLOBAL",
        "the cycle outlives its program, until #RT CYCLE DELETE",
        "der Zyklus überlebt sein Programm, bis #RT CYCLE DELETE",
        "#RT CYCLE [ID=1 SCOPE=GLOBAL]",
    ),
    (
        "END_ACTION",
        "what becomes of motions that the cycle has started when it ends",
        "was aus Bewegungen wird, die der Zyklus gestartet hat, wenn er endet",
        "#RT CYCLE [ID=1 END_ACTION=MOVE_CONT]",
    ),
    (
        "MOVE_ABORT",
        "motions of the cycle brake when it ends (unless another END_ACTION is given)",
        "Bewegungen des Zyklus bremsen, wenn er endet (ohne andere Angabe von END_ACTION)",
        "#RT CYCLE [ID=1 END_ACTION=MOVE_ABORT]",
    ),
    (
        "MOVE_CONT",
        "motions of the cycle continue to their end when it ends",
        "Bewegungen des Zyklus laufen zu Ende, wenn er endet",
        "#RT CYCLE [ID=1 END_ACTION=MOVE_CONT]",
    ),
    (
        "START",
        "starts a defined cycle; the states of its $IF are as new",
        "startet einen definierten Zyklus; die Zustände seiner $IF sind wie neu",
        "#RT CYCLE START [ID=1]",
    ),
    (
        "HOLD",
        "the cycle is not run until CONTINUE; its states stay",
        "der Zyklus läuft bis CONTINUE nicht; seine Zustände bleiben",
        "#RT CYCLE HOLD [ID=1]",
    ),
    (
        "CONTINUE",
        "a cycle on hold continues with the states that it had",
        "ein angehaltener Zyklus läuft mit den Zuständen weiter, die er hatte",
        "#RT CYCLE CONTINUE [ID=1]",
    ),
    (
        "ABORT ACTION",
        "motions and spindle jobs of the cycle end; it keeps running",
        "Bewegungen und Spindelaufträge des Zyklus enden; er selbst läuft weiter",
        "#RT CYCLE ABORT ACTION [ID=1]",
    ),
    (
        "DELETE",
        "the cycle ends; an ID that no cycle has is harmless",
        "der Zyklus endet; eine ID, die kein Zyklus hat, schadet nicht",
        "#RT CYCLE DELETE [ID=1]",
    ),
    (
        "INDP",
        "a single axis moves on its own, beside the path; in realtime cycles",
        "eine einzelne Achse fährt für sich, neben der Bahn; in Echtzeit-Zyklen",
        "Z[INDP G90 G00 POS=100]",
    ),
    (
        "ABORTING",
        "the motion replaces the running one and takes over its speed (unless BUFFERED is given)",
        "die Bewegung ersetzt die laufende und übernimmt deren Geschwindigkeit (ohne BUFFERED)",
        "Z[INDP ABORTING G90 G00 POS=100]",
    ),
    (
        "BUFFERED",
        "the motion begins when the running one has ended",
        "die Bewegung beginnt, wenn die laufende beendet ist",
        "Z[INDP BUFFERED G90 G00 POS=100]",
    ),
    (
        "STOP",
        "the axis brakes, its motion is given up",
        "die Achse bremst, ihre Bewegung wird aufgegeben",
        "Z[INDP STOP]",
    ),
    (
        "FEED",
        "speed of a single axis per minute; without POS it runs on and on",
        "Geschwindigkeit einer Einzelachse je Minute; ohne POS fährt sie endlos",
        "Z[INDP FEED=500]",
    ),
    (
        "POS",
        "target (G90) or way (G91) of a single axis; with DIR: positive direction",
        "Ziel (G90) oder Weg (G91) einer Einzelachse; bei DIR: positive Richtung",
        "Z[INDP G91 G00 POS=-10]",
    ),
    (
        "DIR",
        "direction: POS, NEG, CUR (as it goes now), or a value above, below or equal to 0",
        "Richtung: POS, NEG, CUR (wie gerade) oder ein Wert über, unter oder gleich 0",
        "Z[INDP FEED=500 DIR=NEG]",
    ),
    (
        "CUR",
        "with DIR: the present direction, at rest the last one",
        "bei DIR: die jetzige Richtung, im Stillstand die letzte",
        "Z[INDP FEED=500 DIR=CUR]",
    ),
    (
        "NEG",
        "with DIR: negative direction",
        "bei DIR: negative Richtung",
        "Z[INDP FEED=500 DIR=NEG]",
    ),
    (
        "OFFSET",
        "which active offsets of the axis are added to a target of G90",
        "welche aktiven Verschiebungen der Achse zu einem Ziel mit G90 addiert werden",
        "Z[INDP G90 POS=100 OFFSET=ALL]",
    ),
    (
        "ALL",
        "with OFFSET: all active offsets",
        "bei OFFSET: alle aktiven Verschiebungen",
        "Z[INDP G90 POS=100 OFFSET=ALL]",
    ),
    (
        "ZERO",
        "with OFFSET: the zero offset",
        "bei OFFSET: die Nullpunktverschiebung",
        "Z[INDP G90 POS=100 OFFSET=ZERO]",
    ),
    (
        "ADD_ZERO",
        "with OFFSET: the additive zero offset",
        "bei OFFSET: die additive Nullpunktverschiebung",
        "Z[INDP G90 POS=100 OFFSET=ADD_ZERO]",
    ),
    (
        "PSET",
        "with OFFSET: the position preset",
        "bei OFFSET: die Istwertverschiebung",
        "Z[INDP G90 POS=100 OFFSET=PSET]",
    ),
    (
        "CLAMP",
        "with OFFSET: the clamp offset",
        "bei OFFSET: der Platzversatz",
        "Z[INDP G90 POS=100 OFFSET=CLAMP]",
    ),
    (
        "TOOL",
        "with OFFSET: the tool offset",
        "bei OFFSET: der Werkzeugversatz",
        "Z[INDP G90 POS=100 OFFSET=TOOL]",
    ),
    (
        "MEASURE",
        "with OFFSET: the measuring offset",
        "bei OFFSET: die Messverschiebung",
        "Z[INDP G90 POS=100 OFFSET=MEASURE]",
    ),
    (
        "MANUAL",
        "with OFFSET: the offset of manual mode",
        "bei OFFSET: die Handbetriebverschiebung",
        "Z[INDP G90 POS=100 OFFSET=MANUAL]",
    ),
    (
        "Vs.",
        "synchronous access: the value of each tick, also of an asynchronous variable",
        "synchroner Zugriff: der Wert jedes Takts, auch einer asynchronen Variablen",
        "$IF Vs.E.LEVEL > 5",
    ),
)
