# SPDX-License-Identifier: MIT
"""From a word to its articles; the topics that there are.

In: a word as a user writes it. Out: the articles of all topics that know it, else the nearest known
word.
"""

from __future__ import annotations

from nctakt.base.text import nearest
from nctakt.reference.article import Article, Topic
from nctakt.reference.language import EXPRESSIONS, KEYWORDS_TOPIC, WORDS
from nctakt.reference.messages import MESSAGES
from nctakt.reference.parameters import PARAMETERS
from nctakt.reference.variables import VARIABLES

#: In the order in which they are shown.
TOPICS: tuple[Topic, ...] = (
    MESSAGES,
    PARAMETERS,
    VARIABLES,
    WORDS,
    EXPRESSIONS,
    KEYWORDS_TOPIC,
)


def topic(word: str) -> Topic | None:
    """The topic that this word names."""
    return next((one for one in TOPICS if one.word == word.lower()), None)


def explain(word: str) -> tuple[Article, ...]:
    """All articles about a word, else those that it may mean; none for one that nobody knows."""
    word = word.strip()
    if not word:
        return ()
    known = tuple(article for one in TOPICS for article in one.find(word))
    return known or tuple(article for one in TOPICS for article in one.find_similar(word))


def nearest_word(word: str) -> str:
    """The known word that is most like this one, empty if none is."""
    known = {name for one in TOPICS for name in one.names()}
    return nearest(word, sorted(known))
