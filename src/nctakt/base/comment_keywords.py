# SPDX-License-Identifier: MIT
"""The keywords in comments that turn an NC program into a test, and their misspellings.

A misspelt keyword (``; expct: M100``) is a mistake, not a comment: else the test would pass without
a check. The module imports next to nothing, so that the pytest plugin can search files without
loading nctakt.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from nctakt.base.misspelling import KnownNames

KEYWORDS = ("expect", "given")

_KNOWN = KnownNames(KEYWORDS)

_HEAD = re.compile(r";\s*(?P<word>[^\W\d_]{4,9})\s*:", re.ASCII)


def keyword_near(word: str) -> str:
    """Return the keyword that a word is or misspells; empty for any other word."""
    return _KNOWN.nearest(word) or ""


def heads(line: str) -> Iterator[re.Match[str]]:
    """Yield each word between ``;`` and ``:`` that may be meant as a keyword."""
    return (match for match in _HEAD.finditer(line) if keyword_near(match["word"]))


def has_expectation(text: str) -> bool:
    """Return whether a text has a comment with ``expect``, perhaps misspelt."""
    return any(keyword_near(match["word"]) == "expect" for match in heads(text))
