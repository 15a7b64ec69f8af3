# SPDX-License-Identifier: MIT
"""The catalogue of messages: complete in both languages, consistent, each number in use."""

from __future__ import annotations

import ast
import re
from collections import Counter
from pathlib import Path
from string import Formatter

import pytest

import nctakt
from nctakt.base.diagnostics import Message, Severity, Text
from nctakt.messages import CATALOGUE, unreached
from nctakt.messages.classes import CLEARINGS, REACTIONS

SOURCES = Path(nctakt.__file__).parent
#: A text fits on a line of a terminal and of a report.
LONGEST = 110
FIRST_OWN, LAST_OWN = 900_000, 999_999

ALL = pytest.mark.parametrize("message", tuple(CATALOGUE), ids=lambda message: str(message.id))


def fields(text: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(text) if name is not None}


def is_own(message: Message) -> bool:
    return FIRST_OWN <= message.id <= LAST_OWN


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
        other = "_de" if language == "en" else "_en"
        assert used == {name for name in message.parameters if not name.endswith(other)}
    assert not fields(message.cause.en) | fields(message.cause.de)
    assert all(message.parameters.values())


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
    texts = Counter(message.text.en for message in CATALOGUE if not is_own(message))
    texts += Counter(message.text.de for message in CATALOGUE if not is_own(message))
    assert [text for text, count in texts.items() if count > 1] == []


def test_other_numbers_are_no_messages() -> None:
    """RC-801: a number that a message is also known as belongs to it alone."""
    others = [number for message in CATALOGUE for number in message.known_as]
    assert len(others) == len(set(others))
    assert [number for number in others if number in CATALOGUE] == []
    assert CATALOGUE[50939].known_as == (50930,)


def _numbers_in_code() -> set[int]:
    """All numbers of five digits and more that stand in the code, the catalogue left out."""
    found: set[int] = set()
    for file in SOURCES.rglob("*.py"):
        if file.parent.name != "messages":
            text = re.sub(r'""".*?"""|#[^\n]*', "", file.read_text("utf-8"), flags=re.S)
            found.update(int(number) for number in re.findall(r"\b\d{5,7}\b", text))
    return found


def test_each_message_is_in_use() -> None:
    """Each number of the catalogue is reported somewhere, but for those that say why it is not."""
    used = _numbers_in_code()
    silent = {message.id for message in unreached.MESSAGES}
    assert sorted(message.id for message in CATALOGUE if message.id not in used | silent) == []


def test_faults_of_compiled_cycles_are_never_reported() -> None:
    """errors.md: the numbers that the checker makes impossible are reported nowhere."""
    silent = {message.id for message in unreached.MESSAGES}
    assert silent >= set(unreached.CYCLE_FAULTS)
    assert sorted(silent & _numbers_in_code()) == []


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


def test_each_report_gives_what_its_message_tells() -> None:
    """Where number and values stand in one call, they fit: else a mistake would be a traceback."""
    wrong = []
    for path in sorted(SOURCES.rglob("*.py")):
        if SOURCES / "kernel" in path.parents:
            continue  # what the realtime part fails with becomes a diagnostic elsewhere
        for call in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(call, ast.Call) and call.args and isinstance(call.args[0], ast.Constant):
                number = call.args[0].value
                given = {one.arg for one in call.keywords}
                called = getattr(call.func, "attr", getattr(call.func, "id", ""))
                if called in ("report", "fail", "_fail", "_report", "diagnostic", "BlockError"):
                    if number in CATALOGUE and None not in given:
                        if given != CATALOGUE[number].parameters.keys():
                            wrong.append(f"{path.name}:{call.lineno}: {number}")
    assert wrong == []
