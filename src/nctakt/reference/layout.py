# SPDX-License-Identifier: MIT
"""Articles -> lines of plain text, the same on a terminal and in a pipe."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence

from nctakt.base.diagnostics import Language, Text
from nctakt.reference.article import Article, Topic

WIDTH = 100
_MARGIN = "  "

_HEAD = Text("nctakt explain WORD … explains:", "nctakt explain WORT … erklärt:")
_FOOT = Text(
    "The word at the start of a line lists them all: nctakt explain messages",
    "Das Wort am Anfang einer Zeile listet alle auf: nctakt explain messages",
)
_SUCH_AS = Text("such as", "etwa")


def article_lines(article: Article, language: Language) -> Iterator[str]:
    """Yield an article: its name and kind, its meaning, its facts in two columns."""
    yield f"{article.title(language)}: {article.kind.get(language)}"
    yield from _wrapped(article.meaning.get(language), _MARGIN, _MARGIN)
    labels = [fact.label.get(language) for fact in article.facts]
    width = max(map(len, labels), default=0)
    for label, fact in zip(labels, article.facts, strict=True):
        first = f"{_MARGIN}{_MARGIN}{label.ljust(width)}  "
        yield from _wrapped(fact.value.get(language), first, " " * len(first))


def _wrapped(text: str, first: str, further: str) -> list[str]:
    lines: list[str] = []
    for part in text.split("\n"):
        lead = further if lines else first
        lines += textwrap.wrap(
            part,
            WIDTH,
            initial_indent=lead,
            subsequent_indent=further,
            break_long_words=False,
            break_on_hyphens=False,
        ) or [lead.rstrip()]
    return lines


def list_lines(articles: Sequence[Article], language: Language) -> Iterator[str]:
    """Yield one line for each article: its name and its meaning."""
    width = max(len(article.title(language)) for article in articles)
    for article in articles:
        title = article.title(language).ljust(width)
        yield f"{title}  {_one_line(article.meaning.get(language))}"


def _one_line(text: str) -> str:
    return " ".join(text.split())


def topic_lines(topics: Sequence[Topic], language: Language) -> Iterator[str]:
    """Yield the topics with examples of their words."""
    yield _HEAD.get(language)
    word_width = max(len(topic.word) for topic in topics)
    width = max(len(topic.title.get(language)) for topic in topics)
    for topic in topics:
        title = topic.title.get(language).ljust(width)
        examples = ", ".join(topic.examples)
        such_as = _SUCH_AS.get(language)
        yield f"{_MARGIN}{topic.word.ljust(word_width)}  {title}  {such_as} {examples}"
    yield _FOOT.get(language)
