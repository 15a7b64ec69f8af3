# SPDX-License-Identifier: MIT
"""Lines that open, divide or close a structure, and jumps: ``$`` words, ``#RT CYCLE``, ``#IF``.

In: a block's text at its ``$`` or ``#``. Out: changes of the open structures. A structure is opened
even if its condition cannot be read, so that its end does not cause a second message. A misspelt
word of a structure is reported and taken as intended; otherwise each later line of the structure
would be wrong as well.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple, cast

from nctakt.base.diagnostics import NOTHING, Span
from nctakt.base.misspelling import nearest
from nctakt.messages.path.backward import RT_WHILE_NESTED
from nctakt.messages.programs.checked_blocks import UNKNOWN_COMMAND
from nctakt.messages.programs.nc_text import (
    BRANCH_AFTER_ELSE,
    CYCLE_BEGIN_END_MISMATCH,
    EQUALS_BEFORE_CONDITION,
    NAME_EXPECTED,
    STRUCTURE_NOT_OPENED,
    UNEXPECTED_TEXT,
    UNKNOWN_CONTROL_WORD,
    UNKNOWN_CYCLE_KEYWORD,
)
from nctakt.nc.parse.block_head import parse_label
from nctakt.nc.parse.block_words import parse_offsets
from nctakt.nc.parse.expressions import (
    COMMA,
    EQUALS,
    expected,
    parse_expression,
    parse_target,
    quoted,
    require,
    shown,
    unreadable,
)
from nctakt.nc.parse.hash_commands import (
    CYCLE_ACTIONS,
    RawCommand,
    cycle_control,
    cycle_keywords,
    parse_arguments,
    parse_words,
    simple_command,
)
from nctakt.nc.parse.lexer import BlockError, BlockText
from nctakt.nc.parse.open_structures import (
    CycleFrame,
    DoFrame,
    ForFrame,
    Frame,
    IfFrame,
    LoopFrame,
    Opening,
    RepeatFrame,
    SwitchFrame,
    VariablesFrame,
    WhileFrame,
)
from nctakt.nc.parse.structure_stack import StructureStack
from nctakt.nc.tree import (
    Break,
    Constant,
    Continue,
    Expression,
    Frequency,
    Goto,
    Head,
    If,
    Keyword,
    Name,
    Statement,
)
from nctakt.nc.vocabulary import support_level

_DOLLAR_WORD = re.compile(r"\s*\$([^\W\d]*)")
_PREPROCESSOR = re.compile(r"\s*#\s*(IF|ELSEIF|ELSE|ENDIF)(?!\w)", re.IGNORECASE)
_FREQUENCY = re.compile(r"\s*(ONCE|EDGE|ALWAYS)(?!\w)", re.IGNORECASE)
_DOLLAR = re.compile(r"\s*\$")
_ENDS_IN_LINE = re.compile(r"[^\s$][^$]*\$ENDIF\s*$", re.IGNORECASE)


class CurrentLine(NamedTuple):
    """The line being read: its text, head, open structures, and first word with ``$`` or ``#``."""

    text: BlockText
    head: Head
    structures: StructureStack
    start: int
    word: str

    def span(self) -> Span:
        """Return the span of the first word."""
        return self.text.span(self.start, self.start + len(self.word))

    def opening(self, end: str) -> Opening:
        """Return this line as the opening of a structure that ends with ``end``."""
        span = self.span()
        return Opening(self.word, end, span, self.text.source_line(span), self.head)


def control_line(text: BlockText, head: Head, structures: StructureStack) -> None:
    """Read a line that begins with ``$``; raises ``BlockError``."""
    match = text.match(_DOLLAR_WORD)
    assert match is not None
    word = "$" + match[1].upper()
    start = match.start(1) - 1
    word = control_word(text, start, word, CONTROL_WORDS, structures)
    CONTROL_WORDS[word](CurrentLine(text, head, structures, start, word))


