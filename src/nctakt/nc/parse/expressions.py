# SPDX-License-Identifier: MIT
"""Text -> expression trees, and the ``[ … ]`` lists that expressions and commands share.

In: a block's text at the reading position. Out: nodes of ``tree.py``; the position is after them.
Infix operators are combined with two stacks, so that only brackets and functions recurse; neither
their nesting nor the height of the tree exceeds ``EXPRESSION_DEPTH`` (20386).
"""

from __future__ import annotations

import re
from collections.abc import Callable
from math import isinf
from typing import NamedTuple

from nctakt.base.diagnostics import Message, Text
from nctakt.messages.programs.nc_text import (
    BRACKET_NOT_CLOSED,
    EXPRESSION_TOO_DEEP,
    INDIRECT_PARAMETER_ARRAY,
    NAME_EXPECTED,
    NUMBER_TOO_LARGE,
    SYMBOL_EXPECTED,
    TEXT_NOT_CLOSED,
    UNEXPECTED_TEXT,
    UNMATCHED_CLOSING_BRACKET,
    VALUE_EXPECTED,
)
from nctakt.nc.parse.lexer import BlockError, BlockText
from nctakt.nc.tree import (
    PARAMETER_ARRAYS,
    ArrayLiteral,
    Binary,
    Call,
    Constant,
    Expression,
    Keyword,
    Name,
    Number,
    Parameter,
    Part,
    StringLiteral,
    Unary,
    Variable,
)
from nctakt.nc.vocabulary.operators import CONSTANTS, FUNCTIONS, INFIX, PREFIX

#: Maximum height of an expression tree in nodes, and of nested brackets. Functions that walk the
#: tree may recurse that deep.
EXPRESSION_DEPTH = 64

#: The end of a block in messages.
END_OF_BLOCK = Text("the end of the block", "dem Satzende")

FUNCTION_NAMES = "|".join(sorted(FUNCTIONS, key=len, reverse=True))

NUMBER = re.compile(r"\s*(\d+\.?\d*|\.\d+)")
STRING = re.compile(r'\s*"([^"]*)"')
VARIABLE = re.compile(r"\s*V([sS])?\.", re.IGNORECASE)
PARAMETER = re.compile(r"\s*(?:(@)P|(P+))(?:(\d+)|(?=\[))", re.IGNORECASE)
OPENING = re.compile(r"\s*\[")
CLOSING = re.compile(r"\s*\]")
COMMA = re.compile(r"\s*,")
EQUALS = re.compile(r"\s*=(?!=)")

_PREFIX = re.compile(r"\s*([-+]|NOT(?![\w.]))", re.IGNORECASE)
_INFIX = re.compile(
    r"\s*(\*\*|&&|\|\||==|!=|<=|>=|[-+*/<>&|^]|(?:MOD|XOR)(?![A-Z_.]))", re.IGNORECASE
)
_CALL = re.compile(r"\s*([^\W\d]\w*)\s*\[")
_NAME = re.compile(r"\s*([^\W\d]\w*(?:[.:\\/][\w.:\\/+-]*)?)")
_FAMILY = re.compile(r"[^\W\d]\w*")
_PART = re.compile(r"\.([-+]?\w+)")
_INDEX = re.compile(r"\[")
_NEXT_TOKEN = re.compile(r"\s*(\w+|\S)")
_STARTS_VALUE = re.compile(
    r'\s*(?:[-+\d\["@]|\.\d|Vs?\.|P+(?:\d|\[)|(?:TRUE|FALSE|PI|NOT)(?![\w.])'
    rf"|(?:{FUNCTION_NAMES})\s*\[)",
    re.IGNORECASE,
)

_KEYWORD = re.compile(r"\s*([^\W\d]+(?:\.[^\W\d]+)*)")
_KEYWORD_AND_DIGITS = re.compile(r"\s*([^\W\d]+\d+(?:_\w+)?)\s*=(?!=)")
_ORDINAL_KEYWORD = re.compile(r"\s*(\d(?:ST|ND)_[^\W\d]+)", re.IGNORECASE)
_CALL_KEYWORD = re.compile(r"\s*(@[^\W\d]+\d*)\s*=(?!=)")
_GLUED_VALUE = re.compile(r"[-+]?\.?\d")


Item = Keyword | Expression


class Sized(NamedTuple):
    """An expression with the height of its tree in nodes."""

    node: Expression
    height: int


