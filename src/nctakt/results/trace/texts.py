# SPDX-License-Identifier: MIT
"""Rows and events -> the texts of trace files.

In: float64 values of some ticks, events. Out: texts of numbers column by column, events of a tick
as one text or as JSON objects, lines and cells of CSV and JSON. Each number is written as short as
it can be without loss; negative zero is written as zero, so that equal values are equal text.
"""

from __future__ import annotations

import io
from collections.abc import Iterable, Iterator, Sequence

from nctakt.results.trace.events import Event

#: Number of samples of a column that decide whether its values repeat.
_SAMPLES = 64


def column_texts(
    values: list[float], width: int, integral: Sequence[bool], missing: str = "nan"
) -> list[list[str]]:
    """Return the texts of ``values`` (row after row, ``width`` numbers each), column by column.

    ``missing`` replaces a value that is not finite. The texts are made by columns, since most
    columns of a trace repeat their values, or those of another: such a number is formatted once.
    """
    texts: list[list[str]] = []
    columns: list[tuple[bool, list[float]]] = []
    for i in range(width):
        column = (integral[i], values[i::width])
        if column in columns:
            texts.append(texts[columns.index(column)])
        else:
            texts.append(_column_text(column[1], integral[i], missing))
        columns.append(column)
    return texts


def _column_text(column: list[float], integral: bool, missing: str) -> list[str]:
    if 0.0 in column:  # true for negative zero as well, which is written as zero
        column = [value + 0.0 for value in column]
    if integral:
        memo = {value: f"{value:.0f}" for value in dict.fromkeys(column)}
    else:
        sample = column[:: max(1, len(column) // _SAMPLES)]
        if 2 * len(dict.fromkeys(sample)) > len(sample) > 1:
            return _finite(list(map(repr, column)), column, missing)
        memo = {value: repr(value) for value in dict.fromkeys(column)}
    return _finite(list(map(memo.__getitem__, column)), column, missing)


def _finite(texts: list[str], column: list[float], missing: str) -> list[str]:
    """Return the texts with ``missing`` for values that are not finite; their sum shows any."""
    total = sum(column)
    if total - total == 0.0:
        return texts
    return [
        text if value - value == 0.0 else missing for text, value in zip(texts, column, strict=True)
    ]


def by_tick(events: Sequence[Event]) -> Iterator[tuple[int, list[Event]]]:
    """Yield each tick with its events, which are consecutive."""
    together: list[Event] = []
    for event in events:
        if together and together[0].tick != event.tick:
            yield together[0].tick, together
            together = []
        together.append(event)
    if together:
        yield together[0].tick, together


def join_events(events: Iterable[Event]) -> str:
    """Return the events of a tick as one text, which ``trace.reading.split_events`` divides."""
    return "; ".join(map(_event_text, events))


def _event_text(event: Event) -> str:
    text = f"{event.prefix}{event.kind} {escape(event.text)}"
    if event.span is None and not event.cycle:
        return text
    return f"{text} <{escape(event.cycle) or '-'} {escape(str(event.span or '-'))}>"


def escape(text: str) -> str:
    r"""Put a ``\`` before the dividers of events (``;``, ``<``), ``\`` itself and line ends."""
    for plain, marked in (("\\", "\\\\"), (";", "\\;"), ("<", "\\<"), ("\n", "\\n"), ("\r", "\\r")):
        text = text.replace(plain, marked)
    return text


def event_object(event: Event) -> dict[str, object]:
    """Return an event as a JSON object, without an empty cycle or position."""
    content: dict[str, object] = {"kind": event.kind, "text": event.text}
    if event.channel:
        content["channel"] = event.channel
    if event.cycle:
        content["cycle"] = event.cycle
    if event.span is not None:
        content |= {
            "file": event.span.file,
            "line": event.span.line,
            "column": event.span.column,
            "end_column": event.span.end_column,
        }
    return content


def json_text(content: object) -> str:
    """Return the content as JSON on one line."""
    import json  # noqa: PLC0415 - not every run writes a file

    return json.dumps(content, ensure_ascii=False)


def csv_line(cells: Sequence[str]) -> str:
    """Return a line of CSV with its line end."""
    import csv  # noqa: PLC0415 - as above

    buffer = io.StringIO()
    csv.writer(buffer, lineterminator="\n").writerow(cells)
    return buffer.getvalue()


def csv_cell(text: str) -> str:
    """Return a cell of CSV, in quotation marks where it needs them."""
    if '"' in text or "," in text:
        doubled = text.replace('"', '""')
        return f'"{doubled}"'
    return text
