# SPDX-License-Identifier: MIT
"""The parameters that a complete vendor's set has: each with ID, type, default, unit, meaning.

The IDs are those of the manuals' parameter tables that this project promises, list by list.
"""

from __future__ import annotations

import pytest

from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.format.parameter import Parameter, ValueType

#: Kind of list -> what its IDs begin with, and their numbers.
PROMISED = {
    "startup": ("STUP", "1 9 10 11 12 14 15 33 34 35 37 70 71 111 112 145 146 169 170"),
    "channel": (
        "CHAN",
        "3 6 7 25 26 27 29 30 35 36 39 40 41 42 43 44 45 46 47 48 49 51 53 54 56 63 69 71 79 80 81"
        " 82 99 108 118 119 187 235 252 401 402 403 404 406 407 409 410 411 424 425 426 427 480",
    ),
    "axis": (
        "AXIS",
        "1 2 3 4 5 6 8 11 12 15 16 18 99 109 126 127 155 177 178 179 195 196 197 198 199 200 201"
        " 209 211 212 214 221 236 276 297 457 491",
    ),
    "variables": ("EXTV", "1 2 3 4 5 6 7 8 10 15 16 17 18 19 20 21 22"),
    "rtconf": ("RTCF", "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 17 18"),
}
#: The table of the manual itself: default 0 means not configured, and is outside of the range.
OUTSIDE_OF_ITS_RANGE = ("interrupt_source",)


def _all(kind: str) -> list[Parameter]:
    (schema,) = [one for one in SCHEMAS if one.kind == kind]
    return list(schema.parameters)


@pytest.mark.parametrize("kind", PROMISED)
def test_each_promised_parameter_is_declared(kind: str) -> None:
    """By its ID."""
    family, numbers = PROMISED[kind]
    declared = {parameter.id for parameter in _all(kind)}
    missing = [
        number for number in numbers.split() if f"P-{family}-{int(number):05}" not in declared
    ]
    assert missing == []


@pytest.mark.parametrize("kind", PROMISED)
def test_each_declaration_is_complete(kind: str) -> None:
    """Meanings in both languages; a type, bounds and a default that keeps them."""
    for parameter in _all(kind):
        assert parameter.text.en, parameter.path
        assert parameter.text.de, parameter.path
        assert isinstance(parameter.type, ValueType), parameter.path
        if parameter.type is ValueType.BOOLEAN or parameter.path in OUTSIDE_OF_ITS_RANGE:
            continue
        if isinstance(parameter.default, int | float):
            low, high = parameter.bounds
            assert low <= parameter.default <= high, parameter.path
