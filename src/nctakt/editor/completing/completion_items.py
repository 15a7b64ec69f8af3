# SPDX-License-Identifier: MIT
"""The cursor of a completion, and the items that it makes: they replace the written part."""

from __future__ import annotations

from lsprotocol.types import (
    CompletionItem,
    CompletionItemKind,
    InsertTextFormat,
    InsertTextMode,
    TextEdit,
)

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.editor.completing.surroundings import Surroundings
from nctakt.editor.document import Document
from nctakt.run.realtime.assembly import AssembledMachine


@dataclass(frozen=True, slots=True)
class Cursor:
    """The cursor: its document, machine, line, text before it in the line, its surroundings.

    ``has_snippets``: the editor can fill in the gaps of an item's text.
    """

    document: Document
    machine: AssembledMachine
    line: int
    before: str
    around: Surroundings
    language: Language
    has_snippets: bool

    def item(
        self,
        label: str,
        kind: CompletionItemKind,
        written: int,
        detail: str = "",
        text: str | None = None,
    ) -> CompletionItem:
        """Return an item in place of the last ``written`` characters."""
        end = len(self.before)
        area = self.document.range(self.line, end - written, end)
        edit = TextEdit(area, label if text is None else text)
        return CompletionItem(
            label, kind=kind, detail=detail or None, text_edit=edit, filter_text=label
        )

    def snippet(self, label: str, written: int, detail: str, text: str) -> CompletionItem:
        """Return an item of several lines with gaps; typing its first line selects it.

        Only for editors that know gaps.
        """
        item = self.item(label, CompletionItemKind.Snippet, written, detail, text)
        item.insert_text_format = InsertTextFormat.Snippet
        item.insert_text_mode = InsertTextMode.AdjustIndentation
        return item
