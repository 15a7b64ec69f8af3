# SPDX-License-Identifier: MIT
"""The text of a measure or an expectation -> its parts."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from typing import ClassVar, NamedTuple

from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.lists.format.times import Time, read_time
from nctakt.studies.measuring.measure_nodes import (
    COMPARISONS,
    AnyEvent,
    Binary,
    Condition,
    Constant,
    CountOf,
    Event,
    Extreme,
    Node,
    Order,
    Property,
    Reaction,
    TimeBetween,
    TimeOf,
    ValueAt,
)

_TOKEN = re.compile(
    r'\s*(?:(?P<text>"[^"]*")'
    r"|(?P<time>(?:\d+\.?\d*|\.\d+) ?(?:us|µs|μs|ms|s|min|h|ticks?)\b)"
    r"|(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)"
    r"|(?P<name>[^\W\d][\w.#\[\]]*|#\d+)"
    r"|(?P<sign><=|>=|==|!=|<>|[<>=+\-*/()]))"
)
#: The longest measure, in words and signs.
MAX_WORDS = 200

_FUNCTION = re.compile(r"[MHT]\d+", re.IGNORECASE)


class NotAMeasureError(Exception):
    """A text is no measure; ``reason`` says why."""

    def __init__(self, en: str, de: str) -> None:
        self.reason = Text(en, de)
        super().__init__(en)


def _unexpected(text: str) -> NotAMeasureError:
    return NotAMeasureError(f"unexpected {text or 'end'}", f"unerwartet: {text or 'das Ende'}")


class _Token(NamedTuple):
    kind: str
    text: str


def _tokens(text: str) -> list[_Token]:
    tokens = []
    position = 0
    while text[position:].strip():
        match = _TOKEN.match(text, position)
        if match is None:
            raise _unexpected(text[position:].strip()[0])
        assert match.lastgroup is not None
        tokens.append(_Token(match.lastgroup, match[match.lastgroup]))
        position = match.end()
    return tokens


class Reader:
    """Reads one text; ``known``: measures that it may name. Raises ``NotAMeasureError``.

    ``is_of_program``: its expectations may be those of NC comments as well.
    """

    is_of_program: ClassVar[bool] = True

    def __init__(self, text: str, known: Mapping[str, Node]) -> None:
        self._tokens = _tokens(text)
        if len(self._tokens) > MAX_WORDS:
            raise NotAMeasureError(f"more than {MAX_WORDS} words", f"mehr als {MAX_WORDS} Wörter")
        self._known = known
        self._position = 0

    def measure(self) -> Node:
        """Return the measure that the whole text is."""
        node = self._sum()
        self._end()
        return node

    def expectation(self) -> Node:
        """Return the expectation that the whole text is."""
        order = self._order()
        if order is not None:
            return order
        reaction = self._reaction()
        if reaction is not None:
            return reaction
        left = self._sum()
        word = self._take().text
        if word not in COMPARISONS:
            raise NotAMeasureError("a comparison is missing", "es fehlt ein Vergleich")
        node = Binary(word, left, self._sum())
        self._end()
        return node

    # --- tokens ----------------------------------------------------------------------------------

    def _peek(self, offset: int = 0) -> _Token:
        position = self._position + offset
        return self._tokens[position] if position < len(self._tokens) else _Token("end", "")

    def _take(self) -> _Token:
        token = self._peek()
        self._position += 1
        return token

    def _word(self, *words: str) -> bool:
        """Take the next token if it is one of the words; return whether it was."""
        if self._peek().text.lower() in words and self._peek().kind in ("name", "sign"):
            self._position += 1
            return True
        return False

    def _expect(self, word: str) -> None:
        if not self._word(word):
            found = self._peek().text
            raise NotAMeasureError(
                f"{word} expected, not {found or 'the end'}",
                f"{word} erwartet, nicht {found or 'das Ende'}",
            )

    def _end(self) -> None:
        if self._peek().kind != "end":
            raise _unexpected(self._peek().text)

    # --- expectations ----------------------------------------------------------------------------

    def _order(self) -> Order | None:
        """Return ``EVENT before EVENT``; ``None`` for another text, which is left unread."""
        begin = self._position
        try:
            first = self._event()
            self._expect("before")
            order = Order(first, self._event())
            self._end()
        except NotAMeasureError:
            self._position = begin
            return None
        return order

    def _reaction(self) -> Reaction | None:
        """Return ``CONDITION within TIME``; ``None`` likewise."""
        begin = self._position
        try:
            condition = self._condition()
            self._expect("within")
            token = self._take()
            if token.kind != "time":
                raise NotAMeasureError(
                    "a time with its unit expected", "eine Zeit mit ihrer Einheit erwartet"
                )
            after = self._event() if self._word("after") else None
            self._end()
        except NotAMeasureError:
            self._position = begin
            return None
        return Reaction(condition, _time(token.text), after)

    # --- values ----------------------------------------------------------------------------------

    def _sum(self) -> Node:
        node = self._product()
        while self._peek().text in ("+", "-"):
            node = Binary(self._take().text, node, self._product())
        return node

    def _product(self) -> Node:
        node = self._single()
        while self._peek().text in ("*", "/"):
            node = Binary(self._take().text, node, self._single())
        return node

    def _single(self) -> Node:
        if self._word("("):
            node = self._sum()
            self._expect(")")
            return node
        if self._word("-"):
            return Binary("-", Constant(0), self._single())
        token = self._take()
        if token.kind == "number":
            return Constant(Fraction(token.text))
        if token.kind == "time":
            return Constant(_time(token.text))
        if token.kind == "text":
            return Constant(token.text[1:-1])
        if token.kind != "name":
            raise _unexpected(token.text)
        return self._named(token.text)

    def _named(self, name: str) -> Node:
        word = name.lower()
        if word == "time" and self._peek().text.lower() in ("of", "from"):
            return self._time()
        if word == "count" and self._word("of"):
            return CountOf(self._event())
        if word in ("max", "min") and self._peek().kind == "name":
            return Extreme(self._take().text, word == "max")
        if self._word("at"):
            return ValueAt(name, self._moment())
        if name in self._known:
            return self._known[name]
        if word == "duration":
            return Property("duration")
        if word == "ticks":
            return Property("ticks")
        if word == "state":
            return Property("state")
        raise NotAMeasureError(
            f"{name} says neither when nor what of it is meant",
            f"bei {name} fehlt, wann oder was davon gemeint ist",
        )

    def _time(self) -> Node:
        if self._word("from"):
            first = self._event()
            self._expect("to")
            return TimeBetween(first, self._event())
        self._expect("of")
        is_last = self._word("last")
        return TimeOf(self._event(), is_last)

    def _moment(self) -> Time | AnyEvent | None:
        if self._word("end"):
            return None
        token = self._peek()
        if token.kind == "time":
            self._position += 1
            return _time(token.text)
        return self._event()

    # --- events ----------------------------------------------------------------------------------

    def _event(self) -> AnyEvent:
        if self._word("("):
            condition = self._condition()
            self._expect(")")
            return condition
        token = self._take()
        word = token.text.lower()
        if token.kind == "name" and _FUNCTION.fullmatch(token.text):
            return Event("function", token.text.upper())
        if word == "ended":
            return Event("ended")
        if word == "message" and self._peek().kind == "text":
            return Event("message", self._take().text[1:-1])
        if word in ("error", "warning") and self._peek().kind == "number":
            return Event(word, self._whole())
        if word == "fired":
            is_named = self._peek().kind == "number" or self._peek().text.startswith("#")
            cycle = self._take().text if is_named else ""
            line = int(self._whole()) if self._line() else None
            return Event("fired", cycle, line)
        raise NotAMeasureError(
            f"{token.text or 'the end'} is not an event",
            f"{token.text or 'das Ende'} ist kein Ereignis",
        )

    def _whole(self) -> str:
        token = self._take()
        if not (token.text.isascii() and token.text.isdigit()):
            raise NotAMeasureError(
                f"{token.text or 'the end'} is not a whole number",
                f"{token.text or 'das Ende'} ist keine ganze Zahl",
            )
        return token.text

    def _line(self) -> bool:
        return self._peek(1).kind == "number" and self._word("line")

    def _condition(self) -> Condition:
        name, word = self._take(), self._take().text
        sign = -1.0 if self._word("-") else 1.0
        limit = self._take()
        if name.kind != "name" or word not in COMPARISONS or limit.kind != "number":
            raise NotAMeasureError(
                "a comparison such as X < 50 expected", "ein Vergleich wie X < 50 erwartet"
            )
        return Condition(name.text, word, sign * float(limit.text))


def _time(text: str) -> Time:
    try:
        return read_time(text)
    except Failure as failure:
        found = failure.diagnostics[0]
        raise NotAMeasureError(found.text("en"), found.text("de")) from failure
