# SPDX-License-Identifier: MIT
"""``#MCS``, ``#WCS TO MCS``, ``#MCS TO WCS``: machine coordinates in a program (MO-8).

In: the tree of a command. Out: diagnostics for any other form.
"""

from __future__ import annotations

from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.coordinates import MACHINE_COMMANDS, machine_command
from nctakt.nc.tree import HashCommand
from nctakt.nc.vocabulary.commands import forms_of


def check_machine_command(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check the command; return false for another command."""
    name = " ".join(word.name for word in command.words)
    if name not in MACHINE_COMMANDS:
        return False
    parsed = machine_command(command)
    if parsed is None:
        forms = forms_of("#MCS" if name.startswith("MCS O") else f"#{name}")
        findings.report(INVALID_COMMAND_FORM, command.span, command=f"#{name}", forms=forms)
    elif parsed.system is not None:
        values.value(parsed.system)
    return True
