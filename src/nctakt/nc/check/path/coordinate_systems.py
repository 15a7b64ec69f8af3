# SPDX-License-Identifier: MIT
"""``#CS``, ``#ACS``, ``#BCS``, ``#ECS``: the coordinate systems of a program (MO-8).

In: the tree of a command. Out: diagnostics for anything other than ``#CS
DEF|ON [id] [v1, v2, v3, a1, a2, a3]``, ``#CS ON``, ``#CS OFF``, ``#CS OFF ALL``, ``#CS DEF ACT
[id]``, the same with ``#ACS`` and ``#BCS``, ``#CS ADD [name] [v1 … a3]``, ``#CS SELECT [name]``,
``#CS MODE ON|OFF [keyword]``, ``#ECS ON|OFF``. A single value in brackets is the ID, a single word
that of a system of the channel list.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.messages.path.coordinate_systems import INVALID_COORDINATE_SYSTEM_NAME
from nctakt.messages.path.motion import COMMAND_WORD_NOT_SIMULATED
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.coordinates import (
    INTERMEDIATE_SYSTEM,
    MACHINE_SYSTEM,
    SYSTEM_ACTIONS,
    SYSTEM_MODES,
    CsCommand,
    cs_command,
)
from nctakt.nc.tree import HashCommand
from nctakt.nc.vocabulary.commands import forms_of

#: Maximum length of a system's name, and the names reserved for kinematics.
MAX_CHARACTERS = 8
RESERVED = ("ACS", INTERMEDIATE_SYSTEM, MACHINE_SYSTEM)

_MEANING_OF_MCS = Text(
    "no system of the stack is active, offsets and the transformation stay",
    "kein System des Stapels ist aktiv, Verschiebungen und Transformation bleiben",
)


def check_cs_command(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check the command; return false for another command."""
    kind, *words = (word.name for word in command.words)
    if kind not in SYSTEM_ACTIONS or " ".join(words) not in ("", *SYSTEM_ACTIONS[kind]):
        return False
    parsed = cs_command(command)
    if parsed is None:
        name = " ".join(["#" + kind, *words])
        forms = forms_of(name, "#" + kind)
        findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms)
        return True
    if parsed.action.startswith("MODE"):
        if parsed.name not in SYSTEM_MODES:
            findings.report(
                COMMAND_WORD_NOT_SIMULATED,
                command.span,
                command=parsed.shown,
                word=parsed.name,
                names=", ".join(SYSTEM_MODES),
            )
    elif parsed.action in ("ADD", "SELECT"):
        _check_name(parsed, command, findings)
    for value in (parsed.identity, *(parsed.components or ())):
        if value is not None:
            values.value(value)
    return True


def _check_name(parsed: CsCommand, command: HashCommand, findings: Findings) -> None:
    """Check the name of a system of the stack."""
    if parsed.action == "SELECT" and parsed.name == INTERMEDIATE_SYSTEM:
        findings.report(
            COMMAND_WORD_NOT_SIMULATED,
            command.span,
            command="#CS SELECT",
            word=INTERMEDIATE_SYSTEM,
            names=MACHINE_SYSTEM,
        )
    elif parsed.action == "SELECT" and parsed.name == MACHINE_SYSTEM:
        findings.report_simplified("#CS SELECT [MCS]", _MEANING_OF_MCS, command.span)
    elif len(parsed.name) > MAX_CHARACTERS or parsed.name in RESERVED:
        maximum = MAX_CHARACTERS
        findings.report(
            INVALID_COORDINATE_SYSTEM_NAME, command.span, name=parsed.name, maximum=maximum
        )
