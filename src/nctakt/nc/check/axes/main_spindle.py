# SPDX-License-Identifier: MIT
"""``#MAIN SPINDLE``: another spindle becomes the main spindle.

In: the tree of a command. Out: diagnostics for other forms and for spindles that the channel
lacks.
"""

from __future__ import annotations

from nctakt.base.diagnostics import NOTHING
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.axes.spindles import NO_MAIN_SPINDLE, NO_SUCH_SPINDLE
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.axes import main_spindle_command
from nctakt.nc.tree import HashCommand
from nctakt.nc.vocabulary.commands import forms_of

_WORDS = ("MAIN", "SPINDLE")


def is_main_spindle(command: HashCommand) -> bool:
    """Return whether it is ``#MAIN SPINDLE``."""
    return tuple(word.name for word in command.words) == _WORDS


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
