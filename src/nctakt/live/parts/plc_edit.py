# SPDX-License-Identifier: MIT
"""A text of the PLC that a person changes on the page: a declaration, an implementation, a file.

In: a file of the PLC, the row of the cursor. Out: an editor in the place of the lines; the file
with that text, once it is saved. A file that has changed on disk meanwhile is never written over.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from nicegui import ui

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.live.document import replace_file
from nctakt.live.texts import Texts
from nctakt.messages import diagnostic
from nctakt.messages.connections.live import PROGRAM_CHANGED_ON_DISK
from nctakt.messages.files import FILE_NOT_WRITABLE
from nctakt.st.files.editable import EditableTexts


@dataclass(slots=True)
class _Opened:
    """A text that is changed: its file with the content that it was read from, its number."""

    file: str
    content: bytes
    texts: EditableTexts
    number: int


class PlcEdit:
    """The editor of one browser; ``on_typed`` is called with each change.

    What was typed and not saved comes back when the same text is opened again.
    """

    def __init__(self, texts: Texts, on_typed: Callable[[], None]) -> None:
        self._texts = texts
        self._opened: _Opened | None = None
        self._drafts: dict[tuple[str, int], str] = {}
        self._on_typed = on_typed
        self._is_dark = False
        self._room = ui.element("div").classes("nc-plc-edit-room")
        self._editor: Any = None  # there from the first text on: few change one

    @property
    def is_open(self) -> bool:
        """Whether a text is open."""
        return self._opened is not None

    @property
    def is_changed(self) -> bool:
        """Whether the text is not the one of its file."""
        own = self._opened
        return own is not None and self._typed != own.texts.texts[own.number]

    @property
    def _typed(self) -> str:
        return "" if self._editor is None else self._editor.value or ""

    def open(self, file: str, shown: list[str], number: int) -> bool:
        """Let a text of a file be changed; ``shown``: its lines as the session runs them.

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
        name = json.dumps(self._texts["plc_edited"])
        self._editor.client.run_javascript(
            "const typing = () => {"
            f" const view = getElement({self._editor.id})?.editor;"
            " if (!view) return setTimeout(typing, 20);"  # its library is still on the way
            f" view.contentDOM.setAttribute('aria-label', {name}); view.focus();"
            "}; typing();"
        )
        return True

    def _make_editor(self) -> None:
        with self._room:
            self._editor = ui.codemirror(
                "", theme=self._theme, line_wrapping=True, on_change=lambda _: self._on_typed()
            )
        self._editor.classes("nc-plc-edit").props("data-testid=plc-edit")

    @property
    def _theme(self) -> Any:
        return "vscodeDark" if self._is_dark else "basicLight"

    def close(self) -> None:
        """Show no text; what is not saved is kept."""
        own = self._opened
        if own is not None and self.is_changed:
            self._drafts[own.file, own.number] = self._typed
        self._opened = None
        if self._editor is not None:
            self._editor.set_visibility(False)

    def write(self) -> None:
        """Write the text into its file; raises ``Failure`` if that has changed, or cannot be."""
        own = self._opened
        if own is None:
            return
        path = Path(own.file)
        if FileAccess().read_bytes(path) != own.content:
            raise Failure(diagnostic(PROGRAM_CHANGED_ON_DISK, file=own.file))
        content = own.texts.replaced(own.number, self._typed)
        try:
            replace_file(path, content)
        except OSError as error:
            reason = error.strerror or str(error)
            raise Failure(diagnostic(FILE_NOT_WRITABLE, file=own.file, reason=reason)) from error
        self._opened = _Opened(own.file, content, EditableTexts(own.file, content), own.number)

    def set_dark(self, is_dark: bool) -> None:
        """Use dark or light colours."""
        self._is_dark = is_dark
        if self._editor is not None:
            self._editor.run_method("setTheme", self._theme)
