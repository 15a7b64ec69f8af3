# SPDX-License-Identifier: MIT
"""``#`` commands -> statements, and the ``#`` lines that open or close a structure.

In: a block's text at its ``#``. Every command is read as words and arguments; some known ones then
get their own node if their form is right. All others become a ``HashCommand``, which the checker
refuses or accepts by name.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Literal, cast

from nctakt.base.dataclass import dataclass
from nctakt.messages.programs.nc_text import BRACKET_NOT_CLOSED, NAME_EXPECTED, UNEXPECTED_TEXT
from nctakt.nc.parse.expressions import (
    CLOSING,
    COMMA,
    EQUALS,
    OPENING,
    Item,
    expected,
    parse_expression,
    parse_item,
    parse_items,
    parse_variable,
    quoted,
    require,
    starts_value,
)
from nctakt.nc.parse.lexer import BlockError, BlockText
from nctakt.nc.tree import (
    Bracket,
    CycleControl,
    Expression,
    Flush,
    HashCommand,
    Head,
    Keyword,
    Name,
    Number,
    Statement,
    Time,
    Timer,
    UserError,
    UserMessage,
)
from nctakt.nc.vocabulary.operators import TEXT_FUNCTIONS

CYCLE_ACTIONS = ("START", "HOLD", "CONTINUE", "ABORT ACTION", "DELETE")

_HASH = re.compile(r"\s*#\s*")
_SIGNED_AXIS = re.compile(r"\s*([^\W\d]\w*)\s*([-+])(?=\s*[\],])")
_AXIS_NAME = re.compile(r"\s*([A-CQU-Z][^\W\d]*\d+)\s*(?=[],])", re.IGNORECASE)
_SIGNAL_VALUE = re.compile(r"\s*([Pp])\s*\[")
_PAIR = re.compile(r"\s*([^\W\d]\w*)\s*=\s*([^\W\d]\w*)\s*(?=[],])")
_WORD = re.compile(r"\s*([^\W\d]\w*)(?!\w|\s*=|\.\w)")

Argument = Bracket | Keyword | Expression


@dataclass(frozen=True, slots=True)
class RawCommand:
    """A ``#`` command as written: ``[start, end)`` in the block, words, arguments."""

    start: int
    end: int
    words: tuple[Name, ...]
    arguments: tuple[Argument, ...]

    @property
    def name(self) -> tuple[str, ...]:
        """The words in upper case."""
        return tuple(word.name for word in self.words)


def parse_words(text: BlockText) -> tuple[Name, ...]:
    """Return the words after ``#``, at least one."""
    text.match(_HASH)
    words: list[Name] = []
    while (word := text.looking_at(_WORD)) is not None:
        if words and word[1].upper() not in TEXT_FUNCTIONS and starts_value(text):
            break
        text.pos = word.end()
        words.append(Name(text.span(*word.span(1)), word[1].upper(), word[1]))
    if not words:
        raise expected(text, NAME_EXPECTED)
    return tuple(words)


def parse_arguments(text: BlockText, name: tuple[str, ...]) -> tuple[Argument, ...]:
    """Return the arguments after the words, up to the end of the block."""
    arguments: list[Argument] = []
    if name == ("TIME",) and not text.at_end():
        # The only command whose brackets may be those of an expression: ``#TIME [P1] * 2``.
        arguments.append(parse_expression(text))
    if name == ("WAIT", "FOR") and not text.at_end():
        arguments.append(parse_expression(text))
    read = _couplings if "LINK" in name else _BRACKETS.get(name[0], _argument)
    while not text.at_end():
        if text.match(COMMA) is None:
            arguments.append(read(text))
    return tuple(arguments)


def _bracket(text: BlockText, item: Callable[[BlockText, int], Item]) -> Argument:
    """Return a bracket whose items this function reads; another argument as usual."""
    if text.looking_at(OPENING) is None:
        return _argument(text)
    start = text.skip_blanks()
    items = parse_items(text, 0, item)
    return Bracket(text.span(start, text.pos), items)


def _signal(text: BlockText) -> Argument:
    """Return the items of ``#SIGNAL`` and ``#WAIT``, where ``P[0]=`` is a keyword."""
    return _bracket(text, _signal_item)


