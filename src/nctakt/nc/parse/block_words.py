# SPDX-License-Identifier: MIT
"""The words of a block -> statements.

In: a block's text after its head. Out: a ``Block``, or assignments, calls and macro definitions;
one line may hold several, and a jump after G310. Words need no blanks between them and allow
blanks nearly everywhere. Blocks of letters and numbers only, the majority in most programs, are
read with one pattern per word.
"""

from __future__ import annotations

import re
from string import ascii_letters
from typing import NamedTuple, cast

from nctakt.base.diagnostics import Span
from nctakt.base.misspelling import nearest
from nctakt.messages.programs.nc_text import NAME_EXPECTED, TEXT_NOT_CLOSED
from nctakt.messages.programs.program_structure import (
    CYCLE_CALL_WITHOUT_NAME,
    INVALID_CALL_PARAMETER,
)
from nctakt.nc.parse.block_head import parse_label
from nctakt.nc.parse.expressions import (
    EQUALS,
    FUNCTION_NAMES,
    OPENING,
    STRING,
    expected,
    is_keyword_list,
    number_at,
    parse_expression,
    parse_item,
    parse_items,
    parse_list,
    parse_target,
    parse_variable,
    starts_value,
    unreadable,
)
from nctakt.nc.parse.lexer import BlockError, BlockText
from nctakt.nc.tree import (
    NO_HEAD,
    Assignment,
    AssignmentOperator,
    AxisWord,
    Block,
    BlockWord,
    BracketCommand,
    Expression,
    Goto,
    Head,
    If,
    Keyword,
    MacroDefinition,
    Number,
    OffsetCommand,
    OffsetCommandName,
    Part,
    Statement,
    StringLiteral,
    StringWord,
    SubprogramCall,
    Variable,
    VariableBlock,
    Word,
)
from nctakt.nc.vocabulary.functions import INTERRUPTIBLE

#: Letters that the name of an axis may begin with.
AXIS_LETTERS = frozenset("ABCQUVWXYZ")
#: Letters whose number may be followed by a further value: ``M110=130``, ``G129=50``.
_NUMBERED = frozenset("DGHMT")
#: Letters of functions of the PLC.
_FUNCTIONS = frozenset("HM")

# L is a call, N a block number, P a parameter: never plain.
_PLAIN_WORD = re.compile(r"\s*([A-KMOQ-Za-kmoq-z])\s*([+-]?(?:\d+\.?\d*|\.\d+))", re.ASCII)
_PLAIN_KINDS: dict[str, tuple[type[AxisWord] | type[Word], str]] = {
    letter: (AxisWord if letter.upper() in AXIS_LETTERS else Word, letter.upper())
    for letter in ascii_letters
}
_TARGET = re.compile(r"\s*(?:Vs?\.|@?P+(?:\d|\[))", re.IGNORECASE)
_GOTO = re.compile(r"\s*(\$GOTO)(?!\w)", re.IGNORECASE)
_END_OF_WORDS = re.compile(f"{_TARGET.pattern}|{_GOTO.pattern}", re.IGNORECASE)
_ASSIGN = re.compile(r"\s*([-+*/]?=)(?!=)")
_LETTERS = re.compile(r"\s*([^\W\d]+)")
_NAMED = re.compile(r"\s*([^\W\d]+)(\d*)\s*=(?!=)")
_NAMED_COMMAND = re.compile(r"\s*([^\W\d]+\d+)(?=\s*\[)")
_LONG_NAME = re.compile(
    r"""\s*( S\.(?:POS|OFFSET)(?![^\W\d])
          | \#\s*(?:CHR|CHF|RND|FRC)(?=\s*=)
          | \#\s*ANG(?!\w)
          | \#\s*(?:SET\s+)?SPLINE\s+(?:ON|OFF)\b
          | \#\s*(?:AKIMA\s+(?:START|END)VECTOR|SET\s+ASPLINE\s+(?:STARTTANG|ZIELTANG))\b )""",
    re.IGNORECASE | re.VERBOSE,
)
_GLUED = re.compile(rf"(?:Vs?\.|@|P+(?:\d|\[)|(?:{FUNCTION_NAMES})\s*\[)", re.IGNORECASE)
#: A text that may hold names of macros between \" and \".
_MACRO_TEXT = re.compile(r'\s*"((?:[^"\\]|\\"|\\(?!"))*)"')
_DIGITS = re.compile(r"\.?\d")
_BARE_VALUE = re.compile(r"\s+(?:[-+\d]|\.\d|Vs?\.|P+(?:\d|\[))", re.IGNORECASE)
_CALL = re.compile(
    r"""\s*(LL|L(?!L)|ll|l(?!l))
        (?: (?=\s*") | \s+(?=[^\s=\[+\-])                # a text, or a blank and a name,
          | (?=[A-Z\d])(?![A-Z]+\d*\s*(?:=|\[)) )         # or glued: LM06, but not LX=5""",
    re.VERBOSE,
)
_OFFSETS = re.compile(
    r"\s*#\s*(PSET|PRESET|SUPPRESS\s+OFFSETS|SCALE(?!\s+OFF(?!\w))(?:\s+ON)?)(?!\w)", re.IGNORECASE
)
_CALL_CYCLE = re.compile(r"\s*CYCLE(?=\s*\[)", re.IGNORECASE)
_CALL_NAME = re.compile(r"\s*([^\s\[\]\"]+)")
_NAME_KEYWORD = re.compile(r"\s*(NAME)\s*=", re.IGNORECASE)


