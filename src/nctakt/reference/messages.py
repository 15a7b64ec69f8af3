# SPDX-License-Identifier: MIT
"""Articles about messages, from the catalogue (RC-602)."""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.diagnostics import Message, Severity, Text
from nctakt.messages.catalogue import catalogue, is_own, messages_of
from nctakt.messages.classes import CLEARINGS, REACTIONS
from nctakt.reference.article import Article, Fact, Topic, fact, same

_KINDS = {
    Severity.ERROR: Text("error", "Fehler"),
    Severity.WARNING: Text("warning", "Warnung"),
    Severity.NOTE: Text("note", "Hinweis"),
}


def article(message: Message) -> Article:
    """Return the article of one message."""
    level = _KINDS[message.severity]
    whose = Text("of nctakt", "von nctakt")
    if not is_own(message.id):
        whose = Text("of the controller", "der Steuerung")
    kind = Text(f"{level.en} {whose.en}", f"{level.de} {whose.de}")
    return Article(str(message.id), kind, message.text, tuple(_facts(message)))


def _facts(message: Message) -> Iterator[Fact]:
    if message.cause.en:
        yield fact("Cause", "Ursache", message.cause)
    if message.remedy.en:
        yield fact("Remedy", "Abhilfe", message.remedy)
    for name, meaning in message.parameters.items():
        yield Fact(same(f"{{{name}}}"), Text(*meaning))
    if message.reaction:
        yield fact("Effect", "Wirkung", _class(message.reaction, REACTIONS[message.reaction]))
        yield fact("Cleared by", "Löschen", _class(message.clearing, CLEARINGS[message.clearing]))
    if message.cases is not None:
        numbers = ", ".join(map(str, message.cases.numbers))
        yield fact("Number by case", "Nummer je nach Fall", numbers)
    if message.known_as:
        yield fact("Also known as", "Auch bekannt als", ", ".join(map(str, message.known_as)))


def _class(number: int, meaning: Text) -> Text:
    return Text(f"{meaning.en} (class {number})", f"{meaning.de} (Klasse {number})")


def _all() -> Iterator[Article]:
    for message in catalogue():
        yield article(message)


def _find(word: str) -> tuple[Article, ...]:
    if not (word.isascii() and word.isdigit()):
        return ()
    return tuple(map(article, messages_of(int(word))))


def _names() -> Iterator[str]:
    return (str(message.id) for message in catalogue())


MESSAGES = Topic(
    "messages",
    Text("Messages by their number", "Meldungen nach ihrer Nummer"),
    ("22009", "50879", "20196"),
    _all,
    _find,
    _names,
)
