# SPDX-License-Identifier: MIT
"""The parts of a Structured Text that have their own colours, by spelling.

In: a text. Out: comments, pragmas, strings, numbers and words, each with its kind; further meanings
of words are up to the checker.
"""

from __future__ import annotations

import re

from nctakt.st.parse.lexer import KEYWORDS
from nctakt.st.vocabulary.elementary import ELEMENTARY
from nctakt.st.vocabulary.functions import BUILT_INS, conversion

#: A part with a colour; its group is ``comment``, ``macro``, ``string``, ``number`` or ``word``.
TOKEN = re.compile(
    r"(?P<comment>//[^\n]*|\(\*.*?\*\)|/\*.*?\*/)|(?P<macro>\{[^}]*\})"
    r"|(?P<string>'(?:[^'$\n]|\$.)*'|\"(?:[^\"$\n]|\$.)*\")"
    r"|(?P<number>\b(?:[^\W\d]\w*)?\d*\#[\w.:#-]+|\b\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][-+]?\d+)?\b)"
    r"|(?P<word>[^\W\d]\w*)",
    re.DOTALL,
)
#: Words that are keywords in this position, and names elsewhere.
_SOFT = frozenset(
    """METHOD PROPERTY ACTION GET SET EXTENDS IMPLEMENTS ABSTRACT FINAL PUBLIC PRIVATE PROTECTED
    INTERNAL CONSTANT RETAIN PERSISTENT AT ARRAY POINTER REFERENCE STRING WSTRING""".split()
)


def kind_of_word(word: str) -> str:
    """Return ``keyword``, ``type``, ``function``, or "" for a name of somebody."""
    upper = word.upper()
    if upper in KEYWORDS or upper in _SOFT:
        return "keyword"
    if upper in ELEMENTARY:
        return "type"
    return "function" if upper in BUILT_INS or conversion(upper) is not None else ""