def parse_plain(text: BlockText, head: Head) -> Block | None:
    """Return the block if it consists of letters with numbers only; else leave the position
    unchanged.
    """
    if len(text.pieces) > 1:
        return None
    content, file, line = text.text, text.file, text.line_number
    next_word = _PLAIN_WORD.match
    words: list[BlockWord] = []
    start = end = text.pos
    while (match := next_word(content, end)) is not None:
        letter, number = match.groups()
        column = match.start(1) + 1
        digits_at, end = match.span(2)
        value = Number(Span(file, line, digits_at + 1, end + 1), float(number))
        make, name = _PLAIN_KINDS[letter]
        words.append(make(Span(file, line, column, end + 1), name, value))
    # The general parser reports a number too large for float64.
    if not words or end - start > 300 or not (end == len(content) or content[end:].isspace()):
        return None
    text.pos = len(content)
    return Block(Span(file, line, start + 1, end + 1), head, tuple(words))


def parse_content(text: BlockText, head: Head) -> list[Statement]:
    """Return the statements of the rest of the block, at least one; the first has the head.

    All of them have its skip level.
    """
    plain = parse_plain(text, head)
    if plain is not None:
        return [plain]
    statements = [_statement(text, head)]
    rest = NO_HEAD if head.skip is None else Head(skip=head.skip)
    while not text.at_end() and text.looking_at(_GOTO) is None:
        statements.append(_statement(text, rest))
    if not text.at_end():
        statements.append(_jump_of(statements[-1], text, rest))
    return statements


def _jump_of(block: Statement, text: BlockText, head: Head) -> Statement:
    """Return the ``$GOTO`` of ``G310 X10 $GOTO[A]``: a jump if the first axis has touched.

    Raises ``BlockError`` after any other block.
    """
    words = block.words if isinstance(block, Block) else ()
    axis = next((word.name for word in words if isinstance(word, AxisWord)), "")
    if not axis or not any(_interrupts(word) for word in words):
        raise unreadable(text)
    match = text.match(_GOTO)
    assert match is not None
    start = match.start(1)
    label = parse_label(text)
    if label is None:
        raise expected(text, NAME_EXPECTED)
    span = text.span(start, text.pos)
    has_touched = Variable(span, "A", (Part(span, "MERF"), Part(span, axis)))
    return If(span, head, None, has_touched, (Goto(span, NO_HEAD, label),))


def _interrupts(word: BlockWord) -> bool:
    return (
        isinstance(word, Word)
        and word.name == "G"
        and isinstance(word.value, Number)
        and word.value.value == INTERRUPTIBLE
    )


def begins_with_word(text: BlockText) -> bool:
    """Return whether the rest of a block begins with a word like ``#CHR=2``."""
    return text.looking_at(_LONG_NAME) is not None


