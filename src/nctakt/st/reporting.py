# SPDX-License-Identifier: MIT
"""Reports of mistakes in Structured Text: at positions of a project, within bounds.

In: messages with positions of ``Sources``. Out: diagnostics with file, line, column and source
line; each once for a position.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import replace

from nctakt.base.diagnostics import Message, Severity, Span
from nctakt.messages import Collector
from nctakt.st.sources import Sources


class Reporter:
    """Gathers the diagnostics of a project."""

    def __init__(self, sources: Sources, collector: Collector) -> None:
        self.sources = sources
        self.collector = collector
        self._known: set[tuple[int, int, str]] = set()
        self.error_count = 0

    @contextlib.contextmanager
    def apart(self) -> Iterator[Collector]:
        """Gather the reports made meanwhile separately, as if nothing had been reported before."""
        outer = self.collector, self._known, self.error_count
        self.collector, self._known, self.error_count = Collector(), set(), 0
        try:
            yield self.collector
        finally:
            self.collector, self._known, self.error_count = outer

    def report(self, message: Message, start: int, end: int, **values: object) -> None:
        """Report a message at a stretch of text, unless it was reported there."""
        key = (message.id, start, str(values.get("name", "")))
        if key in self._known:
            return
        self._known.add(key)
        if message.severity is Severity.ERROR:
            self.error_count += 1
        span = self.sources.span(start, end)
        line = "" if span is None else self.sources.line(span.file, span.line)
        found = self.collector.report(message, span, line, **values)
        within = self.sources.within(start)
        if within is not None:
            self.collector.diagnostics[-1] = replace(found, within=within)

    def report_file(self, message: Message, span: Span | None, **values: object) -> None:
        """Report a message about a file."""
        if message.severity is Severity.ERROR:
            self.error_count += 1
        line = "" if span is None else self.sources.line(span.file, span.line)
        self.collector.report(message, span, line, **values)
