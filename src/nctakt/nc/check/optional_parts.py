# SPDX-License-Identifier: MIT
"""``#OPTIONAL EXECUTION``: parts of a program that backward motion leaves out."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.messages.path.backward import OPTIONAL_PART_SWITCHED_TWICE, OPTIONAL_PART_WORDS
from nctakt.messages.path.motion import COMMAND_WORD_NOT_SIMULATED
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.path_commands import check_item
from nctakt.nc.meaning.path import Form, keywords
from nctakt.nc.tree import Bracket, HashCommand
from nctakt.nc.vocabulary.commands import forms_of

NAME = "#OPTIONAL EXECUTION"
SWITCHES = ("ON", "OFF", "CLEAR")
_FORM = Form(("SIMULATE", "APPROACH"), ("MASK",))
_NOT_BEHIND = Text(
    "backward motion ends after such a part, and does not leave it out",
    "die Rückwärtsfahrt endet nach einem solchen Teil und lässt ihn nicht aus",
)
_NEVER_LEFT_OUT = Text(
    "the part is always executed, for no motion is simulated",
    "der Teil wird immer ausgeführt, denn keine Bewegung wird simuliert",
)


def check_optional(command: HashCommand, values: ValueChecker, findings: Findings) -> None:
    """Check ``#OPTIONAL EXECUTION ON [SIMULATE]``."""
    switches = [word.name for word in command.words[2:]]
    bracket = command.arguments[0] if command.arguments else None
    if len(switches) > 1 and set(switches) <= set(SWITCHES):
        findings.report(OPTIONAL_PART_SWITCHED_TWICE, command.words[3].span)
        return
    is_known = len(switches) == 1 and switches[0] in SWITCHES
    if not is_known or len(command.arguments) > 1 or not isinstance(bracket, Bracket | None):
        forms = forms_of(NAME)
        findings.report(INVALID_COMMAND_FORM, command.span, command=NAME, forms=forms)
        return
    for item in bracket.items if bracket is not None else ():
        check_item(_FORM, NAME, item, values, findings)
    given = {item.name: item for item in keywords(command)}
    approach = given.get("APPROACH")
    if approach is not None and "SIMULATE" in given:
        findings.report(OPTIONAL_PART_WORDS, approach.span)
    elif approach is not None:
        findings.report(
            COMMAND_WORD_NOT_SIMULATED,
            approach.span,
            command=NAME,
            word="APPROACH",
            names="SIMULATE, MASK",
        )
    if "SIMULATE" in given:
        findings.report_simplified(f"{NAME} [SIMULATE]", _NEVER_LEFT_OUT, command.span)
    elif switches == ["ON"]:
        findings.report_simplified(NAME, _NOT_BEHIND, command.span)