def parse_offsets(text: BlockText, head: Head) -> OffsetCommand | None:
    """Return a ``#`` command followed by words of a block; ``None`` for any other command."""
    start = text.skip_blanks()
    match = text.match(_OFFSETS)
    if match is None:
        return None
    name = cast(OffsetCommandName, " ".join(match[1].upper().split()))
    kinds = parse_items(text) if text.looking_at(OPENING) is not None else ()
    words: list[BlockWord] = []
    while not text.at_end():
        words.append(_word(text))
    end = start + len(text.text[start:].rstrip())
    return OffsetCommand(text.span(start, end), head, name, kinds, tuple(words))


def _statement(text: BlockText, head: Head) -> Statement:
    """Return one statement; its words end where an assigned or bare variable begins."""
    start = text.skip_blanks()
    if text.looking_at(_TARGET) is not None:
        return _assignment(text, head)
    words: list[BlockWord] = []
    call: _Call | None = None
    while not text.at_end() and text.looking_at(_END_OF_WORDS) is None:
        quoted = text.match(STRING)
        if quoted is not None:
            if not words and text.match(EQUALS) is not None:
                return _macro(text, head, start, quoted[1])
            span = text.span(quoted.start(1) - 1, quoted.end())
            words.append(StringWord(span, quoted[1]))
        elif call is None and (match := text.match(_CALL)) is not None:
            call = _call(text, local=len(match[1]) == 2)
        else:
            words.append(_word(text))
    end = start + len(text.text[start : text.pos].rstrip())
    span = text.span(start, end)
    if call is None:
        return Block(span, head, tuple(words))
    return SubprogramCall(span, head, *call, tuple(words))


def _assignment(text: BlockText, head: Head) -> Statement:
    start = text.pos
    target = parse_target(text)
    assert target is not None
    match = text.match(_ASSIGN)
    if match is None:
        return VariableBlock(text.span(start, text.pos), head, target)
    value = parse_expression(text)
    operator = cast(AssignmentOperator, match[1])
    return Assignment(text.span(start, text.pos), head, target, operator, value)


def _macro(text: BlockText, head: Head, start: int, name: str) -> MacroDefinition:
    value = text.match(_MACRO_TEXT) or text.match(STRING)
    if value is None:
        raise expected(text)
    meaning = value[1].replace('\\"', '"')
    return MacroDefinition(text.span(start, text.pos), head, name, meaning)


# --- calls ---------------------------------------------------------------------------------------


class _Call(NamedTuple):
    local: bool
    name: Expression
    cycle: bool
    keywords: tuple[Keyword | Expression, ...]


def _call(text: BlockText, *, local: bool) -> _Call:
    if text.match(_CALL_CYCLE) is None:
        return _Call(local, _called_name(text), False, ())
    start = text.skip_blanks()
    keywords: list[Keyword | Expression] = []
    name: Expression | None = None
    for item in parse_items(text, item=_call_item):
        if name is None and isinstance(item, Keyword) and item.name == "NAME":
            name = item.value
        else:
            keywords.append(item)
    if name is None:
        raise _without_name(keywords, start)
    return _Call(local, name, True, tuple(keywords))


def _without_name(keywords: list[Keyword | Expression], start: int) -> BlockError:
    """Return the error for a call without NAME: a misspelt keyword if there is one."""
    for item in keywords:
        if isinstance(item, Keyword) and nearest(item.name, ("NAME",)):
            return BlockError(
                INVALID_CALL_PARAMETER, 0, 0, item.span, word=item.name, nearest="NAME"
            )
    return BlockError(CYCLE_CALL_WITHOUT_NAME, start, start + 1)


def _call_item(text: BlockText, depth: int) -> Keyword | Expression:
    match = text.match(_NAME_KEYWORD)
    if match is None:
        return parse_item(text, depth)
    return Keyword(text.span(*match.span(1)), "NAME", _called_name(text))


def _called_name(text: BlockText) -> Expression:
    """Return a quoted text, a variable, or the characters up to the next blank or bracket."""
    quoted = text.match(STRING)
    if quoted is not None:
        return StringLiteral(text.span(quoted.start(1) - 1, quoted.end()), quoted[1])
    variable = parse_variable(text)
    if variable is not None:
        return variable
    match = text.match(_CALL_NAME)
    if match is None:
        raise expected(text, NAME_EXPECTED)
    return StringLiteral(text.span(*match.span(1)), match[1])


# --- words ---------------------------------------------------------------------------------------


