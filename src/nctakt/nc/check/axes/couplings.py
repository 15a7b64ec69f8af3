# SPDX-License-Identifier: MIT
"""``#SET AX LINK``, ``#AX LINK``, ``#ENABLE AX LINK``, ``#DISABLE AX LINK``: coupled axes.

In: the tree of a command. Out: diagnostics for other forms and names. Values are checked when
they are decoded.
"""

from __future__ import annotations

from collections.abc import Collection

from nctakt.lists.machine.couplings import MAX_PAIRS
from nctakt.messages.axes.couplings import DENOMINATOR_MISSING, TOO_MANY_PAIRS, UNKNOWN_COUPLED_AXIS
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.axes import coupling_command, is_coupling
from nctakt.nc.tree import HashCommand
from nctakt.nc.vocabulary.commands import forms_of


def check_coupling(
    command: HashCommand, known: Collection[str], values: ValueChecker, findings: Findings
) -> bool:
    """Check one of these commands; return false for any other.

    ``known``: the names of axes and spindles.
    """
    if not is_coupling(command):
        return False
    parsed = coupling_command(command)
    if parsed is None:
        name = "#" + " ".join(word.name for word in command.words[:3])
        findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms_of(name))
        return True
    if parsed.group is not None:
        values.block(parsed.group)
    if len(parsed.pairs) > MAX_PAIRS:
        findings.report(TOO_MANY_PAIRS, command.span, limit=MAX_PAIRS)
    for pair in parsed.pairs:
        for expression in pair.expressions:
            values.block(expression)
        if len(pair.factor) == 1:
            findings.report(DENOMINATOR_MISSING, pair.span)
        for axis in (pair.slave, pair.master):
            if isinstance(axis, str) and axis not in known:
                text = ", ".join(known)
                findings.report(UNKNOWN_COUPLED_AXIS, pair.span, axis=axis, known=text)
    return True
