# SPDX-License-Identifier: MIT
"""Splines: ``#SPLINE``, ``#AKIMA`` and their old forms, G150 and G151 (MO-18).

In: commands and blocks. Out: diagnostics. Shared by checker and decoder.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.whole_numbers import is_whole
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM
from nctakt.messages.splines import INVALID_SPLINE_VECTOR, INVALID_TRANSITION
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import (
    AxisWord,
    Block,
    Bracket,
    Expression,
    HashCommand,
    Keyword,
    Name,
    Number,
    Word,
)
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.simplifications import AKIMA_CURVE, BSPLINE_CURVE

#: Words that switch, as they are written, with what they mean.
SWITCHES = {
    "#SPLINE ON": True,
    "#SPLINE OFF": False,
    "#SET SPLINE ON": True,
    "#SET SPLINE OFF": False,
}
#: Words of a direction, with whether it is that of the start.
VECTORS = {
    "#AKIMA STARTVECTOR": True,
    "#AKIMA ENDVECTOR": False,
    "#SET ASPLINE STARTTANG": True,
    "#SET ASPLINE ZIELTANG": False,
}
#: Commands without words of a block.
COMMANDS = frozenset(
    (
        "SPLINE TYPE AKIMA",
        "SPLINE TYPE BSPLINE",
        "SET SPLINETYPE AKIMA",
        "SET SPLINETYPE BSPLINE",
        "AKIMA TRANS",
        "SET ASPLINE MODE",
    )
)
TRANSITIONS = ("AUTO", "TANGENTIAL", "USER")


def spline_name(command: HashCommand) -> str:
    """Return the words of a command."""
    return " ".join(word.name for word in command.words)


def transitions(command: HashCommand) -> tuple[str | Expression | None, str | Expression | None]:
    """Return start and end of ``#AKIMA TRANS`` or ``#SET ASPLINE MODE``; ``None``: not given.

    Raises ``ValueError`` for another form.
    """
    if not command.arguments:
        return (None, None)
    if len(command.arguments) > 1 or not isinstance(command.arguments[0], Bracket):
        raise ValueError
    items = command.arguments[0].items
    if spline_name(command) == "SET ASPLINE MODE":
        if len(items) != 2 or any(isinstance(item, Keyword) for item in items):
            raise ValueError
        first, second = items
        assert isinstance(first, Expression)
        assert isinstance(second, Expression)
        return (first, second)
    found: dict[str, str | Expression | None] = {"START": None, "END": None}
    for item in items:
        if not isinstance(item, Keyword) or item.name not in found:
            raise ValueError
        if not isinstance(item.value, Name) or item.value.name not in TRANSITIONS:
            raise ValueError
        found[item.name] = item.value.name
    return (found["START"], found["END"])


def is_transition(number: float) -> bool:
    """Return whether a number stands for one of ``TRANSITIONS``, counted from 1."""
    return is_whole(number, 1, len(TRANSITIONS))


def check_spline_command(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check one of these commands; return false for any other."""
    name = spline_name(command)
    if name not in COMMANDS:
        return False
    if name.endswith("BSPLINE"):
        findings.report_simplified("#SPLINE TYPE BSPLINE", BSPLINE_CURVE, command.span)
    try:
        if name.endswith(("AKIMA", "BSPLINE")) and command.arguments:
            raise ValueError
        for value in transitions(command):
            if isinstance(value, Number) and not is_transition(value.value):
                findings.report(INVALID_TRANSITION, value.span, value=value.value)
            elif isinstance(value, Expression):
                values.value(value)
    except ValueError:
        shown = "#AKIMA TRANS" if name in ("AKIMA TRANS", "SET ASPLINE MODE") else "#SPLINE TYPE"
        forms = forms_of(shown)
        findings.report(INVALID_COMMAND_FORM, command.span, command=f"#{name}", forms=forms)
    return True


def check_spline_words(block: Block, main_axes: Sequence[str], findings: Findings) -> bool:
    """Check the words of splines in a block; return whether there are any."""
    words = [word for word in block.words if isinstance(word, Word) and word.value is None]
    for word in words:
        if SWITCHES.get(word.name):
            findings.report_simplified("G151", AKIMA_CURVE, word.span)
        if word.name in VECTORS:
            given = {other.name: other for other in block.words if isinstance(other, AxisWord)}
            numbers = [
                axis.value.value
                for name, axis in given.items()
                if name in main_axes and isinstance(axis.value, Number)
            ]
            is_zero = len(numbers) == len(main_axes) and not any(numbers)
            if is_zero or any(name not in given for name in main_axes):
                findings.report(
                    INVALID_SPLINE_VECTOR,
                    word.span,
                    command=word.name,
                    axes=", ".join(main_axes),
                    example=" ".join(f"{name}1" for name in main_axes),
                )
    return any(word.name in SWITCHES or word.name in VECTORS for word in words)
