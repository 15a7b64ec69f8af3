# SPDX-License-Identifier: MIT
"""The topics of the reference, and the search for the articles of a word.

In: a word as a user writes it. Out: the articles of all topics about it, else the nearest known
word.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Language
from nctakt.base.misspelling import nearest
from nctakt.reference.article import Article, Topic
from nctakt.reference.elements import ELEMENTS
from nctakt.reference.interface import HLI
from nctakt.reference.language import EXPRESSIONS, KEYWORDS_TOPIC, WORDS
from nctakt.reference.messages import MESSAGES
from nctakt.reference.parameter_numbers import PARAMETER_NUMBERS
from nctakt.reference.parameters import PARAMETERS
from nctakt.reference.rules import RULES_TOPIC
from nctakt.reference.variables import VARIABLES

#: The topics in the order of their display.
TOPICS: tuple[Topic, ...] = (
    MESSAGES,
    PARAMETERS,
    PARAMETER_NUMBERS,
    VARIABLES,
    WORDS,
    EXPRESSIONS,
    KEYWORDS_TOPIC,
    RULES_TOPIC,
    HLI,
    ELEMENTS,
)


def topic(word: str) -> Topic | None:
    """Return the topic with this name, ``None`` if there is none."""
    return next((candidate for candidate in TOPICS if candidate.word == word.lower()), None)


def articles_about(word: str) -> tuple[Article, ...]:
    """Return all articles about a word, none for an unknown one."""
    word = word.strip()
    return tuple(article for topic in TOPICS for article in topic.find(word)) if word else ()


def explain(word: str) -> tuple[Article, ...]:
    """Return all articles about a word, else those that it may mean; none for an unknown word."""
    word = word.strip()
    return articles_about(word) or tuple(
        article for topic in TOPICS if word for article in topic.find_similar(word)
    )


def nearest_word(word: str) -> str:
    """Return the known word most similar to this one, empty if none is."""
    names = {name for topic in TOPICS for name in topic.names()}
    return nearest(word, sorted(names))


def search(words: str, language: Language) -> list[Article]:
    """Return the articles whose texts contain words; those with them in name or meaning first."""
    phrase = " ".join(words.casefold().split())
    first: list[Article] = []
    others: list[Article] = []
    for article in (article for topic in TOPICS for article in topic.articles()):
        if phrase in _folded(article.name, article.meaning.get(language)):
            first.append(article)
        elif phrase in _folded(*(fact.value.get(language) for fact in article.facts)):
            others.append(article)
    return [*first, *others]


def _folded(*texts: str) -> str:
    return " ".join(" ".join(texts).casefold().split())
