# SPDX-License-Identifier: MIT
"""Documents in Structured Text -> the projects that they belong to.

In: open documents. Out: the project of each: that of the ``.plcproj`` that lists its file, else its
folder's files. A file is left out if it redeclares an object of the document or of an earlier file:
it belongs to another PLC.
"""

from __future__ import annotations

import gc
import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text
from nctakt.editor.document import STRUCTURED_LANGUAGE, Document, uri_of
from nctakt.editor.open_buffers import Buffers, OpenBuffers
from nctakt.editor.structured_text.plc_project import PlcProject, Texts, same_files
from nctakt.messages import Collector
from nctakt.plc.python.stubs import ProjectLibraries, libraries_of
from nctakt.project.project_file import find_project
from nctakt.st.files.project import PlcSources, project_around, read_project
from nctakt.st.files.suffixes import OBJECT_SUFFIXES, PROJECT_SUFFIXES, SOURCE_SUFFIXES
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Sources

#: Maximum number of files of a folder that count as one project.
MAX_FILES = 2000

_OBJECT = re.compile(
    r"^[ \t]*(?:FUNCTION_BLOCK|FUNCTION|PROGRAM|INTERFACE|TYPE)[ \t]+"
    r"(?:(?:ABSTRACT|FINAL|PUBLIC|PRIVATE|INTERNAL|PROTECTED)[ \t]+)*(\w+)",
    re.MULTILINE | re.IGNORECASE,
)
_XML_NAME = re.compile(r"<(?:POU|DUT|GVL|Itf)\b[^>]*?\bName=\"(\w+)\"")


class PlcProjects:
    """The projects of the open documents; those with the same files are one."""

    def __init__(self, documents: Mapping[str, Document], lines_of: Buffers) -> None:
        self._documents = documents
        self._of_document: dict[str, PlcProject] = {}
        self._projects: dict[object, PlcProject] = {}
        self._access = OpenBuffers(lines_of)

    def findings(
        self, document: Document, poll: Callable[[], None] | None = None
    ) -> list[Diagnostic]:
        """Return the findings of a document."""
        return self.of(document).findings(document.name, poll)

    def of(self, document: Document) -> PlcProject:
        """Return the project of a document, as found when the document was opened."""
        known = self._of_document.get(document.uri)
        if known is None:
            known = self._of_document[document.uri] = self._find(document)
        return known

    def documents_beside(self, document: Document) -> list[Document]:
        """Return the other open documents of the same project."""
        project = self.of(document)
        return [
            other
            for other in self._documents.values()
            if other is not document and other.is_structured and self.of(other) is project
        ]

    def of_program(self, program: Document) -> Iterator[Document]:
        """Yield a document of each PLC that may be that of a program.

        First those that its project names, then open ones, then those of its folder.
        """
        path = program.location
        files: list[Path] = []
        if path is not None:
            try:
                project = find_project(path, self._access)
            except Failure:
                project = None
            for plc in () if project is None else project.plcs:
                files += self._first_of(plc)
        yield from (self._document(one, program) for one in files)
        yield from [one for one in self._documents.values() if one.is_structured]
        if path is not None:
            yield from (self._document(one, program) for one in _sources_in(path.parent))

    def _first_of(self, plc: Path) -> list[Path]:
        """Return a file of each project that a file names: the file itself, or the first object."""
        if plc.suffix.lower() in SOURCE_SUFFIXES:
            return [plc]
        if plc.suffix.lower() not in PROJECT_SUFFIXES:
            return []
        reporter = Reporter(Sources(), Collector())
        return [one.files[0] for one in read_project(plc, self._bytes, reporter) if one.files]

    def _document(self, path: Path, like: Document) -> Document:
        path = path.resolve()
        lines = decode_text(self._bytes(path) or b"").text.split("\n")
        name, language = path.as_posix(), STRUCTURED_LANGUAGE
        return Document(uri_of(path), path, name, language, 0, lines, like.encoding)

    def tidy(self) -> None:
        """Collect the garbage of earlier checks, while no request waits for an answer."""
        projects = [one for one in self._projects.values() if one.has_garbage]
        for project in projects:
            project.has_garbage = False
        if projects:
            gc.collect()

    def forget(self) -> None:
        """Find the projects again: files have been saved, added or removed."""
        self._of_document.clear()

    # --- finding ----------------------------------------------------------------------------------

    def _find(self, document: Document) -> PlcProject:
        path = document.location
        if path is None:
            listed = PlcSources(document.name, [Path(document.name)])
            return PlcProject(listed, ProjectLibraries(), _WithoutFile(document, self._access))
        listed = self._listed(document, path)
        libraries = self._libraries(path)
        key = (tuple(listed.files), libraries)
        known = self._projects.get(key)
        if known is None or not same_files(known.listed, listed):
            texts: Texts = self._access
            if document.path is None:
                texts = _WithoutFile(document, self._access)
            known = self._projects[key] = PlcProject(listed, libraries, texts)
        return known

    def _listed(self, document: Document, path: Path) -> PlcSources:
        """Return the files of a document's project."""
        if path.suffix.lower() in OBJECT_SUFFIXES:
            around = project_around(path)
            if around is not None:
                reporter = Reporter(Sources(), Collector())
                for found in read_project(around, self._bytes, reporter):
                    if any(_is_same(one, path) for one in found.files):
                        found.files = [path if _is_same(one, path) else one for one in found.files]
                        return found
        return PlcSources(path.parent.name, list(self._beside(document, path)))

    def _beside(self, document: Document, path: Path) -> Iterator[Path]:
        """Yield the file and those of its folder that belong to no project, by their names."""
        known = _names(document.text())
        chosen = {path}
        for one in _sources_in(path.parent)[:MAX_FILES]:
            if one.name == path.name or not self._is_loose(one):
                continue
            names = _names(decode_text(self._bytes(one) or b"").text)
            if known.isdisjoint(names):
                known |= names
                chosen.add(one)
        yield from sorted(chosen)

    def _is_loose(self, path: Path) -> bool:
        return path.suffix.lower() not in OBJECT_SUFFIXES or project_around(path) is None

    def _libraries(self, path: Path) -> ProjectLibraries:
        try:
            return libraries_of(find_project(path, self._access))
        except Failure:
            return ProjectLibraries()

    def _bytes(self, path: Path) -> bytes | None:
        try:
            return self._access.read_bytes(path)
        except Failure:
            return None


class _WithoutFile:
    """The text of a document that has no file, and all others as in the editor."""

    def __init__(self, document: Document, others: OpenBuffers) -> None:
        self._document = document
        self._others = others

    def read_bytes(self, path: Path) -> bytes:
        """Return a file's bytes; raises ``Failure`` where it cannot be read."""
        if path.as_posix() != self._document.name:
            return self._others.read_bytes(path)
        return self._document.text().encode("utf-8", "surrogatepass")

    def state_of(self, path: Path) -> object:
        """Return a key that changes with the text of a file."""
        if path.as_posix() != self._document.name:
            return self._others.state_of(path)
        return self._document.version


def _sources_in(folder: Path) -> list[Path]:
    try:
        return sorted(one for one in folder.iterdir() if one.suffix.lower() in SOURCE_SUFFIXES)
    except OSError:
        return []


def _names(text: str) -> set[str]:
    """Return the names of the objects that a text declares, in lower case."""
    return {name.lower() for name in (*_OBJECT.findall(text), *_XML_NAME.findall(text))}


def _is_same(first: Path, second: Path) -> bool:
    return first.name.lower() == second.name.lower() and first.resolve() == second.resolve()
