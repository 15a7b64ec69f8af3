# SPDX-License-Identifier: MIT
"""The help of the page: all keys in groups, in a dialog."""

from __future__ import annotations

from nicegui import ui

from nctakt.live.parts.keys import GROUPS
from nctakt.live.parts.naming import named
from nctakt.live.texts import Texts


class Help:
    """The dialog with all keys, closed; its rows are built when it is opened first."""

    def __init__(self, texts: Texts) -> None:
        self._texts = texts
        self._is_built = False
        with ui.dialog().props("data-testid=help-dialog") as self._dialog:
            self._card = ui.element("div").classes("nc-card nc-help")
        named(self._dialog, texts["help"])

    def open(self) -> None:
        """Show all keys."""
        if not self._is_built:
            self._is_built = True
            with self._card:
                self._build()
        self._dialog.open()

    def _build(self) -> None:
        texts = self._texts
        index = 1 if texts.language == "de" else 0
        with ui.element("div").classes("nc-help-groups"):
            for heading, keys in GROUPS:
                with ui.element("div"):
                    ui.label(texts[heading]).classes("nc-title")
                    for key in keys:
                        with ui.element("div").classes("nc-row"):
                            ui.label(key.label[index]).classes("nc-keycap")
                            ui.label(texts[key.command]).classes("nc-soft")
        with ui.element("div").classes("nc-row"):
            ui.space()
            button = ui.button(texts["close"], on_click=self._dialog.close)
            button.props("dense flat no-caps size=sm")
