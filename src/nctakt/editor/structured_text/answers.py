# SPDX-License-Identifier: MIT
"""The requests of an editor about documents in Structured Text.

In: a document and a request. Out: answers of the other modules, about the present text in the
editor: a change that has not been checked yet is checked first.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterator, Sequence

from lsprotocol import types
from lsprotocol.types import (
    FoldingRange,
    FoldingRangeKind,
    ParameterInformation,
    Position,
    SignatureHelp,
    SignatureInformation,
)

from nctakt.base.diagnostics import Diagnostic, Language
from nctakt.editor.document import Document
from nctakt.editor.structured_text import navigation
from nctakt.editor.structured_text.colours import semantic_tokens
from nctakt.editor.structured_text.completion import called_unit, complete
from nctakt.editor.structured_text.descriptions import comment_of, parameter_text, signature_of
from nctakt.editor.structured_text.formatting import format_edits
from nctakt.editor.structured_text.plc_projects import PlcProjects
from nctakt.editor.structured_text.positions import position_at, range_of
from nctakt.editor.structured_text.project_names import ProjectNames
from nctakt.editor.structured_text.remedies import structured_actions
from nctakt.editor.structured_text.renaming import (
    PathPart,
    Programs,
    check_fixed,
    rename,
    rename_part,
)
from nctakt.editor.structured_text.surroundings import hidden_parts, masked, surroundings

_WORD = re.compile(
    r"\b(?:END_(?P<end>\w+)|(?P<open>IF|CASE|FOR|WHILE|REPEAT|STRUCT|UNION|VAR(?:_\w+)?"
    r"|FUNCTION_BLOCK|FUNCTION|PROGRAM|INTERFACE|METHOD|PROPERTY|ACTION|TYPE))\b",
    re.IGNORECASE,
)


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


def signature_help(
    names: ProjectNames, document: Document, position: Position
) -> SignatureHelp | None:
    """Return the signature of the innermost open call, with the argument at the position."""
    file = names.project.file_named(document.name)
    spot = None if file is None else position_at(document, position, file)
    if spot is None:
        return None
    piece, offset = spot
    around = surroundings(piece.text, offset, piece.title, is_declaration=piece.is_declaration)
    if not around.callee:
        return None
    called = called_unit(names, around.callee, names.scope_of(around.unit))
    if called is None:
        return None
    sources = names.project.sources
    parameters = [
        ParameterInformation(parameter_text(one), comment_of(sources, one.start) or None)
        for one in called.parameters
    ]
    active = around.argument
    for index, one in enumerate(called.parameters):
        if around.named and one.name.lower() == around.named.lower():
            active = index
    text = comment_of(sources, called.start) or None
    signature = SignatureInformation(
        signature_of(called, called.path), text, parameters, min(active, len(parameters))
    )
    return SignatureHelp([signature], 0, min(active, len(parameters)))


def folding_ranges(document: Document) -> list[FoldingRange]:
    """Return the folding ranges, by line; structures without an end in their file have none."""
    text = document.text()
    return sorted(
        [*_structures(text), *_comments(text)], key=lambda one: (one.start_line, -one.end_line)
    )


def _structures(text: str) -> Iterator[FoldingRange]:
    code = masked(text, " ")
    opened: list[tuple[str, int]] = []
    line = position = 0
    for match in _WORD.finditer(code):
        line += code.count("\n", position, match.start())
        position = match.start()
        if match["open"] is not None:
            word = match["open"].upper()
            opened.append(("VAR" if word.startswith("VAR") else word, line))
            continue
        closed = match["end"].upper()
        known = [index for index, (word, _) in enumerate(opened) if word == closed]
        if known:
            first = opened[known[-1]][1]
            del opened[known[-1] :]
            if line > first:
                yield FoldingRange(first, line)


def _comments(text: str) -> Iterator[FoldingRange]:
    for start, end in hidden_parts(text):
        count = text.count("\n", start, end)
        if count and text.startswith(("(*", "/*"), start):
            first = text.count("\n", 0, start)
            yield FoldingRange(first, first + count, kind=FoldingRangeKind.Comment)
