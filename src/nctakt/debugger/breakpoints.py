# SPDX-License-Identifier: MIT
"""Breakpoints of the protocol as stops of a session.

In: a client's settings for a file, for functions, data and exceptions. Out: the stops to watch, and
for those that have held the breakpoints that they belong to, with counts and log texts. A line
without a block moves the breakpoint to the next one; a breakpoint that cannot be watched is not
verified, and says why.
"""

from __future__ import annotations

import operator
import re
from array import array
from bisect import bisect_left
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.debugger.arguments import Arguments
from nctakt.debugger.places import Place
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import CHANGES_NEEDS_A_BRANCH, NOT_A_HIT_CONDITION
from nctakt.messages.connections.session import TOO_MANY_STOPS
from nctakt.session.stops import MAX_STOPS, Kind, StopAt

#: How often a breakpoint with a hit condition is counted at most.
MAX_HITS = 1_000_000

#: Stops that are left for exceptions and steps.
RESERVED_STOPS = 8

#: The modes of breakpoints that the client may offer: name, label, what they belong to.
MODES = (
    ("runs", "Stop whenever the body runs", ("source",)),
    ("changes", "Stop when the condition or the value changes", ("source", "data")),
    ("fires", "Stop when a series of runs begins", ("source",)),
    ("written", "Stop when a realtime cycle writes another value", ("data",)),
)

_HIT = re.compile(r"(?P<operator>==|>=|<=|>|<|=|%)?\s*(?P<number>\d{1,9})")
_QUALIFIER = re.compile(r"(?P<word>changes|fires|runs|written)\b\s*(?:if\b)?\s*", re.IGNORECASE)

_OPERATORS: dict[str, Callable[[int, int], bool]] = {
    "==": operator.eq,
    "=": operator.eq,
    ">": operator.gt,
    ">=": operator.ge,
    "<": operator.lt,
    "<=": operator.le,
    "%": lambda count, number: number > 0 and count % number == 0,
}


@dataclass(slots=True)
class Breakpoint:
    """A breakpoint: its stops, and its mistake; ``line`` 0: it has no line.

    ``asked``: the client's request, and its ``source``; it is reread when a program restarts.
    ``hit_condition`` counts ``hits``, the moments in which it has held (``moment_of``); ``log``:
    the text that it prints instead of stopping.
    """

    number: int
    kind: str
    asked: Arguments
    source: Arguments | None = None
    stops: tuple[StopAt, ...] = ()
    file: str = ""
    line: int = 0
    hit_condition: str = ""
    log: str = ""
    mistake: Failure | None = None
    hits: array[int] = field(default_factory=lambda: array("q"))

    def is_due(self, moment: int) -> bool:
        """Count a moment in which it has held; return whether its hit condition is true there."""
        if not self.hit_condition:
            return True
        index = bisect_left(self.hits, moment)
        if index == len(self.hits) or self.hits[index] != moment:
            if len(self.hits) >= MAX_HITS:
                return True
            self.hits.insert(index, moment)
        return is_met(self.hit_condition, index + 1)


def moment_of(tick: int, number: int = 0) -> int:
    """Return a number for a tick, or for a statement of the PLC in it; later ones are greater."""
    return (tick << 32) + number


def is_met(condition: str, count: int) -> bool:
    """Return whether a hit condition is true for a count; raises ``Failure`` (901231)."""
    match = _HIT.fullmatch(condition.strip())
    if match is None:
        raise Failure(diagnostic(NOT_A_HIT_CONDITION, text=condition))
    return _OPERATORS[match["operator"] or ">="](count, int(match["number"]))


def divided_condition(text: str) -> tuple[str, str]:
    """Return the qualifier at the begin of a condition, and the condition after it."""
    match = _QUALIFIER.match(text.strip())
    if match is None:
        return "", text.strip()
    return match["word"].lower(), text.strip()[match.end() :].strip()


