# SPDX-License-Identifier: MIT
"""The help of the page: all keys in groups, in a dialog."""

from __future__ import annotations

from typing import Any

from nicegui import ui

from nctakt.live.parts.keys import GROUPS
from nctakt.live.parts.naming import named
from nctakt.live.texts import Texts


def build_help(texts: Texts) -> Any:
    """Return the dialog with all keys, closed."""
    index = 1 if texts.language == "de" else 0
    with ui.dialog().props("data-testid=help-dialog") as dialog, ui.element("div") as card:
        named(dialog, texts["help"])
        card.classes("nc-card nc-help")
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
            ui.button(texts["close"], on_click=dialog.close).props("dense flat no-caps size=sm")
    return dialog
