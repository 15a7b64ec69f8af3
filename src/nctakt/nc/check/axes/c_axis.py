# SPDX-License-Identifier: MIT
"""``#CAX``: the main spindle becomes an axis of the path.

In: the tree of a command. Out: diagnostics for other forms. The name of the axis is known from
the command on.
"""

from __future__ import annotations

from nctakt.base.diagnostics import NOTHING, Text
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.axes.axis_exchange import UNSUITABLE_AXIS_NAME
from nctakt.messages.axes.c_axis import NO_NAME_OF_C_AXIS, NOT_THE_MAIN_SPINDLE
from nctakt.messages.path.rotating_planes import NO_C_AXIS
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.axes import c_axis_command
from nctakt.nc.parse.block_words import AXIS_LETTERS
from nctakt.nc.tree import HashCommand
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.variables.variable_table import NameTable

_MEANING = Text(
    "the spindle stops, and its axis stands at the first free index from 3 on, at the spindle's "
    "angle; #CAX OFF or the next program ends it",
    "die Spindel hält an, und ihre Achse steht am ersten freien Index ab 3, im Winkel der Spindel; "
    "#CAX OFF oder das nächste Programm beendet es",
)


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
