# SPDX-License-Identifier: MIT
"""HTML tables that notebooks show for an object."""

from __future__ import annotations

from collections.abc import Iterable


def html_table(caption: str, rows: Iterable[tuple[str, str]]) -> str:
    """Return a table with a head before each row; all texts are escaped."""
    from html import escape  # noqa: PLC0415 - only in a notebook

    lines = "".join(
        f'<tr><th style="text-align: left">{escape(head)}</th>'
        f'<td style="text-align: left">{escape(text)}</td></tr>'
        for head, text in rows
    )
    return f"<table><caption>{escape(caption)}</caption>{lines}</table>"
