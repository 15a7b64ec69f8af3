# SPDX-License-Identifier: MIT
"""M, H and T functions <-> their codes, the numbers by which the realtime part knows them.

In: letter and number, ``("M", 100)``. Out: the code, and the other way round. A code is the number
of an M function, the negative number - 1 of an H function, ``codes.FIRST_T`` + the number of a tool
for T, so that one number holds all three.
"""

from __future__ import annotations

from nctakt.kernel import codes

#: Letters of functions in their order in the HLI.
LETTERS = ("M", "H", "T")


def code_of(letter: str, number: int) -> int:
    """Return the code of a function."""
    if letter == "H":
        return -number - 1
    return codes.FIRST_T + number if letter == "T" else number


def function_of(code: float) -> tuple[str, int]:
    """Return letter and number of the function with this code."""
    number = int(code)
    if number < 0:
        return "H", -number - 1
    return ("T", number - codes.FIRST_T) if number >= codes.FIRST_T else ("M", number)


def function_name(code: float) -> str:
    """Return the function with this code as in a program: ``M100``."""
    letter, number = function_of(code)
    return f"{letter}{number}"
