# SPDX-License-Identifier: MIT
"""``#SINGLE STEP``: where single block stops."""

from __future__ import annotations

from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.messages.programs.single_steps import NEGATIVE_RESOLUTION, SINGLE_STEP_WORDS
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.path_commands import check_item
from nctakt.nc.meaning.path import Form, keywords
from nctakt.nc.meaning.words import SINGLE_STEP_OFF
from nctakt.nc.tree import Bracket, HashCommand, Number
from nctakt.nc.vocabulary.commands import forms_of

NAME = "#SINGLE STEP"
RESOLUTION = "RESOLUTION"
_FORM = Form((SINGLE_STEP_OFF, "ENABLE"), (RESOLUTION,))


def check_single_step(command: HashCommand, values: ValueChecker, findings: Findings) -> None:
    """Check ``#SINGLE STEP [DISABLE]``, ``[ENABLE]``, ``[RESOLUTION=10]`` (207618443)."""
    bracket = command.arguments[0] if len(command.arguments) == 1 else None
    if not isinstance(bracket, Bracket) or not bracket.items:
        forms = forms_of(NAME)
        findings.report(INVALID_COMMAND_FORM, command.span, command=NAME, forms=forms)
        return
    if len(bracket.items) > 1:
        findings.report(SINGLE_STEP_WORDS, bracket.items[1].span)
        return
    check_item(_FORM, NAME, bracket.items[0], values, findings)
    for item in keywords(command):
        value = item.value
        if item.name == RESOLUTION and isinstance(value, Number) and value.value < 0.0:
            findings.report(NEGATIVE_RESOLUTION, value.span, value=value.value)
