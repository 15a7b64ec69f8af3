# SPDX-License-Identifier: MIT
"""A text of the PLC that a person changes on the page: a declaration, an implementation, a file.

In: a file of the PLC, the row of the cursor. Out: an editor in the place of the lines, with the
findings of its text; the file with that text, once it is saved. A file that has changed on disk
meanwhile is never written over.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from nicegui import run, ui

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text, split_lines
from nctakt.files.access import FileAccess
from nctakt.live import view
from nctakt.live.document import replace_file
from nctakt.live.parts.commander import Newest
from nctakt.live.texts import Texts
from nctakt.messages import diagnostic
from nctakt.messages.connections.live import PROGRAM_CHANGED_ON_DISK
from nctakt.messages.files import FILE_NOT_WRITABLE
from nctakt.st.files.editable import EditableTexts

#: How long the page waits for more typing, in seconds.
_TYPING_S = 0.35

_MARKS = (Path(__file__).parent / "plc_marks.js").read_text("utf-8")


@dataclass(slots=True)
class _Opened:
    """A text that is changed: its file with the content that it was read from, its number."""

    file: str
    content: bytes
    texts: EditableTexts
    number: int

    def lines_with(self, text: str) -> list[str]:
        """Return the lines of the file with another text."""
        return split_lines(decode_text(self.texts.replaced(self.number, text)).text)

    def placed(self, found: Sequence[Diagnostic], lines: Sequence[str]) -> list[Diagnostic]:
        """Return the findings in the text's lines, by their places there.

        If the file writes a line differently, as entities, the whole line counts.
        """
        first, column = self.texts.place_of(self.number)
        whole = self.lines_with("\n".join(lines))
        placed = []
        for one in found:
            span = one.span
            if span is None or span.file != self.file or not 0 <= span.line - first < len(lines):
                continue
            line = lines[span.line - first]
            shift = column - 1 if span.line == first else 0
            is_plain = whole[span.line - 1][shift:].startswith(line)
            begin, end = (span.column, span.end_column) if is_plain else (1, len(line) + 1)
            shift = shift if is_plain else 0
            moved = replace(
                span, line=span.line - first + 1, column=begin - shift, end_column=end - shift
            )
            placed.append(replace(one, span=moved))
        return placed


#: Returns the findings of the check for the session's files if one had other lines.
Find = Callable[[str, Sequence[str]], list[Diagnostic]]


class PlcEdit:
    """The editor of one browser; ``on_typed`` is called with each change.

    Unsaved text comes back when the same text is opened again. ``findings``: those of the text as
    it was checked last, by the places in their files.
    """

    def __init__(
        self,
        texts: Texts,
        on_typed: Callable[[], None],
        find: Find,
        on_findings: Callable[[], None],
    ) -> None:
        self._texts = texts
        self._find = find
        self._on_findings = on_findings
        self._checks = Newest(self._check)
        self._changes = 0
        self.findings: list[Diagnostic] = []
        self._opened: _Opened | None = None
        self._drafts: dict[tuple[str, int], str] = {}
        self._on_typed = on_typed
        self._is_dark = False
        self._room = ui.element("div").classes("nc-plc-edit-room")
        self._editor: Any = None  # created with the first text: few users change one

    @property
    def is_open(self) -> bool:
        """Whether a text is open."""
        return self._opened is not None

    @property
    def is_changed(self) -> bool:
        """Whether the text differs from that of its file."""
        opened = self._opened
        return opened is not None and self._typed != opened.texts.texts[opened.number]

    @property
    def _typed(self) -> str:
        return "" if self._editor is None else self._editor.value or ""

    def open(self, file: str, shown: list[str], number: int) -> bool:
        """Open a text of a file for editing; ``shown``: its lines as the session runs them.

        Returns whether that is possible: the file must be as it was when the run began.
        """
        try:
            content = FileAccess().read_bytes(Path(file))
        except Failure:
            return False
        texts = EditableTexts(file, content)
        as_run = EditableTexts(file, "\n".join(shown).encode("utf-8", "replace"))
        if [one.rstrip("\n") for one in as_run.texts] != [one.rstrip("\n") for one in texts.texts]:
            return False
        if not 0 <= number < len(texts.texts):
            return False
        self._opened = _Opened(file, content, texts, number)
        if self._editor is None:
            self._make_editor()
        self._editor.set_value(self._drafts.pop((file, number), texts.texts[number]))
        self._editor.set_visibility(True)
        self._check_later()
        name = json.dumps(self._texts["plc_edited"])
        self._editor.client.run_javascript(
            "const typing = () => {"
            f" const view = getElement({self._editor.id})?.editor;"
            " if (!view) return setTimeout(typing, 20);"  # its library is still loading
            f" view.contentDOM.setAttribute('aria-label', {name}); view.focus();"
            "}; typing();"
        )
        return True

    def _make_editor(self) -> None:
        with self._room:
            self._editor = ui.codemirror(
                "", theme=self._theme, line_wrapping=True, on_change=self._changed
            )
        self._editor.classes("nc-plc-edit").props("data-testid=plc-edit")
        script = _MARKS.replace("EDITOR", str(self._editor.id))
        self._editor.client.run_javascript(script)

    def _changed(self, _: Any) -> None:
        self._on_typed()
        self._check_later()

    # --- findings -------------------------------------------------------------------------------

    def _check_later(self) -> None:
        """Check the text after a short pause in typing."""
        self._changes += 1
        ui.timer(_TYPING_S, lambda change=self._changes: self._checks.request(change), once=True)

    async def _check(self, change: int) -> None:
        opened, typed = self._opened, self._typed
        if opened is None or change != self._changes:
            return
        found = await run.io_bound(self._find, opened.file, opened.lines_with(typed))
        if opened is self._opened and change == self._changes and found is not None:
            self.findings = found
            lines = typed.split("\n")
            placed = opened.placed(found, lines)
            self._show_marks(view.finding_marks(lines, opened.file, placed, self._texts.language))
            self._on_findings()

    def _show_marks(self, marks: list[dict[str, Any]]) -> None:
        self._run(f"globalThis.nctaktPlcMarks = {json.dumps(marks)};")
        self._run("globalThis.nctaktPlcText?.show(globalThis.nctaktPlcMarks);")

    def _run(self, code: str) -> None:
        self._editor.client.run_javascript(code)

    def reveal(self, file: str, line: int) -> bool:
        """Go to a line of a file; return whether it lies in the text that is open."""
        opened = self._opened
        if opened is None or opened.file != file:
            return False
        index = line - opened.texts.place_of(opened.number)[0]
        if not 0 <= index <= self._typed.count("\n"):
            return False
        self._run(f"globalThis.nctaktPlcText?.go({index + 1});")
        return True

    @property
    def _theme(self) -> Any:
        return "vscodeDark" if self._is_dark else "basicLight"

    def close(self) -> None:
        """Show no text; unsaved text is kept."""
        opened = self._opened
        if opened is not None and self.is_changed:
            self._drafts[opened.file, opened.number] = self._typed
        self._opened, self.findings = None, []
        if self._editor is not None:
            self._show_marks([])
            self._editor.set_visibility(False)

    def write(self) -> None:
        """Write the text into its file; raises ``Failure`` if that has changed, or cannot be."""
        opened = self._opened
        if opened is None:
            return
        path = Path(opened.file)
        if FileAccess().read_bytes(path) != opened.content:
            raise Failure(diagnostic(PROGRAM_CHANGED_ON_DISK, file=opened.file))
        content = opened.texts.replaced(opened.number, self._typed)
        try:
            replace_file(path, content)
        except OSError as error:
            reason = error.strerror or str(error)
            raise Failure(diagnostic(FILE_NOT_WRITABLE, file=opened.file, reason=reason)) from error
        self._opened = _Opened(
            opened.file, content, EditableTexts(opened.file, content), opened.number
        )

    def set_dark(self, is_dark: bool) -> None:
        """Use dark or light colours."""
        self._is_dark = is_dark
        if self._editor is not None:
            self._editor.run_method("setTheme", self._theme)