def hash_line(text: BlockText, head: Head, structures: StructureStack) -> None:
    """Read a line that begins with ``#``; raises ``BlockError``."""
    start = text.skip_blanks()
    preprocessor = text.match(_PREPROCESSOR)
    if preprocessor is not None:
        word = "#" + preprocessor[1].upper()
        _PREPROCESSOR_LINES[word](CurrentLine(text, head, structures, start, word))
        return
    offsets = parse_offsets(text, head)
    if offsets is not None:
        structures.add_block(offsets, text)
        return
    written = words = parse_words(text)
    name = tuple(word.name for word in words)
    handler = _HASH_LINES.get(name[:2]) or _HASH_LINES.get(name)
    if handler is None and support_level.hash_command(name) is None:
        words = structure_command(text, words, _HASH_LINES, structures)
        name = tuple(word.name for word in words)
        handler = _HASH_LINES.get(name[:2]) or _HASH_LINES.get(name)
    try:
        arguments = parse_arguments(text, name)
    except BlockError as error:
        if handler is None:
            raise
        # The line opens or closes its structure even if the rest of it cannot be read.
        structures.block_error(text, error)
        arguments = ()
        text.pos = len(text.text)
    command = RawCommand(start, text.pos, words, arguments)
    if handler is not None:
        handler(CurrentLine(text, head, structures, start, "#" + " ".join(name[:2])), command)
        if words is not written and isinstance(structures.top, CycleFrame):
            structures.top.reported = True
    else:
        structures.add_block(simple_command(text, head, command), text)


# --- conditions ----------------------------------------------------------------------------------


def _value(current: CurrentLine) -> Expression:
    """Return the expression that follows; report a missing one and return TRUE for it.

    An ``=`` before it is reported and left out.
    """
    equals = current.text.match(EQUALS)
    if equals is not None:
        error = BlockError(
            EQUALS_BEFORE_CONDITION, equals.end() - 1, equals.end(), word=current.word
        )
        current.structures.block_error(current.text, error)
    try:
        return parse_expression(current.text)
    except BlockError as error:
        current.structures.block_error(current.text, error)
        current.text.pos = len(current.text.text)
        return Constant(current.span(), "TRUE")


def _frequency(current: CurrentLine) -> Frequency | None:
    match = current.text.match(_FREQUENCY)
    return None if match is None else cast(Frequency, match[1].upper())


def _stray(current: CurrentLine, begin: str) -> None:
    span = current.span()
    line = current.text.source_line(span)
    if current.text.text_of(span).replace(" ", "").upper() == current.word.replace(" ", ""):
        # A misspelt one has been reported.
        current.structures.report(STRUCTURE_NOT_OPENED, span, line, word=current.word, begin=begin)
    current.text.pos = len(current.text.text)


def _find(current: CurrentLine, begin: str) -> Frame | None:
    """Return the structure that this line divides or closes; report it if there is none."""
    frame = current.structures.find(lambda open_frame: open_frame.opening.begin == begin)
    if frame is None:
        _stray(current, begin)
    return frame


# --- $IF, #IF ------------------------------------------------------------------------------------


def _if(current: CurrentLine) -> None:
    text = current.text
    frequency = _frequency(current)
    begin = text.pos
    condition = _value(current)
    failed = condition.span == current.span()
    if failed and "$" in text.text[begin:]:
        # A jump in the same line, most likely: it needs no $ENDIF.
        return
    if not failed and _ENDS_IN_LINE.search(text.text, text.pos) is not None:
        raise unreadable(text)
    if text.looking_at(_DOLLAR) is not None:
        body = _one_line_body(text)
        current.structures.add_block(
            If(current.span(), current.head, frequency, condition, (body,)), text
        )
    else:
        frame = IfFrame(current.opening("$ENDIF"), frequency, condition, preprocessor=False)
        current.structures.open(frame)


def _one_line_body(text: BlockText) -> Statement:
    """Return the jump after a condition in the same line."""
    match = text.match(_DOLLAR_WORD)
    assert match is not None
    start = match.start(1) - 1
    make = _JUMPS.get("$" + match[1].upper())
    if make is None:
        raise BlockError(UNEXPECTED_TEXT, start, match.end(), found=quoted("$" + match[1]))
    return make(text, Head(), text.span(start, match.end()))


def _preprocessor_if(current: CurrentLine) -> None:
    current.structures.open(
        IfFrame(current.opening("#ENDIF"), None, _value(current), preprocessor=True)
    )


