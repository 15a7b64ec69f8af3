# SPDX-License-Identifier: MIT
"""The requests of an editor about documents in Structured Text.

In: a document and a request. Out: answers of the other modules, about the present text in the
editor: a change that has not been checked yet is checked first.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence

from lsprotocol import types

from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.editor.document import Document
from nctakt.editor.structured_text import navigation
from nctakt.editor.structured_text.colours import semantic_tokens
from nctakt.editor.structured_text.completion import complete
from nctakt.editor.structured_text.folding import folding_ranges
from nctakt.editor.structured_text.formatting import format_edits
from nctakt.editor.structured_text.plc_projects import PlcProjects
from nctakt.editor.structured_text.positions import range_of
from nctakt.editor.structured_text.project_names import ProjectNames
from nctakt.editor.structured_text.remedies import structured_actions
from nctakt.editor.structured_text.renaming import (
    PathPart,
    Programs,
    check_fixed,
    rename,
    rename_part,
)
from nctakt.editor.structured_text.signatures import signature_help


class StructuredAnswers:
    """Answers about the documents of some projects."""

    def __init__(self, projects: PlcProjects) -> None:
        self._projects = projects
        self._known: ProjectNames | None = None

    @contextlib.contextmanager
    def _names(self, document: Document) -> Iterator[ProjectNames]:
        """Hold the names of a document's project."""
        project = self._projects.of(document)
        with project.lock:
            checker = project.update()
            known = self._known
            if known is None or known.checker is not checker:
                known = self._known = ProjectNames(project)
            yield known

    def hover(
        self, document: Document, position: types.Position, language: Language
    ) -> types.Hover | None:
        """Explain the name at a position."""
        with self._names(document) as names:
            return navigation.hover(names, document, position, language)

    def complete(self, document: Document, position: types.Position) -> list[types.CompletionItem]:
        """Return the completions at a position."""
        with self._names(document) as names:
            return complete(names, document, position)

    def signature(self, document: Document, position: types.Position) -> types.SignatureHelp | None:
        """Return the parameters of the open call."""
        with self._names(document) as names:
            return signature_help(names, document, position)

    def definition(self, document: Document, position: types.Position) -> list[types.Location]:
        """Return where a name is declared."""
        with self._names(document) as names:
            return navigation.definition(names, document, position)

    def references(
        self, document: Document, position: types.Position, *, with_definition: bool
    ) -> list[types.Location]:
        """Return where a name is used."""
        with self._names(document) as names:
            return navigation.references(names, document, position, with_definition=with_definition)

    def highlights(self, document: Document, position: types.Position) -> list[types.Range]:
        """Return where the document has a name."""
        with self._names(document) as names:
            return navigation.highlights(names, document, position)

    def renamed_range(self, document: Document, position: types.Position) -> types.Range | None:
        """Return the name that would change; raises ``Failure`` if it must not."""
        with self._names(document) as names:
            found = names.at(document, position)
            if found is None:
                return None
            check_fixed(names, found, names.all_of(found.target, found.name))
            return range_of(document, names.project.sources, found.start, found.end)

    def rename(
        self, document: Document, position: types.Position, new: str, programs: Programs
    ) -> types.WorkspaceEdit | None:
        """Return the edits for another name; raises ``Failure``."""
        with self._names(document) as names:
            return rename(names, document, position, new, programs)

    def rename_from_program(
        self, program: Document, part: PathPart, new: str, programs: Programs
    ) -> types.WorkspaceEdit | None:
        """Return the edits for renaming a variable named in a comment of a program.

        ``None`` where no PLC of the program has it; raises ``Failure``.
        """
        for document in self._projects.of_program(program):
            with self._names(document) as names:
                edit = rename_part(names, document, part, new, programs)
            if edit is not None:
                return edit
        return None

    def symbols(self, document: Document) -> list[types.DocumentSymbol]:
        """Return the outline."""
        with self._names(document) as names:
            file = names.project.file_named(document.name)
            return [] if file is None else navigation.Outline(names, document, file).symbols()

    def folds(self, document: Document) -> list[types.FoldingRange]:
        """Return the folding ranges."""
        return folding_ranges(document)

    def tokens(self, document: Document, first: int, last: int) -> list[int]:
        """Return the semantic tokens of lines."""
        with self._names(document) as names:
            file = names.project.file_named(document.name)
            return [] if file is None else semantic_tokens(names, document, file, first, last)

    def format(self, document: Document, first: int, last: int) -> list[types.TextEdit]:
        """Return the edits that give lines their form."""
        with self._names(document) as names:
            file = names.project.file_named(document.name)
            return [] if file is None else format_edits(document, file, first, last)

    def actions(
        self,
        document: Document,
        found: Sequence[tuple[Diagnostic, types.Diagnostic]],
        language: Language,
    ) -> list[types.CodeAction]:
        """Return the edits that remedy findings of a document."""
        with self._names(document) as names:
            return structured_actions(names, document, found, language)