class _SizedTarget(NamedTuple):
    node: Variable | Parameter
    height: int


class _PendingOperator(NamedTuple):
    """An operator without its right operand; ``start``: its position in the text."""

    symbol: str
    precedence: int
    prefix: bool
    start: int


def parse_expression(text: BlockText, *, names: bool = True) -> Expression:
    """Return the expression at the reading position; ``names``: a bare word is a value, too."""
    return _expression(text, 0, names).node


def starts_value(text: BlockText) -> bool:
    """Return whether a value other than a bare word follows."""
    return text.looking_at(_STARTS_VALUE) is not None


def parse_target(text: BlockText) -> Variable | Parameter | None:
    """Return the variable or parameter that follows, ``None`` if there is none."""
    target = _target(text, 0)
    return None if target is None else target.node


def expected(
    text: BlockText, message: Message = VALUE_EXPECTED, symbol: str | None = None
) -> BlockError:
    """Return the error for something missing at the reading position; shows the text there."""
    token = text.looking_at(_NEXT_TOKEN)
    word: str | Text = END_OF_BLOCK
    if token is None:
        start = len(text.text.rstrip())
        end = start + 1
    else:
        start, end = token.span(1)
        word = quoted(token[1])
    if symbol is None:
        return BlockError(message, start, end, found=word)
    return BlockError(message, start, end, found=word, symbol=symbol)


def number_at(text: BlockText, start: int, end: int) -> Number:
    """Return the literal at a position; raises ``BlockError`` 900119 if float64 cannot hold it."""
    value = float(text.text[start:end])
    if isinf(value):
        raise BlockError(NUMBER_TOO_LARGE, start, end)
    return Number(text.span(start, end), value)


def unreadable(text: BlockText) -> BlockError:
    """Return the error for unexpected text at the reading position."""
    closing = text.looking_at(CLOSING)
    if closing is not None:
        return BlockError(UNMATCHED_CLOSING_BRACKET, closing.end() - 1, closing.end())
    return expected(text, UNEXPECTED_TEXT)


def shown(piece: str) -> str:
    """Return a piece of the text for a message, cut to 40 characters, all printable."""
    return "".join(c if c.isprintable() else f"U+{ord(c):04X}" for c in piece[:40])


def quoted(piece: str) -> str:
    """Return a piece of the text for a message, in quotation marks."""
    return f"'{shown(piece)}'"


def require(text: BlockText, pattern: re.Pattern[str], symbol: str) -> None:
    """Skip a required sign; raises ``BlockError`` if it is missing."""
    if text.match(pattern) is None:
        raise expected(text, SYMBOL_EXPECTED, symbol=symbol)


def _expression(text: BlockText, depth: int, names: bool) -> Sized:
    """Return an expression; an operator is applied when one of lower precedence follows."""
    if depth > EXPRESSION_DEPTH:
        raise _too_deep(text)
    operands: list[Sized] = []
    waiting: list[_PendingOperator] = []
    while True:
        while (prefix := text.match(_PREFIX)) is not None:
            symbol = prefix[1].upper()
            # A plus sign as a prefix makes no node.
            if symbol != "+":
                waiting.append(
                    _PendingOperator(symbol, PREFIX[symbol].precedence, True, prefix.start(1))
                )
        operands.append(_operand(text, depth, names))
        infix = text.match(_INFIX)
        if infix is None:
            break
        symbol = infix[1].upper()
        operator = INFIX[symbol]
        while waiting and (
            waiting[-1].precedence > operator.precedence
            or (waiting[-1].precedence == operator.precedence and not operator.right_associative)
        ):
            _apply(text, waiting.pop(), operands)
        waiting.append(_PendingOperator(symbol, operator.precedence, False, infix.start(1)))
    while waiting:
        _apply(text, waiting.pop(), operands)
    assert len(operands) == 1
    return operands[0]


def _apply(text: BlockText, operator: _PendingOperator, operands: list[Sized]) -> None:
    right = operands.pop()
    if operator.prefix:
        operand = right.node
        if operator.symbol == "-" and isinstance(operand, Number):
            span = text.span(operator.start, text.pos)
            operands.append(Sized(Number(span, 0.0 - operand.value), 1))
            return
        height = right.height + 1
        node: Expression = Unary(text.span(operator.start, text.pos), operator.symbol, operand)
    else:
        left = operands.pop()
        height = max(left.height, right.height) + 1
        span = text.span(operator.start, operator.start + len(operator.symbol))
        node = Binary(span, operator.symbol, left.node, right.node)
    operands.append(Sized(node, _checked(text, height)))


