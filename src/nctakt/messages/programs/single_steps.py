# SPDX-License-Identifier: MIT
"""Messages about the places where single block stops."""

from __future__ import annotations

from nctakt.messages.catalogue import error

SINGLE_STEP_WORDS = error(
    21743,
    en="#SINGLE STEP has more than one keyword",
    de="#SINGLE STEP hat mehr als ein Schlüsselwort",
    remedy_en="Write one command for each: DISABLE, ENABLE or RESOLUTION=10.",
    remedy_de="Für jedes einen eigenen Befehl schreiben: DISABLE, ENABLE oder RESOLUTION=10.",
)
NEGATIVE_RESOLUTION = error(
    901887,
    en="RESOLUTION of #SINGLE STEP is {value}, below 0",
    de="RESOLUTION von #SINGLE STEP ist {value}, kleiner als 0",
    remedy_en="Give 0 or more: 0 stops at each block, 1 at those with a number, 10 at N10, N20 "
    "and so on.",
    remedy_de="0 oder mehr angeben: 0 hält an jedem Satz, 1 an denen mit Nummer, 10 an N10, N20 "
    "und so weiter.",
    classes=(2, 3),
)
