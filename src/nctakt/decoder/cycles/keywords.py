# SPDX-License-Identifier: MIT
"""The keywords of a definition of a realtime cycle, by name."""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.nc import tree


def keyword_of(
    keywords: Sequence[tree.Keyword | tree.Expression], name: str
) -> tree.Keyword | None:
    """Return the keyword of this name, ``None`` without one."""
    for keyword in keywords:
        if isinstance(keyword, tree.Keyword) and keyword.name == name:
            return keyword
    return None


def word_of(keyword: tree.Keyword) -> str:
    """Return the word that a keyword has as its value."""
    assert isinstance(keyword.value, tree.Name)
    return keyword.value.name