def _else_if(current: CurrentLine) -> None:
    frequency = _frequency(current)
    condition = _value(current)
    frame = _branch_of(current)
    if frame is not None:
        frame.add_branch(current.span(), current.head, frequency, condition)


def _else(current: CurrentLine) -> None:
    frame = _branch_of(current)
    if frame is not None:
        frame.add_else(current.span())


def _branch_of(current: CurrentLine) -> IfFrame | None:
    frame = _find(current, current.word[0] + "IF")
    if frame is None:
        return None
    assert isinstance(frame, IfFrame)
    if frame.else_body is not None:
        raise BlockError(
            BRANCH_AFTER_ELSE, current.start, current.start + len(current.word), word=current.word
        )
    return frame


def _end_if(current: CurrentLine) -> None:
    _close(current, current.word[0] + "IF")


def _close(current: CurrentLine, begin: str) -> None:
    frame = _find(current, begin)
    if frame is not None:
        current.structures.close(frame)


# --- loops and branches --------------------------------------------------------------------------


def _for(current: CurrentLine) -> None:
    """Open a ``$FOR`` loop; a ``$WHILE`` loop if its line cannot be read."""
    text = current.text
    opening = current.opening("$ENDFOR")
    try:
        target = parse_target(text)
        if target is None:
            raise expected(text, NAME_EXPECTED)
        require(text, EQUALS, "=")
        start = parse_expression(text)
        require(text, COMMA, ",")
        end = parse_expression(text)
        require(text, COMMA, ",")
        bounds = (start, end, parse_expression(text))
    except BlockError as error:
        current.structures.block_error(text, error)
        text.pos = len(text.text)
        current.structures.open(WhileFrame(opening, Constant(opening.span, "TRUE")))
        return
    current.structures.open(ForFrame(opening, target, bounds))


def _end_for(current: CurrentLine) -> None:
    _close(current, "$FOR")


def _while(current: CurrentLine) -> None:
    current.structures.open(WhileFrame(current.opening("$ENDWHILE"), _value(current)))


def _end_while(current: CurrentLine) -> None:
    _close(current, "$WHILE")


def _do(current: CurrentLine) -> None:
    current.structures.open(DoFrame(current.opening("$ENDDO")))


def _end_do(current: CurrentLine) -> None:
    _close_with_condition(current, "$DO")


def _repeat(current: CurrentLine) -> None:
    current.structures.open(RepeatFrame(current.opening("$UNTIL")))


def _until(current: CurrentLine) -> None:
    _close_with_condition(current, "$REPEAT")


def _close_with_condition(current: CurrentLine, begin: str) -> None:
    frame = _find(current, begin)
    if frame is not None:
        assert isinstance(frame, DoFrame | RepeatFrame)
        frame.condition = _value(current)
        current.structures.close(frame)


def _switch(current: CurrentLine) -> None:
    current.structures.open(SwitchFrame(current.opening("$ENDSWITCH"), _value(current)))


def _case(current: CurrentLine) -> None:
    value = _value(current)
    frame = _find(current, "$SWITCH")
    if frame is not None:
        assert isinstance(frame, SwitchFrame)
        frame.add_case(current.span(), current.head, value)


def _default(current: CurrentLine) -> None:
    frame = _find(current, "$SWITCH")
    if frame is not None:
        assert isinstance(frame, SwitchFrame)
        frame.add_case(current.span(), current.head, None)


def _end_switch(current: CurrentLine) -> None:
    _close(current, "$SWITCH")


# --- jumps ---------------------------------------------------------------------------------------


def _goto(text: BlockText, head: Head, span: Span) -> Statement:
    label = parse_label(text)
    if label is None:
        raise expected(text, NAME_EXPECTED)
    return Goto(span, head, label)


def _break(_: BlockText, head: Head, span: Span) -> Statement:
    return Break(span, head)


def _continue(_: BlockText, head: Head, span: Span) -> Statement:
    return Continue(span, head)


_JUMPS: dict[str, Callable[[BlockText, Head, Span], Statement]] = {
    "$GOTO": _goto,
    "$BREAK": _break,
    "$CONTINUE": _continue,
}


