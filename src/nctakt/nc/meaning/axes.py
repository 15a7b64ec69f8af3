# SPDX-License-Identifier: MIT
"""Meaning of the commands for axes and spindles: exchange, C axis, couplings, targets.

In: ``#`` commands of the tree. Out: their content as records, ``None`` for another form. The
checker reports missing parts, the decoder acts on the records.
"""

from __future__ import annotations

from enum import Enum

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.nc.meaning.signals import axis_name
from nctakt.nc.tree import Bracket, BracketCommand, Expression, HashCommand, Keyword, Name, Number
from nctakt.nc.vocabulary.single_axes.axis_brackets import INDP_ASYN, INDP_SYN, OSC, form_of
from nctakt.nc.vocabulary.single_axes.independent_axes import read_independent
from nctakt.nc.vocabulary.single_axes.oscillation import read_oscillation

#: The words of the commands, and what they do.
EXCHANGE_ACTIONS = {
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
    return tuple(word.name for word in command.words) in EXCHANGE_ACTIONS


def exchange_command(command: HashCommand) -> ExchangeCommand | None:
    """Return the parsed command, ``None`` for another form."""
    words = tuple(word.name for word in command.words)
    action = EXCHANGE_ACTIONS[words]
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


_C_AXIS_WORDS = (("CAX",), ("CAX", "OFF"))


@dataclass(frozen=True, slots=True)
class CAxisCommand:
    """One command; ``spindle`` and ``name``: empty where they are left out."""

    is_on: bool
    spindle: str = ""
    name: str = ""


def is_c_axis(command: HashCommand) -> bool:
    """Return whether it is ``#CAX`` or ``#CAX OFF``."""
    return tuple(word.name for word in command.words) in _C_AXIS_WORDS


def c_axis_command(command: HashCommand) -> CAxisCommand | None:
    """Return the parsed command, ``None`` for another form."""
    is_on = len(command.words) == 1
    if not command.arguments:
        return CAxisCommand(is_on)
    bracket = command.arguments[0]
    if not is_on or len(command.arguments) > 1 or not isinstance(bracket, Bracket):
        return None
    names = [spindle_name(item) for item in bracket.items]
    if not all(names) or not 0 < len(names) <= 2:
        return None
    return CAxisCommand(True, names[0] if len(names) == 2 else "", names[-1])


def spindle_name(item: Keyword | Expression) -> str:
    """Return a name in brackets; ``S2`` reads as the word S with the value 2."""
    match item:
        case Keyword(value=Number(value=value)) if value == int(value):
            return f"{item.name}{int(value)}"
    return axis_name(item)


#: The highest number of a group.
MAX_GROUP = 99


class CouplingAction(Enum):
    """Effects of a command on its group."""

    DEFINE = "#SET AX LINK"
    ENABLE = "#ENABLE AX LINK"
    DISABLE = "#DISABLE AX LINK"
    DISABLE_ALL = "#AX LINK OFF ALL"


_COUPLING_ACTIONS = {
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
    compared, up to the first of ``limits``.
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
    return tuple(word.name for word in command.words) in _COUPLING_ACTIONS


def coupling_command(command: HashCommand) -> CouplingCommand | None:
    """Return the parsed command, ``None`` for another form."""
    words = tuple(word.name for word in command.words)
    action = _COUPLING_ACTIONS[words]
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
    pairs = [_coupled_pair(item, by_number=words[-1] == "NBR") for item in rest]
    written = tuple(pair for pair in pairs if pair is not None)
    if not written or len(written) < len(pairs):
        return None
    return CouplingCommand(action, group, written)


def _coupled_pair(item: Keyword | Expression, *, by_number: bool) -> WrittenPair | None:
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


@dataclass(frozen=True, slots=True)
class MainSpindleCommand:
    """One command: the name of a spindle or its logical number, neither for that of the list."""

    name: str = ""
    number: Expression | None = None


def main_spindle_command(command: HashCommand) -> MainSpindleCommand | None:
    """Return the parsed command, ``None`` for another form."""
    if not command.arguments:
        return MainSpindleCommand()
    bracket = command.arguments[0]
    if len(command.arguments) > 1 or not isinstance(bracket, Bracket) or len(bracket.items) != 1:
        return None
    item = bracket.items[0]
    name = spindle_name(item)
    if name:
        return MainSpindleCommand(name)
    if not isinstance(item, Expression) or isinstance(item, Name):
        return None
    return MainSpindleCommand(number=item)


def fixed_targets(bracket: BracketCommand) -> tuple[Expression, ...]:
    """Return the positions of the machine to which a single axis of a program goes.

    None for relative motions, and for brackets that are not such a motion or have mistakes.
    """
    form = form_of(bracket)
    if form in (INDP_SYN, INDP_ASYN):
        command, mistakes, _ = read_independent(bracket)
        if mistakes or not command.absolute or command.position is None:
            return ()
        return (command.position,)
    if form == OSC:
        oscillation, mistakes = read_oscillation(bracket)
        ends = [oscillation.values.get(name) for name in ("1ST_POS", "2ND_POS")]
        return () if mistakes else tuple(end for end in ends if end is not None)
    return ()
