# SPDX-License-Identifier: MIT
"""Lines that open, divide or close a structure, and jumps: ``$`` words, ``#RT CYCLE``, ``#IF``.

In: a block's text at its ``$`` or ``#``. Out: what it does to the open structures. If a condition
cannot be read, the structure is opened nevertheless, so that its end does not become a second
mistake.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from difflib import get_close_matches
from typing import NamedTuple, cast

from nctakt.base.diagnostics import Span
from nctakt.messages.backward import RT_WHILE_NESTED
from nctakt.messages.nc_text import (
    BRANCH_AFTER_ELSE,
    CYCLE_BEGIN_END_MISMATCH,
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
)
from nctakt.nc.parse.hash_commands import (
    CYCLE_ACTIONS,
    Hash,
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
from nctakt.nc.parse.structure_stack import Structure
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
    Statement,
)

_DOLLAR_WORD = re.compile(r"\s*\$([^\W\d]*)")
_PREPROCESSOR = re.compile(r"\s*#\s*(IF|ELSEIF|ELSE|ENDIF)(?!\w)", re.IGNORECASE)
_FREQUENCY = re.compile(r"\s*(ONCE|EDGE|ALWAYS)(?!\w)", re.IGNORECASE)
_DOLLAR = re.compile(r"\s*\$")


class Here(NamedTuple):
    """The line at hand: its text, what stood in front, its first word with ``$`` or ``#``."""

    text: BlockText
    head: Head
    structure: Structure
    start: int
    word: str

    def span(self) -> Span:
        """The place of the first word."""
        return self.text.span(self.start, self.start + len(self.word))

    def opening(self, end: str) -> Opening:
        """This line as the one that opens a structure."""
        span = self.span()
        return Opening(self.word, end, span, self.text.source_line(span), self.head)


def control_line(text: BlockText, head: Head, structure: Structure) -> None:
    """A line that begins with ``$``."""
    found = text.match(_DOLLAR_WORD)
    assert found is not None
    word = "$" + found[1].upper()
    handler = CONTROL_WORDS.get(word)
    if handler is None:
        suggestion = get_close_matches(word, CONTROL_WORDS, 1, 0.0)[0]
        start = found.start(1) - 1
        raise BlockError(
            UNKNOWN_CONTROL_WORD,
            start,
            found.end(),
            word=shown("$" + found[1]),
            suggestion=suggestion,
        )
    handler(Here(text, head, structure, found.start(1) - 1, word))


def hash_line(text: BlockText, head: Head, structure: Structure) -> None:
    """A line that begins with ``#``."""
    start = text.skip_blanks()
    preprocessor = text.match(_PREPROCESSOR)
    if preprocessor is not None:
        word = "#" + preprocessor[1].upper()
        _PREPROCESSOR_LINES[word](Here(text, head, structure, start, word))
        return
    offsets = parse_offsets(text, head)
    if offsets is not None:
        structure.add_block(offsets, text)
        return
    words = parse_words(text)
    name = tuple(word.name for word in words)
    handler = _HASH_LINES.get(name[:2]) or _HASH_LINES.get(name)
    try:
        arguments = parse_arguments(text, name)
    except BlockError as error:
        if handler is None:
            raise
        # What the line opens or closes counts even if the rest of it cannot be read.
        structure.block_error(text, error)
        arguments = ()
        text.pos = len(text.text)
    command = Hash(start, text.pos, words, arguments)
    if handler is not None:
        handler(Here(text, head, structure, start, "#" + " ".join(name[:2])), command)
    else:
        structure.add_block(simple_command(text, head, command), text)


# --- conditions ----------------------------------------------------------------------------------


def _value(here: Here) -> Expression:
    """The expression that follows; if there is none, that is reported and TRUE stands for it."""
    try:
        return parse_expression(here.text)
    except BlockError as error:
        here.structure.block_error(here.text, error)
        here.text.pos = len(here.text.text)
        return Constant(here.span(), "TRUE")


def _frequency(here: Here) -> Frequency | None:
    found = here.text.match(_FREQUENCY)
    return None if found is None else cast(Frequency, found[1].upper())


def _stray(here: Here, begin: str) -> None:
    span = here.span()
    line = here.text.source_line(span)
    here.structure.report(STRUCTURE_NOT_OPENED, span, line, word=here.word, begin=begin)
    here.text.pos = len(here.text.text)


