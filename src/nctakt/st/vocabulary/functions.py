# SPDX-License-Identifier: MIT
"""Functions that fit many types, and have no declaration therefore (ST-307, ST-712 … 715).

In: a name. Out: how many operands it takes, and which rule its type follows; for conversions the
types. Functions with fixed types are declared in the libraries in their folder.
"""

from __future__ import annotations

import re

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.st.types import StringType, Type
from nctakt.st.vocabulary.elementary import ELEMENTARY, string


@dataclass(frozen=True, slots=True)
class BuiltIn:
    """A function: ``rule`` is the method of the checker that types it."""

    name: str
    rule: str
    low: int
    high: int


_MANY = 64

BUILT_INS: dict[str, BuiltIn] = {
    one.name: one
    for one in (
        BuiltIn("ABS", "number", 1, 1),
        *(
            BuiltIn(name, "real", 1, 1)
            for name in "SQRT LN LOG EXP SIN COS TAN ASIN ACOS ATAN".split()
        ),
        BuiltIn("EXPT", "power", 2, 2),
        BuiltIn("TRUNC", "truncation", 1, 1),
        BuiltIn("TRUNC_INT", "truncation", 1, 1),
        BuiltIn("MIN", "common", 2, _MANY),
        BuiltIn("MAX", "common", 2, _MANY),
        BuiltIn("LIMIT", "common", 3, 3),
        BuiltIn("SEL", "selection", 3, 3),
        BuiltIn("MUX", "selection", 2, _MANY),
        BuiltIn("MOVE", "common", 1, 1),
        *(BuiltIn(name, "shift", 2, 2) for name in ("SHL", "SHR", "ROL", "ROR")),
        BuiltIn("ADR", "address", 1, 1),
        BuiltIn("SIZEOF", "size", 1, 1),
        BuiltIn("XSIZEOF", "size", 1, 1),
        BuiltIn("LOWER_BOUND", "bound", 2, 2),
        BuiltIn("UPPER_BOUND", "bound", 2, 2),
        BuiltIn("TIME", "clock", 0, 0),
        BuiltIn("LTIME", "clock", 0, 0),
        BuiltIn("__ISVALIDREF", "valid", 1, 1),
        BuiltIn("__QUERYINTERFACE", "query", 2, 2),
        BuiltIn("__QUERYPOINTER", "query", 2, 2),
        BuiltIn("__POUNAME", "text", 0, 0),
        BuiltIn("__POSITION", "text", 0, 0),
        BuiltIn("__VARINFO", "information", 1, 1),
    )
}

#: Names that are refused (ST-315, ST-620), and what to do instead.
_MEMORY = Text(
    "Declare the instances, or an array of them.",
    "Die Instanzen oder ein Feld davon deklarieren.",
)
_BIT = Text("Use bit access: x.3.", "Bitzugriff verwenden: x.3.")
REFUSED: dict[str, Text] = {
    "__NEW": _MEMORY,
    "__DELETE": _MEMORY,
    "BITADR": _BIT,
    "INDEXOF": Text("Call the POU by its name.", "Die POU mit ihrem Namen aufrufen."),
    "INI": Text("Assign the values.", "Die Werte zuweisen."),
}

_CONVERSION = re.compile(r"(?:(\w+?)_)?TO_(\w+)")


def conversion(name: str) -> tuple[Type | None, Type] | None:
    """Return source and target of ``INT_TO_REAL``, ``TO_REAL`` or ``ANY_TO_REAL``.

    The source is ``None`` if any is accepted; the result is ``None`` for any other name.
    """
    match = _CONVERSION.fullmatch(name)
    if match is None:
        return None
    target = _named(match[2])
    if target is None:
        return None
    if match[1] is None or match[1].startswith("ANY"):
        return None, target
    source = _named(match[1])
    return None if source is None else (source, target)


def _named(name: str) -> Type | None:
    if name in ("STRING", "WSTRING"):
        kind: StringType = string(80, is_wide=name == "WSTRING")
        return kind
    return ELEMENTARY.get(name)
