# SPDX-License-Identifier: MIT
"""The diagnostics of the checker, each with its source line.

In: messages with spans. Out: diagnostics in the collector. Levels of support (``entries.py``)
become diagnostics here: an error for each refused name, one note per program for an accepted one.
"""

from __future__ import annotations

from dataclasses import replace

from nctakt.base.diagnostics import Message, Span, Text
from nctakt.messages import Collector
from nctakt.messages.path.motion import SIMPLIFIED
from nctakt.messages.programs.checked_blocks import ACCEPTED_WITHOUT_EFFECT, NOT_SIMULATED
from nctakt.nc.source import Source
from nctakt.nc.vocabulary.entries import Entry, Support

#: State of ``Findings``: the notes given once, the macros so far, whether calls may define others,
#: the words that call a program named so far.
FindingsState = tuple[tuple[str, ...], frozenset[str], bool, frozenset[str]]


class Findings:
    """Collects the diagnostics of one program."""

    def __init__(self, source: Source, collector: Collector) -> None:
        self._source = source
        self._collector = collector
        self._reported: dict[str, None] = {}
        #: Macros that the program has defined so far; calls may define others.
        self.macros: set[str] = set()
        self.has_other_macros = False
        #: The words whose program the program has named so far: M6, G80 …
        self.named_programs: set[str] = set()

    @property
    def state(self) -> FindingsState:
        """State that later findings depend on."""
        named = frozenset(self.named_programs)
        return tuple(self._reported), frozenset(self.macros), self.has_other_macros, named

    def resume(self, state: FindingsState) -> None:
        """Continue from a state."""
        reported, macros, self.has_other_macros, named = state
        self._reported = dict.fromkeys(reported)
        self.macros = set(macros)
        self.named_programs = set(named)

    def report(self, message: Message, span: Span, **values: object) -> None:
        """Add a diagnostic."""
        self._collector.report(message, span, self._source.line_of(span), **values)

    def report_once(self, message: Message, span: Span) -> None:
        """Add a note without values once per program."""
        if str(message.id) not in self._reported:
            self._reported[str(message.id)] = None
            self.report(message, span)

    def report_each(self, message: Message, span: Span, **values: object) -> None:
        """Add a note once per program for each of its values."""
        key = f"{message.id} {tuple(values.values())}"
        if key not in self._reported:
            self._reported[key] = None
            self.report(message, span, **values)

    def line_of(self, span: Span) -> str:
        """Return the line of a span."""
        return self._source.line_of(span)

    def written(self, span: Span) -> str:
        """Return the text that a span covers, cut to the length for a message."""
        text = self._source.line_of(span)[span.column - 1 : span.end_column - 1]
        return " ".join(text.split())[:40]

    def text_after(self, span: Span) -> tuple[str, Span]:
        """Return the text after a span in its line, and the span of that text."""
        rest = self._source.line_of(span)[span.end_column - 1 :]
        text = rest.strip()
        begin = span.end_column + len(rest) - len(rest.lstrip())
        return text, replace(span, column=begin, end_column=begin + len(text))

    def report_simplified(self, command: str, meaning: Text, span: Span) -> None:
        """Report once what nctakt does where the sources are silent."""
        key = f"simplified {command}"
        if key not in self._reported:
            self._reported[key] = None
            self.report(SIMPLIFIED, span, command=command, meaning=meaning)

    def report_support(self, entry: Entry, span: Span, name: str = "", nearest: str = "") -> None:
        """Report a refused entry, and an accepted one once; ``name``: as written in the program.

        ``nearest``: a known name that may be meant.
        """
        command = name or entry.name
        if entry.support is Support.SIMULATED:
            return
        if entry.support is Support.ACCEPTED:
            if command in self._reported:
                return
            self._reported[command] = None
            self.report(ACCEPTED_WITHOUT_EFFECT, span, command=command, meaning=entry.meaning)
            return
        advice = entry.advice
        if nearest:
            meant = Text(f"Did you mean {nearest}? ", f"War {nearest} gemeint? ")
            advice = Text(meant.en + advice.en, meant.de + advice.de)
        self.report(NOT_SIMULATED, span, command=command, meaning=entry.meaning, advice=advice)
