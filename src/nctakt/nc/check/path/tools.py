# SPDX-License-Identifier: MIT
"""``#TOOL DATA``, ``#TOOL PREP``, ``#TOOL REFRESH``, ``#TLAX``: the forms of these commands."""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.messages.path.tools import NEGATIVE_TOOL_LIFE
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.path_commands import check_item
from nctakt.nc.meaning.path import Form, keywords
from nctakt.nc.meaning.words import TOOL_COMMANDS, numbers_of, signed_axis
from nctakt.nc.tree import Bracket, HashCommand, Number
from nctakt.nc.vocabulary.commands import forms_of

_MAIN_AXES = 3
_LIFE = Form(numbers=("DIST", "TIME"))


def _check_length_axis(
    command: HashCommand, name: str, main_axes: Sequence[str], findings: Findings
) -> None:
    if name == "TLAX DEFAULT":
        is_right = not command.arguments
    else:
        signed = signed_axis(command)
        is_right = name == "TLAX" and signed is not None and signed[0] in main_axes
    if not is_right:
        forms = forms_of("#TLAX")
        findings.report(INVALID_COMMAND_FORM, command.span, command="#TLAX", forms=forms)


def _check_life(command: HashCommand, values: ValueChecker, findings: Findings) -> None:
    """Check ``#TOOL LIFE DEF [DIST=1000 TIME=60]``."""
    bracket = command.arguments[0] if len(command.arguments) == 1 else None
    if not isinstance(bracket, Bracket) or not bracket.items:
        name = "#TOOL LIFE DEF"
        findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms_of(name))
        return
    for item in bracket.items:
        check_item(_LIFE, "#TOOL LIFE DEF", item, values, findings)
    for item in keywords(command):
        value = item.value
        if item.name in _LIFE.numbers and isinstance(value, Number) and value.value < 0.0:
            word = item.name
            findings.report(NEGATIVE_TOOL_LIFE, value.span, word=word, value=value.value)


def check_tool_command(
    command: HashCommand, axes: Sequence[str], values: ValueChecker, findings: Findings
) -> bool:
    """Check the command; return false for another command. ``axes``: those of the channel."""
    name = " ".join(word.name for word in command.words)
    if command.words[0].name == "TLAX":
        _check_length_axis(command, name, axes[:_MAIN_AXES], findings)
        return True
    if name not in TOOL_COMMANDS:
        return False
    if name == "TOOL LIFE DEF":
        _check_life(command, values, findings)
        return True
    numbers = numbers_of(command)
    if numbers is None:
        forms = forms_of(f"#{name}")
        findings.report(INVALID_COMMAND_FORM, command.span, command=f"#{name}", forms=forms)
    for number in numbers or ():
        values.value(number)
    return True
