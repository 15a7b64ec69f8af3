# SPDX-License-Identifier: MIT
"""``#MCS``, ``#WCS TO MCS``, ``#MCS TO WCS``: machine coordinates in a program (MO-8).

In: the tree of a command. Out: a ``MachineCommand``, and diagnostics for any other form. Shared by
checker and decoder.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword
from nctakt.nc.vocabulary.commands import forms_of

CONVERSIONS = ("WCS TO MCS", "MCS TO WCS")
MACHINE_COMMANDS = ("MCS ON", "MCS OFF", *CONVERSIONS)


@dataclass(frozen=True, slots=True)
class MachineCommand:
    """One of these commands.

    ``is_without_tools``: ``EX TOOL``. ``system``: the number of a stored coordinate system between
    both positions; ``has_kinematic``: so is the selected kinematic.
    """

    name: str
    is_without_tools: bool = False
    system: Expression | None = None
    has_kinematic: bool = False

    @property
    def shown(self) -> str:
        """The command as it is written."""
        return f"#{self.name}"


def machine_command(command: HashCommand) -> MachineCommand | None:
    """Return the parsed command; ``None`` if its form is unknown."""
    name = " ".join(word.name for word in command.words)
    items: list[Expression | Keyword] = []
    for argument in command.arguments:
        if not isinstance(argument, Bracket) or not argument.items:
            return None
        items += argument.items
    if name == "MCS ON":
        words = [item.name for item in items if isinstance(item, Keyword) and item.value is None]
        is_known = not items or (len(words) == len(items) and words == ["EX", "TOOL"])
        return MachineCommand(name, bool(items)) if is_known else None
    if name not in CONVERSIONS:
        return MachineCommand(name) if name == "MCS OFF" and not items else None
    system: Expression | None = None
    first = items[0] if items else None
    if isinstance(first, Keyword) and first.name == "CS":
        system = first.value
        del items[0]
        value = items[0] if items else None
        if system is None and isinstance(value, Expression):
            system = value
            del items[0]
        if system is None:
            return None
    has_kinematic = bool(items)
    if has_kinematic:
        last = items.pop(0)
        is_word = isinstance(last, Keyword) and last.value is None and last.name == "KIN"
        if items or not is_word:
            return None
    return MachineCommand(name, False, system, has_kinematic)


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