def _signal_item(text: BlockText, depth: int) -> Item:
    match = text.looking_at(_SIGNAL_VALUE)
    if match is None:
        return parse_item(text, depth)
    start = match.start(1)
    text.pos = match.end(1)
    text.match(OPENING)
    index = parse_expression(text)
    require(text, CLOSING, "]")
    span = text.span(start, text.pos)
    if text.match(EQUALS) is None:
        return Keyword(span, "P", None, (index,))
    return Keyword(span, "P", parse_expression(text), (index,))


def _axes(text: BlockText) -> Argument:
    """Return the items of commands about axes, whose names may end in digits: ``[X1, 4, 3]``."""
    return _bracket(text, _axis_item)


def _axis_item(text: BlockText, depth: int) -> Item:
    match = text.looking_at(_AXIS_NAME)
    if match is None:
        return parse_item(text, depth)
    text.pos = match.end(1)
    return Keyword(text.span(*match.span(1)), match[1].upper())


def _couplings(text: BlockText) -> Argument:
    """Return the items of ``#AX LINK``, where pairs are keywords: ``[1, C=X, [Y2=Y, 1, 2]]``."""
    return _bracket(text, _coupling)


def _coupling(text: BlockText, depth: int) -> Item:
    """Return a pair as a keyword: the slave is its name, or the first argument of a nameless one.

    Separate brackets after a pair contain the arguments after that pair.
    """
    start, before = text.skip_blanks(), text.pos
    is_nested = text.match(OPENING) is not None
    pair = _pair(text)
    if pair is None:
        text.pos = before
        return parse_item(text, depth)
    rest: list[Item] = []
    while is_nested and text.match(COMMA) is not None:
        rest.append(parse_item(text, depth + 1))
    if is_nested:
        require(text, CLOSING, "]")
    return Keyword(text.span(start, text.pos), pair.name, pair.value, (*pair.arguments, *rest))


def _pair(text: BlockText) -> Keyword | None:
    named = text.match(_PAIR)
    if named is not None:
        master = Name(text.span(*named.span(2)), named[2].upper(), named[2])
        return Keyword(text.span(*named.span(1)), named[1].upper(), master)
    if not starts_value(text):
        return None
    slave = parse_expression(text)
    if text.match(EQUALS) is None:
        return None
    return Keyword(slave.span, "", parse_expression(text), (slave,))


def _signed_axes(text: BlockText) -> Argument:
    """Return axes with their signs (``#TLAX [Z+]``), which are part of the name."""
    return _bracket(text, _signed_axis)


def _signed_axis(text: BlockText, depth: int) -> Item:
    match = text.match(_SIGNED_AXIS)
    if match is None:
        return parse_item(text, depth)
    return Keyword(text.span(match.start(1), match.end(2)), match[1].upper() + match[2])


def _components(text: BlockText) -> Argument:
    """Return values in brackets by position (``#CS``); an empty position is 0."""
    if text.looking_at(OPENING) is None:
        return _argument(text)
    start = text.skip_blanks()
    text.match(OPENING)
    items: list[Item] = []
    is_gap = True
    while text.match(CLOSING) is None:
        if text.at_end():
            raise BlockError(BRACKET_NOT_CLOSED, start, start + 1)
        position = text.skip_blanks()
        is_comma = text.match(COMMA) is not None
        if not is_comma:
            items.append(parse_item(text))
        elif is_gap:
            items.append(Number(text.span(position, position + 1), 0.0))
        is_gap = is_comma
    return Bracket(text.span(start, text.pos), tuple(items))


def _tolerances(text: BlockText) -> Argument:
    """Return keywords whose value may follow without ``=`` (``#HSC``, ``#CONTOUR``)."""
    return _bracket(text, _tolerance_item)


def _tolerance_item(text: BlockText, depth: int) -> Item:
    item = parse_item(text, depth)
    if not isinstance(item, Keyword) or item.value is not None:
        return item
    if len(item.arguments) == 1 and not isinstance(item.arguments[0], Keyword):
        return Keyword(item.span, item.name, item.arguments[0])
    if item.arguments or not starts_value(text):
        return item
    value = parse_item(text, depth)
    assert not isinstance(value, Keyword)
    return Keyword(item.span, item.name, value)


