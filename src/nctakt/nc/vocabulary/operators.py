# SPDX-License-Identifier: MIT
"""The operators and functions of NC expressions, in one table.

Data only. The parser takes names and precedence, the checker arity and where a function is allowed,
the documentation the meaning; ``kernel/base/arithmetic.py`` computes. Angles are in degrees.
Precedence: RC-206 (*choice*).
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text


@dataclass(frozen=True, slots=True)
class Operator:
    """A prefix (one operand) or infix operator; a higher ``precedence`` binds more strongly."""

    symbol: str
    precedence: int
    meaning: Text
    domain: Text
    right_associative: bool = False


@dataclass(frozen=True, slots=True)
class Function:
    """``NAME[a, …]`` with ``minimum`` to ``maximum`` arguments.

    ``decoder_only``: works on names or texts and is not allowed in a realtime cycle. ``arguments``:
    the kind of each argument, T text, N number, V any value, A a variable, parameter or function
    name; empty: all are numbers. ``is_text``: the result is a text.
    """

    name: str
    minimum: int
    maximum: int
    meaning: Text
    domain: Text
    decoder_only: bool = False
    arguments: str = ""
    is_text: bool = False


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


#: Operators before their operand.
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


#: Functions of numbers with their arguments in brackets (facts 2.2).
_OF_NUMBERS = _functions(
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
    ("FRACT", 1, 1, "the part after the point", "Teil hinter dem Komma", ANY, False),
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
)


def _asking(
    *rows: tuple[str, int, str, str, str, Text, bool],
) -> Mapping[str, Function]:
    return MappingProxyType(
        {
            name: Function(name, minimum, len(kinds), Text(en, de), domain, True, kinds, is_text)
            for name, minimum, kinds, en, de, domain, is_text in rows
        }
    )


PLACES = Text("positions from 1 to the text's length", "Stellen von 1 bis zur Länge des Textes")
LENGTHS = Text("a number not below 0", "eine Zahl nicht unter 0")
NUMBER_TEXT = Text("the text of a number", "der Text einer Zahl")

#: Functions of names and texts, not allowed in realtime cycles.
_OF_NAMES = _asking(
    (
        "EXIST",
        1,
        "A",
        "1 if the variable or M function exists",
        "1, wenn es die Variable oder M-Funktion gibt",
        NAMES,
        False,
    ),
    (
        "SIZEOF",
        1,
        "AN",
        "elements of an array, in its first or another dimension; 0 for a single value",
        "Elemente eines Feldes, in der ersten oder einer anderen Dimension; 0 bei Einzelwerten",
        NAMES,
        False,
    ),
    (
        "IS_STRING",
        1,
        "V",
        "1 if the value is a text",
        "1, wenn der Wert ein Text ist",
        ANY,
        False,
    ),
    (
        "IS_NUMBER",
        1,
        "V",
        "1 if the value is a number",
        "1, wenn der Wert eine Zahl ist",
        ANY,
        False,
    ),
    ("LEN", 1, "T", "characters of a text", "Zeichen eines Textes", ANY, False),
    (
        "FIND",
        2,
        "TT",
        "position of the second text in the first, 0 if it is not in it",
        "wo der zweite Text im ersten steht, 0, wenn nirgends",
        ANY,
        False,
    ),
    ("ORD", 1, "TN", "code of a character", "Code eines Zeichens", PLACES, False),
    (
        "LEFT",
        2,
        "TN",
        "a number of characters from the left",
        "eine Anzahl Zeichen von links",
        LENGTHS,
        True,
    ),
    (
        "RIGHT",
        2,
        "TN",
        "a number of characters from the right",
        "eine Anzahl Zeichen von rechts",
        LENGTHS,
        True,
    ),
    (
        "MID",
        3,
        "TNN",
        "a number of characters from a position on",
        "eine Anzahl Zeichen ab einer Stelle",
        PLACES,
        True,
    ),
    (
        "INSERT",
        3,
        "TTN",
        "the first text with the second after a position",
        "der erste Text mit dem zweiten hinter einer Stelle",
        PLACES,
        True,
    ),
    (
        "DELETE",
        3,
        "TNN",
        "the text without a number of characters from a position on",
        "der Text ohne eine Anzahl Zeichen ab einer Stelle",
        PLACES,
        True,
    ),
    (
        "REPLACE",
        4,
        "TTNN",
        "the first text with a number of characters from a position on replaced",
        "der erste Text, darin eine Anzahl Zeichen ab einer Stelle ersetzt",
        PLACES,
        True,
    ),
    ("REAL_TO_STR", 1, "N", "the number as text", "die Zahl als Text", ANY, True),
    ("INT_TO_STR", 1, "N", "the rounded number as text", "die gerundete Zahl als Text", ANY, True),
    ("STR_TO_REAL", 1, "T", "the number of a text", "die Zahl eines Textes", NUMBER_TEXT, False),
    (
        "STR_TO_INT",
        1,
        "T",
        "the whole number of a text",
        "die ganze Zahl eines Textes",
        NUMBER_TEXT,
        False,
    ),
)

#: Names of the functions of texts; DELETE is also an action of #RT CYCLE.
TEXT_FUNCTIONS = frozenset(_OF_NAMES)

#: All functions.
FUNCTIONS: Mapping[str, Function] = MappingProxyType({**_OF_NUMBERS, **_OF_NAMES})

#: Names with a fixed value.
CONSTANTS = ("TRUE", "FALSE", "PI")