def _jump(current: CurrentLine) -> None:
    statement = _JUMPS[current.word](current.text, current.head, current.span())
    current.structures.add_block(statement, current.text)


#: Handlers of the words with ``$``.
CONTROL_WORDS: dict[str, Callable[[CurrentLine], None]] = {
    "$IF": _if,
    "$ELSEIF": _else_if,
    "$ELSE": _else,
    "$ENDIF": _end_if,
    "$FOR": _for,
    "$ENDFOR": _end_for,
    "$WHILE": _while,
    "$ENDWHILE": _end_while,
    "$DO": _do,
    "$ENDDO": _end_do,
    "$REPEAT": _repeat,
    "$UNTIL": _until,
    "$SWITCH": _switch,
    "$CASE": _case,
    "$DEFAULT": _default,
    "$ENDSWITCH": _end_switch,
    "$GOTO": _jump,
    "$BREAK": _jump,
    "$CONTINUE": _jump,
}

_PREPROCESSOR_LINES: dict[str, Callable[[CurrentLine], None]] = {
    "#IF": _preprocessor_if,
    "#ELSEIF": _else_if,
    "#ELSE": _else,
    "#ENDIF": _end_if,
}


# --- # structures --------------------------------------------------------------------------------


def _realtime_cycle(current: CurrentLine, command: RawCommand) -> None:
    words = command.name[2:]
    if words in ((), ("DEF",)):
        span = current.span()
        current.structures.close_cycle_before(span, current.text.source_line(span))
        frame = CycleFrame(current.opening("#RT CYCLE END"), definition_only=bool(words))
        current.structures.open(frame)
        frame.keywords = cycle_keywords(current.text, command)
    elif words[:1] == ("END",):
        _end_realtime_cycle(current, command)
    elif " ".join(words) in CYCLE_ACTIONS:
        current.structures.add_block(
            cycle_control(current.text, current.head, command), current.text
        )
    else:
        # If it was meant as a definition, its end follows and must not cause a second message.
        current.structures.expect_stray_cycle_end()
        has_action = words[0] in CYCLE_ACTIONS and len(words) > 1
        wrong = command.words[3 if has_action else 2]
        raise BlockError(UNKNOWN_CYCLE_KEYWORD, 0, 0, wrong.span, keyword=shown(wrong.text))


def _end_realtime_cycle(current: CurrentLine, command: RawCommand) -> None:
    frame = current.structures.find(lambda open_frame: isinstance(open_frame, CycleFrame))
    if frame is not None:
        assert isinstance(frame, CycleFrame)
        frame.end_span = current.text.span(command.start, command.end)
        current.structures.close(frame)
    elif not current.structures.forgive_cycle_end():
        raise BlockError(
            CYCLE_BEGIN_END_MISMATCH, command.start, command.end, found="#RT CYCLE END"
        )
    rest = (*command.words[3:], *command.arguments)
    if rest:
        written = quoted(current.text.text_of(rest[0].span))
        raise BlockError(UNEXPECTED_TEXT, 0, 0, rest[0].span, found=written)


def _realtime_loop(current: CurrentLine, command: RawCommand) -> None:
    """Open ``#RT WHILE``, with or without ``[MODULO]``."""
    frame = LoopFrame(current.opening("#RT ENDWHILE"))
    current.structures.open(frame)
    for wrong in command.words[2:]:
        raise BlockError(UNEXPECTED_TEXT, 0, 0, wrong.span, found=shown(wrong.text))
    for item in cycle_keywords(current.text, command):
        if not isinstance(item, Keyword) or item != Keyword(item.span, "MODULO", None):
            written = shown(current.text.text_of(item.span))
            raise BlockError(UNEXPECTED_TEXT, 0, 0, item.span, found=written)
        frame.modulo = True


def _end_realtime_loop(current: CurrentLine, command: RawCommand) -> None:
    frame = current.structures.find(lambda open_frame: isinstance(open_frame, LoopFrame))
    if frame is None:
        raise BlockError(RT_WHILE_NESTED, command.start, command.end, found="#RT ENDWHILE")
    current.structures.close(frame)
    for wrong in (*command.words[2:], *command.arguments):
        written = shown(current.text.text_of(wrong.span))
        raise BlockError(UNEXPECTED_TEXT, 0, 0, wrong.span, found=written)


