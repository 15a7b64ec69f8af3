# SPDX-License-Identifier: MIT
"""Single-axis commands of realtime cycles, ``X[INDP …]`` (RC-405, RC-407).

In: the bracket of the tree. Out: an ``AxisCommand``, and every mistake that can be found without
values. Checker, decoder and listing read commands through this module only.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Message, Span, Text, number_text
from nctakt.messages.programs.checked_axes import (
    DUPLICATE_INDP_KEYWORD,
    INDEPENDENT_MOTION_REFUSED,
    INDP_KEYWORD_NOT_ALLOWED,
    INDP_KEYWORD_WITH_VALUE,
    UNKNOWN_INDP_KEYWORD,
)
from nctakt.messages.programs.checked_blocks import WORD_VALUE_MISSING
from nctakt.messages.programs.checked_cycles import INVALID_KEYWORD_VALUE
from nctakt.nc.tree import (
    Binary,
    Block,
    BracketCommand,
    Expression,
    If,
    Keyword,
    Name,
    Number,
    Statement,
    Unary,
)
from nctakt.nc.vocabulary.functions import ABSOLUTE, G_FUNCTIONS, LINE, RAPID, RELATIVE

#: Values of OFFSET; single kinds in the order of ``kernel/axes/coordinates.py``, then ALL.
OFFSETS = ("ZERO", "ADD_ZERO", "PSET", "CLAMP", "TOOL", "MEASURE", "MANUAL", "ALL")
#: Values of DIR as numbers of the realtime part.
DIRECTIONS = MappingProxyType({"POS": 1.0, "CUR": 0.0, "NEG": -1.0})
_SIGNS = tuple(DIRECTIONS.values())

_FLAGS = ("INDP", "ABORTING", "BUFFERED", "STOP")
_VALUES = ("OFFSET", "FEED", "POS", "DIR")
#: Keywords that nothing but independent motion has.
INDP_WORDS = ("ABORTING", "BUFFERED", "STOP", "OFFSET", "FEED", "POS")
#: All keywords, for suggestions.
KEYWORDS = (*_FLAGS, *_VALUES, "G90", "G91", "G00", "G01")
_G_WORDS = MappingProxyType(
    {float(number): G_FUNCTIONS[number].name for number in (ABSOLUTE, RELATIVE, RAPID, LINE)}
)

#: Reasons of message 50967 by number; the tick reports those that depend on values by number.
REFUSALS = MappingProxyType(
    {
        1: Text("STOP must be alone", "STOP muss allein stehen"),
        2: Text("either ABORTING or BUFFERED", "entweder ABORTING oder BUFFERED"),
        3: Text("either G90 or G91", "entweder G90 oder G91"),
        4: Text("either G00 or G01", "entweder G00 oder G01"),
        5: Text("POS needs G90 or G91", "POS braucht G90 oder G91"),
        6: Text(
            "DIR must be POS (1), CUR (0) or NEG (-1)",
            "DIR muss POS (1), CUR (0) oder NEG (-1) sein",
        ),
        7: Text(
            "POS with G01 needs FEED, here or in an earlier command of the cycle for this axis",
            "POS mit G01 braucht FEED, hier oder in einem früheren Befehl des Zyklus an die Achse",
        ),
        8: Text("FEED must not be 0", "FEED darf nicht 0 sein"),
        10: Text(
            "with G91 the sign of POS is the direction, not DIR",
            "bei G91 ist das Vorzeichen von POS die Richtung, nicht DIR",
        ),
        11: Text("POS, FEED or STOP is missing", "POS, FEED oder STOP fehlt"),
        12: Text("FEED with POS must be above 0", "FEED mit POS muss über 0 sein"),
    }
)

#: Why a keyword that the syntax allows has no effect.
FEED_BESIDE_RAPID = Text("G00 moves at rapid speed", "G00 fährt im Eilgang")
RAPID_BESIDE_ENDLESS_FEED = Text(
    "FEED is the speed of an endless motion", "FEED ist die Geschwindigkeit endloser Bewegung"
)
DIRECTION_OF_LINEAR_AXIS = Text(
    "with POS only a modulo axis can choose", "mit POS kann nur eine Modulo-Achse wählen"
)


@dataclass(frozen=True, slots=True)
class AxisTraits:
    """The properties of an axis that programs depend on; ``number`` is that of the whole
    machine.

    ``low``, ``high``: its software limits or modulo range, in mm or degrees.
    """

    number: int
    is_linear: bool
    is_modulo: bool
    moves_alone: bool
    low: float
    high: float


@dataclass(frozen=True, slots=True)
class AxisCommand:
    """The content of a command; absent parts are ``None``, empty or false.

    ``rapid``: G00 true, G01 false. ``absolute``: G90 true, G91 false.
    """

    axis: str
    span: Span
    stops: bool
    buffered: bool
    offset: str
    absolute: bool | None
    rapid: bool | None
    feed: Expression | None
    position: Expression | None
    direction: Expression | None

    @property
    def kind(self) -> Literal["stop", "position", "distance", "endless"]:
        """The kind of motion."""
        if self.stops:
            return "stop"
        if self.position is None:
            return "endless"
        return "position" if self.absolute else "distance"

    @property
    def has_idle_feed(self) -> bool:
        """Whether FEED has no effect, because the motion to a target is rapid (G00)."""
        return bool(self.rapid) and self.feed is not None and self.position is not None

    def expressions(self) -> list[Expression]:
        """Return the expressions that are computed in the tick, in the order of computation."""
        direction = None if isinstance(self.direction, Name) else self.direction
        values = [self.feed, self.position, direction]
        return [value for value in values if value is not None]


@dataclass(frozen=True, slots=True)
class Finding:
    """A message with its span and values; ``written``: the value that is the text at the span."""

    message: Message
    span: Span
    values: dict[str, object]
    written: str = ""


def is_axis_command(command: BracketCommand) -> bool:
    """Return whether a bracket is a single-axis command, that is, contains INDP."""
    return any(isinstance(item, Keyword) and item.name == "INDP" for item in command.items)


def has_function(command: BracketCommand) -> bool:
    """Return whether a bracket commands an M or H function of its axis."""
    return any(isinstance(item, Keyword) and item.name in ("M", "H") for item in command.items)


def blocks_in(statements: Sequence[Statement]) -> Iterator[Block]:
    """Yield all blocks of these statements of a realtime cycle and of those inside them."""
    for statement in statements:
        match statement:
            case Block():
                yield statement
            case If():
                yield from blocks_in(statement.body)
                for branch in statement.elseifs:
                    yield from blocks_in(branch.body)
                yield from blocks_in(statement.else_body or ())


def axis_commands_in(statements: Sequence[Statement]) -> Iterator[BracketCommand]:
    """Yield all single-axis commands of these statements and of those inside them."""
    for block in blocks_in(statements):
        for word in block.words:
            if isinstance(word, BracketCommand) and is_axis_command(word):
                yield word


def read_axis_command(command: BracketCommand) -> tuple[AxisCommand, list[Finding]]:
    """Return the command and its mistakes."""
    findings: list[Finding] = []
    keywords = _sorted(command, findings)
    parsed = AxisCommand(
        command.name,
        command.span,
        "STOP" in keywords,
        "BUFFERED" in keywords,
        _offset(keywords.get("OFFSET"), findings),
        True if "G90" in keywords else False if "G91" in keywords else None,
        True if "G00" in keywords else False if "G01" in keywords else None,
        _value(keywords, "FEED"),
        _value(keywords, "POS"),
        _value(keywords, "DIR"),
    )
    direction = parsed.direction
    is_name = isinstance(direction, Name) and direction.name in DIRECTIONS
    if direction is not None and not is_name and _has_name(direction):
        findings.append(_unknown_choice(direction, "DIR", tuple(DIRECTIONS)))
    if not findings:
        findings += [refusal(command, number) for number in _combination(parsed, keywords)]
    return parsed, findings


def refusal(command: BracketCommand, number: int) -> Finding:
    """Return finding 50967 with the reason of this number in ``REFUSALS``."""
    return Finding(
        INDEPENDENT_MOTION_REFUSED,
        command.span,
        {"axis": command.name, "reason": REFUSALS[number]},
    )


def _sorted(command: BracketCommand, findings: list[Finding]) -> dict[str, Keyword]:
    """Return the keywords by name, G functions as ``G90``; report unknown and duplicate ones."""
    keywords: dict[str, Keyword] = {}
    for item in command.items:
        name = item.name if isinstance(item, Keyword) else ""
        if isinstance(item, Keyword) and name == "G":
            name = _g_word(item)
            if not name:
                findings.append(
                    Finding(
                        INDP_KEYWORD_NOT_ALLOWED,
                        item.span,
                        {"axis": command.name, "word": _shown(item)},
                    )
                )
                continue
        elif not isinstance(item, Keyword) or item.arguments or name not in _FLAGS + _VALUES:
            findings.append(
                Finding(UNKNOWN_INDP_KEYWORD, item.span, {"axis": command.name}, "word")
            )
            continue
        if name in keywords:
            findings.append(
                Finding(DUPLICATE_INDP_KEYWORD, item.span, {"axis": command.name, "word": name})
            )
        elif name in _FLAGS and item.value is not None:
            findings.append(Finding(INDP_KEYWORD_WITH_VALUE, item.span, {"word": name}))
        elif name in _VALUES and item.value is None:
            findings.append(Finding(WORD_VALUE_MISSING, item.span, {"word": name}))
        keywords.setdefault(name, item)
    return keywords


def _g_word(keyword: Keyword) -> str:
    """Return the name ``G90``, ``G91``, ``G00`` or ``G01``; empty for any other G function or a
    computed number.
    """
    return _G_WORDS.get(keyword.value.value, "") if isinstance(keyword.value, Number) else ""


def _shown(keyword: Keyword) -> str:
    return f"G{number_text(keyword.value.value)}" if isinstance(keyword.value, Number) else "G"


def _value(keywords: dict[str, Keyword], name: str) -> Expression | None:
    keyword = keywords.get(name)
    return None if keyword is None else keyword.value


def _offset(keyword: Keyword | None, findings: list[Finding]) -> str:
    if keyword is None or keyword.value is None:
        return ""
    value = keyword.value
    if isinstance(value, Name) and value.name in OFFSETS:
        return value.name
    findings.append(_unknown_choice(value, "OFFSET", OFFSETS))
    return ""


def _has_name(direction: Expression) -> bool:
    """Return whether a direction is another name than POS, CUR or NEG, or computes with these."""
    match direction:
        case Name():
            return True
        case Unary():
            return _has_direction(direction.operand)
        case Binary():
            return _has_direction(direction.left) or _has_direction(direction.right)
    return False


def _has_direction(value: Expression) -> bool:
    if isinstance(value, Name):
        return value.name in DIRECTIONS
    return _has_name(value)


def _unknown_choice(value: Expression, word: str, names: tuple[str, ...]) -> Finding:
    written = whole_span(value)
    return Finding(
        INVALID_KEYWORD_VALUE, written, {"word": word, "names": ", ".join(names)}, "value"
    )


def whole_span(value: Expression) -> Span:
    """Return the span of a value from its first operand to its last."""
    match value:
        case Binary():
            return replace(whole_span(value.left), end_column=whole_span(value.right).end_column)
        case Unary():
            return replace(value.span, end_column=whole_span(value.operand).end_column)
    return value.span


def _combination(command: AxisCommand, keywords: dict[str, Keyword]) -> list[int]:
    """Return the numbers of those ``REFUSALS`` that need no value."""
    if command.stops:
        return [1] if len(keywords) > 2 else []
    refused = [
        number
        for number, pair in (
            (2, ("ABORTING", "BUFFERED")),
            (3, ("G90", "G91")),
            (4, ("G00", "G01")),
        )
        if all(word in keywords for word in pair)
    ]
    if isinstance(command.direction, Number) and command.direction.value not in _SIGNS:
        refused.append(6)
    if isinstance(command.feed, Number) and command.feed.value == 0.0:
        refused.append(8)
    if command.position is None:
        return refused if command.feed is not None else [*refused, 11]
    if command.absolute is None:
        refused.append(5)
    if isinstance(command.feed, Number) and command.feed.value < 0.0:
        refused.append(12)
    if command.absolute is False and command.direction is not None:
        refused.append(10)
    return refused
