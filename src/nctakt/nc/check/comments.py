# SPDX-License-Identifier: MIT
"""Comments that look like inputs or expectations of a test but are not: ``; expct: M100``.

In: lines of a program. Out: diagnostics. The controller ignores comments, so such a mistake changes
no run: it is an error where comments are read, a warning elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from nctakt.base.comment_keywords import heads, keyword_near
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import MISSPELT_KEYWORD


def misspelt_keywords(
    file: str, number: int, line: str, *, is_lenient: bool = False
) -> Iterator[Diagnostic]:
    """Yield 900662 for each word in a line that is nearly ``expect`` or ``given``."""
    for match in heads(line):
        word, keyword = match["word"], keyword_near(match["word"])
        if word.lower() != keyword:
            span = Span(file, number, match.start("word") + 1, match.end("word") + 1)
            found = diagnostic(MISSPELT_KEYWORD, span, line, word=word, keyword=keyword)
            yield replace(found, is_lenient=is_lenient)
