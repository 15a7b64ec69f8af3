# SPDX-License-Identifier: MIT
"""The topics of the reference, and the search for the articles of a word.

In: a word as a user writes it. Out: the articles of all topics about it, else the nearest known
word.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache

from nctakt.base.diagnostics import Language
from nctakt.base.misspelling import nearest
from nctakt.reference.article import Article, Topic
from nctakt.reference.concepts import CONCEPTS, SMALL_WORDS, find_concepts
from nctakt.reference.elements import ELEMENTS
from nctakt.reference.interface import HLI
from nctakt.reference.language import EXPRESSIONS, KEYWORDS_TOPIC, WORDS
from nctakt.reference.messages import MESSAGES
from nctakt.reference.parameters import PARAMETER_NUMBERS, PARAMETERS
from nctakt.reference.rules import RULES_TOPIC
from nctakt.reference.variables import VARIABLES

#: The topics in the order of their display.
TOPICS: tuple[Topic, ...] = (
    WORDS,
    KEYWORDS_TOPIC,
    EXPRESSIONS,
    CONCEPTS,
    VARIABLES,
    HLI,
    ELEMENTS,
    RULES_TOPIC,
    PARAMETERS,
    PARAMETER_NUMBERS,
    MESSAGES,
)

#: Spellings by which a misspelt word is known to belong to some topics only.
_FAMILIES = (
    (re.compile(r"\d+"), (MESSAGES,)),
    (re.compile(r"P-[A-Z]+-\d*", re.IGNORECASE), (PARAMETERS, PARAMETER_NUMBERS)),
    (re.compile(r"(RC|ST)-\d*", re.IGNORECASE), (RULES_TOPIC,)),
    (re.compile(r"Vs?\..*", re.IGNORECASE), (VARIABLES, WORDS)),
    (re.compile(r"#.*|\$.*|[GMH]\d+", re.IGNORECASE), (WORDS, KEYWORDS_TOPIC)),
    (re.compile(r".*[\^\[].*"), (ELEMENTS, HLI)),
)
_WORD = re.compile(r"\w+")


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
    """Return the known word most similar to this one, empty if none is.

    A word that has the form of a message's number, a parameter, a variable … is similar to one of
    these only.
    """
    family = next((topics for spelt, topics in _FAMILIES if spelt.fullmatch(word)), TOPICS)
    names = {name for topic in family for name in topic.names()}
    return nearest(word, sorted(names))


def search(words: str, language: Language) -> list[Article]:
    """Return the articles whose texts contain words.

    First those that have them as whole words, in name or meaning before other facts; within these
    in the order of the topics.
    """
    phrase = " ".join(words.casefold().split())
    whole = re.compile(rf"(?<!\w){re.escape(phrase)}(?!\w)")
    found: tuple[list[Article], ...] = ([], [], [], [])
    for article, head, facts in _texts(language):
        if phrase in head:
            found[0 if whole.search(head) else 2].append(article)
        elif phrase in facts:
            found[1 if whole.search(facts) else 3].append(article)
    return [article for articles in found for article in articles]


def is_question(words: Sequence[str]) -> bool:
    """Return whether words are a question, with one that says nothing about its subject."""
    return len(words) > 1 and any(word.casefold() in SMALL_WORDS for word in words)


def answer_question(words: str, language: Language) -> list[Article]:
    """Return the articles for a question: of the subjects that it names, else of its words.

    Without a subject these are the articles whose texts have all of its words that say something.
    """
    concepts = find_concepts(words)
    if concepts:
        return list(concepts)
    asked = [word for word in _WORD.findall(words.casefold()) if word not in SMALL_WORDS]
    if not asked:
        return []
    lists = [search(word, language) for word in asked]
    names = [{article.name for article in one} for one in lists]
    return [article for article in lists[0] if all(article.name in one for one in names)]


@cache
def _texts(language: Language) -> tuple[tuple[Article, str, str], ...]:
    """Return all articles, each with its name and meaning, and its facts, as they are searched."""
    return tuple(
        (
            article,
            _folded(article.name, article.meaning.get(language)),
            _folded(*(fact.value.get(language) for fact in article.facts)),
        )
        for topic in TOPICS
        for article in topic.articles()
    )


def _folded(*texts: str) -> str:
    return " ".join(" ".join(texts).casefold().split())
