# SPDX-License-Identifier: MIT
"""An article about one word of the controller.

In: the tables of messages, parameters, variables and language. Out: ``Article``, without layout.
The functions below turn it into lines of plain text, the same on a terminal and in a pipe,
``scripts/docs`` into tables.
"""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Text


@dataclass(frozen=True, slots=True)
class Fact:
    """A fact of an article: its label and its value."""

    label: Text
    value: Text


@dataclass(frozen=True, slots=True)
class Article:
    """An article: the word in its full form, its kind, its meaning in one sentence, its facts.

    ``german``: the word in German if it differs, else empty.
    """

    name: str
    kind: Text
    meaning: Text
    facts: tuple[Fact, ...] = ()
    german: str = ""

    def title(self, language: Language) -> str:
        """Return the word in a language."""
        return Text(self.name, self.german or self.name).get(language)


@dataclass(frozen=True, slots=True)
class Topic:
    """A kind of articles.

    ``word`` names it on the command line. ``articles`` returns all of them in order, ``find`` those
    of a word in any usual spelling, ``names`` the words for a comparison with a misspelt one,
    ``find_similar`` the articles that a word may mean if no topic has it.
    """

    word: str
    title: Text
    examples: tuple[str, ...]
    articles: Callable[[], Iterator[Article]]
    find: Callable[[str], tuple[Article, ...]]
    names: Callable[[], Iterator[str]]
    find_similar: Callable[[str], tuple[Article, ...]] = lambda word: ()


def same(text: object) -> Text:
    """Return a text that is the same in all languages."""
    return Text(str(text), str(text))


def fact(en: str, de: str, value: Text | str | int) -> Fact:
    """Return a fact with its label in both languages."""
    return Fact(Text(en, de), value if isinstance(value, Text) else same(value))


# --- as text --------------------------------------------------------------------------------------


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