def _word(text: BlockText) -> BlockWord:
    long_name = text.match(_LONG_NAME)
    if long_name is not None:
        name = " ".join(long_name[1].upper().split()).replace("# ", "#")
        value = None if " " in name else _optional_value(text, equals=True)
        return _make(text, name, long_name.start(1), value)
    named = text.match(_NAMED)
    if named is not None:
        return _named_word(text, named)
    letters = text.match(_LETTERS)
    if letters is None:
        raise _unreadable_word(text)
    start, end = letters.span(1)
    if _GLUED.match(text.text, start + 1) is not None:
        text.pos = start + 1
        return _computed(text, letters[1][0], start, parse_expression(text, names=False))
    text.pos = start
    command = text.match(_NAMED_COMMAND)
    if command is not None:
        return _numbered_command(text, command)
    text.pos = end
    name = letters[1]
    if text.looking_at(OPENING) is not None and is_keyword_list(text):
        items = parse_items(text)
        return BracketCommand(text.span(start, text.pos), name.upper(), items)
    if len(name) > 1 and text.looking_at(OPENING) is None and text.looking_at(_DIGITS) is None:
        return _make(text, name, start, None)
    value = _optional_value(text, equals=False)
    if name.upper() == "G" and isinstance(value, Number) and value.value.is_integer():
        return _with_bare_value(text, start, value)
    return _computed(text, name, start, value)


def _computed(text: BlockText, name: str, start: int, value: Expression | None) -> BlockWord:
    """Return a word with a computed value: ``XP1``, or ``M[P1]=5`` with an additional value."""
    if name.upper() in _FUNCTIONS and value is not None and text.match(EQUALS) is not None:
        additional = parse_expression(text, names=False)
        return Word(text.span(start, text.pos), name.upper(), value, additional)
    return _make(text, name, start, value)


def _make(text: BlockText, name: str, start: int, value: Expression | None) -> BlockWord:
    span = text.span(start, text.pos)
    upper = name.upper()
    if upper[0] in AXIS_LETTERS:
        return AxisWord(span, upper, value)
    return Word(span, upper, value)


def _optional_value(text: BlockText, *, equals: bool) -> Expression | None:
    if equals and text.match(EQUALS) is not None:
        return parse_expression(text, names=False)
    return parse_expression(text, names=False) if starts_value(text) else None


def _named_word(text: BlockText, named: re.Match[str]) -> BlockWord:
    """Return a word of the form ``X1=10``, ``F=100``, ``M110=130``."""
    letters, digits = named[1].upper(), named[2]
    if digits and letters[1:] == "P" and letters[0] in _FUNCTIONS:
        text.pos = named.start(1) + 1
        number = parse_expression(text, names=False)
        return _computed(text, letters[0], named.start(1), number)
    value = parse_expression(text, names=False)
    if digits and letters in _NUMBERED:
        span = text.span(named.start(1), text.pos)
        number = number_at(text, *named.span(2))
        return Word(span, letters, number, value)
    return _make(text, letters + digits, named.start(1), value)


def _numbered_command(text: BlockText, command: re.Match[str]) -> BlockWord:
    """Return a word of the form ``S2[M03 REV=1000]``, ``M17[MAIN]``, ``G805[1, 2]``."""
    name = command[1].upper()
    if name[0] == "G" and name[1:].isdigit():
        number = number_at(text, command.start(1) + 1, command.end(1))
        arguments = tuple(item.node for item in parse_list(text))
        return Word(text.span(command.start(1), text.pos), "G", number, None, arguments)
    items = parse_items(text)
    return BracketCommand(text.span(command.start(1), text.pos), name, items)


def _with_bare_value(text: BlockText, start: int, value: Number) -> Word:
    """Return a G word with the value after it, ``G04 3.0``, unless that is an assignment's
    target.
    """
    end = text.pos
    additional: Expression | None = None
    if text.looking_at(_BARE_VALUE) is not None:
        additional = parse_expression(text, names=False)
        if text.looking_at(_ASSIGN) is not None:
            text.pos, additional = end, None
    return Word(text.span(start, text.pos), "G", value, additional)


def _unreadable_word(text: BlockText) -> BlockError:
    start = text.skip_blanks()
    if text.text.startswith('"', start):
        return BlockError(TEXT_NOT_CLOSED, start, start + 1)
    return unreadable(text)
