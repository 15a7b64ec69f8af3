# SPDX-License-Identifier: MIT
"""Rows of the tables of known names: meaning and level of support.

Three levels of support: *simulated*; *accepted*, checked but without effect on positions;
*refused*, an error by name, because it would change positions or timing in a way that is not
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


@dataclass(frozen=True, slots=True)
class Entry:
    """One row; ``instead``: what to use in place of a refused name, empty for nothing."""

    kind: Kind
    name: str
    support: Support
    meaning: Text
    instead: Text = NOTHING_INSTEAD


#: Name, support, meaning in English and German, what to use instead.
Row = tuple[str, Support, str, str] | tuple[str, Support, str, str, Text]


def table(kind: Kind, *rows: Row) -> Mapping[str, Entry]:
    """Return the entries of one kind by name."""
    entries = {}
    for name, support, en, de, *instead in rows:
        entries[name] = Entry(kind, name, support, Text(en, de), *instead)
    return MappingProxyType(entries)
