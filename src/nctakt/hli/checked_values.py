# SPDX-License-Identifier: MIT
"""Values from outside, checked for the type of their target (RC-307).

In: names as a user writes them, values of Python. Out: the converted value; a wrong one is a
``Failure``.
"""

from __future__ import annotations

import math
import re

from nctakt.base.failure import Failure
from nctakt.hli.layout import PANEL, SPINDLE_OVERRIDE, TOOL_ANSWER, Entry
from nctakt.kernel.base import arithmetic
from nctakt.lists.declared.variables import SCALARS
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import VALUE_NOT_OF_TYPE, VARIABLE_NOT_SETTABLE
from nctakt.messages.plcs.hli_table import NUMBER_NOT_TAKEN
from nctakt.messages.programs.decoder import VALUE_OUTSIDE_TYPE_RANGE
from nctakt.messages.programs.realtime import VALUE_NOT_FINITE
from nctakt.nc.vocabulary.variables import strings

_CHANNEL = re.compile(r"\s*[Cc][Hh](\d{1,4})\.")


def split_channel(name: str) -> tuple[str, int, str]:
    """Divide ``CH2.V.E.X`` into ``("CH2.", 2, "V.E.X")``; channel 1 for a name without one."""
    match = _CHANNEL.match(name)
    if match is None:
        return "", 1, name
    return match[0].strip(), int(match[1]), name[match.end() :]


def command_number(name: str, entry: Entry, value: float | bool | str) -> float:
    """Return the checked value of a command; only signed ones may be below 0."""
    if entry not in (*PANEL, *TOOL_ANSWER, SPINDLE_OVERRIDE):
        raise Failure(diagnostic(VARIABLE_NOT_SETTABLE, name=name))
    if isinstance(value, str):
        raise Failure(diagnostic(VALUE_NOT_OF_TYPE, name=name, type=entry.type, value=value))
    number = number_of(name, entry.type, float(value))
    if number < 0.0 and not entry.is_signed:
        high = SCALARS["REAL64"].high
        raise Failure(
            diagnostic(VALUE_OUTSIDE_TYPE_RANGE, name=name, value=number, low=0, high=high)
        )
    tie = entry.tie
    if tie is not None and not tie.takes(number):
        raise Failure(diagnostic(NUMBER_NOT_TAKEN, path=name, value=number, known=tie.taken))
    return number


def characters_of(name: str, type_: str, size_bytes: int, text: str) -> bytes:
    """Return the bytes of a text, padded with zeros to ``size_bytes``."""
    wrong = strings.misfit(name, type_, size_bytes, text)
    if wrong is not None:
        raise Failure(diagnostic(wrong[0], None, "", **wrong[1]))
    return strings.encode(text, size_bytes)


def number_of(name: str, type_: str, number: float) -> float:
    """Return the number as converted for a variable of this type (RC-307)."""
    if not math.isfinite(number):
        raise Failure(diagnostic(VALUE_NOT_FINITE, name=name, value=number))
    scalar = SCALARS[type_]
    if type_ == "BOOLEAN":
        number = 1.0 if arithmetic.is_true(number) else 0.0
    elif scalar.is_integer:
        number = arithmetic.round_half_even(number)
    if not scalar.low <= number <= scalar.high:
        raise Failure(
            diagnostic(
                VALUE_OUTSIDE_TYPE_RANGE,
                name=name,
                value=number,
                low=scalar.low,
                high=scalar.high,
            )
        )
    return number
