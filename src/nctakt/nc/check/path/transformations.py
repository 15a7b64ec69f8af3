# SPDX-License-Identifier: MIT
"""``#KIN ID``, ``#TRAFO``, ``#RTCP``, ``#TLC``, ``#PTP``, ``#ORI MODE``, ``#TOOL ORI CS`` (MO-8).

In: the tree of a command. Out: diagnostics for any other form.
"""

from __future__ import annotations

from nctakt.messages.path.motion import COMMAND_WORD_NOT_SIMULATED
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.coordinates import TRANSFORMATION_COMMANDS, transformation_command
from nctakt.nc.tree import Expression, HashCommand
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.orientation import ANGLE, VECTOR

#: Modes of ``#ORI MODE`` that belong to robots with six axes (P-CHAN-00177).
_OF_SIX_AXES = ("VECTOR_ABC", "VECTOR_IJK")


def check_transformation(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check the command; return false for another command."""
    words = [word.name for word in command.words]
    if " ".join(words) not in TRANSFORMATION_COMMANDS:
        return False
    parsed = transformation_command(command)
    if parsed is None:
        name = "#" + " ".join(words)
        written = findings.written(command.span).upper()
        other = next((word for word in _OF_SIX_AXES if word in written), "")
        if words == ["ORI", "MODE"] and other:
            names = f"{ANGLE}, {VECTOR}"
            findings.report(
                COMMAND_WORD_NOT_SIMULATED, command.span, command=name, word=other, names=names
            )
            return True
        forms = forms_of(name, f"#{words[0]}")
        findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms)
        return True
    for value in parsed.values:
        if isinstance(value, Expression):
            values.value(value)
    return True
