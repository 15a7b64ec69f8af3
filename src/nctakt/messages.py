# SPDX-License-Identifier: MIT
"""The catalogue: each message that nctakt can give, once.

The controller's own number is used where it is known; what the controller does not number has one
of ours:

====================  ==========================================================
900000 … 900099       lists: reader, schema, machine folder
900100 … 900199       NC text: lexer and parser
900200 … 900299       checked program: words, names, cycles
900300 … 900399       decoder, while it evaluates
900400 … 900499       realtime part
900500 … 900599       command line, files, stimuli, PLC
====================  ==========================================================
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.diagnostics import Diagnostic, Message, Severity, Span, Text

NOTE, WARNING, ERROR = Severity.NOTE, Severity.WARNING, Severity.ERROR


class Catalogue:
    """Messages by number; a number can be given once."""

    def __init__(self) -> None:
        self._messages: dict[int, Message] = {}

    def __getitem__(self, number: int) -> Message:
        return self._messages[number]

    def __iter__(self) -> Iterator[Message]:
        return iter(self._messages.values())

    def __contains__(self, number: int) -> bool:
        return number in self._messages

    def add(
        self,
        number: int,
        severity: Severity,
        en: str,
        de: str,
        *,
        remedy_en: str,
        remedy_de: str,
        parameters: dict[str, str] | None = None,
        reaction: int = 0,
        clearing: int = 0,
    ) -> None:
        """Declare one message; ``parameters`` says what each name in the texts means."""
        assert number not in self._messages, number
        self._messages[number] = Message(
            number,
            severity,
            Text(en, de),
            Text(remedy_en, remedy_de),
            parameters or {},
            reaction,
            clearing,
        )


CATALOGUE = Catalogue()
_add = CATALOGUE.add


class Collector:
    """Gathers diagnostics of one run over some text, in the order of their discovery."""

    def __init__(self) -> None:
        self.diagnostics: list[Diagnostic] = []

    def report(
        self, number: int, span: Span | None, source_line: str = "", **values: object
    ) -> Diagnostic:
        """Add the message ``number`` at ``span``."""
        found = diagnostic(number, span, source_line, **values)
        self.diagnostics.append(found)
        return found

    @property
    def has_errors(self) -> bool:
        """Whether anything worse than a warning was reported."""
        return any(found.severity is Severity.ERROR for found in self.diagnostics)


def diagnostic(
    number: int, span: Span | None = None, source_line: str = "", **values: object
) -> Diagnostic:
    """Make the diagnostic of message ``number``; each parameter of the message needs a value."""
    message = CATALOGUE[number]
    assert values.keys() == message.parameters.keys(), (number, tuple(values))
    return Diagnostic(message, span, values, source_line)


# --- lists: reader, schema, machine folder -------------------------------------------------------

# --- NC text: lexer and parser -------------------------------------------------------------------

# --- checked program: words, names, cycles -------------------------------------------------------

# --- decoder, while it evaluates -----------------------------------------------------------------

# --- realtime part -------------------------------------------------------------------------------

# --- command line, files, stimuli, PLC -----------------------------------------------------------
