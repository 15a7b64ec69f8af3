# SPDX-License-Identifier: MIT
"""``#FACE`` and ``#CYL``: planes that turn with a rotary axis (language: C axis).

In: the tree of a command. Out: diagnostics for any other form.
"""

from __future__ import annotations

from collections.abc import Collection

from nctakt.messages.path.rotating_planes import UNKNOWN_AXIS_OF_PLANE
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.coordinates import PLANE_COMMANDS, plane_command
from nctakt.nc.tree import HashCommand
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.support_level import hash_command

#: The word of planes with two rotary axes.
_TWO_ROTARY = "2ROT"


def check_plane_command(
    command: HashCommand, axes: Collection[str], values: ValueChecker, findings: Findings
) -> bool:
    """Check the command; return false for another command. ``axes``: those of the channel."""
    name = " ".join(word.name for word in command.words)
    if name not in PLANE_COMMANDS:
        return False
    parsed = plane_command(command)
    two_rotary = hash_command((name, _TWO_ROTARY))
    if _TWO_ROTARY in findings.written(command.span).upper() and two_rotary is not None:
        findings.report_support(two_rotary, command.span)
        return True
    if parsed is None:
        forms = forms_of(f"#{name.partition(' ')[0]}")
        findings.report(INVALID_COMMAND_FORM, command.span, command=f"#{name}", forms=forms)
        return True
    for axis in parsed.axes:
        if axis not in axes:
            known = ", ".join(axes)
            findings.report(UNKNOWN_AXIS_OF_PLANE, command.span, axis=axis, known=known)
    if parsed.radius is not None:
        values.value(parsed.radius)
    return True
