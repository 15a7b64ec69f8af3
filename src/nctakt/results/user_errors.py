# SPDX-License-Identifier: MIT
"""User-defined errors and warnings (``#ERROR``, RC-402) in the events of a run.

In: events: ``user_error`` has the ID and RC, each ``user_value`` after it one value. Out:
``UserErrorReport``, and the lines of the log file (P-STUP-00170).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Message, Span
from nctakt.base.source_ids import statement_span
from nctakt.kernel import rows
from nctakt.messages import diagnostic
from nctakt.messages.programs.user_errors import FATAL_USER_ERROR, USER_ERROR, USER_WARNING
from nctakt.results.trace.chunks import of_kinds
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader

_ROWS = frozenset((rows.EVENT_USER_ERROR, rows.EVENT_USER_VALUE, rows.EVENT_USER_TEXT))


@dataclass(frozen=True, slots=True)
class UserErrorReport:
    """One ``#ERROR``: time, ID, RC, values by keyword, position, and the cycle that raised it."""

    time_us: int
    identity: int
    reaction: int
    values: Mapping[str, str]
    span: Span | None
    cycle: str

    def diagnostic(self, texts: Mapping[int, str], line: str) -> Diagnostic:
        """Return the diagnostic with the text of the ID; ``line`` is the source line."""
        message = user_message(self.reaction)
        values = {"RC": str(self.reaction), **self.values}
        values_text = ", ".join(f"{name} = {value}" for name, value in values.items())
        span = statement_span(self.span, line)
        return diagnostic(message, span, line, said=self.label(texts), values=values_text)

    def label(self, texts: Mapping[int, str]) -> str:
        """Return the ID, followed by its text if it has one."""
        text = texts.get(self.identity, "")
        return f"{self.identity}: {text}" if text else str(self.identity)


def user_message(reaction: int) -> Message:
    """Return the message for an ``#ERROR`` with this RC."""
    return {0: USER_WARNING, 7: FATAL_USER_ERROR}.get(reaction, USER_ERROR)


def user_errors(events: Iterable[Event]) -> list[UserErrorReport]:
    """Return the user's errors and warnings in their order."""
    reports: list[UserErrorReport] = []
    values: dict[str, str] = {}
    for event in events:
        if event.kind == "user_error":
            identity, reaction = map(int, event.text.split())
            values = {}
            report = UserErrorReport(
                event.time_us, identity, reaction, values, event.span, event.cycle
            )
            reports.append(report)
        elif event.kind == "user_value":
            name, value = event.text.split(" ", 1)
            values[name] = value
    return reports


class UserErrorLog:
    """A sink that writes a line for each of the user's errors."""

    def __init__(self, texts: Mapping[int, str], write: Callable[[str], None]) -> None:
        self._texts = texts
        self._write = write

    def open(self, header: TraceHeader) -> None:
        """Do nothing: the events suffice."""

    def events(self, events: Sequence[Event]) -> None:
        """Write time in microseconds, ID with text, RC, values and position of each error."""
        for error in user_errors(of_kinds(events, _ROWS)):
            values = {"RC": str(error.reaction), **error.values}
            values_text = " ".join(f"{name}={value}" for name, value in values.items())
            position = "" if error.span is None else f" {error.span}"
            self._write(f"{error.time_us} {error.label(self._texts)} [{values_text}]{position}\n")

    def close(self) -> None:
        """Do nothing: the caller closes the file."""