class Breakpoints:
    """All breakpoints of a debugger; they outlive a restart of its session."""

    def __init__(self) -> None:
        self._count = 0
        self._sets: dict[str, list[Breakpoint]] = {}

    # --- setting --------------------------------------------------------------------------------

    def set(self, group: str, breakpoints: list[Breakpoint]) -> None:
        """Replace the breakpoints of a file, or those of another kind."""
        self._sets[group] = breakpoints

    def make(self, kind: str, arguments: Arguments, **where: Any) -> Breakpoint:
        """Return a breakpoint with the hit condition and log text that a client has sent."""
        self._count += 1
        new = Breakpoint(self._count, kind, arguments, **where)
        new.hit_condition = arguments.text("hitCondition", "").strip()
        new.log = arguments.text("logMessage", "")
        if new.hit_condition:
            try:
                is_met(new.hit_condition, 1)
            except Failure as failure:
                new.mistake = failure
        return new

    def at_place(self, arguments: Arguments, file: str, location: Place) -> Breakpoint:
        """Return the breakpoint at a place of a text."""
        new = self.make("source", arguments, file=file, line=location.line)
        qualifier, condition = divided_condition(arguments.text("condition", ""))
        mode = qualifier or arguments.text("mode", "") or "runs"
        try:
            kinds = _kinds_at(location, mode)
        except Failure as failure:
            new.mistake = failure
            return new
        new.stops = tuple(
            StopAt(
                kind,
                location.target if kind == "changes" else "",
                file,
                line,
                condition,
                statement=location.statement if kind in ("runs", "cycle") else 0,
            )
            for kind, line in kinds
        )
        return new

    def of_function(self, arguments: Arguments) -> Breakpoint:
        """Return the breakpoint at an M, H or T function."""
        new = self.make("function", arguments)
        _, condition = divided_condition(arguments.text("condition", ""))
        name = arguments.text("name").strip().upper()
        new.stops = (StopAt("function", name, only_if=condition),)
        return new

    def of_data(self, arguments: Arguments) -> Breakpoint:
        """Return the breakpoint on a variable or expression; its id is ``mode channel name``."""
        new = self.make("data", arguments)
        mode, channel, name = data_of(arguments.text("dataId"))
        qualifier, condition = divided_condition(arguments.text("condition", ""))
        kind: Kind = "written" if (qualifier or mode) == "written" else "changes"
        new.stops = (StopAt(kind, name, only_if=condition, channel=channel),)
        return new

    # --- watching -------------------------------------------------------------------------------

    @property
    def all(self) -> list[Breakpoint]:
        """All of them, in the order in which they were set."""
        return [one for own in self._sets.values() for one in own]

    def verify(self, own: Iterable[Breakpoint], check: Callable[[Sequence[StopAt]], None]) -> None:
        """Note mistakes in breakpoints; ``check`` raises ``Failure`` for stops."""
        unknown = [breakpoint_ for breakpoint_ in own if breakpoint_.mistake is None]
        different = dict.fromkeys(breakpoint_.stops for breakpoint_ in unknown)
        mistakes: dict[tuple[StopAt, ...], Failure] = {}
        for stops in different:
            try:
                check(stops)
            except Failure as failure:
                mistakes[stops] = failure
        for breakpoint_ in unknown:
            breakpoint_.mistake = mistakes.get(breakpoint_.stops)

    def bound(self) -> None:
        """Note of breakpoints beyond the stops that a session can watch that they are too many."""
        stops, owners = self.stops()
        limit = MAX_STOPS - RESERVED_STOPS
        for breakpoint_ in owners[limit:]:
            found = diagnostic(TOO_MANY_STOPS, count=len(stops), limit=limit)
            breakpoint_.mistake = Failure(found)

    def stops(self) -> tuple[list[StopAt], list[Breakpoint]]:
        """Return the stops to watch, and for each of them its breakpoint."""
        stops: list[StopAt] = []
        owners: list[Breakpoint] = []
        for breakpoint_ in self.all:
            if breakpoint_.mistake is None:
                stops += breakpoint_.stops
                owners += [breakpoint_] * len(breakpoint_.stops)
        return stops, owners

    def forget_from(self, tick: int) -> None:
        """Forget hits in and after a tick: another branch begins there."""
        for breakpoint_ in self.all:
            del breakpoint_.hits[bisect_left(breakpoint_.hits, moment_of(tick)) :]

    def renew(self, again: Callable[[Breakpoint], Breakpoint]) -> None:
        """Replace each by what ``again`` returns for it, with its number and without hits."""
        for group, own in self._sets.items():
            renewed = [again(one) for one in own]
            for old, new in zip(own, renewed, strict=True):
                new.number = old.number
            self._sets[group] = renewed


def shown(
    breakpoint_: Breakpoint, source: Mapping[str, Any] | None, language: Language
) -> dict[str, Any]:
    """Return a breakpoint as the protocol shows it."""
    found: dict[str, Any] = {"id": breakpoint_.number, "verified": breakpoint_.mistake is None}
    if breakpoint_.line:
        found["line"] = breakpoint_.line
    if source is not None:
        found["source"] = source
    if breakpoint_.mistake is not None:
        first = replace(breakpoint_.mistake.diagnostics[0], span=None)
        found["message"] = f"{first.headline(language)} {first.remedy(language)}"
        found["reason"] = "failed"
    return found


def data_id(mode: str, channel: int, name: str) -> str:
    """Return the id of a data breakpoint."""
    return f"{mode} {channel} {name}"


def data_of(text: str) -> tuple[str, int, str]:
    """Return mode, channel and name of a data breakpoint's id."""
    mode, _, rest = text.partition(" ")
    channel, _, name = rest.partition(" ")
    if mode not in ("changes", "written") or not channel.isdecimal() or len(channel) > 4:
        return "changes", 1, text
    return mode, int(channel), name


def _kinds_at(location: Place, mode: str) -> list[tuple[Kind, int]]:
    """Return the kinds of stops at a place, each with its line."""
    if location.kind == "block":
        if mode in ("changes", "fires", "written"):
            raise Failure(diagnostic(CHANGES_NEEDS_A_BRANCH))
        return [("block", location.line)]
    if location.kind == "statement":
        if mode != "runs":
            raise Failure(diagnostic(CHANGES_NEEDS_A_BRANCH))
        return [("statement", location.line)]
    if location.kind == "cycle":
        if mode == "changes" and location.target:
            return [("changes", 0)]
        if mode != "runs":
            raise Failure(diagnostic(CHANGES_NEEDS_A_BRANCH))
        return [("cycle", location.owner)]
    if mode == "changes" and location.kind == "branch":
        return [("turns", location.owner), ("false", location.owner)]
    if mode in ("changes", "fires"):
        return [("fires", location.owner)]
    return [("runs", location.owner)]