def _too_deep(text: BlockText) -> BlockError:
    start = min(text.skip_blanks(), len(text.text) - 1)
    return BlockError(EXPRESSION_TOO_DEEP, start, start + 1, limit=EXPRESSION_DEPTH)


def _operand(text: BlockText, depth: int, names: bool) -> Sized:
    """Return a number, text, variable, parameter, function, constant, bracket or bare word."""
    number = text.match(NUMBER)
    if number is not None:
        return Sized(number_at(text, *number.span(1)), 1)
    target = _target(text, depth)
    if target is not None:
        return Sized(*target)
    if text.looking_at(OPENING) is not None:
        return _brackets(text, depth)
    call = text.looking_at(_CALL)
    if call is not None:
        text.pos = call.end() - 1
        arguments = parse_list(text, depth)
        height = _checked(text, 1 + max(argument.height for argument in arguments))
        nodes = tuple(argument.node for argument in arguments)
        return Sized(Call(text.span(*call.span(1)), call[1].upper(), nodes), height)
    string = text.match(STRING)
    if string is not None:
        return Sized(StringLiteral(text.span(string.start(1) - 1, string.end()), string[1]), 1)
    name = text.looking_at(_NAME)
    if name is not None:
        upper = name[1].upper()
        if upper in CONSTANTS:
            text.pos = name.end()
            return Sized(Constant(text.span(*name.span(1)), upper), 1)
        if names:
            text.pos = name.end()
            return Sized(Name(text.span(*name.span(1)), upper, name[1]), 1)
    start = text.skip_blanks()
    if text.text.startswith('"', start):
        raise BlockError(TEXT_NOT_CLOSED, start, start + 1)
    raise expected(text)


def _brackets(text: BlockText, depth: int) -> Sized:
    """Return the value in brackets, ``[a]``, or the value of an array, ``[a, b]``."""
    start = text.skip_blanks()
    items = parse_list(text, depth)
    if len(items) == 1:
        return items[0]
    height = _checked(text, 1 + max(item.height for item in items))
    return Sized(ArrayLiteral(text.span(start, text.pos), tuple(i.node for i in items)), height)


def parse_list(text: BlockText, depth: int = 0) -> list[Sized]:
    """Return the values of ``[a, b, …]`` at the reading position, at least one."""
    start = text.skip_blanks()
    require(text, OPENING, "[")
    items = [_expression(text, depth + 1, True)]
    while text.match(COMMA) is not None:
        items.append(_expression(text, depth + 1, True))
    if text.match(CLOSING) is None:
        if text.at_end():
            raise BlockError(BRACKET_NOT_CLOSED, start, start + 1)
        raise expected(text, SYMBOL_EXPECTED, symbol="]")
    return items


def _target(text: BlockText, depth: int) -> _SizedTarget | None:
    variable = text.match(VARIABLE)
    if variable is not None:
        start = variable.end() - len("Vs." if variable[1] else "V.")
        return _variable(text, start, variable[1] is not None, depth, False)
    match = text.match(PARAMETER)
    if match is None:
        return None
    is_of_call = match[1] is not None
    start, end = match.start(1 if is_of_call else 2), match.end()
    if match[3] is not None:
        if text.looking_at(_INDEX) is not None and not is_of_call:
            return _parameter_array(text, match, depth)
        index = Sized(number_at(text, *match.span(3)), 1)
    else:
        items = parse_list(text, depth)
        if len(items) != 1:
            raise BlockError(UNEXPECTED_TEXT, end, end + 1, found=quoted("["))
        index = items[0]
    parameter, height = Parameter(text.span(start, text.pos), index.node, is_of_call), index.height
    for _ in (match[2] or "")[1:]:
        parameter, height = Parameter(parameter.span, parameter), height + 1
    return _SizedTarget(parameter, _checked(text, height + 1))


def _parameter_array(text: BlockText, match: re.Match[str], depth: int) -> _SizedTarget:
    """Return the element of an array of P parameters; its indices follow, ``P10[1][2]``."""
    if len(match[2]) > 1:
        raise BlockError(
            INDIRECT_PARAMETER_ARRAY, match.start(2), match.end(), word=match[0].strip()
        )
    indices, height = _indices(text, depth)
    start, end = match.span(3)
    span = text.span(match.start(2), text.pos)
    part = Part(text.span(start, text.pos), str(int(text.text[start:end])), tuple(indices))
    return _SizedTarget(Variable(span, PARAMETER_ARRAYS, (part,), False), _checked(text, height))


