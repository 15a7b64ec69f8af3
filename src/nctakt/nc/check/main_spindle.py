# SPDX-License-Identifier: MIT
"""``#MAIN SPINDLE``: another spindle becomes the main one.

In: the tree of a command. Out: a ``MainSpindleCommand``, shared by checker and decoder, and
diagnostics for other forms and for spindles that the channel lacks.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM
from nctakt.messages.spindles import NO_MAIN_SPINDLE, NO_SUCH_SPINDLE
from nctakt.nc.check.c_axis import spindle_name
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Bracket, Expression, HashCommand, Name
from nctakt.nc.vocabulary.commands import forms_of

_WORDS = ("MAIN", "SPINDLE")


@dataclass(frozen=True, slots=True)
class MainSpindleCommand:
    """One command: the name of a spindle or its logical number, neither for that of the list."""

    name: str = ""
    number: Expression | None = None


def is_main_spindle(command: HashCommand) -> bool:
    """Return whether it is ``#MAIN SPINDLE``."""
    return tuple(word.name for word in command.words) == _WORDS


def main_spindle_command(command: HashCommand) -> MainSpindleCommand | None:
    """Return the parsed command, ``None`` for another form."""
    if not command.arguments:
        return MainSpindleCommand()
    bracket = command.arguments[0]
    if len(command.arguments) > 1 or not isinstance(bracket, Bracket) or len(bracket.items) != 1:
        return None
    item = bracket.items[0]
    name = spindle_name(item)
    if name:
        return MainSpindleCommand(name)
    if not isinstance(item, Expression) or isinstance(item, Name):
        return None
    return MainSpindleCommand(number=item)


def check_main_spindle(
    command: HashCommand, channel: ChannelParameters, values: ValueChecker, findings: Findings
) -> bool:
    """Check the command; return false for another command."""
    if not is_main_spindle(command):
        return False
    parsed = main_spindle_command(command)
    if parsed is None:
        name = "#MAIN SPINDLE"
        findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms_of(name))
    elif not any(spindle.is_main for spindle in channel.spindles):
        findings.report(NO_MAIN_SPINDLE, command.span)
    elif parsed.number is not None:
        values.value(parsed.number)
    elif parsed.name and parsed.name not in channel.spindle_names:
        known = ", ".join(channel.spindle_names) or NOTHING
        findings.report(NO_SUCH_SPINDLE, command.span, spindle=parsed.name, known=known)
    return True
