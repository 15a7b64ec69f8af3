# SPDX-License-Identifier: MIT
"""Messages about paths of the interface between CNC and PLC."""

from __future__ import annotations

from nctakt.messages.catalogue import error

_PATH = ("the path as it was given", "der Pfad, wie er angegeben wurde")

UNKNOWN_HLI_PATH = error(
    902100,
    en="the interface has no {path}: nothing is called {part} there",
    de="die Schnittstelle hat kein {path}: dort heißt nichts {part}",
    remedy_en="Did you mean {nearest}? nctakt explain finds paths by any part of their names.",
    remedy_de="War {nearest} gemeint? nctakt explain findet Pfade nach jedem Teil ihres Namens.",
    path=_PATH,
    part=("the name in it that is unknown", "der unbekannte Name darin"),
    nearest=("the nearest path, or –", "der ähnlichste Pfad, oder –"),
)
INDEX_OUTSIDE_ARRAY = error(
    902101,
    en="{path}: there is no index {index}",
    de="{path}: den Index {index} gibt es nicht",
    remedy_en="Give an index from {low} to {high}.",
    remedy_de="Einen Index von {low} bis {high} angeben.",
    path=_PATH,
    index=("the index that is not there", "der Index, den es nicht gibt"),
    low=("the first index", "der erste Index"),
    high=("the last index", "der letzte Index"),
)
NO_INDEX_TAKEN = error(
    902102,
    en="{path}: {name} is not an array and takes no index",
    de="{path}: {name} ist kein Feld und nimmt keinen Index",
    remedy_en="Leave the index out.",
    remedy_de="Den Index weglassen.",
    path=_PATH,
    name=("the name before the index", "der Name vor dem Index"),
)
