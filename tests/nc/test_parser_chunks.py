# SPDX-License-Identifier: MIT
"""Diagnostics of the parser, written beside the lines that cause them (``parse_*.nc``)."""

from __future__ import annotations

import pytest
from support.nc_chunks import Chunk, compare, read_chunks

from nctakt.messages import Collector
from nctakt.nc.parse.parser import parse_program
from nctakt.nc.source import Source


@pytest.mark.parametrize("chunk", read_chunks("parse_*.nc"), ids=str)
def test_the_parser_reports_what_each_line_says_and_nothing_else(chunk: Chunk) -> None:
    """Each mistake of a chunk is reported once, at its line, in the order of the text."""
    collector = Collector()
    parse_program(Source(chunk.file, chunk.lines), collector)
    assert compare(chunk, collector.diagnostics) == []
    places = [found.span.line for found in collector.diagnostics if found.span is not None]
    assert places == sorted(places)
