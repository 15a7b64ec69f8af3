# SPDX-License-Identifier: MIT
"""``#SET AX LINK``, ``#AX LINK``, ``#ENABLE AX LINK``, ``#DISABLE AX LINK``: coupled axes.

In: the tree of a command. Out: a ``CouplingCommand``, shared by checker and decoder, and
diagnostics for other forms and names. Values are checked when they are decoded.
"""

from __future__ import annotations

from collections.abc import Collection
from enum import Enum

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.lists.machine.couplings import MAX_PAIRS
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM
from nctakt.messages.couplings import DENOMINATOR_MISSING, TOO_MANY_PAIRS, UNKNOWN_COUPLED_AXIS
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name
from nctakt.nc.vocabulary.commands import forms_of

#: The highest number of a group.
MAX_GROUP = 99


class CouplingAction(Enum):
    """What a command does with its group."""

    DEFINE = "#SET AX LINK"
    ENABLE = "#ENABLE AX LINK"
    DISABLE = "#DISABLE AX LINK"
    DISABLE_ALL = "#AX LINK OFF ALL"


_ACTIONS = {
    ("SET", "AX", "LINK"): CouplingAction.DEFINE,
    ("AX", "LINK"): CouplingAction.DEFINE,
    ("AX", "LINK", "NBR"): CouplingAction.DEFINE,
    ("ENABLE", "AX", "LINK"): CouplingAction.ENABLE,
    ("AX", "LINK", "ON"): CouplingAction.ENABLE,
    ("DISABLE", "AX", "LINK"): CouplingAction.DISABLE,
    ("AX", "LINK", "OFF"): CouplingAction.DISABLE,
    ("AX", "LINK", "OFF", "ALL"): CouplingAction.DISABLE_ALL,
}


@dataclass(frozen=True, slots=True)
class WrittenPair:
    """A slave and its master: names, or with NBR the values of their logical numbers.

    ``factor``: numerator and denominator, empty for 1. ``is_gantry``: actual positions are
    compared, up to the first one of ``limits``.
    """

    span: Span
    slave: str | Expression
    master: str | Expression
    factor: tuple[Expression, ...] = ()
    is_gantry: bool = False
    limits: tuple[Expression, ...] = ()

    @property
    def expressions(self) -> list[Expression]:
        """All values that are to be evaluated."""
        given = (self.slave, self.master, *self.factor, *self.limits)
        return [one for one in given if isinstance(one, Expression)]


@dataclass(frozen=True, slots=True)
class CouplingCommand:
    """One command; ``group``: ``None`` where its number is left out."""

    action: CouplingAction
    group: Expression | None = None
    pairs: tuple[WrittenPair, ...] = ()


def is_coupling(command: HashCommand) -> bool:
    """Return whether it is one of these commands."""
    return tuple(word.name for word in command.words) in _ACTIONS


def coupling_command(command: HashCommand) -> CouplingCommand | None:
    """Return the parsed command, ``None`` for another form."""
    words = tuple(word.name for word in command.words)
    action = _ACTIONS[words]
    if not command.arguments:
        return None if action is CouplingAction.DEFINE else CouplingCommand(action)
    bracket = command.arguments[0]
    if len(command.arguments) > 1 or not isinstance(bracket, Bracket) or not bracket.items:
        return None
    group, *rest = bracket.items
    if isinstance(group, Keyword) or action is CouplingAction.DISABLE_ALL:
        return None
    if action is not CouplingAction.DEFINE:
        return None if rest else CouplingCommand(action, group)
    pairs = [_pair(item, by_number=words[-1] == "NBR") for item in rest]
    written = tuple(pair for pair in pairs if pair is not None)
    if not written or len(written) < len(pairs):
        return None
    return CouplingCommand(action, group, written)


def _pair(item: Keyword | Expression, *, by_number: bool) -> WrittenPair | None:
    if not isinstance(item, Keyword) or item.value is None:
        return None
    slave: str | Expression = item.name
    master: str | Expression = item.value
    rest = list(item.arguments)
    if by_number:
        if item.name or not rest or isinstance(rest[0], Keyword):
            return None
        slave = rest.pop(0)  # type: ignore[assignment]  # no keyword
    elif not item.name or not isinstance(item.value, Name):
        return None
    else:
        master = item.value.name
    match rest:
        case []:
            return WrittenPair(item.span, slave, master)
        case [Keyword(name="G", value=None, arguments=()), *limits] if len(limits) in (0, 2):
            values = tuple(one for one in limits if not isinstance(one, Keyword))
            if len(values) < len(limits):
                return None
            return WrittenPair(item.span, slave, master, (), True, values)
        case [Expression() as numerator, *denominator] if len(denominator) < 2:
            values = tuple(one for one in denominator if not isinstance(one, Keyword))
            if len(values) == len(denominator):
                return WrittenPair(item.span, slave, master, (numerator, *values))
    return None


def check_coupling(
    command: HashCommand, known: Collection[str], values: ValueChecker, findings: Findings
) -> bool:
    """Check one of these commands; return false for any other.

    ``known``: the names of axes and spindles.
    """
    if not is_coupling(command):
        return False
    parsed = coupling_command(command)
    if parsed is None:
        name = "#" + " ".join(word.name for word in command.words[:3])
        findings.report(INVALID_COMMAND_FORM, command.span, command=name, forms=forms_of(name))
        return True
    if parsed.group is not None:
        values.block(parsed.group)
    if len(parsed.pairs) > MAX_PAIRS:
        findings.report(TOO_MANY_PAIRS, command.span, limit=MAX_PAIRS)
    for pair in parsed.pairs:
        for expression in pair.expressions:
            values.block(expression)
        if len(pair.factor) == 1:
            findings.report(DENOMINATOR_MISSING, pair.span)
        for axis in (pair.slave, pair.master):
            if isinstance(axis, str) and axis not in known:
                text = ", ".join(known)
                findings.report(UNKNOWN_COUPLED_AXIS, pair.span, axis=axis, known=text)
    return True
