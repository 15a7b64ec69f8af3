# SPDX-License-Identifier: MIT
"""Meaning of ``#SIGNAL``, ``#WAIT`` and related commands.

In: ``#`` commands of the tree. Out: ``SignalCommand``, ``None`` for another form.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name

#: Highest number of a signal.
MAX_SIGNAL = 2_147_483_647

#: Highest number of a channel that signals can name.
MAX_CHANNEL = 30

#: Number of values that a signal can carry: P[0] … P[11].
SIGNAL_VALUES = 12


@dataclass(frozen=True, slots=True)
class SignalCommand:
    """One command; ``action``: SIGNAL, WAIT, SIGNAL READ or SIGNAL REMOVE.

    ``numbers``: the values of ID, IDMIN, IDMAX, COUNT; ``channels``: those of CH; ``parameters``:
    index and value, or target, of each P.
    """

    action: str
    is_synchronous: bool
    numbers: dict[str, Expression]
    channels: tuple[Expression, ...]
    parameters: tuple[tuple[Expression, Expression], ...]
    overtakes: bool
    span: Span


def action_of(command: HashCommand) -> str | None:
    """Return the action of a command with signals; ``None`` for any other command."""
    words = [word.name for word in command.words]
    if words[:1] not in (["SIGNAL"], ["WAIT"]) or words[1:2] in (["FOR"], ["INDP"]):
        return None
    return " ".join(words[:2]) if words[1:2] in (["READ"], ["REMOVE"]) else words[0]


def signal_command(command: HashCommand) -> SignalCommand:
    """Return the parsed command, whose form has been checked."""
    action = action_of(command)
    assert action is not None
    numbers: dict[str, Expression] = {}
    channels: list[Expression] = []
    parameters: list[tuple[Expression, Expression]] = []
    overtakes = False
    for item in items_of(command):
        if not isinstance(item, Keyword):
            continue
        if item.name == "AHEAD":
            overtakes = True
        elif item.name == "CH" and item.value is not None:
            channels.append(item.value)
        elif item.name == "P" and item.value is not None and item.arguments:
            index = item.arguments[0]
            assert isinstance(index, Expression)
            parameters.append((index, item.value))
        elif item.value is not None:
            numbers[item.name] = item.value
    return SignalCommand(
        action,
        command.words[-1].name == "SYN",
        numbers,
        tuple(channels),
        tuple(parameters),
        overtakes,
        command.span,
    )


def items_of(command: HashCommand) -> Iterator[Keyword | Expression]:
    """Yield the content of a command's brackets."""
    for argument in command.arguments:
        if isinstance(argument, Bracket):
            yield from argument.items


def axis_name(item: Keyword | Expression) -> str:
    """Return the name of an axis that is alone in brackets, else an empty text."""
    if isinstance(item, Keyword):
        return "" if item.value is not None or item.arguments else item.name
    return item.name if isinstance(item, Name) else ""