def _find(here: Here, begin: str) -> Frame | None:
    """The structure that this line divides or closes, or the report that there is none."""
    frame = here.structure.find(lambda open_frame: open_frame.opening.begin == begin)
    if frame is None:
        _stray(here, begin)
    return frame


# --- $IF, #IF ------------------------------------------------------------------------------------


def _if(here: Here) -> None:
    text = here.text
    frequency = _frequency(here)
    begin = text.pos
    condition = _value(here)
    failed = condition.span == here.span()
    if failed and "$" in text.text[begin:]:
        # A jump in the same line, most likely: it needs no $ENDIF.
        return
    if text.looking_at(_DOLLAR) is not None:
        body = _one_line_body(text)
        here.structure.add_block(If(here.span(), here.head, frequency, condition, (body,)), text)
    else:
        frame = IfFrame(here.opening("$ENDIF"), frequency, condition, preprocessor=False)
        here.structure.open(frame)


def _one_line_body(text: BlockText) -> Statement:
    """What may stand behind the condition in the same line: a jump."""
    found = text.match(_DOLLAR_WORD)
    assert found is not None
    start = found.start(1) - 1
    make = _JUMPS.get("$" + found[1].upper())
    if make is None:
        raise BlockError(UNEXPECTED_TEXT, start, found.end(), found=quoted("$" + found[1]))
    return make(text, Head(), text.span(start, found.end()))


def _preprocessor_if(here: Here) -> None:
    here.structure.open(IfFrame(here.opening("#ENDIF"), None, _value(here), preprocessor=True))


def _else_if(here: Here) -> None:
    frequency = _frequency(here)
    condition = _value(here)
    frame = _branch_of(here)
    if frame is not None:
        frame.add_branch(here.span(), here.head, frequency, condition)


def _else(here: Here) -> None:
    frame = _branch_of(here)
    if frame is not None:
        frame.add_else(here.span())


def _branch_of(here: Here) -> IfFrame | None:
    frame = _find(here, here.word[0] + "IF")
    if frame is None:
        return None
    assert isinstance(frame, IfFrame)
    if frame.else_body is not None:
        raise BlockError(BRANCH_AFTER_ELSE, here.start, here.start + len(here.word), word=here.word)
    return frame


def _end_if(here: Here) -> None:
    _close(here, here.word[0] + "IF")


def _close(here: Here, begin: str) -> None:
    frame = _find(here, begin)
    if frame is not None:
        here.structure.close(frame)


# --- loops and branches --------------------------------------------------------------------------


def _for(here: Here) -> None:
    """If the loop's line cannot be read, a ``$WHILE`` stands for it."""
    text = here.text
    opening = here.opening("$ENDFOR")
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
        here.structure.block_error(text, error)
        text.pos = len(text.text)
        here.structure.open(WhileFrame(opening, Constant(opening.span, "TRUE")))
        return
    here.structure.open(ForFrame(opening, target, bounds))


def _end_for(here: Here) -> None:
    _close(here, "$FOR")


def _while(here: Here) -> None:
    here.structure.open(WhileFrame(here.opening("$ENDWHILE"), _value(here)))


def _end_while(here: Here) -> None:
    _close(here, "$WHILE")


def _do(here: Here) -> None:
    here.structure.open(DoFrame(here.opening("$ENDDO")))


def _end_do(here: Here) -> None:
    _close_foot(here, "$DO")


def _repeat(here: Here) -> None:
    here.structure.open(RepeatFrame(here.opening("$UNTIL")))


def _until(here: Here) -> None:
    _close_foot(here, "$REPEAT")


def _close_foot(here: Here, begin: str) -> None:
    frame = _find(here, begin)
    if frame is not None:
        assert isinstance(frame, DoFrame | RepeatFrame)
        frame.condition = _value(here)
        here.structure.close(frame)


def _switch(here: Here) -> None:
    here.structure.open(SwitchFrame(here.opening("$ENDSWITCH"), _value(here)))


def _case(here: Here) -> None:
    value = _value(here)
    frame = _find(here, "$SWITCH")
    if frame is not None:
        assert isinstance(frame, SwitchFrame)
        frame.add_case(here.span(), here.head, value)


def _default(here: Here) -> None:
    frame = _find(here, "$SWITCH")
    if frame is not None:
        assert isinstance(frame, SwitchFrame)
        frame.add_case(here.span(), here.head, None)


