# SPDX-License-Identifier: MIT
"""Where the time went, as tables: kinds, causes, tools, programs, the slowest blocks."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Hashable, Iterator, Sequence
from typing import TypeVar

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Span, Text
from nctakt.lists.format.times import Time
from nctakt.results.summary import Table, plain_table, state_text
from nctakt.timing.entries import Purpose, Times
from nctakt.timing.what_if import Variant
from nctakt.timing.words import KINDS, general_text, limit_text

_Key = TypeVar("_Key", bound=Hashable)

#: Blocks that the table shows, the slowest ones.
MAX_BLOCKS = 20
#: Characters of a block's text.
_MAX_TEXT = 40

_TIME = Text("time", "Zeit")
_SHARE = Text("share", "Anteil")
_KIND = Text("kind", "Art")
_SPEEDING = Text("accelerating", "Beschleunigen")
_BRAKING = Text("braking", "Bremsen")
_LIMIT = Text("limited by", "begrenzt durch")
_TOOL = Text("tool", "Werkzeug")
_PROGRAM = Text("program", "Programm")
_BLOCK = Text("block", "Satz")
_MAIN_LIMIT = Text("limited most by", "am meisten begrenzt durch")
_SUM = Text("sum", "Summe")
_MORE = Text("{count} other blocks", "{count} weitere Sätze")
_CHANNEL = Text("Channel {number}", "Kanal {number}")
_WITHOUT = Text("none", "keines")
_DOUBLED = Text("if doubled", "wenn verdoppelt")
_SAVED = Text("saved", "gespart")
_STATE = Text("end", "Ende")
_NO_EFFECT = Text("without effect: {names}", "ohne Wirkung: {names}")


@dataclass(frozen=True, slots=True)
class TimeTable(Table):
    """A table of times; ``spans``: the blocks of its first rows, if it is one of blocks."""

    spans: tuple[Span, ...] = ()


#: For each channel its title, empty if it is the only one, and its tables.
TitledTables = list[tuple[str, list[TimeTable]]]


def time_tables(times: Times, language: Language) -> TitledTables:
    """Return the tables of each channel that has a program, with its title if there are more."""
    found = []
    for channel in range(1, times.channels + 1):
        if set(times.by(lambda one: one.kind, channel)) - {"idle"}:
            title = _CHANNEL.get(language).format(number=channel) if times.channels > 1 else ""
            found.append((title, list(_ChannelTables(times, channel, language))))
    return found


def time_text(times: Times, language: Language) -> str:
    """Return all tables of a run, those of each channel by themselves."""
    parts: list[str] = []
    for title, tables in time_tables(times, language):
        parts += [title] if title else []
        parts += ["\n".join(plain_table(table)) for table in tables]
    return "\n\n".join(parts) + "\n"


def what_if_text(variants: Sequence[Variant], language: Language) -> str:
    """Return the saving of each doubled limit, the largest first; name those without effect."""
    heads = (
        _DOUBLED.get(language),
        _TIME.get(language),
        _SAVED.get(language),
        _STATE.get(language),
    )
    rows = tuple(
        (
            one.name.get(language),
            _time(one.time_us),
            _time(one.saved_us),
            state_text(one.state, language),
        )
        for one in sorted(variants, key=lambda one: -one.saved_us)
        if not one.changes_nothing
    )
    lines = plain_table(Table(heads, rows)) if rows else []
    names = ", ".join(one.name.get(language) for one in variants if one.changes_nothing)
    if names:
        lines.append(_NO_EFFECT.get(language).format(names=names))
    return "".join(f"{line}\n" for line in lines)


class _ChannelTables:
    """The tables of one channel, in the order in which they are shown."""

    def __init__(self, account: Times, channel: int, language: Language) -> None:
        self._account = account
        self._channel = channel
        self._language = language
        self._total = account.ticks

    def __iter__(self) -> Iterator[TimeTable]:
        yield self._kinds()
        yield self._grouped(_LIMIT, self._cause)
        tools = self._grouped(_TOOL, lambda one: str(one.tool or _WITHOUT.get(self._language)))
        if len(tools.rows) > 1 + 1:
            yield tools
        programs = self._grouped(_PROGRAM, lambda one: " > ".join(one.calls) or "-")
        if len(programs.rows) > 1 + 1:
            yield programs
        yield self._blocks()

    def _cause(self, purpose: Purpose) -> str:
        text = general_text(purpose.limit, self._language)
        return text or KINDS[purpose.kind].get(self._language)

    def _kinds(self) -> TimeTable:
        language, account = self._language, self._account
        ticks = account.by(lambda one: (one.kind, one.phase), self._channel)
        rows = []
        for kind, text in KINDS.items():
            own = sum(count for (one, _), count in ticks.items() if one == kind)
            if own:
                parts = [
                    _time(account.us(ticks.get((kind, phase), 0)), blank=True)
                    for phase in ("accelerating", "braking")
                ]
                rows.append((text.get(language), *self._amount(own), *parts))
        heads = (_KIND, _TIME, _SHARE, _SPEEDING, _BRAKING)
        return self._with_sum(heads, rows, sum(ticks.values()))

    def _grouped(self, head: Text, key: Callable[[Purpose], str]) -> TimeTable:
        ticks = self._account.by(key, self._channel)
        rows = [(name, *self._amount(count)) for name, count in _largest(ticks)]
        return self._with_sum((head, _TIME, _SHARE), rows, sum(ticks.values()))

    def _blocks(self) -> TimeTable:
        language, account = self._language, self._account
        ticks = account.by(lambda one: one.span, self._channel)
        causes: dict[object, dict[str, int]] = defaultdict(dict)
        for (span, text), count in account.by(self._span_and_cause, self._channel).items():
            causes[span][text] = count
        found = [(span, count) for span, count in _largest(ticks) if span is not None]
        rows = []
        for span, count in found[:MAX_BLOCKS]:
            text = account.lines[span][:_MAX_TEXT]
            main_cause = max(causes[span], key=causes[span].__getitem__)
            rows.append((f"{span.line}: {text}", *self._amount(count), main_cause))
        left = sum(count for _, count in found[MAX_BLOCKS:]) + ticks.get(None, 0)
        if left:
            more = _MORE.get(language).format(count=len(found[MAX_BLOCKS:]))
            name = more if len(found) > MAX_BLOCKS else "-"
            rows.append((name, *self._amount(left), ""))
        spans = tuple(span for span, _ in found[:MAX_BLOCKS])
        heads = (_BLOCK, _TIME, _SHARE, _MAIN_LIMIT)
        return self._with_sum(heads, rows, sum(ticks.values()), spans)

    def _span_and_cause(self, purpose: Purpose) -> tuple[object, str]:
        text = limit_text(purpose.limit, self._language)
        return purpose.span, text or KINDS[purpose.kind].get(self._language)

    def _amount(self, ticks: int) -> tuple[str, str]:
        return _time(self._account.us(ticks)), f"{100.0 * ticks / self._total:.1f} %"

    def _with_sum(
        self,
        heads: tuple[Text, ...],
        rows: Sequence[tuple[str, ...]],
        ticks: int,
        spans: tuple[Span, ...] = (),
    ) -> TimeTable:
        """Return a table that ends with the sum of its ticks."""
        rest = ("",) * (len(heads) - 3)
        rows = [*rows, (_SUM.get(self._language), *self._amount(ticks), *rest)]
        titles = tuple(head.get(self._language) for head in heads)
        return TimeTable(titles, tuple(rows), spans)


def _largest(ticks: dict[_Key, int]) -> list[tuple[_Key, int]]:
    """Return the groups with most ticks first."""
    return sorted(ticks.items(), key=lambda one: -one[1])


def _time(us: int, *, blank: bool = False) -> str:
    return "" if blank and not us else str(Time(us))
