# SPDX-License-Identifier: MIT
"""Commands of programs for independent axes: ``X[INDP_SYN …]``, ``X[INDP_ASYN …]`` (SA-1 … SA-3).

In: the bracket of the tree. Out: an ``IndependentCommand``, and every mistake that can be found
without values. Checker and decoder read these commands through this module only.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import inf
from types import MappingProxyType

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Message, Span, Text
from nctakt.messages.checked_blocks import WORD_VALUE_MISSING
from nctakt.messages.independent_axes import (
    DUPLICATE_AXIS_KEYWORD,
    INDEPENDENT_KEYWORD_NOT_FIRST,
    INDEPENDENT_SYNTAX,
    INDEPENDENT_VALUE_INVALID,
)
from nctakt.nc.tree import BracketCommand, Expression, Keyword, Number
from nctakt.nc.vocabulary.axis_commands import Finding
from nctakt.nc.vocabulary.functions import ABSOLUTE, G_FUNCTIONS, LINE, RAPID, RELATIVE

#: The first keywords, and whether the block waits for the axis.
FORMS = MappingProxyType({"INDP_SYN": True, "INDP_ASYN": False})
#: Keywords without and with a value.
_FLAGS, _VALUES = ("INCL_OFFSETS",), ("FEED", "TIME", "FEED_MAX_WEIGHT", "POS")
_SPEEDS = ("FEED", "TIME", "FEED_MAX_WEIGHT")
#: Keywords of the language that are refused; each has a row among the forms (``commands.py``).
REFUSED_KEYWORDS = MappingProxyType(
    {
        "SLOPE_TYPE": "SLOPE_TYPE",
        "SLOPE_PROFIL": "SLOPE_TYPE",
        "DRY_RUN": "DRY_RUN",
        "ACC_WEIGHT": "ACC_WEIGHT",
        "RAPID_ACC_WEIGHT": "ACC_WEIGHT",
        "M": "M",
        "H": "M",
        "G100": "G100",
    }
)
KEYWORDS = ("G90", "G91", "G00", "G01", *_VALUES, *_FLAGS)
_MEASURING_LINE = 100
_G_WORDS = MappingProxyType(
    {float(number): G_FUNCTIONS[number].name for number in (ABSOLUTE, RELATIVE, RAPID, LINE)}
    | {float(_MEASURING_LINE): "G100"}
)

#: Reasons of message 21068.
_UNKNOWN_KEYWORD = Text("{word} is not one of its keywords", "{word} ist keines davon")
_REASONS = MappingProxyType(
    {
        "G": Text("only G90, G91, G00 and G01 are possible", "möglich sind nur G90, G91, G00, G01"),
        "both": Text("either G90 or G91", "entweder G90 oder G91"),
        "neither": Text("G90 or G91 is missing", "G90 oder G91 fehlt"),
        "motions": Text("either G00 or G01", "entweder G00 oder G01"),
        "POS": Text("POS is missing", "POS fehlt"),
        "speeds": Text(
            "only one of FEED, TIME and FEED_MAX_WEIGHT",
            "nur eines von FEED, TIME und FEED_MAX_WEIGHT",
        ),
        "speed": Text(
            "G01 needs FEED, TIME or FEED_MAX_WEIGHT",
            "G01 braucht FEED, TIME oder FEED_MAX_WEIGHT",
        ),
        "rapid": Text(
            "G00 moves at rapid traverse, without FEED, TIME or FEED_MAX_WEIGHT",
            "G00 fährt im Eilgang, ohne FEED, TIME oder FEED_MAX_WEIGHT",
        ),
        "flag": Text("INCL_OFFSETS takes no value", "INCL_OFFSETS erwartet keinen Wert"),
        "word": Text("a value without a keyword", "ein Wert ohne Schlüsselwort"),
    }
)
#: The highest weight, percent.
MAX_WEIGHT = 100.0


@dataclass(frozen=True, slots=True)
class IndependentCommand:
    """The content of a command; absent parts are ``None`` or false.

    ``waits``: INDP_SYN. ``rapid``: neither G01 nor a speed, or G00. ``with_offsets``: INCL_OFFSETS.
    """

    axis: str
    form: str
    span: Span
    waits: bool
    absolute: bool
    rapid: bool
    speeds: Mapping[str, Expression]
    position: Expression | None
    with_offsets: bool

    def expressions(self) -> list[Expression]:
        """Return the values of the command, in the order of computation."""
        position = () if self.position is None else (self.position,)
        return [*self.speeds.values(), *position]


def form_of(command: BracketCommand) -> str:
    """Return INDP_SYN or INDP_ASYN if a bracket has one of them, else an empty text."""
    names = (item.name for item in command.items if isinstance(item, Keyword))
    return next((name for name in names if name in FORMS), "")


def read_independent(
    command: BracketCommand,
) -> tuple[IndependentCommand, list[Finding], list[tuple[str, Span]]]:
    """Return the command, its mistakes, and its keywords that are refused by name."""
    reader = _Reader(command)
    reader.read()
    return reader.command(), reader.findings, reader.refused


class _Reader:
    """Reads the keywords of one command."""

    def __init__(self, command: BracketCommand) -> None:
        self._bracket = command
        self._form = form_of(command)
        self._named = {"axis": command.name, "form": self._form}
        self._keywords: dict[str, Keyword] = {}
        self.findings: list[Finding] = []
        self.refused: list[tuple[str, Span]] = []

    def _find(self, message: Message, span: Span, **values: object) -> None:
        self.findings.append(Finding(message, span, values))

    def _wrong(self, reason: str, span: Span | None = None) -> None:
        span = span or self._bracket.span
        self._find(INDEPENDENT_SYNTAX, span, reason=_REASONS[reason], **self._named)

    def read(self) -> None:
        """Note the keywords and what is wrong with them."""
        first = self._bracket.items[0]
        if not isinstance(first, Keyword) or first.name != self._form or first.value is not None:
            self._find(INDEPENDENT_KEYWORD_NOT_FIRST, self._bracket.span, **self._named)
            return
        pending: Keyword | None = None
        for item in self._bracket.items[1:]:
            if not isinstance(item, Keyword):
                if pending is None:
                    self._wrong("word", item.span)
                else:
                    self._keywords[pending.name] = Keyword(pending.span, pending.name, item)
                pending = None
                continue
            self._miss(pending)
            pending = self._keyword(item)
        self._miss(pending)
        if not self.findings:
            for reason in self._combination():
                self._wrong(reason)
            self._check_numbers()

    def _miss(self, pending: Keyword | None) -> None:
        """Report a keyword after which no value came: the sign ``=`` is optional."""
        if pending is not None:
            self._find(WORD_VALUE_MISSING, pending.span, word=pending.name)

    def _keyword(self, item: Keyword) -> Keyword | None:
        """Note a keyword; return it if its value has to follow."""
        name = item.name
        if name == "G":
            value = item.value
            name = _G_WORDS.get(value.value, "") if isinstance(value, Number) else ""
            if not name:
                self._wrong("G", item.span)
                return None
        if name in REFUSED_KEYWORDS:
            self.refused.append((REFUSED_KEYWORDS[name], item.span))
            return None
        if item.arguments or name not in KEYWORDS:
            form = _UNKNOWN_KEYWORD
            reason = Text(form.en.format(word=name), form.de.format(word=name))
            self._find(INDEPENDENT_SYNTAX, item.span, reason=reason, **self._named)
            return None
        if name in self._keywords:
            self._find(DUPLICATE_AXIS_KEYWORD, item.span, word=name, **self._named)
            return None
        if name in _FLAGS and item.value is not None:
            self._wrong("flag", item.span)
        self._keywords[name] = item
        return item if name in _VALUES and item.value is None else None

    def _combination(self) -> list[str]:
        """Return the reasons why the keywords do not fit together."""
        has = self._keywords.__contains__
        speeds = [name for name in _SPEEDS if has(name)]
        is_refused = {word for word, _ in self.refused}
        wrong = []
        if has("G90") and has("G91"):
            wrong.append("both")
        if has("G00") and has("G01"):
            wrong.append("motions")
        if not has("POS"):
            return wrong if "M" in is_refused else [*wrong, "POS"]
        if not has("G90") and not has("G91"):
            wrong.append("neither")
        if len(speeds) > 1:
            wrong.append("speeds")
        if has("G00") and speeds:
            wrong.append("rapid")
        if has("G01") and not speeds:
            wrong.append("speed")
        return wrong

    def _check_numbers(self) -> None:
        for name in _SPEEDS:
            value = self._value(name)
            if isinstance(value, Number) and not is_valid(name, value.value):
                values = {"word": name, "value": value.value}
                self._find(INDEPENDENT_VALUE_INVALID, value.span, **values, **self._named)

    def _value(self, name: str) -> Expression | None:
        keyword = self._keywords.get(name)
        return None if keyword is None else keyword.value

    def command(self) -> IndependentCommand:
        """Return the command."""
        values = {name: self._value(name) for name in _SPEEDS}
        speeds = {name: value for name, value in values.items() if value is not None}
        return IndependentCommand(
            self._bracket.name,
            self._form,
            self._bracket.span,
            FORMS.get(self._form, False),
            "G90" in self._keywords,
            not speeds,
            speeds,
            self._value("POS"),
            "INCL_OFFSETS" in self._keywords,
        )


def is_valid(name: str, value: float) -> bool:
    """Return whether FEED, TIME or FEED_MAX_WEIGHT may have a value: above 0, a weight to 100."""
    return 0.0 < value < inf and (name != "FEED_MAX_WEIGHT" or value <= MAX_WEIGHT)
