# SPDX-License-Identifier: MIT
"""Splines: ``#SPLINE``, ``#AKIMA`` and their old forms, G150 and G151 (MO-18).

In: commands and blocks. Out: diagnostics.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.messages.path.splines import INVALID_SPLINE_VECTOR, INVALID_TRANSITION
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.path import (
    SPLINE_COMMANDS,
    SWITCHES,
    VECTORS,
    command_name,
    is_transition,
    transitions,
)
from nctakt.nc.tree import (
    AxisWord,
    Block,
    Expression,
    HashCommand,
    Number,
    Word,
)
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.simplifications import AKIMA_CURVE, BSPLINE_CURVE


def check_spline_command(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check one of these commands; return false for any other."""
    name = command_name(command)
    if name not in SPLINE_COMMANDS:
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
