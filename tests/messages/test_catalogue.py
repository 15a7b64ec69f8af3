# SPDX-License-Identifier: MIT
"""The catalogue of messages: complete in both languages, consistent."""

from __future__ import annotations

import re
from collections import Counter
from string import Formatter

import pytest

from nctakt.base.diagnostics import Message, Severity, Text
from nctakt.messages.catalogue import catalogue, is_own, next_free_number
from nctakt.messages.classes import CLEARINGS, REACTIONS

#: A text fits on a line of a terminal and of a report.
LONGEST = 110

ALL = pytest.mark.parametrize(
    "message", tuple(catalogue().values()), ids=lambda message: str(message.id)
)


def fields(text: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(text) if name is not None}


@ALL
def test_both_languages(message: Message) -> None:
    """RC-602: a message has text, remedy and cause in both languages or in none."""
    assert message.text.en
    assert message.text.de
    assert bool(message.remedy.en) == bool(message.remedy.de)
    assert bool(message.cause.en) == bool(message.cause.de)
    assert message.text.en != message.text.de or "{" in message.text.en


@ALL
def test_parameters_are_those_of_the_texts(message: Message) -> None:
    """RC-602: text and remedy use exactly the parameters that the message explains."""
    for language in ("en", "de"):
        used = fields(message.text.get(language)) | fields(message.remedy.get(language))
        assert used == message.parameters.keys()
    assert not fields(message.cause.en) | fields(message.cause.de)
    for meaning in message.parameters.values():
        assert all(meaning), meaning


@ALL
def test_texts_fit_on_a_line(message: Message) -> None:
    """No text or remedy is longer than a line."""
    for text in (message.text, message.remedy):
        for line in (*text.en.split("\n"), *text.de.split("\n")):
            assert len(line) <= LONGEST, line


@ALL
def test_errors_tell_a_remedy(message: Message) -> None:
    """What stops a program says what to do about it."""
    if message.severity is Severity.ERROR:
        assert message.remedy.en


@ALL
def test_classes_are_explained(message: Message) -> None:
    """The class numbers of a message stand in the tables, or it has none."""
    assert (message.reaction == 0) == (message.clearing == 0)
    if message.reaction:
        assert message.reaction in REACTIONS
        assert message.clearing in CLEARINGS
        assert message.severity >= Severity.WARNING


def test_class_tables_have_both_languages() -> None:
    """The meanings of the classes are there in English and German."""
    for text in (*REACTIONS.values(), *CLEARINGS.values()):
        assert isinstance(text, Text)
        assert text.en
        assert text.de


def test_texts_of_the_controllers_numbers_are_unique() -> None:
    """Two numbers of the controller never have the same text."""
    messages = [message for number, message in catalogue().items() if not is_own(number)]
    texts = Counter(text for one in messages for text in {one.text.en, one.text.de})
    assert [text for text, count in texts.items() if count > 1] == []


def test_the_next_number_is_free() -> None:
    """A new message gets a number of nctakt's own above all others, never one that was given up."""
    number = next_free_number()
    assert is_own(number)
    assert all(number > other for other in catalogue() if is_own(other))


def test_other_numbers_are_no_messages() -> None:
    """RC-801: a number that a message is also known as belongs to it alone."""
    others = [number for message in catalogue().values() for number in message.known_as]
    assert len(others) == len(set(others))
    assert [number for number in others if number in catalogue()] == []
    assert catalogue()[50939].known_as == (50930,)


#: A first word that is written as in a program, a list or on the command line.
CODE = re.compile(r"[^\w]|[\d_]|^nctakt$|^moduloo$")


@ALL
def test_remedies_are_sentences(message: Message) -> None:
    """A remedy begins with a capital letter, unless with code, and ends as a sentence does.

    Behind a colon there may be names at its end, which a full stop would blur.
    """
    for text in (message.remedy.en, message.remedy.de):
        if not text:
            continue
        first, last = text.split()[0].rstrip(":,;"), text.split()[-1]
        assert not text[0].islower() or CODE.search(first), text
        is_prose = last.isalpha() and not last.isupper() and len(last) > 1
        assert not is_prose, text
