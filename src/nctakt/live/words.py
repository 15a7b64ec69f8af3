# SPDX-License-Identifier: MIT
"""Completion and explanations in the page's editor: the answers of the language server.

In: the lines of a program, a place as browsers count it. Out: plain values for the browser. The
functions are those of ``nctakt lsp``; of its libraries only lsprotocol is needed, whose types they
take and return.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.run.realtime.assembly import AssembledMachine

#: Signs of Markdown that are no words.
_MARKS = re.compile(r"\*\*|^- |```\w*", re.MULTILINE)

#: Elements of explanations beyond plain Markdown.
_EXTRAS = ["cuddled-lists", "code-friendly", "fenced-code-blocks"]


@dataclass(frozen=True, slots=True)
class TextCursor:
    """Where the cursor or the pointer is: a line, from 1, a column in units of UTF-16, from 0."""

    file: str
    lines: Sequence[str]
    line: int
    column: int


def completed(
    cursor: TextCursor, machine: AssembledMachine, language: Language
) -> list[dict[str, Any]]:
    """Return completions at a place, the best first.

    ``start``: the column from which ``text`` replaces the written text. ``hasGaps``: the text has
    gaps, as snippets of editors have them.
    """
    from lsprotocol import types  # noqa: PLC0415 - when it is asked for

    from nctakt.editor.completing.completion import complete  # noqa: PLC0415 - as above

    document, position = _document_and_position(cursor)
    found = []
    for item in complete(document, position, machine, language, has_snippets=True):
        assert isinstance(item.text_edit, types.TextEdit)
        kind = "" if item.kind is None else types.CompletionItemKind(item.kind).name
        found.append(
            {
                "label": item.label,
                "detail": item.detail or "",
                "kind": kind.casefold(),
                "text": item.text_edit.new_text,
                "start": item.text_edit.range.start.character,
                "hasGaps": item.insert_text_format == types.InsertTextFormat.Snippet,
            }
        )
    return found


def explained_word(
    cursor: TextCursor,
    machine: AssembledMachine,
    findings: Sequence[Diagnostic],
    language: Language,
) -> dict[str, Any] | None:
    """Return the explanation of the word at a place, as HTML and as text, and its columns."""
    from lsprotocol.types import MarkupContent  # noqa: PLC0415 - when it is asked for

    from nctakt.editor.display.hover import hover  # noqa: PLC0415 - as above

    document, position = _document_and_position(cursor)
    found = hover(document, position, machine, findings, language)
    if found is None or found.range is None:
        return None
    assert isinstance(found.contents, MarkupContent)
    html, text = as_html(found.contents.value)
    return {
        "html": html,
        "text": text,
        "from": found.range.start.character,
        "to": found.range.end.character,
    }


def as_html(text: str) -> tuple[str, str]:
    """Return an explanation in Markdown as HTML, and as plain text."""
    from markdown2 import markdown  # noqa: PLC0415 - when it is asked for

    html = str(markdown(text, safe_mode="escape", extras=_EXTRAS))
    return html, _MARKS.sub("", text)


def _document_and_position(cursor: TextCursor) -> tuple[Any, Any]:
    """Return a place as the language server has it: an open document, a position in it."""
    from lsprotocol.types import Position  # noqa: PLC0415 - when it is asked for

    from nctakt.editor.document import Document, uri_of  # noqa: PLC0415 - as above

    path = Path(cursor.file).absolute()
    lines = cursor.lines if isinstance(cursor.lines, list) else list(cursor.lines)
    document = Document(uri_of(path), path, path.as_posix(), "nctakt", 0, lines)
    return document, Position(cursor.line - 1, cursor.column)


def line_found(lines: Sequence[str], request: str, after: int) -> int:
    """Return the line that a person looks for: by its number, or the next one with a text.

    The search begins after line ``after`` and wraps around; 0 if there is none.
    """
    if request.isascii() and request.isdigit():
        return int(request) if 1 <= int(request) <= len(lines) else 0
    sought = request.casefold()
    count = len(lines)
    for distance in range(count):
        number = (after + distance) % count
        if sought in lines[number].casefold():
            return number + 1
    return 0
