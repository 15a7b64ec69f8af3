# SPDX-License-Identifier: MIT
"""``#CALL AX``, ``#PUT AX``, ``#SET AX``, ``#AX REQUEST``, ``#AX RELEASE``, ``#AX DEF``, ``#CAX``.

In: the tree of a command. Out: an ``ExchangeCommand``, shared by checker and decoder, the uses for
checks across programs, and diagnostics for other forms. The names of fetched axes are known from
the command on. Values that are not constant are checked when they are decoded.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span, Text
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages.axis_exchange import AXIS_OPTION_REFUSED, UNSUITABLE_AXIS_NAME
from nctakt.messages.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.c_axis import check_c_axis, is_c_axis
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.signals import axis_name, constant
from nctakt.nc.outline import AxisUse
from nctakt.nc.parse.block_words import AXIS_LETTERS
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.variable_table import NameTable

#: The words of the commands, and what they do.
_ACTIONS = {
    ("CALL", "AX"): "CALL AX",
    ("CALL", "AX", "FAST"): "CALL AX",
    ("AX", "REQUEST"): "AX REQUEST",
    ("PUT", "AX"): "PUT AX",
    ("PUT", "AX", "ALL"): "PUT AX",
    ("AX", "RELEASE"): "AX RELEASE",
    ("AX", "RELEASE", "ALL"): "AX RELEASE",
    ("AX", "RELEASE", "NBR"): "AX RELEASE",
    ("SET", "AX"): "SET AX",
    ("SET", "AX", "FAST"): "SET AX",
    ("AX", "DEF"): "AX DEF",
    ("AX", "DEF", "DEFAULT"): "AX DEF",
}
#: Those that fetch axes without giving others away, and those that only give.
_FETCHING = ("CALL AX", "AX REQUEST")
GIVING = ("PUT AX", "AX RELEASE")

_MEANING = Text(
    "the command waits until the path and the axes stand and no other channel has the axes; "
    "offsets of an exchanged axis begin at 0",
    "der Befehl wartet, bis Bahn und Achsen stehen und kein anderer Kanal die Achsen hat; "
    "Verschiebungen einer getauschten Achse beginnen bei 0",
)


@dataclass(frozen=True, slots=True)
class FetchedAxis:
    """An axis in brackets: its name, the values of its logical number and its index."""

    name: str
    number: Expression
    slot: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class ExchangeCommand:
    """One command; ``action``: its words without options.

    ``fetched``: the axes with their numbers. ``names`` and ``numbers``: those to be given.
    ``is_all``: all axes are given. ``from_default``: the configuration of the list, with changes.
    """

    action: str
    fetched: tuple[FetchedAxis, ...]
    names: tuple[str, ...]
    numbers: tuple[Expression, ...]
    is_all: bool
    from_default: bool

    @property
    def keeps_others(self) -> bool:
        """Whether axes that are not named stay in the channel."""
        return self.action in (*_FETCHING, *GIVING)


def is_exchange(command: HashCommand) -> bool:
    """Return whether it is one of these commands."""
    return tuple(word.name for word in command.words) in _ACTIONS


def exchange_command(command: HashCommand) -> ExchangeCommand | None:
    """Return the parsed command, ``None`` for another form."""
    words = tuple(word.name for word in command.words)
    action = _ACTIONS[words]
    brackets = [one.items for one in command.arguments if isinstance(one, Bracket)]
    if len(brackets) != len(command.arguments):
        return None
    if action not in GIVING:
        if words[-1] != "FAST" and brackets and [axis_name(i) for i in brackets[0]] == ["FAST"]:
            brackets = brackets[1:]
        fetched = [_fetched(items) for items in brackets]
        axes = tuple(axis for axis in fetched if axis is not None)
        if len(axes) < len(fetched) or (not axes and words[-1] != "DEFAULT"):
            return None
        return ExchangeCommand(action, axes, (), (), False, words[-1] == "DEFAULT")
    if words[-1] == "ALL":
        return None if brackets else ExchangeCommand(action, (), (), (), True, False)
    if len(brackets) != 1 or not brackets[0]:
        return None
    if words[-1] == "NBR":
        numbers = tuple(item for item in brackets[0] if not isinstance(item, Keyword))
        if len(numbers) < len(brackets[0]):
            return None
        return ExchangeCommand(action, (), (), numbers, False, False)
    names = tuple(axis_name(item) for item in brackets[0])
    return ExchangeCommand(action, (), names, (), False, False) if all(names) else None


def _fetched(items: tuple[Keyword | Expression, ...]) -> FetchedAxis | None:
    if len(items) < 3 or not axis_name(items[0]):
        return None
    number, slot = items[1], items[2]
    if isinstance(number, Keyword) or isinstance(slot, Keyword):
        return None
    return FetchedAxis(axis_name(items[0]), number, slot, items[0].span)


class ExchangeChecker:
    """Checks the commands of one program; ``axes`` and ``names`` learn the axes that it fetches."""

    def __init__(
        self,
        channel: ChannelParameters,
        names: NameTable,
        axes: list[str],
        values: ValueChecker,
        findings: Findings,
    ) -> None:
        self._channel = channel
        self._names = names
        self._axes = axes
        self._values = values
        self._findings = findings
        self._uses: list[AxisUse] = []
        for name in names.fetched:
            self._learn(name, None)

    @property
    def fetched(self) -> tuple[tuple[str, int | None], ...]:
        """The names of fetched axes with their numbers."""
        return tuple(self._names.fetched.items())

    def resume(self, fetched: Sequence[tuple[str, int | None]]) -> None:
        """Know these names of fetched axes."""
        for name, number in fetched:
            self._learn(name, number)

    def take(self) -> list[AxisUse]:
        """Return the uses since the last call of this method."""
        taken, self._uses = self._uses, []
        return taken

    def command(self, command: HashCommand) -> bool:
        """Check one of these commands; return false for any other."""
        if is_c_axis(command):
            name = check_c_axis(command, self._channel, self._names, self._findings)
            self._axes += [name] if name and name not in self._axes else []
            return True
        if not is_exchange(command):
            return False
        name = f"#{_ACTIONS[tuple(word.name for word in command.words)]}"
        parsed = exchange_command(command)
        if parsed is None:
            self._findings.report(
                INVALID_COMMAND_FORM, command.span, command=name, forms=forms_of(name)
            )
            return True
        self._findings.report_simplified("#CALL AX, #PUT AX, #SET AX, #AX", _MEANING, command.span)
        for one in command.arguments:
            assert isinstance(one, Bracket)
            for item in one.items[3:] if parsed.fetched else ():
                written = self._findings.written(item.span)
                self._findings.report(AXIS_OPTION_REFUSED, item.span, option=written)
        for axis in parsed.fetched:
            self._values.block(axis.number)
            self._values.block(axis.slot)
            if axis.name[0] not in AXIS_LETTERS:
                self._findings.report(UNSUITABLE_AXIS_NAME, axis.span, name=axis.name)
            else:
                self._learn(axis.name, constant(axis.number))
        for number in parsed.numbers:
            self._values.block(number)
        self._note(parsed, command)
        return True

    def _learn(self, name: str, number: int | None) -> None:
        self._names.learn_axis(name, number)
        if name not in self._axes:
            self._axes.append(name)

    def _note(self, parsed: ExchangeCommand, command: HashCommand) -> None:
        """Note the use for checks across programs."""
        fetched = tuple(constant(axis.number) for axis in parsed.fetched)
        numbers = tuple(constant(number) for number in parsed.numbers)
        gives_all = parsed.is_all or not parsed.keeps_others
        line = self._findings.line_of(command.span)
        names = tuple((axis.name, constant(axis.number)) for axis in parsed.fetched)
        self._uses.append(
            AxisUse(fetched, parsed.names, numbers, gives_all, names, command.span, line)
        )
