# SPDX-License-Identifier: MIT
"""An article about one word of the controller.

In: the tables of messages, parameters, variables and language. Out: ``Article``, without layout:
``layout.py`` turns it into lines, ``scripts/docs`` into tables.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

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
