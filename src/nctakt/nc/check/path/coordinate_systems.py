# SPDX-License-Identifier: MIT
"""Commands that select a coordinate system, a transformation or a plane (MO-8).

In: the tree of a command, ``#CS``, ``#ACS``, ``#BCS``, ``#ECS``, ``#MCS``, ``#WCS TO MCS``,
``#TRAFO``, ``#RTCP``, ``#FACE``, ``#CYL`` … Out: diagnostics for any other form. Of a system a
single value in brackets is the ID, a single word the name of a system of the channel list.
"""

from __future__ import annotations

from collections.abc import Collection

from nctakt.base.diagnostics import Text
from nctakt.messages.path.coordinate_systems import INVALID_COORDINATE_SYSTEM_NAME
from nctakt.messages.path.motion import COMMAND_WORD_NOT_SIMULATED
from nctakt.messages.path.rotating_planes import UNKNOWN_AXIS_OF_PLANE
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.coordinates import (
    INTERMEDIATE_SYSTEM,
    MACHINE_COMMANDS,
    MACHINE_SYSTEM,
    PLANE_COMMANDS,
    SYSTEM_ACTIONS,
    SYSTEM_MODES,
    TRANSFORMATION_COMMANDS,
    CsCommand,
    cs_command,
    machine_command,
    plane_command,
    transformation_command,
)
from nctakt.nc.tree import Expression, HashCommand
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.orientation import ANGLE, VECTOR
from nctakt.nc.vocabulary.support_level import hash_command

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


#: Modes of ``#ORI MODE`` that belong to robots with six axes (P-CHAN-00177).
_OF_SIX_AXES = ("VECTOR_ABC", "VECTOR_IJK")


def check_transformation(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check the command; return false for another command."""
    words = [word.name for word in command.words]
    if " ".join(words) not in TRANSFORMATION_COMMANDS:
        return False
    parsed = transformation_command(command)
    if parsed is None:
        name = "#" + " ".join(words)
        written = findings.written(command.span).upper()
        other = next((word for word in _OF_SIX_AXES if word in written), "")
        if words == ["ORI", "MODE"] and other:
            names = f"{ANGLE}, {VECTOR}"
            findings.report(
                COMMAND_WORD_NOT_SIMULATED, command.span, command=name, word=other, names=names
            )
            return True
        forms = forms_of(name, f"#{words[0]}")
        findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms)
        return True
    for value in parsed.values:
        if isinstance(value, Expression):
            values.value(value)
    return True


def check_machine_command(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check the command; return false for another command."""
    name = " ".join(word.name for word in command.words)
    if name not in MACHINE_COMMANDS:
        return False
    parsed = machine_command(command)
    if parsed is None:
        forms = forms_of("#MCS" if name.startswith("MCS O") else f"#{name}")
        findings.report(INVALID_COMMAND_FORM, command.span, command=f"#{name}", forms=forms)
    elif parsed.system is not None:
        values.value(parsed.system)
    return True
