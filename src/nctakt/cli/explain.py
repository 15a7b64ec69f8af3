# SPDX-License-Identifier: MIT
"""``nctakt explain``: what a message, parameter, variable or word of the language means.

In: words. Out: their articles on standard output, from the tables that the controller itself uses.
A word that nobody knows is told with the nearest known one (900570, 900571): exit code 2.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import click

from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.cli import EXIT_RAN, EXIT_USAGE
from nctakt.cli.terminal import print_diagnostics, show_at_the_end
from nctakt.messages import diagnostic
from nctakt.messages.explaining import MISSPELLED_TOPIC, UNKNOWN_TOPIC
from nctakt.reference.layout import article_lines, list_lines, topic_lines
from nctakt.reference.topics import TOPICS, explain, nearest_word, topic

_EPILOG = """\b
Words with # or $ stand in quotation marks, so that the shell leaves them alone.
Without a word the topics are listed; the name of a topic lists all its words.

\b
  nctakt explain 22009
  nctakt explain P-CHAN-00425 V.RTA.ACS.ACT_POS.X
  nctakt explain "#RT CYCLE" ONCE --lang de
"""


@click.command("explain", epilog=_EPILOG, short_help="Explain a message, parameter or word.")
@click.argument("words", metavar="[WORD]...", nargs=-1)
@click.option(
    "--lang",
    "language",
    type=click.Choice(["en", "de"]),
    default="en",
    help="Language of the explanation.",
)
def command(words: tuple[str, ...], language: Language) -> int:
    """Explain messages, parameters of lists, variables and words of NC programs."""
    if not words:
        _show([*topic_lines(TOPICS, language)])
        return EXIT_RAN
    paragraphs: list[list[str]] = []
    unknown: list[Diagnostic] = []
    for word in _phrases(words):
        lines = list(_lines(word, language))
        if not lines:
            unknown.append(_unknown(word))
        elif lines not in paragraphs:
            paragraphs.append(lines)
    _show([line for lines in paragraphs for line in (*lines, "")][:-1])
    print_diagnostics(unknown, language)
    return EXIT_USAGE if unknown else EXIT_RAN


def _phrases(words: Sequence[str]) -> Iterator[str]:
    """The words one by one; several that are the name of a command together: ``#RT CYCLE``."""
    begin = 0
    while begin < len(words):
        end = begin + 1
        for longer in range(len(words), end, -1) if words[begin].startswith("#") else ():
            phrase = " ".join(words[begin:longer]).upper()
            if any(article.name.upper() == phrase for article in explain(phrase)):
                end = longer
                break
        yield " ".join(words[begin:end])
        begin = end


def _lines(word: str, language: Language) -> Iterator[str]:
    """All that is known of a word, an empty line between two articles; nothing of unknown ones."""
    for number, article in enumerate(explain(word)):
        if number:
            yield ""
        yield from article_lines(article, language)
    named = topic(word)
    if named is not None:
        yield from list_lines(list(named.articles()), language)


def _unknown(word: str) -> Diagnostic:
    near = nearest_word(word)
    if near:
        return diagnostic(MISSPELLED_TOPIC, word=word, nearest=near)
    return diagnostic(UNKNOWN_TOPIC, word=word)


def _show(lines: Sequence[str]) -> None:
    if lines:
        show_at_the_end(lambda file: print(*lines, sep="\n", file=file))
