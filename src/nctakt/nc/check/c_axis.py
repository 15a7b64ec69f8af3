# SPDX-License-Identifier: MIT
"""``#CAX``: the main spindle becomes an axis of the path.

In: the tree of a command. Out: a ``CAxisCommand``, shared by checker and decoder, and diagnostics
for other forms. The name of the axis is known from the command on.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Text
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.axis_exchange import UNSUITABLE_AXIS_NAME
from nctakt.messages.c_axis import NO_NAME_OF_C_AXIS, NOT_THE_MAIN_SPINDLE
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM
from nctakt.messages.rotating_planes import NO_C_AXIS
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.signals import axis_name
from nctakt.nc.parse.block_words import AXIS_LETTERS
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Number
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.variable_table import NameTable

_WORDS = (("CAX",), ("CAX", "OFF"))
_MEANING = Text(
    "the spindle stops, and its axis stands at the first free index from 3 on, at the spindle's "
    "angle; #CAX OFF or the next program ends it",
    "die Spindel hält an, und ihre Achse steht am ersten freien Index ab 3, im Winkel der Spindel; "
    "#CAX OFF oder das nächste Programm beendet es",
)


@dataclass(frozen=True, slots=True)
class CAxisCommand:
    """One command; ``spindle`` and ``name``: empty where they are left out."""

    is_on: bool
    spindle: str = ""
    name: str = ""


def is_c_axis(command: HashCommand) -> bool:
    """Return whether it is ``#CAX`` or ``#CAX OFF``."""
    return tuple(word.name for word in command.words) in _WORDS


def c_axis_command(command: HashCommand) -> CAxisCommand | None:
    """Return the parsed command, ``None`` for another form."""
    is_on = len(command.words) == 1
    if not command.arguments:
        return CAxisCommand(is_on)
    bracket = command.arguments[0]
    if not is_on or len(command.arguments) > 1 or not isinstance(bracket, Bracket):
        return None
    names = [spindle_name(item) for item in bracket.items]
    if not all(names) or not 0 < len(names) <= 2:
        return None
    return CAxisCommand(True, names[0] if len(names) == 2 else "", names[-1])


def spindle_name(item: Keyword | Expression) -> str:
    """Return a name in brackets; ``S2`` reads as the word S with the value 2."""
    match item:
        case Keyword(value=Number(value=value)) if value == int(value):
            return f"{item.name}{int(value)}"
    return axis_name(item)


def check_c_axis(
    command: HashCommand,
    channel: ChannelParameters,
    names: NameTable,
    findings: Findings,
) -> str:
    """Check the command; return the name of the axis that the channel has then, or nothing."""
    parsed = c_axis_command(command)
    if parsed is None:
        findings.report(INVALID_COMMAND_FORM, command.span, command="#CAX", forms=forms_of("#CAX"))
        return ""
    if not parsed.is_on:
        return ""
    main = next((one for one in channel.spindles if one.is_main), None)
    if parsed.spindle and (main is None or parsed.spindle not in (main.name, main.list_name)):
        known = NOTHING if main is None else main.name
        findings.report(NOT_THE_MAIN_SPINDLE, command.span, spindle=parsed.spindle, main=known)
        return ""
    if main is None or main.plc_controlled or not names.can_fetch(main.logical_number):
        findings.report(NO_C_AXIS, command.span, command="#CAX")
        return ""
    name = parsed.name or channel.c_axis_name
    if not name:
        findings.report(NO_NAME_OF_C_AXIS, command.span)
        return ""
    if name[0] not in AXIS_LETTERS:
        findings.report(UNSUITABLE_AXIS_NAME, command.span, name=name)
        return ""
    findings.report_simplified("#CAX", _MEANING, command.span)
    names.learn_axis(name, main.logical_number)
    return name
