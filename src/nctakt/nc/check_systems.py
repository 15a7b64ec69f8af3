# SPDX-License-Identifier: MIT
"""``#CS``: the coordinate systems of a program (MO-8).

In: the tree of a command. Out: a ``SystemCommand``, and diagnostics of what has none of the forms
``#CS DEF|ON [id] [v1, v2, v3, a1, a2, a3]``, ``#CS ON``, ``#CS OFF``, ``#CS OFF ALL``. One value
alone in brackets is the ID. Checker and decoder share it.
"""

from __future__ import annotations

from dataclasses import dataclass

from nctakt.nc.check_values import ValueChecker
from nctakt.nc.command_forms import forms_of
from nctakt.nc.findings import Findings
from nctakt.nc.syntax import Bracket, Expression, HashCommand

#: Shift along three axes, three angles.
MOST_COMPONENTS = 6

ACTIONS = ("DEF", "ON", "OFF", "OFF ALL")


@dataclass(frozen=True, slots=True)
class SystemCommand:
    """``components``: ``None`` where a stored system is meant, the last one without an ID."""

    action: str
    identity: Expression | None
    components: tuple[Expression, ...] | None


def system_command(command: HashCommand) -> SystemCommand | None:
    """What the command says; ``None`` where it has no form that there is."""
    words = [word.name for word in command.words]
    action = " ".join(words[1:])
    if words[0] != "CS" or action not in ACTIONS:
        return None
    brackets: list[tuple[Expression, ...]] = []
    for argument in command.arguments:
        if not isinstance(argument, Bracket):
            return None
        values = tuple(item for item in argument.items if isinstance(item, Expression))
        if len(values) != len(argument.items) or not 0 < len(values) <= MOST_COMPONENTS:
            return None
        brackets.append(values)
    if action.startswith("OFF"):
        return SystemCommand(action, None, None) if not brackets else None
    identity = None
    if brackets and len(brackets[0]) == 1:
        identity = brackets.pop(0)[0]
    if len(brackets) > 1 or (action == "DEF" and not brackets):
        return None
    return SystemCommand(action, identity, brackets[0] if brackets else None)


def check_system(command: HashCommand, values: ValueChecker, findings: Findings) -> bool:
    """Check the command; false where it is another one."""
    words = [word.name for word in command.words]
    if words[0] != "CS" or " ".join(words[1:]) not in ("", *ACTIONS):
        return False
    found = system_command(command)
    if found is None:
        name = "#" + " ".join(words)
        findings.report(900233, command.span, command=name, forms=forms_of("#CS"))
        return True
    for value in (found.identity, *(found.components or ())):
        if value is not None:
            values.value(value)
    return True
