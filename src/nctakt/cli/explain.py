# SPDX-License-Identifier: MIT
"""``nctakt explain``: the meaning of messages, parameters, variables and words of the language.

In: words. Out: their articles on standard output, from the tables that the controller itself uses.
A word without an article is searched in all texts; an unknown one is reported with the nearest
known one (900570, 900571): exit code 2.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import click

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_RAN, EXIT_USAGE
from nctakt.cli.common.help import described, option
from nctakt.cli.common.options import FORMAT_OPTION, language_option
from nctakt.cli.common.terminal import print_diagnostics, show_at_the_end
from nctakt.cli.findings.formats import diagnostics_as_json
from nctakt.cli.findings.json_documents import as_json, plain
from nctakt.hli.table import find
from nctakt.messages import diagnostic
from nctakt.messages.commands.explaining import MISSPELLED_TOPIC, UNKNOWN_TOPIC
from nctakt.reference.article import Article, article_lines, list_lines, topic_lines
from nctakt.reference.concepts import SMALL_WORDS, find_concepts, is_subject
from nctakt.reference.elements import is_path
from nctakt.reference.topics import (
    TOPICS,
    answer_question,
    explain,
    is_question,
    nearest_word,
    search,
    topic,
)

#: The form of a variable of a machine's lists.
_MACHINE_VARIABLE = re.compile(r"Vs?\.(E|CH)\b", re.IGNORECASE)

#: Minimum length of a word that is searched in texts, in characters.
_SHORTEST_SEARCHED = 3
#: Maximum number of listed articles that contain a word.
_MAX_FOUND = 30
#: Maximum number of articles that answer a question.
_MAX_ANSWERS = 3

_FOUND = Text("'{word}' appears in {count} articles:", "'{word}' steht in {count} Artikeln:")
_FOUND_ONE = Text("'{word}' appears in one article:", "'{word}' steht in einem Artikel:")
_FURTHER = Text("… {count} more", "… {count} weitere")


@described(
    "explain",
    summary=Text("Explain a message, parameter or word.", "Meldung, Parameter oder Wort erklären."),
    text=Text(
        "Explain messages, parameters of lists, variables and words of NC programs. A word without "
        "an article is searched in the texts of all articles.",
        "Meldungen, Parameter der Listen, Variablen und Wörter von NC-Programmen erklären. Ein "
        "Wort ohne Artikel wird in den Texten aller Artikel gesucht.",
    ),
    codes=(Text("all words are known", "alle Wörter sind bekannt"), None),
    notes=Text(
        "Words with # or $ need quotation marks, so that the shell leaves them alone. Without a "
        "word the topics are listed; the name of a topic lists all its words.",
        "Wörter mit # oder $ brauchen Anführungszeichen, damit die Shell sie in Ruhe lässt. Ohne "
        "Wort werden die Themen genannt; der Name eines Themas nennt alle seine Wörter.",
    ),
    examples=(
        "nctakt explain 22009",
        "nctakt explain P-CHAN-00425 V.RTA.ACS.ACT_POS.X RC-105 hli_axis.command",
        'nctakt explain "gpCh[0]^.bahn_state.program_end_r" backward_motion',
        "nctakt explain V.E.DOOR --machine mymachine",
        "nctakt explain expect",
        "nctakt explain why does my program wait",
        'nctakt explain "cannot be written"',
        'nctakt explain "#RT CYCLE" ONCE --lang de',
    ),
)
@click.argument("words", metavar="[WORD]...", nargs=-1)
@option(
    "--machine",
    metavar="FOLDER",
    text=Text(
        "The machine with V.E and V.CH variables [default: demo].",
        "Die Maschine mit V.E- und V.CH-Variablen [Vorgabe: demo].",
    ),
)
@FORMAT_OPTION
@language_option()
def command(words: tuple[str, ...], machine: str | None, form: str, language: Language) -> int:
    """Explain words."""
    try:
        return _explain(words, machine, form, language)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE


def _explain(words: Sequence[str], machine: str | None, form: str, language: Language) -> int:
    """Show the articles; raises ``Failure`` for an invalid machine."""
    if not words and form == "text":
        _show([*topic_lines(TOPICS, language)])
        return EXIT_RAN
    answers = [_answer(word, machine, language) for word in dict.fromkeys(_phrases(words))]
    if is_question(words) and any(not answer.articles for answer in answers):
        found = answer_question(" ".join(words), language)
        if found:
            answers = [_Answer(" ".join(words), tuple(found[:_MAX_ANSWERS]))]
        else:
            asked = [one for one in answers if one.word.casefold() not in SMALL_WORDS]
            answers = [one for one in asked if one.articles] or asked or answers
    unknown = [message for answer in answers for message in answer.unknown]
    if form == "json":
        _show([as_json(_document(answers, unknown, language)).rstrip()])
        return EXIT_USAGE if unknown else EXIT_RAN
    paragraphs: list[list[str]] = []
    for answer in answers:
        lines = list(_lines(answer, language))
        if lines and lines not in paragraphs:
            paragraphs.append(lines)
    _show([line for lines in paragraphs for line in (*lines, "")][:-1])
    print_diagnostics(unknown, language)
    return EXIT_USAGE if unknown else EXIT_RAN


@dataclass(frozen=True, slots=True)
class _Answer:
    """The answer for a word: its articles, all of a topic, articles that contain it."""

    word: str
    articles: tuple[Article, ...] = ()
    listed: tuple[Article, ...] = ()
    containing: tuple[Article, ...] = ()
    unknown: tuple[Diagnostic, ...] = ()


def _answer(word: str, machine: str | None, language: Language) -> _Answer:
    """Return the answer for a word; raises ``Failure`` for an invalid machine."""
    named_topic = topic(word)
    listed = () if named_topic is None else tuple(named_topic.articles())
    articles = explain(word)
    if _MACHINE_VARIABLE.match(word):
        from nctakt.reference.machine_variables import MachineVariables  # noqa: PLC0415 - as above

        variables = MachineVariables(machine)
        own = variables.find(word)
        if articles and articles[0].name == word.upper().replace("VS.", "V."):
            return _Answer(word, articles, tuple(own))
        return _Answer(word, (*own, *articles), unknown=() if own else variables.unknown(word))
    if articles or listed:
        return _Answer(word, articles, listed)
    if " " in word.strip():
        found = find_concepts(word)
        if found:
            return _Answer(word, found)
    containing = tuple(_containing(word, language)) if len(word) >= _SHORTEST_SEARCHED else ()
    return _Answer(word, containing=containing, unknown=() if containing else (_unknown(word),))


def _containing(word: str, language: Language) -> list[Article]:
    """Return the articles that contain a word, by their texts in the other language if need be."""
    other: Language = "en" if language == "de" else "de"
    words = " ".join(word.split())
    found = search(words, language) or search(words, other)
    return found or (answer_question(words, language) if " " in words else [])


def _document(
    answers: Sequence[_Answer], unknown: Sequence[Diagnostic], language: Language
) -> dict[str, object]:
    """Return the answers as a JSON document."""
    entries = [
        {
            "word": answer.word,
            "articles": plain([*answer.articles, *answer.listed], language),
            "found_in": [article.name for article in answer.containing],
        }
        for answer in answers
    ]
    return {"words": entries, "diagnostics": diagnostics_as_json(unknown, "", language)}


def _phrases(words: Sequence[str]) -> Iterator[str]:
    """Yield the words one by one, those of a name together: ``#RT CYCLE``, ``feed hold``."""
    begin = 0
    while begin < len(words):
        end = begin + 1
        is_command = words[begin].startswith("#")
        for longer in range(len(words), end, -1):
            phrase = " ".join(words[begin:longer])
            if is_subject(phrase) or (is_command and _is_name(phrase)):
                end = longer
                break
        yield " ".join(words[begin:end])
        begin = end


