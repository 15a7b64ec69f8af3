# SPDX-License-Identifier: MIT
"""The keywords of realtime cycles, in words (RC-101 … RC-111, RC-203).

Data for explanation and documentation; the parser and the checker know the words themselves, and
a test compares the two.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from nctakt.diagnostics import Text


@dataclass(frozen=True, slots=True)
class KeywordMeaning:
    """A keyword, what it does, and how it is written."""

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
        "motions of the cycle go on to their end when it ends",
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
        "a held cycle goes on with the states that it had",
        "ein angehaltener Zyklus läuft mit den Zuständen weiter, die er hatte",
        "#RT CYCLE CONTINUE [ID=1]",
    ),
    (
        "ABORT ACTION",
        "motions and spindle jobs of the cycle end; it goes on running",
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
        "Vs.",
        "synchronous access: the value of each tick, also of an asynchronous variable",
        "synchroner Zugriff: der Wert jedes Takts, auch einer asynchronen Variablen",
        "$IF Vs.E.LEVEL > 5",
    ),
)
