# SPDX-License-Identifier: MIT
"""What a catalogue of messages is.

In: the declarations of the modules beside this one, each with the numbers of one stage. Out: a
table from number to ``Message``, in which no number stands twice.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.diagnostics import Message, Severity, Text

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
        cause_en: str = "",
        cause_de: str = "",
        parameters: dict[str, str] | None = None,
        reaction: int = 0,
        clearing: int = 0,
        known_as: tuple[int, ...] = (),
    ) -> None:
        """Declare one message; ``parameters`` says what each name in the texts means.

        ``known_as`` are other numbers under which sources know the same message.
        """
        assert number not in self._messages, number
        self._messages[number] = Message(
            number,
            severity,
            Text(en, de),
            Text(remedy_en, remedy_de),
            parameters or {},
            reaction,
            clearing,
            Text(cause_en, cause_de),
            known_as,
        )

    def include(self, other: Catalogue) -> None:
        """Take over all messages of ``other``."""
        for message in other:
            assert message.id not in self._messages, message.id
            self._messages[message.id] = message