def _argument(text: BlockText) -> Argument:
    if text.looking_at(OPENING) is not None:
        start = text.skip_blanks()
        items = parse_items(text)
        return Bracket(text.span(start, text.pos), items)
    return parse_variable(text, whole_family=True) or parse_item(text)


#: The readers of an argument, for commands whose brackets have special items.
_BRACKETS: dict[str, Callable[[BlockText], Argument]] = {
    "ACS": _components,
    "AX": _axes,
    "BCS": _components,
    "CALL": _axes,
    "CONTOUR": _tolerances,
    "CS": _components,
    "HSC": _tolerances,
    "PUT": _axes,
    "SET": _axes,
    "SIGNAL": _signal,
    "TLAX": _signed_axes,
    "WAIT": _signal,
}


def only_bracket(command: RawCommand) -> tuple[Item, ...] | None:
    """Return the items of a command's only bracket, empty without one; ``None`` for other
    arguments.
    """
    if not command.arguments:
        return ()
    if len(command.arguments) > 1 or not isinstance(command.arguments[0], Bracket):
        return None
    return command.arguments[0].items


def cycle_keywords(text: BlockText, command: RawCommand) -> tuple[Item, ...]:
    """Return the keywords of an ``#RT CYCLE`` line; raises ``BlockError`` for other arguments."""
    items = only_bracket(command)
    if items is None:
        wrong = next(
            argument
            for index, argument in enumerate(command.arguments)
            if index or not isinstance(argument, Bracket)
        )
        written = quoted(text.text_of(wrong.span))
        raise BlockError(UNEXPECTED_TEXT, 0, 0, wrong.span, found=written)
    return items


def simple_command(text: BlockText, head: Head, command: RawCommand) -> Statement:
    """Return the statement of a command that opens and closes no structure."""
    special = _SPECIAL.get(command.words[0].name)
    statement = special(text, head, command) if special is not None else None
    if statement is not None:
        return statement
    span = text.span(command.start, command.end)
    return HashCommand(span, head, command.words, command.arguments)


def cycle_control(text: BlockText, head: Head, command: RawCommand) -> CycleControl:
    """Return ``#RT CYCLE`` with one of the ``CYCLE_ACTIONS``."""
    keywords = cycle_keywords(text, command)
    action = " ".join(command.name[2:])
    return CycleControl(text.span(command.start, command.end), head, action, keywords)


def _flush(text: BlockText, head: Head, command: RawCommand) -> Statement | None:
    name = command.name
    if command.arguments or len(name) > 2 or (len(name) == 2 and name[1] not in _FLUSH_MODES):
        return None
    mode = cast(Literal["WAIT", "CONTINUE"], name[1]) if len(name) == 2 else None
    return Flush(text.span(command.start, command.end), head, mode)


_FLUSH_MODES = ("WAIT", "CONTINUE")


def _time(text: BlockText, head: Head, command: RawCommand) -> Statement | None:
    if len(command.words) != 1 or len(command.arguments) != 1:
        return None
    value = command.arguments[0]
    assert isinstance(value, Expression)
    return Time(text.span(command.start, command.end), head, value)


def _message(text: BlockText, head: Head, command: RawCommand) -> Statement | None:
    items = only_bracket(command)
    if not items or not all(isinstance(item, Expression) for item in items):
        return None
    values = cast(tuple[Expression, ...], items)
    span = text.span(command.start, command.end)
    return UserMessage(span, head, command.words[1:], values[0], values[1:])


def _timer(text: BlockText, head: Head, command: RawCommand) -> Statement | None:
    items = only_bracket(command)
    if items is None or len(command.words) < 2:
        return None
    span = text.span(command.start, command.end)
    return Timer(span, head, command.words[1].name, command.words[2:], items)


def _error(text: BlockText, head: Head, command: RawCommand) -> Statement | None:
    items = only_bracket(command)
    if items is None or len(command.words) != 1:
        return None
    return UserError(text.span(command.start, command.end), head, items)


_SPECIAL: dict[str, Callable[[BlockText, Head, RawCommand], Statement | None]] = {
    "ERROR": _error,
    "FLUSH": _flush,
    "MSG": _message,
    "TIME": _time,
    "TIMER": _timer,
}
