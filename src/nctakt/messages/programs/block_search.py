# SPDX-License-Identifier: MIT
"""Messages about block search."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

START_BLOCK_LOCKED = error(
    21399,
    en="block search cannot end here: this part of the program is locked",
    de="der Satzvorlauf kann hier nicht enden: dieser Programmteil ist gesperrt",
    remedy_en="Choose a block before #BLOCKSEARCH LOCKED, or after #BLOCKSEARCH RELEASED.",
    remedy_de="Einen Satz vor #BLOCKSEARCH LOCKED oder hinter #BLOCKSEARCH RELEASED wählen.",
)
HOMING_DURING_SEARCH = error(
    50717,
    en="G74 before the start block: block search cannot home axes",
    de="G74 vor dem Startsatz: der Satzvorlauf kann keine Achsen referenzieren",
    remedy_en="Home the axes first and skip the block (/G74), or begin before it.",
    remedy_de="Die Achsen vorher referenzieren und den Satz ausblenden (/G74), oder vor ihm "
    "beginnen.",
)
START_BLOCK_NOT_REACHED = error(
    901730,
    en="the program has ended without coming to its start block {block}",
    de="das Programm ist zu Ende, ohne zu seinem Startsatz {block} zu kommen",
    remedy_en="Name the line of a block, or its N number, that the program executes.",
    remedy_de="Die Zeile eines Satzes oder seine Satznummer nennen, den das Programm ausführt.",
    block=("its line or number: N120", "seine Zeile oder Nummer: N120"),
    classes=(2, 3),
)
START_OF_SEARCH = note(
    901731,
    en="the program begins at {block}; the axes go straight to its start at rapid traverse",
    de="das Programm beginnt bei {block}; die Achsen fahren gerade im Eilgang zu seinem Anfang",
    remedy_en="M, H and T functions before it are not output; spindles get their last job.",
    remedy_de="M-, H- und T-Funktionen davor werden nicht ausgegeben; Spindeln erhalten ihren "
    "letzten Auftrag.",
    block=("its line or number: N120", "seine Zeile oder Nummer: N120"),
)
BOTH_STARTS_GIVEN = error(
    901732,
    en="--from-line and --from-block exclude each other",
    de="--from-line und --from-block schließen einander aus",
    remedy_en="Name the start block by its line or by its N number.",
    remedy_de="Den Startsatz durch seine Zeile oder durch seine Satznummer nennen.",
)
START_IN_LOOP = error(
    901960,
    en="block search cannot end within a realtime loop, which is decoded as a whole",
    de="der Satzvorlauf kann nicht in einer Echtzeit-Schleife enden: sie wird als Ganzes dekodiert",
    remedy_en="Begin at #RT WHILE, or after #RT ENDWHILE.",
    remedy_de="Bei #RT WHILE oder nach #RT ENDWHILE beginnen.",
    classes=(2, 3),
)
READ_DURING_SEARCH = warning(
    901961,
    en="{variable} is read before the start block: it has its present value, not that of the "
    "program",
    de="{variable} wird vor dem Startsatz gelesen: es gilt der jetzige Wert, nicht der im Programm",
    remedy_en="Begin before this block if its value matters.",
    remedy_de="Vor diesem Satz beginnen, wo es auf den Wert ankommt.",
    variable=("the variable as written", "die Variable, wie geschrieben"),
)
