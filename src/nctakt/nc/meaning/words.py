# SPDX-License-Identifier: MIT
"""Bounds, names and keywords that checker and decoder read in words and commands."""

from __future__ import annotations

import re

from nctakt.lists.declared.variables import SCALARS
from nctakt.nc.meaning.path import keywords
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword

#: Bounds of the value of an M or H function: signed, 32 bits.
MIN_VALUE, MAX_VALUE = -(2**31), 2**31 - 1

#: Maximum number of a parameter of a call.
CALL_PARAMETERS = 200

_PARAMETER = re.compile(r"@P(\d+)")

#: Keywords of modal calls: after each block with a motion, after each block.
MODAL_MOVE = ("MODAL_MOVE", "MODAL")

MODAL_BLOCK = "MODAL_BLOCK"


def parameter_number(keyword: Keyword) -> int | None:
    """Return the number of ``@P1 = …``; ``None`` for any other keyword."""
    match = _PARAMETER.fullmatch(keyword.name)
    number = 0 if match is None else int(match[1][:4])
    return number if 1 <= number <= CALL_PARAMETERS else None


#: The words of ``#MEAS MODE``.
MEASURING_MODE = ["MEAS", "MODE"]


def is_for_simulation(command: HashCommand) -> bool:
    """Return whether a checked command marks a part that only simulated motion leaves out."""
    return any(item.name == "SIMULATE" for item in keywords(command))


#: Types in declarations: name -> type. REAL is short for REAL64.
DECLARED_TYPES = {
    **{name: name for name, scalar in SCALARS.items() if scalar.is_numeric},
    "REAL": "REAL64",
    "STRING": "STRING",
}

#: The highest ID of a realtime cycle.
HIGHEST_CYCLE_ID = 2147483647

SINGLE_STEP_OFF = "DISABLE"

_AXIS_SIGNS = {"+": 1, "-": -1}

#: The commands, with the largest number of values in their bracket.
TOOL_COMMANDS = {
    "TOOL DATA": 3,
    "TOOL PREP": 3,
    "TOOL REFRESH": 0,
    "TOOL LIFE READ": 3,
    "TOOL LIFE REMOVE": 0,
    "TOOL LIFE DEF": 0,
}


def numbers_of(command: HashCommand) -> tuple[Expression, ...] | None:
    """Return the numbers of an ID in the bracket of a command; ``None`` for another form."""
    highest = TOOL_COMMANDS[" ".join(word.name for word in command.words)]
    if highest == 0:
        return None if command.arguments else ()
    bracket = command.arguments[0] if len(command.arguments) == 1 else None
    if not isinstance(bracket, Bracket) or not 0 < len(bracket.items) <= highest:
        return None
    numbers = tuple(item for item in bracket.items if isinstance(item, Expression))
    return numbers if len(numbers) == len(bracket.items) else None


def signed_axis(command: HashCommand) -> tuple[str, int] | None:
    """Return the axis of ``#TLAX [Z-]`` with its sign; ``None`` for another form."""
    bracket = command.arguments[0] if len(command.arguments) == 1 else None
    item = bracket.items[0] if isinstance(bracket, Bracket) and len(bracket.items) == 1 else None
    if not isinstance(item, Keyword) or item.name[-1] not in _AXIS_SIGNS:
        return None
    return item.name[:-1], _AXIS_SIGNS[item.name[-1]]


ERROR_KEYWORDS = (
    "ID",
    "RC",
    "MID",
    *(f"{kind}{number}" for number in range(1, 6) for kind in ("PV", "PM", "PIV")),
)
