# SPDX-License-Identifier: MIT
"""The operators and functions of NC expressions: one table for all who deal with them.

Data only. The parser takes names and precedence from here, the checker arity and where a function
may stand, the documentation the meaning; the numeric functions themselves are in
``kernel/arithmetic.py``. Angles are in degrees. Precedence: RC-206 (*choice*).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from nctakt.diagnostics import Text


@dataclass(frozen=True, slots=True)
class Operator:
    """A prefix (one operand) or infix operator; the higher ``precedence`` binds stronger."""

    symbol: str
    precedence: int
    meaning: Text
    domain: Text
    right_associative: bool = False


@dataclass(frozen=True, slots=True)
class Function:
    """``NAME[a, …]`` with ``minimum`` to ``maximum`` arguments.

    ``decoder_only``: asks about names or texts, so it has no place in a realtime cycle.
    """

    name: str
    minimum: int
    maximum: int
    meaning: Text
    domain: Text
    decoder_only: bool = False


ANY = Text("any values", "beliebige Werte")
WHOLE = Text("rounded; whole numbers below 2^53", "gerundet; ganze Zahlen unter 2^53")
DIVISOR = Text("the right operand is not 0", "der rechte Operand ist nicht 0")
POWER = Text(
    "a negative base has a whole exponent, base 0 none below 0",
    "eine negative Basis hat einen ganzen Exponenten, Basis 0 keinen unter 0",
)
TRUTH = Text("true is |value| ≥ 0.5", "wahr ist |Wert| ≥ 0,5")
EXACT = Text("any values, compared exactly", "beliebige Werte, exakt verglichen")


def _operators(*rows: tuple[str, int, str, str, Text]) -> Mapping[str, Operator]:
    return MappingProxyType(
        {
            symbol: Operator(symbol, precedence, Text(en, de), domain, symbol == "**")
            for symbol, precedence, en, de, domain in rows
        }
    )


#: Operators in front of their operand.
PREFIX = _operators(
    ("-", 11, "the value with its sign changed", "der Wert mit anderem Vorzeichen", ANY),
    ("NOT", 11, "1 if the value is false, else 0", "1, wenn der Wert falsch ist, sonst 0", TRUTH),
)

#: Operators between two operands, from the strongest to the weakest.
INFIX = _operators(
    ("**", 12, "left to the power of right", "links hoch rechts", POWER),
    ("*", 10, "product", "Produkt", ANY),
    ("/", 10, "quotient", "Quotient", DIVISOR),
    ("MOD", 10, "remainder, sign of the left", "Rest, Vorzeichen von links", DIVISOR),
    ("+", 9, "sum; texts are joined", "Summe; Texte werden verkettet", ANY),
    ("-", 9, "difference", "Differenz", ANY),
    ("==", 8, "1 if equal", "1, wenn gleich", EXACT),
    ("!=", 8, "1 if different", "1, wenn verschieden", EXACT),
    (">=", 8, "1 if greater or equal", "1, wenn größer oder gleich", EXACT),
    ("<=", 8, "1 if less or equal", "1, wenn kleiner oder gleich", EXACT),
    ("<", 8, "1 if less", "1, wenn kleiner", EXACT),
    (">", 8, "1 if greater", "1, wenn größer", EXACT),
    ("&", 7, "bits that both have", "Bits, die beide haben", WHOLE),
    ("^", 6, "bits that one of both has", "Bits, die genau einer hat", WHOLE),
    ("|", 5, "bits that any has", "Bits, die mindestens einer hat", WHOLE),
    ("&&", 4, "1 if both are true", "1, wenn beide wahr sind", TRUTH),
    ("XOR", 3, "1 if exactly one is true", "1, wenn genau einer wahr ist", TRUTH),
    ("||", 2, "1 if any is true", "1, wenn mindestens einer wahr ist", TRUTH),
)

UNIT_INTERVAL = Text("−1 … 1", "−1 … 1")
NOT_NEGATIVE = Text("not below 0", "nicht unter 0")
POSITIVE = Text("above 0", "über 0")
NO_POLE_TAN = Text("not an odd multiple of 90°", "kein ungerades Vielfaches von 90°")
NO_POLE_COT = Text("not a multiple of 180°", "kein Vielfaches von 180°")
FINITE = Text("the result is finite", "das Ergebnis ist endlich")
NOT_BOTH_ZERO = Text("not both 0", "nicht beide 0")
NAMES = Text("the name of a variable", "der Name einer Variablen")


def _functions(*rows: tuple[str, int, int, str, str, Text, bool]) -> Mapping[str, Function]:
    return MappingProxyType(
        {
            name: Function(name, minimum, maximum, Text(en, de), domain, decoder_only)
            for name, minimum, maximum, en, de, domain, decoder_only in rows
        }
    )


#: Functions with their arguments in brackets (facts 2.2).
FUNCTIONS = _functions(
    ("ABS", 1, 1, "absolute value", "Betrag", ANY, False),
    ("SQR", 1, 1, "square", "Quadrat", ANY, False),
    ("SQRT", 1, 1, "square root", "Quadratwurzel", NOT_NEGATIVE, False),
    ("EXP", 1, 1, "e to the power of the value", "e hoch Wert", FINITE, False),
    ("LN", 1, 1, "natural logarithm", "natürlicher Logarithmus", POSITIVE, False),
    ("DEXP", 1, 1, "10 to the power of the value", "10 hoch Wert", FINITE, False),
    ("LOG", 1, 1, "logarithm to base 10", "Logarithmus zur Basis 10", POSITIVE, False),
    ("SIN", 1, 1, "sine of degrees", "Sinus von Grad", ANY, False),
    ("COS", 1, 1, "cosine of degrees", "Kosinus von Grad", ANY, False),
    ("TAN", 1, 1, "tangent of degrees", "Tangens von Grad", NO_POLE_TAN, False),
    ("COT", 1, 1, "cotangent of degrees", "Kotangens von Grad", NO_POLE_COT, False),
    ("ASIN", 1, 1, "angle of a sine", "Winkel eines Sinus", UNIT_INTERVAL, False),
    ("ACOS", 1, 1, "angle of a cosine", "Winkel eines Kosinus", UNIT_INTERVAL, False),
    ("ATAN", 1, 1, "angle of a tangent", "Winkel eines Tangens", ANY, False),
    ("ATAN2", 2, 2, "angle of y, x", "Winkel von y, x", NOT_BOTH_ZERO, False),
    ("ACOT", 1, 1, "angle of a cotangent", "Winkel eines Kotangens", ANY, False),
    ("INT", 1, 1, "the whole part", "ganzzahliger Teil", ANY, False),
    ("FRACT", 1, 1, "the part behind the point", "Teil hinter dem Komma", ANY, False),
    (
        "ROUND",
        1,
        1,
        "nearest whole number, half to even",
        "nächste ganze Zahl, halbe zur geraden",
        ANY,
        False,
    ),
    ("CEIL", 1, 1, "next whole number above", "nächste ganze Zahl darüber", ANY, False),
    ("FLOOR", 1, 1, "next whole number below", "nächste ganze Zahl darunter", ANY, False),
    ("INV", 1, 1, "all bits inverted", "alle Bits umgekehrt", WHOLE, False),
    (
        "EXIST",
        1,
        1,
        "1 if the variable or M function exists",
        "1, wenn es die Variable oder M-Funktion gibt",
        NAMES,
        True,
    ),
    ("SIZEOF", 1, 2, "elements of an array", "Elemente eines Feldes", NAMES, True),
    ("IS_STRING", 1, 1, "1 if the value is a text", "1, wenn der Wert ein Text ist", ANY, True),
    ("IS_NUMBER", 1, 1, "1 if the value is a number", "1, wenn der Wert eine Zahl ist", ANY, True),
    ("REAL_TO_STR", 1, 1, "the number as text", "die Zahl als Text", ANY, True),
)

#: Names with a fixed value.
CONSTANTS = ("TRUE", "FALSE", "PI")
