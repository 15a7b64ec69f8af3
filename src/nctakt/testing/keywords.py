# SPDX-License-Identifier: MIT
"""The keywords of comments that make an NC program a test, and words that are nearly one.

A misspelt keyword (``; expct: M100``) is a mistake, not a comment: else the test would pass without
a check. The module needs nothing of nctakt, so that the plugin can look at files without loading
it.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterator

KEYWORDS = ("expect", "given")

#: How similar a word is to a keyword that it is taken for: one or two letters differ.
_SIMILARITY = 0.8

_HEAD = re.compile(r";\s*(?P<word>[^\W\d_]{4,9})\s*:", re.ASCII)


def keyword_near(word: str) -> str:
    """Return the keyword that a word is, or nearly is; empty if it is none."""
    near = difflib.get_close_matches(word.lower(), KEYWORDS, n=1, cutoff=_SIMILARITY)
    return near[0] if near else ""


def heads(line: str) -> Iterator[re.Match[str]]:
    """Return each word between ``;`` and ``:`` that may be meant as a keyword."""
    return (match for match in _HEAD.finditer(line) if keyword_near(match["word"]))


def has_expectation(text: str) -> bool:
    """Return whether a text has a comment with ``expect``, perhaps misspelt."""
    return any(keyword_near(match["word"]) == "expect" for match in heads(text))
