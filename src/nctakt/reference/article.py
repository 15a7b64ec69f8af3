# SPDX-License-Identifier: MIT
"""An article: what there is to say about one word of the controller.

In: the tables of messages, parameters, variables and language. Out: ``Article``, without layout:
``layout.py`` makes lines of it, ``scripts/docs`` tables.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text


@dataclass(frozen=True, slots=True)
class Fact:
    """A label and what stands behind it."""

    label: Text
    value: Text


@dataclass(frozen=True, slots=True)
class Article:
    """``name`` is the word in its full form, ``kind`` what it is, ``meaning`` one sentence."""

    name: str
    kind: Text
    meaning: Text
    facts: tuple[Fact, ...] = ()


@dataclass(frozen=True, slots=True)
class Topic:
    """A kind of articles.

    ``word`` names it on the command line, ``articles`` gives all of them in order, ``find`` those
    of a word in any usual spelling, ``names`` the words that a misspelt one is compared with.
    ``find_similar``: those that a word may mean if no topic knows it.
    """

    word: str
    title: Text
    examples: tuple[str, ...]
    articles: Callable[[], Iterator[Article]]
    find: Callable[[str], tuple[Article, ...]]
    names: Callable[[], Iterator[str]]
    find_similar: Callable[[str], tuple[Article, ...]] = lambda word: ()


def same(text: object) -> Text:
    """A text that is the same in all languages."""
    return Text(str(text), str(text))


def fact(en: str, de: str, value: Text | str | int) -> Fact:
    """A fact with its label in both languages."""
    return Fact(Text(en, de), value if isinstance(value, Text) else same(value))
