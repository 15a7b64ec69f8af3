# SPDX-License-Identifier: MIT
"""The catalogue of messages: complete in both languages, consistent."""

from __future__ import annotations

import re
from collections import Counter
from string import Formatter

import pytest

from nctakt.base.diagnostics import Severity, Text
from nctakt.messages import diagnostic
from nctakt.messages.catalogue import catalogue, is_own, messages_of, next_free_number
from nctakt.messages.classes import CLEARINGS, REACTIONS

#: A text fits on a line of a terminal and of a report.
LONGEST = 110


def fields(text: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(text) if name is not None}


def test_both_languages() -> None:
    """RC-602: a message has text, remedy and cause in both languages or in none."""
    for message in catalogue():
        assert message.text.en, message
        assert message.text.de, message
        assert bool(message.remedy.en) == bool(message.remedy.de), message
        assert bool(message.cause.en) == bool(message.cause.de), message
        assert message.text.en != message.text.de or "{" in message.text.en, message


def test_parameters_are_those_of_the_texts() -> None:
    """RC-602: text and remedy use exactly the parameters that the message explains."""
    for message in catalogue():
        for language in ("en", "de"):
            used = fields(message.text.get(language)) | fields(message.remedy.get(language))
            assert used == message.parameters.keys(), message
        assert not fields(message.cause.en) | fields(message.cause.de), message
        for meaning in message.parameters.values():
            assert all(meaning), message


def test_texts_fit_on_a_line() -> None:
    """No text or remedy is longer than a line."""
    for message in catalogue():
        for text in (message.text, message.remedy):
            for line in (*text.en.split("\n"), *text.de.split("\n")):
                assert len(line) <= LONGEST, message


def test_errors_tell_a_remedy() -> None:
    """What stops a program says what to do about it."""
    for message in catalogue():
        if message.severity is Severity.ERROR:
            assert message.remedy.en, message


def test_classes_are_explained() -> None:
    """The class numbers of a message are in the tables, or it has none."""
    for message in catalogue():
        assert (message.reaction == 0) == (message.clearing == 0), message
        if message.reaction:
            assert message.reaction in REACTIONS, message
            assert message.clearing in CLEARINGS, message
            assert message.severity >= Severity.WARNING, message


def test_class_tables_have_both_languages() -> None:
    """The meanings of the classes are there in English and German."""
    for text in (*REACTIONS.values(), *CLEARINGS.values()):
        assert isinstance(text, Text)
        assert text.en
        assert text.de


def test_texts_of_the_controllers_numbers_are_unique() -> None:
    """Two messages with a number of the controller never have the same text."""
    messages = [message for message in catalogue() if not is_own(message.id)]
    texts = Counter(text for one in messages for text in {one.text.en, one.text.de})
    assert [text for text, count in texts.items() if count > 1] == []


def test_the_next_number_is_free() -> None:
    """A new message gets a number of nctakt's own above all others, never one that was given up."""
    number = next_free_number()
    assert is_own(number)
    others = [other for message in catalogue() for other in message.numbers]
    assert all(number > other for other in others if is_own(other))


def test_each_message_has_a_number_of_its_own() -> None:
    """RC-801: of several messages with one number of the controller each has one of ours, too."""
    own = Counter(number for one in catalogue() for number in one.numbers if is_own(number))
    assert [number for number, count in own.items() if count > 1] == []
    shared = Counter(one.id for one in catalogue())
    for message in catalogue():
        assert any(map(is_own, message.numbers)) or shared[message.id] == 1, message


def test_numbers_of_a_message_are_reported_once() -> None:
    """What a message is also known as neither leads it nor is reported twice."""
    for message in catalogue():
        assert len(message.known_as) == len(set(message.known_as)), message
        assert set(message.known_as).isdisjoint(message.leading), message


