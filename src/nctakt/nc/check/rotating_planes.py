# SPDX-License-Identifier: MIT
"""``#FACE`` and ``#CYL``: planes that turn with a rotary axis (language: C axis).

In: the tree of a command. Out: a ``PlaneCommand``, and diagnostics for any other form. Shared by
checker and decoder.
"""

from __future__ import annotations

from collections.abc import Collection

from nctakt.base.dataclass import dataclass
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM
from nctakt.messages.rotating_planes import UNKNOWN_AXIS_OF_PLANE
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.support_level import hash_command

#: Commands with the number of axes in their bracket.
PLANE_COMMANDS = {"FACE": 2, "FACE OFF": 0, "CYL": 3, "CYL OFF": 0}
#: The word of planes with two rotary axes.
_TWO_ROTARY = "2ROT"


@dataclass(frozen=True, slots=True)
class PlaneCommand:
    """One of these commands; ``axes``: names; ``radius``: that behind the third name of #CYL."""

    name: str
    axes: tuple[str, ...] = ()
    radius: Expression | None = None

    @property
    def shown(self) -> str:
        """The command as it is written."""
        return f"#{self.name}"


def plane_command(command: HashCommand) -> PlaneCommand | None:
    """Return the parsed command; ``None`` if its form is unknown."""
    name = " ".join(word.name for word in command.words)
    count = PLANE_COMMANDS[name]
    if count == 0:
        return None if command.arguments else PlaneCommand(name)
    if len(command.arguments) != 1 or not isinstance(command.arguments[0], Bracket):
        return None
    items = command.arguments[0].items
    if len(items) != count:
        return None
    axes: list[str] = []
    radius: Expression | None = None
    for index, item in enumerate(items):
        value = item.value if isinstance(item, Keyword) else None
        if not isinstance(item, Name | Keyword) or (value is None) == (index == 2):
            return None
        axes.append(item.name)
        radius = value
    return PlaneCommand(name, tuple(axes), radius)


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
