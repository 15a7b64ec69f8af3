# SPDX-License-Identifier: MIT
"""A PLC's files: whether they changed since the run began, explanations of them, findings.

In: the texts that the session runs, places in them, texts that are typed. Out: HTML, findings.
Nothing is executed.
The functions are those of ``nctakt lsp``; of its libraries only lsprotocol is needed.
"""

from __future__ import annotations

import threading
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Diagnostic, Language, Severity
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.live.plc_view import WordPlace
from nctakt.live.words import as_html
from nctakt.messages import Collector
from nctakt.st.files.project import read_project
from nctakt.st.files.suffixes import PROJECT_SUFFIXES
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Sources

#: Words of a line that are explained at most.
_MAX_WORDS = 12


#: Files that are looked at, at most.
_MAX_FILES = 5000


class PlcWords:
    """Explains the words of a session's files; ``texts``: their lines by their names."""

    def __init__(self, texts: Mapping[str, Sequence[str]]) -> None:
        self._lines = {_located(file): list(lines) for file, lines in texts.items()}
        self._names = {_located(file).as_posix(): file for file in texts}
        self._documents: dict[str, Any] = {}
        self._answers: Any = None
        self._projects: Any = None
        self._lock = threading.Lock()

    def explained(self, file: str, words: Sequence[WordPlace], language: Language) -> str | None:
        """Return the explanations of words of a file as HTML; ``None`` if there is none."""
        found: dict[str, None] = {}
        with self._lock:
            for word in words[:_MAX_WORDS]:
                text = self._explained(file, word, language)
                if text:
                    found[text] = None
        return as_html("\n\n---\n\n".join(found))[0] if found else None

    def found(self, file: str, lines: Sequence[str]) -> list[Diagnostic]:
        """Return the findings, without notes, for the session's files if one had other lines."""
        with self._lock:
            document = self._document(file)
            found = self._projects.of(document).tried(document.name, lines)
        return [
            replace(one, span=replace(one.span, file=self._names[one.span.file]))
            for one in found
            if one.severity > Severity.NOTE and one.span.file in self._names
        ]

    def _explained(self, file: str, word: WordPlace, language: Language) -> str:
        from lsprotocol.types import MarkupContent, Position  # noqa: PLC0415 - when asked for

        document = self._document(file)
        position = Position(word.line - 1, word.column)
        found = self._answers.hover(document, position, language)
        if found is None:
            return ""
        assert isinstance(found.contents, MarkupContent)
        return found.contents.value

    def _document(self, file: str) -> Any:
        """Return a file as a document that is open, as all files of the session are."""
        from nctakt.editor.document import (  # noqa: PLC0415 - when it is asked for
            STRUCTURED_LANGUAGE,
            Document,
            uri_of,
        )
        from nctakt.editor.structured_text.answers import (  # noqa: PLC0415 - as above
            StructuredAnswers,
        )
        from nctakt.editor.structured_text.plc_projects import (  # noqa: PLC0415 - as above
            PlcProjects,
        )

        if self._answers is None:
            self._projects = PlcProjects(self._documents, self._lines.get)
            self._answers = StructuredAnswers(self._projects)
        path = _located(file)
        uri = uri_of(path)
        if uri not in self._documents:
            lines = self._lines[path]
            name = path.as_posix()
            self._documents[uri] = Document(uri, path, name, STRUCTURED_LANGUAGE, 0, lines)
        return self._documents[uri]


def _located(file: str) -> Path:
    return Path(file).absolute()


class PlcFiles:
    """The files of PLCs with their states when the run began."""

    def __init__(self, plcs: Sequence[Path] = ()) -> None:
        self._plcs = plcs
        self._states: dict[Path, tuple[int, int]] = {}

    def states(self) -> dict[Path, tuple[int, int]]:
        """Return the present state of the files."""
        return {path: _state(path) for path in self._files()[:_MAX_FILES]}

    def note(self, states: dict[Path, tuple[int, int]]) -> None:
        """Note with which files a run has begun."""
        self._states = states

    @property
    def are_replaced(self) -> bool:
        """Whether a file is another than when the run began, or is gone."""
        return any(_state(path) != state for path, state in self._states.items())

    def _files(self) -> list[Path]:
        found: list[Path] = []
        for plc in self._plcs:
            found.append(plc)
            if plc.suffix.lower() in PROJECT_SUFFIXES:
                reporter = Reporter(Sources(), Collector())
                for project in read_project(plc, _bytes, reporter):
                    found += project.files
        return found


def _bytes(path: Path) -> bytes | None:
    try:
        return FileAccess().read_bytes(path)
    except Failure:
        return None


def _state(path: Path) -> tuple[int, int]:
    try:
        state = path.stat()
    except OSError:
        return 0, 0
    return state.st_mtime_ns, state.st_size
