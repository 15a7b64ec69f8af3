# SPDX-License-Identifier: MIT
"""``#CS``: the coordinate systems of a program (MO-8).

In: the tree of a command. Out: a ``CsCommand``, and diagnostics for anything other than ``#CS
DEF|ON [id] [v1, v2, v3, a1, a2, a3]``, ``#CS ON``, ``#CS OFF``, ``#CS OFF ALL``, ``#CS ADD [name]
[v1 … a3]``, ``#CS SELECT [name]``. A single value in brackets is the ID. Shared by checker and
decoder.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM
from nctakt.messages.coordinate_systems import INVALID_COORDINATE_SYSTEM_NAME
from nctakt.messages.motion import COMMAND_WORD_NOT_SIMULATED
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name, Number
from nctakt.nc.vocabulary.command_forms import FORMS, forms_of

#: Maximum number of components: a shift along three axes, three angles.
MAX_COMPONENTS = 6

ACTIONS = ("DEF", "ON", "OFF", "OFF ALL", "ADD", "SELECT")

#: Maximum length of a system's name, and the names reserved for kinematics.
MAX_CHARACTERS = 8
MACHINE_SYSTEM, INTERMEDIATE_SYSTEM = "MCS", "IMCS"
RESERVED = ("ACS", INTERMEDIATE_SYSTEM, MACHINE_SYSTEM)

_MEANING_OF_MCS = Text(
    "no system of the stack is active, offsets and the transformation stay",
    "kein System des Stapels ist aktiv, Verschiebungen und Transformation bleiben",
)


@dataclass(frozen=True, slots=True)
class CsCommand:
    """A ``#CS`` command; ``components``: ``None`` for a stored system, the last one without an ID.

    ``name``: that of ADD and SELECT.
    """

    action: str
    identity: Expression | None
    components: tuple[Expression, ...] | None
    name: str = ""


def cs_command(command: HashCommand) -> CsCommand | None:
    """Return the parsed command; ``None`` if its form is unknown."""
    words = [word.name for word in command.words]
    action = " ".join(words[1:])
    if words[0] != "CS" or action not in ACTIONS:
        return None
    name = ""
    arguments = list(command.arguments)
    if action in ("ADD", "SELECT"):
        name = _name(arguments.pop(0)) if arguments else ""
        if not name or (action == "SELECT") != (not arguments):
            return None
    brackets: list[tuple[Expression, ...]] = []
    for argument in arguments:
        if not isinstance(argument, Bracket):
            return None
        values = tuple(item for item in argument.items if isinstance(item, Expression))
        if len(values) != len(argument.items) or not 0 < len(values) <= MAX_COMPONENTS:
            return None
        brackets.append(values)
    if name:
        return CsCommand(action, None, brackets[0] if brackets else None, name)
    if action.startswith("OFF"):
        return CsCommand(action, None, None) if not brackets else None
    identity = None
    if brackets and len(brackets[0]) == 1:
        identity = brackets.pop(0)[0]
    if len(brackets) > 1 or (action == "DEF" and not brackets):
        return None
    return CsCommand(action, identity, brackets[0] if brackets else None)


def _name(argument: Bracket | Keyword | Expression) -> str:
    """Return the name in brackets, in upper case; empty if there is none."""
    if not isinstance(argument, Bracket) or len(argument.items) != 1:
        return ""
    (item,) = argument.items
    if isinstance(item, Name):
        return item.name
    if not isinstance(item, Keyword) or item.arguments:
        return ""
    if item.value is None:
        return item.name
    number = item.value
    return f"{item.name}{number.value:.0f}" if isinstance(number, Number) else ""


def check_cs_command(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check the command; return false for another command."""
    words = [word.name for word in command.words]
    if words[0] != "CS" or " ".join(words[1:]) not in ("", *ACTIONS):
        return False
    parsed = cs_command(command)
    if parsed is None:
        name = "#" + " ".join(words)
        forms = forms_of(name if name in FORMS else "#CS")
        findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms)
        return True
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
    for value in (parsed.identity, *(parsed.components or ())):
        if value is not None:
            values.value(value)
    return True
