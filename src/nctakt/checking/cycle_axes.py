# SPDX-License-Identifier: MIT
"""Axes that realtime cycles command, and that the program moves or has given away.

In: definitions of cycles and commands of the axis exchange, with the facts certain there. Out: the
facts after them, and the errors of a run (50603, 901800) where they are certain.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.checking.path_facts import CommandedAxis, Facts
from nctakt.messages.axes.axis_exchange import AXIS_NOT_IN_CHANNEL
from nctakt.messages.axes.axis_motions import AXIS_MOVED_BY_PATH
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.axes import GIVING, exchange_command, is_c_axis, is_exchange
from nctakt.nc.tree import (
    AxisWord,
    Block,
    BracketCommand,
    HashCommand,
    Keyword,
    Name,
    Number,
    RealtimeCycle,
    Unary,
)
from nctakt.nc.vocabulary.single_axes.axis_commands import (
    AxisCommand,
    axis_commands_in,
    is_axis_command,
    read_axis_command,
)

_GIVEN = Text("the program has given it away before", "das Programm hat sie vorher abgegeben")


def note_exchange(command: HashCommand, facts: Facts, axes: list[str]) -> None:
    """Note which axes of the channel a command gives away; fetching makes all uncertain."""
    if is_c_axis(command):
        facts.given_axes = frozenset()
        return
    if not is_exchange(command):
        return
    parsed = exchange_command(command)
    if parsed is None or parsed.action not in GIVING:
        facts.given_axes = frozenset()
    elif parsed.is_all:
        facts.given_axes = frozenset(axes)
    else:
        facts.given_axes |= frozenset(parsed.names)


def check_word(word: AxisWord, facts: Facts, findings: Findings) -> None:
    """Report a word of an axis that the program has given away."""
    if word.name in facts.given_axes:
        facts.given_axes -= {word.name}
        findings.report(AXIS_NOT_IN_CHANNEL, word.span, axis=word.name, holder=_GIVEN)


def begin_cycle(cycle: RealtimeCycle, facts: Facts, findings: Findings) -> None:
    """Report axes of a cycle that the program has given away; note those that it commands in each
    tick from its definition on.
    """
    brackets = list(axis_commands_in(cycle.body))
    missing = next((one.name for one in brackets if one.name in facts.given_axes), None)
    if missing is not None:
        findings.report(AXIS_NOT_IN_CHANNEL, cycle.span, axis=missing, holder=_GIVEN)
        return
    scope = _scope(cycle)
    if cycle.definition_only or not scope:
        return
    names = [one.name for one in brackets]
    for statement in cycle.body:
        if not isinstance(statement, Block) or statement.head.skip is not None:
            continue
        for word in statement.words:
            if not isinstance(word, BracketCommand) or not is_axis_command(word):
                continue
            if names.count(word.name) != 1:
                continue
            command, wrong = read_axis_command(word)
            if not wrong and not command.stops and not command.buffered:
                facts.commanded[word.name] = CommandedAxis(
                    word.span, _target(command), facts.positions.get(word.name), scope == "BLOCK"
                )


def _scope(cycle: RealtimeCycle) -> str:
    """Return the scope of a cycle as written, empty if it is not written."""
    for item in cycle.keywords:
        if isinstance(item, Keyword) and item.name == "SCOPE":
            return item.value.name if isinstance(item.value, Name) else ""
    return ""


def _target(command: AxisCommand) -> float | None:
    """Return a constant absolute target without additional offsets."""
    if command.kind != "position" or command.offset:
        return None
    position = command.position
    if isinstance(position, Unary) and position.operator == "-":
        position = position.operand
        return -position.value if isinstance(position, Number) else None
    return position.value if isinstance(position, Number) else None


def end_block(facts: Facts) -> None:
    """Forget the cycles that run with one block only."""
    facts.commanded = {
        axis: command for axis, command in facts.commanded.items() if not command.is_of_block
    }


def check_motion(axis: str, target: float | None, facts: Facts, findings: Findings) -> None:
    """Report a block that moves an axis to a target while a cycle commands it in each tick.

    A cycle that continues first brings the axis to its target, since the block waits for it.
    """
    command = facts.commanded.get(axis)
    if command is None or target is None or facts.is_shifted is not False or facts.is_inch:
        return
    begin = command.start if command.is_of_block else command.target
    if begin is not None and begin != target:
        del facts.commanded[axis]
        findings.report(AXIS_MOVED_BY_PATH, command.span, axis=axis)
