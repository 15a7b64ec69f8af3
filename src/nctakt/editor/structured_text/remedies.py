# SPDX-License-Identifier: MIT
"""Findings in Structured Text -> the edits that remedy them.

In: a document of a project and its findings. Out: code actions. An edit is offered only if a check
of the resulting text no longer has the finding, and no new one in the whole project.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence

from lsprotocol.types import (
    CodeAction,
    CodeActionKind,
    Position,
    Range,
    TextDocumentContentChangePartial,
    TextEdit,
    WorkspaceEdit,
)
from lsprotocol.types import Diagnostic as Shown

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Diagnostic, Language, Message, Text
from nctakt.editor.document import Document
from nctakt.editor.structured_text.missing_declarations import declarations
from nctakt.editor.structured_text.plc_project import PlcFile
from nctakt.editor.structured_text.positions import position_at
from nctakt.editor.structured_text.project_names import ProjectNames
from nctakt.messages.plcs import st_check, st_text
from nctakt.st.sources import Piece
from nctakt.st.vocabulary.elementary import ELEMENTARY

_REPLACE = Text("Write {new}", "{new} schreiben")
_REMOVE = Text("Remove {old}", "{old} entfernen")
_INSERT = Text("Insert {new}", "{new} einfügen")
_DECLARE = Text("Declare {new}", "{new} deklarieren")

#: Signs and keywords that can be put where they are missed.
_MISSED = frozenset((";", ")", "]", ":", "THEN", "DO", "OF", "TO"))
#: Words that divide a structure and are indented like its beginning.
_DIVIDER = re.compile(r"\s*(?:ELSE|ELSIF|UNTIL)\b", re.IGNORECASE)
_COMMENT = re.compile(r"\s*(?://[^\n]*|\(\*(?:(?!\*\)).)*\*\))\s*\Z", re.DOTALL)
#: Characters before a place in which comments are looked for.
_LOOKED_BACK = 1000
_SIMPLE = re.compile(r"[\w.^\[\]%]+")


@dataclass(frozen=True, slots=True)
class Edit:
    """A stretch of a piece of text, by its offsets, and the text that takes its place."""

    piece: Piece
    start: int
    end: int
    new: str


@dataclass(frozen=True, slots=True)
class _Found:
    """A finding in its piece of text; ``written``: its text, up to the end of its line."""

    item: Diagnostic
    piece: Piece
    start: int
    written: str

    def replaced(self, new: str) -> Edit:
        """Return the edit that puts a text in its place."""
        return Edit(self.piece, self.start, self.start + len(self.written), new)

    def inserted(self, offset: int, new: str) -> Edit:
        """Return the edit that inserts a text."""
        return Edit(self.piece, offset, offset, new)


_Remedies = Iterator[tuple[str, list[Edit]]]


def structured_actions(
    names: ProjectNames,
    document: Document,
    found: Sequence[tuple[Diagnostic, Shown]],
    language: Language,
) -> list[CodeAction]:
    """Return the code actions of some findings of a document, the preferred ones first.

    Callers hold the project's lock.
    """
    file = names.project.file_named(document.name)
    result = []
    for item, shown in () if file is None else found:
        number = 0
        for title, edits in _remedies(names, document, item, language):
            changes = [_shown(document, edit) for edit in edits]
            if not _remedies_it(names, document, item, changes):
                continue
            result.append(
                CodeAction(
                    title,
                    kind=CodeActionKind.QuickFix,
                    diagnostics=[shown],
                    is_preferred=number == 0,
                    edit=WorkspaceEdit(changes={document.uri: changes}),
                )
            )
            number += 1
            if item.message is st_text.END_KEYWORD_MISSING:
                break  # the others would put it elsewhere
    return result


def _remedies(
    names: ProjectNames, document: Document, item: Diagnostic, language: Language
) -> list[tuple[str, list[Edit]]]:
    """Return title and edits of each remedy that a finding may have."""
    file = names.project.file_named(document.name)
    slip = None if file is None else _located(document, item, file)
    if file is None or slip is None:
        return []
    remedies = _BY_MESSAGE.get(item.message)
    result = [] if remedies is None else list(remedies(slip, language))
    if item.message is st_check.NAME_UNKNOWN:
        for edit, new in declarations(names, file, slip.piece.base + slip.start):
            result.append((_DECLARE.get(language).format(new=new), [Edit(*edit)]))
    return result


def _located(document: Document, item: Diagnostic, file: PlcFile) -> _Found | None:
    span = item.span
    if span is None or not span.line:
        return None
    area = document.range_of(span)
    spot = position_at(document, area.start, file)
    if spot is None:
        return None
    piece, start = spot
    written = document.line(span.line - 1)[span.column - 1 : span.end_column - 1]
    return _Found(item, piece, start, written)


def _shown(document: Document, edit: Edit) -> TextEdit:
    """Return an edit by the places of the file."""
    return TextEdit(
        Range(
            _position(document, edit.piece, edit.start), _position(document, edit.piece, edit.end)
        ),
        edit.new,
    )


def _position(document: Document, piece: Piece, offset: int) -> Position:
    line, column = piece.locate(piece.base + offset)
    return Position(line - 1, document.character_of(document.line(line - 1), column - 1))


def _remedies_it(
    names: ProjectNames, document: Document, item: Diagnostic, edits: Sequence[TextEdit]
) -> bool:
    """Return whether a check after edits no longer has a finding, and has no new one."""
    copy = Document(
        document.uri,
        document.path,
        document.name,
        document.language,
        document.version,
        document.lines[:],
        document.encoding,
    )
    for edit in sorted(edits, key=_start, reverse=True):
        copy.change(TextDocumentContentChangePartial(edit.range, edit.new_text))
    before = Counter(one.id for one in names.project.all_findings())
    after = Counter(one.id for one in names.project.tried(document.name, copy.lines))
    return after[item.id] < before[item.id] and after <= before


def _start(edit: TextEdit) -> tuple[int, int]:
    return edit.range.start.line, edit.range.start.character


# --- different spelling ---------------------------------------------------------------------------


def _nearest(slip: _Found, language: Language) -> _Remedies:
    """Write the name that is meant."""
    name, nearest = str(slip.item.values["name"]), str(slip.item.values["nearest"])
    if nearest != NOTHING and slip.written.lower().startswith(name.lower()):
        new = nearest + slip.written[len(name) :]
        yield _REPLACE.get(language).format(new=nearest), [slip.replaced(new)]


def _qualified(slip: _Found, language: Language) -> _Remedies:
    """Write the list before a name, of several any."""
    name = slip.written
    lists = str(slip.item.values.get("lists", "")).split(", ")
    names = [f"{one}.{name}" for one in lists if one]
    for new in names or [str(slip.item.values["qualified"])]:
        yield _REPLACE.get(language).format(new=new), [slip.replaced(new)]


def _brackets(slip: _Found, language: Language) -> _Remedies:
    new = f"{slip.written}()"
    yield _REPLACE.get(language).format(new=new), [slip.replaced(new)]


def _converted(slip: _Found, language: Language) -> _Remedies:
    """Convert a value by a function."""
    target = str(slip.item.values["target"]).upper()
    if target in ELEMENTARY or target in ("STRING", "WSTRING"):
        new = f"TO_{target}({slip.written})"
        yield _REPLACE.get(language).format(new=new), [slip.replaced(new)]


def _compared(slip: _Found, language: Language) -> _Remedies:
    """Compare a number with 0."""
    written = slip.written
    new = f"{written if _SIMPLE.fullmatch(written) else f'({written})'} <> 0"
    yield _REPLACE.get(language).format(new=new), [slip.replaced(new)]


def _assigned(slip: _Found, language: Language) -> _Remedies:
    """Assign instead of comparing."""
    yield _REPLACE.get(language).format(new=":="), [slip.replaced(":=")]


def _removed(slip: _Found, language: Language) -> _Remedies:
    """Remove a superfluous sign."""
    title = _REMOVE.get(language).format(old=slip.written)
    yield title, [slip.replaced("")]


def _without_pointer(slip: _Found, language: Language) -> _Remedies:
    if slip.written.endswith("^"):
        new = slip.written[:-1].rstrip()
        yield _REMOVE.get(language).format(old="^"), [slip.replaced(new)]


def _power(slip: _Found, language: Language) -> _Remedies:
    left, sign, right = slip.written.partition("**")
    if sign and "**" not in right:
        new = f"EXPT({left.strip()}, {right.strip()})"
        yield _REPLACE.get(language).format(new=new), [slip.replaced(new)]


# --- missing parts --------------------------------------------------------------------------------


def _missed(slip: _Found, language: Language) -> _Remedies:
    """Insert a sign or keyword after the last code before the position, comments left out."""
    new = str(slip.item.values["expected"])
    if new not in _MISSED:
        return
    begin = max(0, slip.start - _LOOKED_BACK)
    before = slip.piece.text[begin : slip.start].rstrip()
    while (comment := _COMMENT.search(before)) is not None:
        before = before[: comment.start()].rstrip()
    text = f" {new}" if new.isalpha() else new
    title = _INSERT.get(language).format(new=new)
    yield title, [slip.inserted(begin + len(before), text)]


def _end_keyword(slip: _Found, language: Language) -> _Remedies:
    """Close a structure before the next line indented no deeper, else where it is missed."""
    keyword = str(slip.item.values["keyword"])
    text, piece = slip.piece.text, slip.piece
    opening = _line_begin(piece, int(str(slip.item.values["line"])))
    if opening is None:
        return
    indent = re.match(r"[ \t]*", text[opening:])
    assert indent is not None
    title = _INSERT.get(language).format(new=keyword)
    written = len(text.rstrip())
    for offset in _ends(text, opening, slip.start, len(indent[0])):
        if offset >= written:
            yield title, [slip.inserted(written, f"\n{indent[0]}{keyword}")]
        else:
            yield title, [slip.inserted(offset, f"{indent[0]}{keyword}\n")]


def _line_begin(piece: Piece, line: int) -> int | None:
    """Return the offset at which a line of the file begins in a piece, ``None`` outside it."""
    first, offset = piece.lines[0], 0
    for _ in range(line - first):
        offset = piece.text.find("\n", offset) + 1
        if not offset:
            return None
    return offset if line >= first else None


def _ends(text: str, opening: int, missed: int, indent: int) -> Iterator[int]:
    """Yield the beginnings of lines before which a structure may end, the likeliest first."""
    last = text.rfind("\n", 0, missed) + 1
    offset = text.find("\n", opening) + 1
    while 0 < offset < last:
        end = text.find("\n", offset)
        line = text[offset : end if end >= 0 else len(text)]
        is_deeper = len(line) - len(line.lstrip()) > indent
        if line.strip() and not is_deeper and _DIVIDER.match(line) is None:
            yield offset
            break
        offset = end + 1
    yield len(text) if not text[missed:].strip() else last


def _closed_pragma(slip: _Found, language: Language) -> _Remedies:
    """Close a pragma at the end of its line."""
    end = slip.piece.text.find("\n", slip.start)
    line = slip.piece.text[slip.start : end if end >= 0 else None].rstrip()
    title = _INSERT.get(language).format(new="}")
    yield title, [slip.inserted(slip.start + len(line), "}")]


def _closed_string(slip: _Found, language: Language) -> _Remedies:
    """Close a string before the semicolon at the end of its line."""
    end = slip.piece.text.find("\n", slip.start)
    line = slip.piece.text[slip.start : end if end >= 0 else None].rstrip()
    if line.endswith(";") and ")" not in line and line[:1] in "'\"":
        title = _INSERT.get(language).format(new=line[0])
        yield title, [slip.inserted(slip.start + len(line) - 1, line[0])]


_BY_MESSAGE: dict[Message, Callable[[_Found, Language], _Remedies]] = {
    st_check.NAME_UNKNOWN: _nearest,
    st_check.TYPE_UNKNOWN: _nearest,
    st_check.INTERFACE_UNKNOWN: _nearest,
    st_check.MEMBER_UNKNOWN: _nearest,
    st_check.PARAMETER_UNKNOWN: _nearest,
    st_check.OUTPUT_UNKNOWN: _nearest,
    st_check.NAME_NEEDS_QUALIFIER: _qualified,
    st_check.NAME_AMBIGUOUS: _qualified,
    st_check.CALL_WITHOUT_BRACKETS: _brackets,
    st_check.TYPE_MISMATCH: _converted,
    st_check.SIGN_MAY_CHANGE: _converted,
    st_check.DIGITS_MAY_GET_LOST: _converted,
    st_check.CONDITION_NOT_BOOL: _compared,
    st_check.DEREFERENCE_OF_NO_POINTER: _without_pointer,
    st_check.POWER_REFUSED: _power,
    st_text.COMPARISON_AS_STATEMENT: _assigned,
    st_text.CHARACTER_UNKNOWN: _removed,
    st_text.TOKEN_EXPECTED: _missed,
    st_text.END_KEYWORD_MISSING: _end_keyword,
    st_text.PRAGMA_NOT_CLOSED: _closed_pragma,
    st_text.STRING_NOT_CLOSED: _closed_string,
}
