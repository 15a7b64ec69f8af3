# SPDX-License-Identifier: MIT
"""Rows of the tables of known names: meaning and level of support.

Three levels of support: *simulated*; *accepted*, checked but without effect on positions;
*refused*, an error by name, because it may change positions or timing in ways that are not
modelled.
"""

from __future__ import annotations

import enum
from collections.abc import Mapping
from types import MappingProxyType

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text


class Support(enum.Enum):
    """The level of support of a name."""

    SIMULATED = "simulated"
    ACCEPTED = "accepted"
    REFUSED = "refused"


SIMULATED, ACCEPTED, REFUSED = Support.SIMULATED, Support.ACCEPTED, Support.REFUSED


class Kind(enum.Enum):
    """The table of a name."""

    G_FUNCTION = "G function"
    M_FUNCTION = "M function"
    TECHNOLOGY = "synchronisation of M and H functions"
    WORD = "word"
    CONTROL = "control word"
    COMMAND = "# command"
    VARIABLE = "variables"
    FUNCTION = "function of expressions"
    FORM = "form"


NOTHING_INSTEAD = Text("", "")
_MOVES = Text(
    "Remove it: its effect would change positions or times.",
    "Entfernen: die Wirkung würde Positionen oder Zeiten ändern.",
)
_QUIET = Text(
    "Remove it: positions and times do not depend on it.",
    "Entfernen: Positionen und Zeiten hängen nicht davon ab.",
)
_UNKNOWN = Text(
    "Remove it: without it positions or times may differ from those on the machine.",
    "Entfernen: Positionen oder Zeiten können dann von denen der Maschine abweichen.",
)
_NO_VALUE = Text(
    "Leave it out, or write a value in its place: here it has none.",
    "Weglassen oder einen Wert an seine Stelle schreiben: hier hat es keinen.",
)


class Effect(enum.Enum):
    """Effect of a refused name on a machine."""

    MOTION = ""
    WITHOUT_MOTION = "without motion"
    #: It depends on its words, or is not published.
    NOT_KNOWN = "not known"


@dataclass(frozen=True, slots=True)
class Entry:
    """One row; ``instead``: what to use in place of a refused name, empty if there is nothing.

    ``forms``: examples of how a ``#`` command is written, each a line that a program may have.
    """

    kind: Kind
    name: str
    support: Support
    meaning: Text
    instead: Text = NOTHING_INSTEAD
    effect: Effect = Effect.MOTION
    forms: tuple[str, ...] = ()

    @property
    def advice(self) -> Text:
        """What to do about a refused name."""
        first = _NO_VALUE if self.kind is Kind.VARIABLE else _MOVES
        if self.effect is Effect.WITHOUT_MOTION:
            first = _QUIET
        elif self.effect is Effect.NOT_KNOWN or self.kind is Kind.FORM:
            first = _UNKNOWN
        if self.kind is Kind.FORM and self.instead.en:
            return self.instead
        second = self.instead
        return Text(f"{first.en} {second.en}".rstrip(), f"{first.de} {second.de}".rstrip())


#: Name, support, meaning in English and German, what to use instead.
Row = tuple[str, Support, str, str] | tuple[str, Support, str, str, Text]


def table(kind: Kind, *rows: Row) -> Mapping[str, Entry]:
    """Return the entries of one kind by name."""
    entries = {}
    for name, support, en, de, *instead in rows:
        entries[name] = Entry(
            kind, name, support, Text(en, de), instead[0] if instead else NOTHING_INSTEAD
        )
    return MappingProxyType(entries)
