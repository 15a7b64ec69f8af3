# SPDX-License-Identifier: MIT
"""Objects in notebooks: tables, small curves, pictures.

In: texts, numbers. Out: HTML in which all texts are escaped.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

_LEFT = 'style="text-align: left"'
_WIDTH, _HEIGHT = 120, 24


def html_table(caption: str, rows: Iterable[tuple[str, str]]) -> str:
    """Return a table with a head before each row."""
    from html import escape  # noqa: PLC0415 - only in a notebook

    lines = "".join(
        f"<tr><th {_LEFT}>{escape(head)}</th><td {_LEFT}>{escape(text)}</td></tr>"
        for head, text in rows
    )
    return f"<table><caption>{escape(caption)}</caption>{lines}</table>"


def html_columns(
    caption: str,
    heads: Sequence[str],
    rows: Iterable[Sequence[str]],
    curves: Sequence[str] = (),
) -> str:
    """Return a table with a head above each column; ``curves``: a last cell of each row, HTML."""
    from html import escape  # noqa: PLC0415 - as above

    head = "".join(f"<th {_LEFT}>{escape(one)}</th>" for one in heads)
    lines = []
    for number, row in enumerate(rows):
        cells = "".join(f"<td {_LEFT}>{escape(text)}</td>" for text in row)
        cells += f"<td>{curves[number]}</td>" if number < len(curves) else ""
        lines.append(f"<tr>{cells}</tr>")
    return f"<table><caption>{escape(caption)}</caption><tr>{head}</tr>{''.join(lines)}</table>"


def curve(lows: Sequence[float], highs: Sequence[float]) -> str:
    """Return the outline of a curve, from the lowest and highest value of each stretch of it."""
    low, high = min(lows), max(highs)
    scale = (_HEIGHT - 2) / (high - low) if high > low else 0.0
    step = _WIDTH / max(1, len(lows) - 1)

    def points(values: Sequence[float]) -> list[str]:
        return [
            f"{index * step:.1f},{_HEIGHT - 1 - (value - low) * scale:.1f}"
            for index, value in enumerate(values)
        ]

    outline = " ".join([*points(highs), *reversed(points(lows))])
    return (
        f'<svg width="{_WIDTH}" height="{_HEIGHT}"><polygon points="{outline}" '
        'fill="#1f77b4" stroke="#1f77b4"/></svg>'
    )


def strip(spans: Sequence[tuple[float, float]]) -> str:
    """Return a strip with bars; ``spans``: begin and end of each as shares of the whole."""
    bars = "".join(
        f'<rect x="{begin * _WIDTH:.2f}" width="{max(1.0, (end - begin) * _WIDTH):.2f}" '
        f'height="{_HEIGHT // 2}" fill="#d95f02"/>'
        for begin, end in spans
    )
    return (
        f'<svg width="{_WIDTH}" height="{_HEIGHT // 2}">'
        f'<rect width="{_WIDTH}" height="{_HEIGHT // 2}" fill="#eef1f5"/>{bars}</svg>'
    )


def html_picture(png: bytes) -> str:
    """Return a picture as part of a page."""
    import base64  # noqa: PLC0415 - as above

    data = base64.b64encode(png).decode("ascii")
    return f'<img src="data:image/png;base64,{data}" style="max-width: 100%">'
