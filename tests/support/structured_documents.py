# SPDX-License-Identifier: MIT
"""Files in Structured Text as an editor has them open."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from lsprotocol.types import Position, TextDocumentContentChangeWholeDocument, TextEdit

from nctakt.editor.document import Document, split_text
from nctakt.editor.structured_text.answers import StructuredAnswers
from nctakt.editor.workspace import Workspace
from nctakt.messages import Collector
from nctakt.st.inspection import inspect_paths


class Typed:
    """Files of a folder, all open, and the project of a language server."""

    def __init__(self, folder: Path, files: dict[str, str]) -> None:
        self.work = Workspace()
        self.documents: dict[str, Document] = {}
        self.folder = folder
        for name, text in files.items():
            path = folder / name
            path.write_text(text, "utf-8")
            document = Document(
                path.as_uri(), path, path.as_posix(), "nctakt-st", 0, split_text(text)
            )
            self.work.open(document)
            self.documents[name] = document
        self.projects = self.work.plc
        self.answers = StructuredAnswers(self.projects)

    def put(self, name: str, text: str) -> None:
        """Give a document another text."""
        document = self.documents[name]
        document.change(TextDocumentContentChangeWholeDocument(text))
        document.version += 1

    def findings(self, name: str) -> list[str]:
        """The findings of the language server."""
        found = self.projects.findings(self.documents[name])
        return [item.headline() for item in found]

    def checked(self) -> dict[str, list[str]]:
        """The findings of a check of all files that restarts, by file."""
        collector = Collector()
        texts = {
            self.folder / name: "\n".join(one.program_lines())
            for name, one in self.documents.items()
        }
        inspect_paths(list(texts), lambda path: texts[path].encode(), collector)
        found = [one for one in collector.diagnostics if one.span is not None]
        found.sort(key=lambda one: (one.span.line, one.span.column, one.id))
        by_file: dict[str, dict[str, None]] = {path.name: {} for path in texts}
        for one in found:
            by_file[Path(one.span.file).name][one.headline()] = None
        return {name: list(items) for name, items in by_file.items()}

    def at(self, name: str, before: str, count: int = 1) -> tuple[Document, Position]:
        """A document, and the position after the first occurrence of a text, or a later one."""
        text = self.documents[name].text()
        index = -1
        for _ in range(count):
            index = text.index(before, index + 1)
        done = text[: index + len(before)]
        return self.documents[name], Position(done.count("\n"), len(done.rpartition("\n")[2]))

    def edited(self, name: str, edits: Sequence[TextEdit]) -> str:
        """The text of a document after edits, which must not overlap."""
        lines = list(self.documents[name].lines)
        for edit in sorted(edits, key=_place, reverse=True):
            start, end = edit.range.start, edit.range.end
            assert start.line == end.line
            line = lines[start.line]
            lines[start.line] = line[: start.character] + edit.new_text + line[end.character :]
        return "\n".join(lines)


def _place(edit: TextEdit) -> tuple[int, int]:
    return edit.range.start.line, edit.range.start.character
