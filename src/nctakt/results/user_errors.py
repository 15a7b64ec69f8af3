# SPDX-License-Identifier: MIT
"""The user's own errors and warnings (``#ERROR``, RC-402) in the events of a run.

In: events, of which ``user_error`` tells the ID and RC and each ``user_value`` behind it one value.
Out: ``UserErrorReport``, and the lines of the log that P-STUP-00170 names.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Message, Span
from nctakt.base.source_ids import statement_span
from nctakt.messages import diagnostic
from nctakt.messages.user_errors import FATAL_USER_ERROR, USER_ERROR, USER_WARNING
from nctakt.trace.events import Event
from nctakt.trace.sinks import TraceHeader


@dataclass(frozen=True, slots=True)
class UserErrorReport:
    """One ``#ERROR``: when, ID, RC, its values by keyword, its place, the cycle it comes from."""

    time_us: int
    identity: int
    reaction: int
    values: Mapping[str, str]
    span: Span | None
    cycle: str

    def diagnostic(self, texts: Mapping[int, str], line: str) -> Diagnostic:
        """The diagnostic with the text of the ID; ``line`` is the source line."""
        message = user_message(self.reaction)
        values = {"RC": str(self.reaction), **self.values}
        told = ", ".join(f"{name} = {value}" for name, value in values.items())
        place = statement_span(self.span, line)
        return diagnostic(message, place, line, said=self.said(texts), values=told)

    def said(self, texts: Mapping[int, str]) -> str:
        """The ID, with its text where there is one."""
        text = texts.get(self.identity, "")
        return f"{self.identity}: {text}" if text else str(self.identity)


def user_message(reaction: int) -> Message:
    """Return the message that tells an ``#ERROR`` with this RC."""
    return {0: USER_WARNING, 7: FATAL_USER_ERROR}.get(reaction, USER_ERROR)


def user_errors(events: Iterable[Event]) -> list[UserErrorReport]:
    """The user's errors and warnings in their order."""
    found: list[UserErrorReport] = []
    values: dict[str, str] = {}
    for event in events:
        if event.kind == "user_error":
            identity, reaction = map(int, event.text.split())
            values = {}
            report = UserErrorReport(
                event.time_us, identity, reaction, values, event.span, event.cycle
            )
            found.append(report)
        elif event.kind == "user_value":
            name, value = event.text.split(" ", 1)
            values[name] = value
    return found


class UserErrorLog:
    """Hands on a line for each of the user's errors while a run goes on; a sink."""

    def __init__(self, texts: Mapping[int, str], write: Callable[[str], None]) -> None:
        self._texts = texts
        self._write = write

    def open(self, header: TraceHeader) -> None:
        """Nothing to do: events hold all that is needed."""

    def events(self, events: Sequence[Event]) -> None:
        """Microseconds, ID with text, RC, values and place of each error."""
        for one in user_errors(events):
            values = {"RC": str(one.reaction), **one.values}
            told = " ".join(f"{name}={value}" for name, value in values.items())
            place = "" if one.span is None else f" {one.span}"
            self._write(f"{one.time_us} {one.said(self._texts)} [{told}]{place}\n")

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Nothing to do: errors are events."""

    def close(self) -> None:
        """Nothing to do: the file is another's."""
