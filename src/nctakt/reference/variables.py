# SPDX-License-Identifier: MIT
"""Articles about realtime variables, from the access tables (RC-303 … RC-306)."""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.diagnostics import Text
from nctakt.nc.vocabulary.variables.realtime_variables import (
    AXIS_VARIABLES,
    CHANNEL_VARIABLES,
    Access,
    RealtimeVariable,
)
from nctakt.reference.article import Article, Fact, Topic, fact

_RIGHTS = {
    Access.NONE: Text("no access", "kein Zugriff"),
    Access.READ: Text("read", "lesen"),
    Access.WRITE: Text("write", "schreiben"),
    Access.BOTH: Text("read and write", "lesen und schreiben"),
}
_FLUSHES = Text(
    "; each access waits until the path is at rest", "; jeder Zugriff wartet, bis die Bahn steht"
)
_LIVE = Text("; the value of each tick", "; der Wert jedes Takts")
UNITS = {
    "mm": Text(
        "mm, of a rotary axis degrees; inch under G70",
        "mm, bei einer Rundachse Grad; Zoll unter G70",
    )
}


def rows() -> Iterator[tuple[str, RealtimeVariable]]:
    """Yield the variables that programs or realtime cycles may use, with their full names."""
    for row in CHANNEL_VARIABLES:
        if row.decoder or row.cycle:
            yield f"V.RTG.{row.path}" + ("[i]" if row.count else ""), row
    for row in AXIS_VARIABLES:
        if row.decoder or row.cycle:
            yield f"V.RTA.{row.path}.<X>", row


def article(name: str, row: RealtimeVariable) -> Article:
    """Return the article of one row."""
    kind = Text("realtime variable of the channel", "Echtzeit-Variable des Kanals")
    if name.startswith("V.RTA"):
        kind = Text("realtime variable of an axis", "Echtzeit-Variable einer Achse")
    return Article(name, kind, row.meaning, tuple(_facts(row)))


def _facts(row: RealtimeVariable) -> Iterator[Fact]:
    yield fact("Type", "Typ", row.type)
    if row.count:
        elements = Text(f"{row.count}, from index 0", f"{row.count}, ab Index 0")
        yield fact("Elements", "Elemente", elements)
    if row.unit:
        yield fact("Unit", "Einheit", UNITS.get(row.unit, Text(row.unit, row.unit)))
    yield fact("In programs", "In Programmen", _rights(row.decoder, _FLUSHES))
    yield fact("In realtime cycles", "In Echtzeit-Zyklen", _rights(row.cycle, _LIVE))


def _rights(access: Access, further: Text) -> Text:
    right = _RIGHTS[access]
    if not access:
        return right
    return Text(right.en + further.en, right.de + further.de)


def rights(access: Access) -> str:
    """Return the rights as text: ``R``, ``W``, ``R W`` or ``–``."""
    letters = [
        letter for flag, letter in ((Access.READ, "R"), (Access.WRITE, "W")) if access & flag
    ]
    return " ".join(letters) or "–"


def _all() -> Iterator[Article]:
    for name, row in rows():
        yield article(name, row)


def _find(word: str) -> tuple[Article, ...]:
    """Find a name with or without axis and index, with ``V.`` or ``Vs.``, in any letter case."""
    pattern = word.upper()
    if pattern.startswith("VS."):
        pattern = "V." + pattern[3:]
    pattern = pattern.split("[", maxsplit=1)[0]
    without_axis = pattern.rsplit(".", 1)[0] if pattern.startswith("V.RTA.") else pattern
    for candidate in (pattern, without_axis):
        rows_of_name = [(name, row) for name, row in rows() if _plain(name) == candidate]
        if rows_of_name:
            return tuple(article(name, row) for name, row in rows_of_name)
    return ()


def _plain(name: str) -> str:
    return name.removesuffix("[i]").removesuffix(".<X>")


def _names() -> Iterator[str]:
    return (_plain(name) for name, _ in rows())


VARIABLES = Topic(
    "variables",
    Text("Realtime variables", "Echtzeit-Variablen"),
    ("V.RTA.ACS.ACT_POS.X", "V.RTG.TIMER"),
    _all,
    _find,
    _names,
)