def _end_switch(here: Here) -> None:
    _close(here, "$SWITCH")


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


def _jump(here: Here) -> None:
    statement = _JUMPS[here.word](here.text, here.head, here.span())
    here.structure.add_block(statement, here.text)


#: What each word with ``$`` does.
CONTROL_WORDS: dict[str, Callable[[Here], None]] = {
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

_PREPROCESSOR_LINES: dict[str, Callable[[Here], None]] = {
    "#IF": _preprocessor_if,
    "#ELSEIF": _else_if,
    "#ELSE": _else,
    "#ENDIF": _end_if,
}


# --- # structures --------------------------------------------------------------------------------


def _realtime_cycle(here: Here, command: Hash) -> None:
    words = command.name[2:]
    if words in ((), ("DEF",)):
        span = here.span()
        here.structure.close_cycle_before(span, here.text.source_line(span))
        frame = CycleFrame(here.opening("#RT CYCLE END"), definition_only=bool(words))
        here.structure.open(frame)
        frame.keywords = cycle_keywords(here.text, command)
    elif words[:1] == ("END",):
        _end_realtime_cycle(here, command)
    elif " ".join(words) in CYCLE_ACTIONS:
        here.structure.add_block(cycle_control(here.text, here.head, command), here.text)
    else:
        # Was it a definition, its end is still to come; it shall not be a second mistake.
        here.structure.expect_stray_cycle_end()
        known = words[0] in CYCLE_ACTIONS and len(words) > 1
        wrong = command.words[3 if known else 2]
        raise BlockError(UNKNOWN_CYCLE_KEYWORD, 0, 0, wrong.span, keyword=shown(wrong.text))


def _end_realtime_cycle(here: Here, command: Hash) -> None:
    frame = here.structure.find(lambda open_frame: isinstance(open_frame, CycleFrame))
    if frame is not None:
        assert isinstance(frame, CycleFrame)
        frame.end_span = here.text.span(command.start, command.end)
        here.structure.close(frame)
    elif not here.structure.forgive_cycle_end():
        raise BlockError(
            CYCLE_BEGIN_END_MISMATCH, command.start, command.end, found="#RT CYCLE END"
        )
    rest = (*command.words[3:], *command.arguments)
    if rest:
        found = quoted(here.text.text_of(rest[0].span))
        raise BlockError(UNEXPECTED_TEXT, 0, 0, rest[0].span, found=found)


def _realtime_loop(here: Here, command: Hash) -> None:
    """``#RT WHILE``, with ``[MODULO]`` or without."""
    frame = LoopFrame(here.opening("#RT ENDWHILE"))
    here.structure.open(frame)
    for wrong in command.words[2:]:
        raise BlockError(UNEXPECTED_TEXT, 0, 0, wrong.span, found=shown(wrong.text))
    for item in cycle_keywords(here.text, command):
        if not isinstance(item, Keyword) or item != Keyword(item.span, "MODULO", None):
            found = shown(here.text.text_of(item.span))
            raise BlockError(UNEXPECTED_TEXT, 0, 0, item.span, found=found)
        frame.modulo = True


def _end_realtime_loop(here: Here, command: Hash) -> None:
    frame = here.structure.find(lambda open_frame: isinstance(open_frame, LoopFrame))
    if frame is None:
        raise BlockError(RT_WHILE_NESTED, command.start, command.end, found="#RT ENDWHILE")
    here.structure.close(frame)
    for wrong in (*command.words[2:], *command.arguments):
        found = shown(here.text.text_of(wrong.span))
        raise BlockError(UNEXPECTED_TEXT, 0, 0, wrong.span, found=found)


def _variables(here: Here, _: Hash) -> None:
    here.structure.open(VariablesFrame(here.opening("#ENDVAR")))


def _end_variables(here: Here, _: Hash) -> None:
    _close(here, "#VAR")


def _comment_end(here: Here, _: Hash) -> None:
    _stray(here, "#COMMENT BEGIN")


_HASH_LINES: dict[tuple[str, ...], Callable[[Here, Hash], None]] = {
    ("RT", "CYCLE"): _realtime_cycle,
    ("RT", "WHILE"): _realtime_loop,
    ("RT", "ENDWHILE"): _end_realtime_loop,
    ("VAR",): _variables,
    ("ENDVAR",): _end_variables,
    ("COMMENT", "END"): _comment_end,
}