def _is_name(phrase: str) -> bool:
    """Return whether words are together the name of a command."""
    folded = phrase.upper()
    return any(article.name.upper() == folded for article in explain(folded))


def _lines(answer: _Answer, language: Language) -> Iterator[str]:
    """Yield the articles of a word, separated by empty lines; nothing for an unknown word."""
    for number, article in enumerate(answer.articles):
        if number:
            yield ""
        yield from article_lines(article, language)
    if answer.listed:
        yield from list_lines(answer.listed, language)
    if answer.containing:
        count = len(answer.containing)
        found = _FOUND if count > 1 else _FOUND_ONE
        yield found.get(language).format(word=answer.word, count=count)
        yield from list_lines(answer.containing[:_MAX_FOUND], language)
        further = count - _MAX_FOUND
        if further > 0:
            yield _FURTHER.get(language).format(count=further)


def _unknown(word: str) -> Diagnostic:
    if is_path(word):
        try:
            find(word)
        except Failure as failure:
            return failure.diagnostics[0]
    near = nearest_word(word)
    if near:
        return diagnostic(MISSPELLED_TOPIC, word=word, nearest=near)
    return diagnostic(UNKNOWN_TOPIC, word=word)


def _show(lines: Sequence[str]) -> None:
    if lines:
        show_at_the_end(lambda file: print(*lines, sep="\n", file=file))