def test_the_controllers_number_leads() -> None:
    """RC-801: both numbers of a message find it, and its finding has the controller's."""
    (label,) = messages_of(900126)
    assert (label.id, label.known_as[0]) == (20840, 900126)
    assert label in messages_of(20840)
    found = diagnostic(label, label="N20", nearest="N10", form="N20:")
    assert (found.id, found.also[0]) == (20840, 900126)


@pytest.mark.parametrize(
    ("own", "values", "number"),
    [
        (900106, {"word": "$ENDWHILE", "begin": "$WHILE"}, 20237),
        (900106, {"word": "#RT ENDWHILE", "begin": "#RT WHILE"}, 900106),
        (900113, {"symbol": "]", "found": "X"}, 20716),
        (900202, {"word": "#XYZ", "nearest": "–"}, 20509),
        (900204, {"word": "M70000"}, 20154),
        (900209, {"word": "F"}, 20175),
        (900209, {"word": "X"}, 20203),
        (900210, {"word": "G18", "other": "G17"}, 20111),
        (900210, {"word": "G91", "other": "G90"}, 20120),
        (900210, {"word": "G108", "other": "G107"}, 900210),
        (900209, {"word": "G90"}, 20120),
        (900204, {"word": "G70000"}, 20107),
        (900204, {"word": "G1.5"}, 20107),
        (900204, {"word": "G777"}, 20131),
        (900213, {"name": "V.P.SUM", "nearest": "–", "declared": "–"}, 20932),
        (900214, {"name": "V.P.SUM", "expected": 0, "given": 1}, 21768),
        (900219, {"word": "SIN", "expected": "1 or 2", "given": 0}, 21471),
        (900305, {"seconds": "-1"}, 20017),
        (900306, {"axis": "X", "position": "11", "low": "0", "high": "10"}, 120002),
        (900306, {"axis": "X", "position": "-1", "low": "0", "high": "10"}, 120003),
        (900835, {"word": "FEED_FACT", "value": -1.0, "low": 0, "high": 200}, 21826),
        (900080, {"key": "var[0].name", "value": "A-B", "limit": 26}, 20788),
        (900080, {"key": "struct[0].element[1].name", "value": "A" * 99, "limit": 26}, 21432),
        (900075, {"low": 5, "high": 5}, 110110),
        (900075, {"low": 6, "high": 5}, 900075),
        (21241, {"operation": "SQRT"}, 20398),
        (21241, {"operation": "LOG"}, 20399),
        (21241, {"operation": "ASIN"}, 21241),
        (50929, {"variable": "V.E.FIELD", "index": "9", "count": 3}, 50895),
        (50929, {"variable": "V.CH.FIELD", "index": "9", "count": 3}, 50929),
    ],
)
def test_the_case_gives_the_number(own: int, values: dict[str, object], number: int) -> None:
    """Where the controller has a number for each case, the values of the finding say which."""
    found = diagnostic(messages_of(own)[0], **values)
    assert found.id == number
    assert number in found.message.leading
    assert number not in found.also


def test_numbers_with_two_readings_name_both() -> None:
    """errors.md: 50939 and 51028 stay; ``explain`` names the others with the same number."""
    time_limit = messages_of(50939)[0]
    assert time_limit.known_as == (50930,)
    assert "M" in time_limit.cause.en
    assert "50939" in time_limit.cause.en
    assert "51028" in messages_of(51028)[0].cause.en


#: A first word that is written as in a program, a list or on the command line.
CODE = re.compile(r"[^\w]|[\d_]|^nctakt$|^moduloo$")


def test_remedies_are_sentences() -> None:
    """A remedy begins with a capital letter, unless with code, and ends as a sentence does.

    After a colon there may be names at its end, which a full stop would blur.
    """
    for text in [text for one in catalogue() for text in (one.remedy.en, one.remedy.de)]:
        if not text:
            continue
        first, last = text.split()[0].rstrip(":,;"), text.split()[-1]
        assert not text[0].islower() or CODE.search(first), text
        is_prose = last.isalpha() and not last.isupper() and len(last) > 1
        assert not is_prose, text
