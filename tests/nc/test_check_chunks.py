# SPDX-License-Identifier: MIT
"""Diagnostics of the checker, written beside the lines that cause them (``check_*.nc``).

Each chunk is checked against the demo machine; M200 and H200 are added to it as functions of X.
"""

from __future__ import annotations

import pytest
from support.check_machine import findings
from support.nc_chunks import Chunk, compare, read_chunks


@pytest.mark.parametrize("chunk", read_chunks("check_*.nc"), ids=str)
def test_the_checker_reports_what_each_line_says_and_nothing_else(chunk: Chunk) -> None:
    """Each mistake of a chunk is reported once, at its line, in the order of the text."""
    found = findings(chunk.lines, file=chunk.file)
    assert compare(chunk, found) == []
    places = [(one.span.line, one.span.column) for one in found if one.span is not None]
    assert places == sorted(places)