def _indices(text: BlockText, depth: int) -> tuple[list[Expression], int]:
    """Return the indices ``[1][2]`` or ``[1, 2]`` that follow, and the height of their node."""
    indices: list[Expression] = []
    height = 1
    while text.looking_at(_INDEX) is not None:
        for index in parse_list(text, depth):
            indices.append(index.node)
            height = max(height, index.height + 1)
    return indices, height


def parse_variable(text: BlockText, *, whole_family: bool = False) -> Variable | None:
    """Return the variable that follows; ``whole_family``: ``V.E.`` needs no name."""
    match = text.match(VARIABLE)
    if match is None:
        return None
    start = match.end() - len("Vs." if match[1] else "V.")
    node = _variable(text, start, match[1] is not None, 0, whole_family).node
    assert isinstance(node, Variable)
    return node


def _variable(
    text: BlockText, start: int, synchronous: bool, depth: int, whole_family: bool
) -> _SizedTarget:
    """Return the variable whose family follows; ``start``: the position of its ``V``."""
    family = text.match(_FAMILY)
    if family is None:
        raise expected(text, NAME_EXPECTED)
    parts = []
    height = 1
    while (part := text.match(_PART)) is not None:
        indices, inner = _indices(text, depth)
        height = max(height, inner)
        parts.append(Part(text.span(part.start(1), text.pos), part[1], tuple(indices)))
    open_end = text.text.startswith(".", text.pos)
    text.pos += open_end
    if (open_end and parts) or not (parts or whole_family):
        raise expected(text, NAME_EXPECTED)
    span = text.span(start, text.pos)
    variable = Variable(span, family[0].upper(), tuple(parts), synchronous)
    return _SizedTarget(variable, _checked(text, height))


def _checked(text: BlockText, height: int) -> int:
    if height > EXPRESSION_DEPTH:
        raise _too_deep(text)
    return height


# --- keywords in brackets ------------------------------------------------------------------------


def is_keyword_list(text: BlockText) -> bool:
    """Return whether the ``[`` at the reading position opens keywords rather than a value."""
    opening = text.looking_at(OPENING)
    assert opening is not None
    if CLOSING.match(text.text, opening.end()) is not None:
        return True
    for keyword in (_CALL_KEYWORD, _ORDINAL_KEYWORD):
        if keyword.match(text.text, opening.end()) is not None:
            return True
    return _STARTS_VALUE.match(text.text, opening.end()) is None


def parse_items(
    text: BlockText, depth: int = 0, item: Callable[[BlockText, int], Item] | None = None
) -> tuple[Item, ...]:
    """Return the keywords and values of ``[ … ]``, with or without commas between them.

    ``item`` reads one of them, by default ``parse_item``.
    """
    start = text.skip_blanks()
    require(text, OPENING, "[")
    if depth > EXPRESSION_DEPTH:
        raise _too_deep(text)
    items: list[Item] = []
    while text.match(CLOSING) is None:
        if text.at_end():
            raise BlockError(BRACKET_NOT_CLOSED, start, start + 1)
        if text.match(COMMA) is None:
            items.append((item or parse_item)(text, depth))
    return tuple(items)


def parse_item(text: BlockText, depth: int = 0) -> Item:
    """Return one keyword with its value, or one value."""
    named = text.match(_CALL_KEYWORD)
    if named is None and not starts_value(text):
        named = text.match(_KEYWORD_AND_DIGITS)
    if named is not None:
        value = _expression(text, depth, True).node
        return Keyword(text.span(*named.span(1)), named[1].upper(), value)
    keyword = text.match(_ORDINAL_KEYWORD)
    if keyword is None and starts_value(text):
        return _expression(text, depth, True).node
    keyword = keyword or text.match(_KEYWORD)
    if keyword is None:
        raise unreadable(text)
    span, name = text.span(*keyword.span(1)), keyword[1].upper()
    if text.match(EQUALS) is not None or text.looking_at(_GLUED_VALUE) is not None:
        return Keyword(span, name, _expression(text, depth, True).node)
    if text.looking_at(_INDEX) is not None:
        return Keyword(span, name, None, parse_items(text, depth + 1))
    return Keyword(span, name)
