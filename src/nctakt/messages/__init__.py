# SPDX-License-Identifier: MIT
"""Messages: all that nctakt can give, each declared once, in English and German.

A module holds the messages of one subject. A message has the controller's number if it is known,
else one of nctakt's, from 900000 on (``scripts/next_message`` prints the next one). In: a declared
message, a span, the values of its parameters. Out: the ``Diagnostic``.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Diagnostic, Message, Severity, Span

__all__ = ["Collector", "diagnostic"]


class Collector:
    """Gathers diagnostics of one run over some text, in the order of their discovery."""

    def __init__(self) -> None:
        self.diagnostics: list[Diagnostic] = []

    def report(
        self, message: Message, span: Span | None, source_line: str = "", **values: object
    ) -> Diagnostic:
        """Add ``message`` at ``span`` and return its diagnostic."""
        return self.report_as(0, message, span, source_line, **values)

    def report_as(
        self,
        number: int,
        message: Message,
        span: Span | None,
        source_line: str = "",
        /,
        **values: object,
    ) -> Diagnostic:
        """Add ``message`` with the number of a case; 0: that which its values give."""
        assert values.keys() == message.parameters.keys(), (message.id, tuple(values))
        found = Diagnostic(message, span, values, source_line, number=number)
        self.diagnostics.append(found)
        return found

    @property
    def has_errors(self) -> bool:
        """Whether anything worse than a warning was reported."""
        return any(found.severity is Severity.ERROR for found in self.diagnostics)


def diagnostic(
    message: Message, span: Span | None = None, source_line: str = "", **values: object
) -> Diagnostic:
    """Make the diagnostic of a message; each of its parameters needs a value."""
    assert values.keys() == message.parameters.keys(), (message.id, tuple(values))
    return Diagnostic(message, span, values, source_line)
