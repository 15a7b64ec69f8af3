# SPDX-License-Identifier: MIT
"""Chunked diagnostics: NC files in which each line says its mistake.

A line ``; ---`` divides a file into chunks, each of which is its own program. A line that shall be
reported ends with ``; error 22005 "part of text"``, or several of these after each other,
``warning`` and ``note`` likewise. What is missing and what is too much are both failures.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.text import decode_text, split_lines

FOLDER = Path(__file__).parent.parent / "nc"

_SEPARATOR = "; ---"
_EXPECTATION = re.compile(r';\s*(error|warning|note) (\d+) "([^"]*)"')


@dataclass(frozen=True, slots=True)
class Chunk:
    """Lines of one chunk and the place of its first line in the file."""

    file: str
    first_line: int
    lines: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.file}:{self.first_line}"


def read_chunks(pattern: str) -> list[Chunk]:
    """The chunks of the files next to this one whose names fit the pattern."""
    chunks: list[Chunk] = []
    for path in sorted(FOLDER.glob(pattern)):
        lines = split_lines(decode_text(path.read_bytes()).text)
        start = 0
        for number, line in enumerate([*lines, _SEPARATOR]):
            if line.startswith(_SEPARATOR):
                chunks.append(Chunk(path.name, start + 1, tuple(lines[start:number])))
                start = number + 1
    assert chunks, pattern
    return chunks


def expected_messages(pattern: str) -> list[tuple[str, int, str]]:
    """Severity, number and text of everything that the chunks expect."""
    return [
        (severity, int(message), text)
        for chunk in read_chunks(pattern)
        for line in chunk.lines
        for severity, message, text in _EXPECTATION.findall(line)
    ]


def compare(chunk: Chunk, diagnostics: Sequence[Diagnostic]) -> list[str]:
    """What was expected and did not come, what came and was not expected; places in the file."""
    missing = [
        (number, severity, int(message), text)
        for number, line in enumerate(chunk.lines, start=1)
        for severity, message, text in _EXPECTATION.findall(line)
    ]
    extra: list[str] = []
    for found in diagnostics:
        assert found.span is not None
        severity = found.severity.label("en")
        fitting = next(
            (
                expectation
                for expectation in missing
                if expectation[:3] == (found.span.line, severity, found.id)
                and expectation[3] in found.text("en")
            ),
            None,
        )
        if fitting is None:
            place = found.span.line + chunk.first_line - 1
            extra.append(f"unexpected at line {place}: {found.headline()}")
        else:
            missing.remove(fitting)
    return extra + [
        f"missing at line {number + chunk.first_line - 1}: {severity} {message} {text!r}"
        for number, severity, message, text in missing
    ]
