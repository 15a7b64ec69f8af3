# SPDX-License-Identifier: MIT
"""Programs that nobody here wrote: found beside the checkout or where NCTAKT_CORPUS says."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from support.nc_trees import shape

from nctakt.base.text import decode_text, split_lines
from nctakt.messages import Collector
from nctakt.nc.parse.parser import parse, parse_program
from nctakt.nc.parse.printer import print_program
from nctakt.nc.source import Source

ROOT = Path(__file__).parents[2]
CORPUS = Path(os.environ.get("NCTAKT_CORPUS", ROOT.parent / "corpus"))
SUFFIXES = (".nc", ".ngc", ".gcode", ".tap")
#: What is printed and read again is bounded, so that the test stays short.
PRINTED_LINES = 3000

FILES = sorted(path for path in CORPUS.rglob("*") if path.suffix in SUFFIXES)
OWN = sorted((ROOT / "tests" / "runs").glob("*/*.nc"))


def _name(path: Path) -> str:
    return f"{path.parent.name}/{path.name}"


def read(path: Path) -> Source:
    """A file as the command line reads it."""
    return Source(path.name, split_lines(decode_text(path.read_bytes()).text))


@pytest.mark.skipif(not FILES, reason="no corpus beside the project")
@pytest.mark.parametrize("path", FILES, ids=_name)
def test_foreign_programs_are_read_to_their_end(path: Path) -> None:
    """Whatever is in them: no exception, and each diagnostic is inside the file."""
    source = read(path)
    collector = Collector()
    count = sum(1 for _ in parse(source, collector))
    assert count + len(collector.diagnostics) > 0
    for found in collector.diagnostics:
        assert found.span is not None
        assert 1 <= found.span.line <= max(1, len(source.lines))
        assert found.source_line == source.line_of(found.span)
        assert 1 <= found.span.column <= len(found.source_line) + 1
        assert found.render("de")


@pytest.mark.parametrize("path", [*FILES, *OWN], ids=_name)
def test_programs_are_the_same_when_printed_and_read_again(path: Path) -> None:
    """parse(print(tree)) == tree for programs without mistakes."""
    source = read(path)
    source = Source(source.file, source.lines[:PRINTED_LINES])
    collector = Collector()
    program = parse_program(source, collector)
    if collector.diagnostics:
        pytest.skip("has mistakes")
    text = print_program(program)
    again = parse_program(Source(path.name, text.split("\n")), collector)
    assert collector.diagnostics == []
    assert shape(again) == shape(program)