def _variables(current: CurrentLine, _: RawCommand) -> None:
    current.structures.open(VariablesFrame(current.opening("#ENDVAR")))


def _end_variables(current: CurrentLine, _: RawCommand) -> None:
    _close(current, "#VAR")


def _comment_end(current: CurrentLine, _: RawCommand) -> None:
    _stray(current, "#COMMENT BEGIN")


_HASH_LINES: dict[tuple[str, ...], Callable[[CurrentLine, RawCommand], None]] = {
    ("RT", "CYCLE"): _realtime_cycle,
    ("RT", "WHILE"): _realtime_loop,
    ("RT", "ENDWHILE"): _end_realtime_loop,
    ("VAR",): _variables,
    ("ENDVAR",): _end_variables,
    ("COMMENT", "END"): _comment_end,
}


# --- misspelt words -------------------------------------------------------------------------------


#: A second word, as in ``$ELSE IF``; not that of a jump, which has a ``$`` itself.
_SECOND_PART = re.compile(r"\s+(IF|FOR|WHILE|DO|SWITCH)(?!\w)", re.IGNORECASE)
_DIVIDED = ("$ELSE", "$END")
#: Words of other languages.
_OTHER_WORDS = {
    "$ELIF": "$ELSEIF",
    "$FI": "$ENDIF",
    "$NEXT": "$ENDFOR",
    "$WEND": "$ENDWHILE",
    "$ESAC": "$ENDSWITCH",
}
#: Ends of ``#`` structures, without blanks and ``_``.
_OTHER_ENDS = {
    **dict.fromkeys(
        ("ENDRTCYCLE", "RTCYCLEEND", "RTENDCYCLE", "ENDCYCLE", "ENDRT"), ("RT", "CYCLE", "END")
    ),
    "ENDVAR": ("ENDVAR",),
    "VAREND": ("ENDVAR",),
    "ENDCOMMENT": ("COMMENT", "END"),
}


def control_word(
    text: BlockText, start: int, word: str, known: Iterable[str], structures: StructureStack
) -> str:
    """Return the known control word, begun at ``start``, that ``word`` is or is meant for.

    Raises ``BlockError`` for any other word.
    """
    names = tuple(known)
    second = text.looking_at(_SECOND_PART) if word in _DIVIDED else None
    if second is None and word in names:
        return word
    if second is not None:
        text.pos = second.end()
        word += second[1].upper()
    suggestion = _OTHER_WORDS.get(word) or nearest(word, names) or NOTHING
    written = shown(text.text[start : text.pos])
    error = BlockError(UNKNOWN_CONTROL_WORD, start, text.pos, word=written, suggestion=suggestion)
    if suggestion == NOTHING:
        raise error
    structures.block_error(text, error)
    return suggestion


def structure_command(
    text: BlockText,
    words: Sequence[Name],
    known: Iterable[tuple[str, ...]],
    structures: StructureStack,
) -> tuple[Name, ...]:
    """Return the words of a command, with misspelt words of a structure corrected."""
    end = _OTHER_ENDS.get("".join(word.name for word in words).replace("_", ""))
    if end is not None:
        return _meant(text, words, end, structures)
    for meant in known:
        written = words[: len(meant)]
        if nearest(" ".join(word.name for word in written), (" ".join(meant),)):
            return (*_meant(text, written, meant, structures), *words[len(meant) :])
    return tuple(words)


def _meant(
    text: BlockText, written: Sequence[Name], meant: tuple[str, ...], structures: StructureStack
) -> tuple[Name, ...]:
    """Report words of a command; return those that are meant, at the same places."""
    start = text.text.index("#")
    span = replace(text.span(start, start + 1), end_column=written[-1].span.end_column)
    nearest = "#" + " ".join(meant)
    error = BlockError(UNKNOWN_COMMAND, 0, 0, span, word=shown(text.text_of(span)), nearest=nearest)
    structures.block_error(text, error)
    last = len(written) - 1
    return tuple(replace(written[min(n, last)], name=name) for n, name in enumerate(meant))
