# SPDX-License-Identifier: MIT
"""Prints the bits of many results of ``nctakt.kernel.base.arithmetic``, for two processes to
compare."""

from __future__ import annotations

import json
import math
import random
import struct
import sys

from nctakt.base import mode
from nctakt.kernel.base import arithmetic

UNARY = (
    "floor",
    "ceiling",
    "truncate",
    "fraction",
    "round_half_even",
    "square_root",
    "exponential",
    "decimal_exponential",
    "natural_logarithm",
    "decimal_logarithm",
    "sine",
    "cosine",
    "tangent",
    "cotangent",
    "arc_sine",
    "arc_cosine",
    "arc_tangent",
    "arc_cotangent",
    "bit_invert",
    "is_true",
    "is_finite",
    "is_bit_pattern",
)
BINARY = ("divide", "modulo", "power", "arc_tangent_2", "bit_and", "bit_or", "bit_xor")
TERNARY = ("within",)


def operands() -> list[float]:
    """Special values, round ones, and random bit patterns, always the same."""
    chance = random.Random(20_25)
    special = [0.0, -0.0, math.inf, -math.inf, math.nan, 5e-324, 1.7976931348623157e308]
    special += [0.5, -0.5, 1.5, 2.5, 4503599627370495.5, 9007199254740991.0, 9007199254740992.0]
    special += [float(angle) for angle in range(-720, 721, 15)]
    special += [n / 8 for n in range(-32, 33)]
    special += [chance.uniform(-1, 1) * 10.0 ** chance.randint(-12, 12) for _ in range(300)]
    bits = [struct.unpack("=d", struct.pack("=Q", chance.getrandbits(64)))[0] for _ in range(300)]
    return special + bits


def bits_of(value: float) -> str:
    """The bits; all NaN are one, since their signs are the processor's."""
    number = float(value)
    return "nan" if math.isnan(number) else struct.pack(">d", number).hex()


def table() -> dict[str, list[str]]:
    """The results by function."""
    values = operands()
    chance = random.Random(7)
    pairs = [(chance.choice(values), chance.choice(values)) for _ in range(2500)]
    found = {name: [bits_of(getattr(arithmetic, name)(one)) for one in values] for name in UNARY}
    for name in BINARY:
        function = getattr(arithmetic, name)
        found[name] = [bits_of(function(left, right)) for left, right in pairs]
    for name in TERNARY:
        function = getattr(arithmetic, name)
        found[name] = [bits_of(function(left, right, 360.0)) for left, right in pairs]
    return found


if __name__ == "__main__":
    json.dump({"compiled": mode.is_compiled(), "table": table()}, sys.stdout)
