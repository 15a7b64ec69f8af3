# SPDX-License-Identifier: MIT
"""Program load: a file or text -> a checked program, with all its mistakes reported at once."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from nctakt.assembly import Machine
from nctakt.diagnostics import Diagnostic
from nctakt.failure import Failure
from nctakt.messages import Collector, diagnostic
from nctakt.nc.check import check
from nctakt.nc.parser import parse_program
from nctakt.nc.source import Source
from nctakt.nc.syntax import Program
from nctakt.text import decode_text, split_lines


@dataclass(frozen=True, slots=True)
class NcText:
    """A program given as text; ``name`` stands for the file in diagnostics and results."""

    name: str
    text: str


def name_of(program: str | Path | NcText) -> str:
    """The name of a program as the user gave it."""
    return program.name if isinstance(program, NcText) else str(program)


def load(program: str | Path | NcText, machine: Machine, diagnostics: list[Diagnostic]) -> Program:
    """Read, parse and check; what is found goes to ``diagnostics``.

    Raises ``Failure`` with the errors when there are any.
    """
    collector = Collector()
    name = name_of(program)
    text = program.text if isinstance(program, NcText) else _read(Path(program), collector)
    source = Source(name, split_lines(text))
    tree = parse_program(source, collector)
    check(tree, machine.names, machine.parameters, collector)
    machine.files.add(source.file, source.lines)
    diagnostics += collector.diagnostics
    errors = [found for found in collector.diagnostics if found.severity.name == "ERROR"]
    if errors:
        raise Failure(*errors)
    return tree


def _read(path: Path, collector: Collector) -> str:
    """The text of a program file; ``Failure`` where there is none."""
    if not path.exists():
        raise Failure(diagnostic(900500, file=str(path)))
    if path.is_dir():
        raise Failure(diagnostic(900501, file=str(path)))
    try:
        data = path.read_bytes()
    except OSError as error:
        reason = error.strerror or str(error)
        raise Failure(diagnostic(900503, file=str(path), reason=reason)) from error
    return decode_text(data).text
