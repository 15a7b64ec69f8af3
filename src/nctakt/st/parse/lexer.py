# SPDX-License-Identifier: MIT
"""A piece of Structured Text -> its tokens (ST-201 … 208).

In: a piece of text, the definitions of the project. Out: ``Tokens``: lists of kinds, texts and
positions. Comments are gone; attributes are those of the token after them; text whose condition
(``{IF …}``) does not hold is gone. One compiled expression finds the tokens, so that the time
grows with the length of the text alone.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Message
from nctakt.messages.plcs.st_text import (
    CHARACTER_UNKNOWN,
    CONDITION_NOT_CLOSED,
    CONDITION_NOT_KNOWN,
    CONDITION_WITHOUT_IF,
    PRAGMA_ERROR,
    PRAGMA_NOT_CLOSED,
    PRAGMA_NOTE,
    PRAGMA_WARNING,
    ST_COMMENT_NOT_CLOSED,
    STRING_NOT_CLOSED,
)
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Piece

#: Kinds of tokens other than keywords and signs, whose kind is their text (in upper case).
NAME, NUMBER, TYPED, STRING, ADDRESS, END = "name", "number", "typed", "string", "address", "end"

KEYWORDS = frozenset(
    """IF THEN ELSIF ELSE END_IF CASE OF END_CASE FOR TO BY DO END_FOR WHILE END_WHILE REPEAT UNTIL
    END_REPEAT EXIT CONTINUE RETURN JMP AND OR XOR NOT MOD AND_THEN OR_ELSE TRUE FALSE THIS SUPER
    VAR VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_TEMP VAR_STAT VAR_INST VAR_GLOBAL VAR_EXTERNAL
    VAR_CONFIG VAR_ACCESS END_VAR PROGRAM END_PROGRAM FUNCTION END_FUNCTION FUNCTION_BLOCK
    END_FUNCTION_BLOCK INTERFACE END_INTERFACE TYPE END_TYPE STRUCT END_STRUCT UNION END_UNION
    END_METHOD END_PROPERTY END_ACTION END_GET END_SET CONFIGURATION END_CONFIGURATION END_RESOURCE
    __TRY __CATCH __FINALLY __ENDTRY""".split()
)

_TOKEN = re.compile(
    r"""
    [\s\0]*(?:(?://[^\n]*|\(\*[^*(]*(?:(?:\*(?!\))|\((?!\*))[^*(]*)*\*\)|/\*.*?\*/)[\s\0]*)*
    (?:
      ([^\W\d]\w*\b(?!\#))
    | (:=|=>|<=|>=|<>|\.\.|\*\*|\((?!\*)|[-+;:,.)\[\]=<>^&*])
    | (\d[\d_]*\#\w+|\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][-+]?\d+)?\b)
    | ([^\W\d]\w*\#(?:
          -?\d[\d_]*\#\w+
        | \d+-\d+-\d+(?:-\d+:\d+(?::\d+(?:\.\d+)?)?)?
        | \d+:\d+(?::\d+(?:\.\d+)?)?
        | -?(?:\d[\d_]*(?:\.\d+)?(?:[dDhH]|[mMuUnN][sS]|[mMsS])_?)+(?!\w)
        | [-+]?\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][-+]?\d+)?\b
        | '(?:[^'$\n]|\$.)*' | "(?:[^"$\n]|\$.)*"
        | [^\W\d]\w*))
    | ('(?:[^'$\n]|\$.)*'|"(?:[^"$\n]|\$.)*")
    | (%[IQMiqm][XBWDLxbwdl]?(?:\*|\d+(?:\.\d+)*))
    | (\{(?:[^{}']|'[^']*')*\}|\{[^}]*\})
    | (/(?!\*))
    | (\(\*|/\*|['"{]|[^\W\d]\w*\#?|\d\w*|.|\Z)
    )""",
    re.VERBOSE | re.DOTALL,
)

_NAME, _SIGN, _NUMBER, _TYPED, _STRING, _ADDRESS, _PRAGMA, _SLASH, _OTHER = range(1, 10)
_KINDS = {_NUMBER: NUMBER, _TYPED: TYPED, _STRING: STRING, _ADDRESS: ADDRESS}

_OPENING_OR_CLOSING = re.compile(r"\(\*|\*\)")
_ATTRIBUTE = re.compile(r"'([^']*)'\s*(?::=\s*)?")
_DIRECTIVE = re.compile(r"(\w+)\s*")
_BRANCH = re.compile(r"\{\s*(IF|ELSIF|ELSE|END_IF)\b([^}]*)\}", re.IGNORECASE)
_CONDITION_PART = re.compile(
    r"\s*(?:(defined|hasvalue|hastype|hasattribute)\s*\(([^()]*)\)|(AND|OR|NOT)\b|([()]))", re.I
)
_TEXT = re.compile(r"['\"](.*?)['\"]", re.S)

_PRAGMAS = {
    "INFO": PRAGMA_NOTE,
    "TEXT": PRAGMA_NOTE,
    "WARNING": PRAGMA_WARNING,
    "ERROR": PRAGMA_ERROR,
}

#: Nested ``{IF}`` and brackets in its condition.
MAX_CONDITIONS = 32


@dataclass(slots=True, eq=False)
class Tokens:
    """The tokens of a piece: parallel lists that end with an ``END``.

    ``attributes``: those before a token, by its index.
    """

    kinds: list[str] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    starts: list[int] = field(default_factory=list)
    attributes: dict[int, dict[str, str]] = field(default_factory=dict)


@dataclass(slots=True, eq=False)
class Definitions:
    """Definitions for conditions: identifiers with values, names of POUs and types (lower case)."""

    values: Mapping[str, str] = field(default_factory=dict)
    pous: frozenset[str] = frozenset()
    types: frozenset[str] = frozenset()


class _UnknownConditionError(Exception):
    """A condition that cannot be evaluated."""


class Lexer:
    """Makes the tokens of one piece."""

    def __init__(self, piece: Piece, definitions: Definitions, reporter: Reporter) -> None:
        self._piece = piece
        self._text = piece.text
        self._base = piece.base
        self._definitions = definitions
        self._values = dict(definitions.values)
        self._reporter = reporter
        self._tokens = Tokens()
        #: For each open {IF}: does its text count, and has one of its branches counted?
        self._conditions: list[tuple[bool, bool]] = []

    def read(self) -> Tokens:
        """Return the tokens."""
        tokens = self._tokens
        kinds, texts, starts = tokens.kinds, tokens.texts, tokens.starts
        position, base, length = 0, self._base, len(self._text)
        keywords = KEYWORDS
        while position < length:
            for match in _TOKEN.finditer(self._text, position):
                group = match.lastindex or 0
                text = match[group]
                start = match.start(group)
                if group == _NAME:
                    upper = text.upper()
                    kinds.append(upper if upper in keywords else NAME)
                elif group in (_SIGN, _SLASH):
                    kinds.append("AND" if text == "&" else text)
                elif group == _PRAGMA:
                    self._pragma(text, start)
                    if self._is_skipping():
                        position = self._skip(match.end())
                        break
                    continue
                elif group == _OTHER:
                    position = self._other(text, start)
                    break
                else:
                    kinds.append(_KINDS[group])
                texts.append(text)
                starts.append(base + start)
            else:
                break
        kinds.append(END)
        texts.append("")
        starts.append(base + length)
        if self._conditions:
            self._report(CONDITION_NOT_CLOSED, length, length)
        return tokens

    def _other(self, text: str, start: int) -> int:
        """Handle text that is not a token; return where reading continues."""
        if text == "(*":
            depth = 0
            for match in _OPENING_OR_CLOSING.finditer(self._text, start):
                depth += 1 if match[0] == "(*" else -1
                if depth == 0:
                    return match.end()
        messages = {
            "(*": ST_COMMENT_NOT_CLOSED,
            "/*": ST_COMMENT_NOT_CLOSED,
            "{": PRAGMA_NOT_CLOSED,
            "'": STRING_NOT_CLOSED,
            '"': STRING_NOT_CLOSED,
        }
        if not text:
            return len(self._text)
        if text in messages:
            self._report(messages[text], start, start + len(text))
            if text in "'\"":
                line_end = self._text.find("\n", start)
                return len(self._text) if line_end < 0 else line_end
            return len(self._text) if text != "{" else start + 1
        self._report(CHARACTER_UNKNOWN, start, start + len(text), text=text)
        return start + len(text)

    def _report(self, message: Message, start: int, end: int, **values: object) -> None:
        self._reporter.report(message, self._base + start, self._base + end, **values)

    # --- pragmas ----------------------------------------------------------------------------------

    def _pragma(self, text: str, start: int) -> None:
        """Handle a pragma outside of skipped text (ST-204, ST-205)."""
        content = text[1:-1].strip()
        if (match := _DIRECTIVE.match(content)) is None:
            return
        word, rest = match[1].upper(), content[match.end() :]
        if word == "ATTRIBUTE" and (named := _ATTRIBUTE.match(rest)) is not None:
            value = rest[named.end() :]
            if value[:1] == "'" and value[-1:] == "'":
                value = value[1:-1]
            found = self._tokens.attributes.setdefault(len(self._tokens.kinds), {})
            found[named[1].strip().lower()] = value
        elif word in ("IF", "ELSIF", "ELSE", "END_IF"):
            self._condition(word, rest, start, start + len(text))
        elif word == "DEFINE" and (named := re.match(r"(\w+)\s*(.*)", rest, re.S)):
            quoted = _TEXT.search(named[2])
            self._values[named[1].lower()] = named[2] if quoted is None else quoted[1]
        elif word == "UNDEFINE":
            self._values.pop(rest.lower(), None)
        elif word in _PRAGMAS and rest[:1] in ("'", '"'):
            self._report(_PRAGMAS[word], start, start + len(text), text=rest.strip("'\""))

    def _is_skipping(self) -> bool:
        return bool(self._conditions) and not self._conditions[-1][0]

    def _condition(self, word: str, rest: str, start: int, end: int) -> None:
        """Handle {IF}, {ELSIF}, {ELSE} and {END_IF} at a place whose text counts or may count."""
        if word == "IF":
            holds = self._holds(rest, start, end)
            self._conditions.append((holds, holds))
            return
        if not self._conditions:
            self._report(CONDITION_WITHOUT_IF, start, end, word=word)
            return
        _, has_counted = self._conditions.pop()
        if word == "END_IF":
            return
        holds = not has_counted and (word == "ELSE" or self._holds(rest, start, end))
        self._conditions.append((holds, has_counted or holds))

    def _skip(self, position: int) -> int:
        """Skip text that does not count; return where text counts again."""
        inner = 0
        for match in _BRANCH.finditer(self._text, position):
            word = match[1].upper()
            if word == "IF":
                inner += 1
            elif word == "END_IF" and inner:
                inner -= 1
            elif not inner:
                self._condition(word, match[2].strip(), match.start(), match.end())
                if not self._is_skipping():
                    return match.end()
        return len(self._text)

    def _holds(self, condition: str, start: int, end: int) -> bool:
        """Evaluate a condition; one that cannot be evaluated is reported and does not hold."""
        parts = []
        position = 0
        condition = condition.strip()
        while position < len(condition):
            match = _CONDITION_PART.match(condition, position)
            if match is None:
                break
            parts.append(match)
            position = match.end()
        try:
            if position < len(condition) or len(parts) > MAX_CONDITIONS:
                raise _UnknownConditionError
            value, rest = self._either(parts)
            if rest:
                raise _UnknownConditionError
        except _UnknownConditionError:
            self._report(CONDITION_NOT_KNOWN, start, end, condition=condition)
            return False
        return value

    def _either(self, parts: list[re.Match[str]]) -> tuple[bool, list[re.Match[str]]]:
        value, parts = self._both(parts)
        while parts and (parts[0][3] or "").upper() == "OR":
            right, parts = self._both(parts[1:])
            value = value or right
        return value, parts

    def _both(self, parts: list[re.Match[str]]) -> tuple[bool, list[re.Match[str]]]:
        value, parts = self._single(parts)
        while parts and (parts[0][3] or "").upper() == "AND":
            right, parts = self._single(parts[1:])
            value = value and right
        return value, parts

    def _single(self, parts: list[re.Match[str]]) -> tuple[bool, list[re.Match[str]]]:
        if not parts:
            raise _UnknownConditionError
        first, rest = parts[0], parts[1:]
        if (first[3] or "").upper() == "NOT":
            value, rest = self._single(rest)
            return not value, rest
        if first[4] == "(":
            value, rest = self._either(rest)
            if not rest or rest[0][4] != ")":
                raise _UnknownConditionError
            return value, rest[1:]
        if first[1] is None:
            raise _UnknownConditionError
        return self._question(first[1].lower(), first[2]), rest

    def _question(self, question: str, asked: str) -> bool:
        """Answer ``defined(…)`` or ``hasvalue(…)``."""
        if question == "hasvalue":
            name, _, value = asked.partition(",")
            return self._values.get(name.strip().lower()) == value.strip().strip("'\"")
        if question != "defined":
            raise _UnknownConditionError
        kind, colon, name = asked.partition(":")
        if not colon:
            return asked.strip().lower() in self._values
        name = name.strip().lower()
        match kind.strip().lower():
            case "pou":
                return name in self._definitions.pous
            case "type":
                return name in self._definitions.types
            case "variable":
                return re.search(rf"\b{re.escape(name)}\b", self._text, re.I) is not None
        raise _UnknownConditionError
