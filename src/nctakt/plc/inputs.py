# SPDX-License-Identifier: MIT
"""Sequences of inputs from a CSV file: values of variables at times.

The first row names the columns: ``time``, then variables (``V.E.DOOR``, ``HLI.OVERRIDE``). Each
further row has a time, as on the command line (``0.5s``, ``1500us``), and values; an empty cell
leaves its variable unchanged. Empty lines and lines that begin with ``#`` are skipped.
"""

from __future__ import annotations

import csv
from collections.abc import Iterator, Sequence
from pathlib import Path

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text, split_lines
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import read_time
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc import INPUT_CELL_COUNT, INPUT_HEADER_MISSING
from nctakt.run.access.stimuli import Stimulus, parse_assignment


def read_inputs(path: Path) -> tuple[Stimulus, ...]:
    """Return the values of a file in the order of its rows.

    Raises one ``Failure`` with all mistakes: a file that is missing (900500), unreadable
    (900503) or endless (900915), invalid rows (900654), times (900510) and values (900512).
    """
    lines = split_lines(decode_text(FileAccess().read_bytes(path)).text)
    diagnostics: list[Diagnostic] = []
    values: list[Stimulus] = []
    rows = _rows(lines)
    number, head = next(rows, (1, [""]))
    names = [cell.strip() for cell in head]
    if names[0].lower() != "time" or len(names) < 2 or not all(names):
        raise Failure(diagnostic(INPUT_HEADER_MISSING, file=str(path), line=number))
    for number, row in rows:
        if len(row) != len(names):
            wide = len(names)
            diagnostics.append(
                diagnostic(
                    INPUT_CELL_COUNT, file=str(path), line=number, count=len(row), expected=wide
                )
            )
            continue
        try:
            values.extend(_stimuli(names, row))
        except Failure as failure:
            diagnostics.extend(failure.diagnostics)
    if diagnostics:
        raise Failure(*diagnostics)
    return tuple(values)


def _rows(lines: Sequence[str]) -> Iterator[tuple[int, list[str]]]:
    """Yield each row with the number of its line."""
    for number, line in enumerate(lines, 1):
        if line.strip() and not line.startswith("#"):
            yield number, next(csv.reader([line]))


def _stimuli(names: Sequence[str], row: Sequence[str]) -> Iterator[Stimulus]:
    time = read_time(row[0])
    for name, cell in zip(names[1:], row[1:], strict=True):
        if cell.strip():
            yield Stimulus(time, *parse_assignment(f"{name}={cell}"))
