# SPDX-License-Identifier: MIT
"""Places as single numbers."""

import pytest

from nctakt.base.diagnostics import Span
from nctakt.base.source_ids import (
    FILE_LIMIT,
    LAST_COLUMN,
    LAST_LINE,
    NO_SOURCE,
    SourceFiles,
    pack,
    unpack,
)


@pytest.mark.parametrize("file_index", [0, 1, FILE_LIMIT - 1])
@pytest.mark.parametrize("line", [1, 77, LAST_LINE - 1, LAST_LINE])
@pytest.mark.parametrize("column", [1, 100, LAST_COLUMN - 1, LAST_COLUMN])
def test_a_place_survives_the_way_through_a_float64_cell(
    file_index: int, line: int, column: int
) -> None:
    """What is packed, stored as float64 and unpacked is the same place."""
    assert unpack(int(float(pack(file_index, line, column)))) == (file_index, line, column)


def test_places_beyond_the_last_line_or_column_share_its_number() -> None:
    """A longer text than the numbers reach is no error: its places are the last ones."""
    assert unpack(pack(0, LAST_LINE + 1, LAST_COLUMN + 1)) == (0, LAST_LINE, LAST_COLUMN)


def test_a_file_beyond_the_limit_has_no_place() -> None:
    """The first file index that does not fit gives no place instead of another file's."""
    assert pack(FILE_LIMIT, 1, 1) == NO_SOURCE
    assert pack(FILE_LIMIT - 1, 1, 1) != NO_SOURCE


def test_source_files_give_back_span_and_line() -> None:
    """A number leads to file, line and column and to the text line."""
    files = SourceFiles()
    files.add("a.nc", ["G0 X1"])
    index = files.add("b.nc", ["M30", "  G1 X2"])
    source = pack(index, 2, 3)
    assert files.span(source) == Span("b.nc", 2, 3, 4)
    assert files.line_of(source) == "  G1 X2"
    assert files.line_at(Span("b.nc", 2, 3, 9)) == "  G1 X2"
    assert files.line_at(Span("b.nc", 3, 1, 2)) == ""
    assert files.line_at(Span("c.nc", 1, 1, 2)) == ""


def test_no_source_has_no_place() -> None:
    """0 represents no place, also when there are files."""
    files = SourceFiles()
    files.add("a.nc", ["G0 X1"])
    assert files.span(NO_SOURCE) is None
    assert files.line_of(NO_SOURCE) == ""
    assert files.line_of(pack(0, 5, 1)) == ""
    assert files.span(pack(3, 5, 1)) is None


def test_the_same_text_added_again_keeps_its_index() -> None:
    """A program that runs twice has one index; a changed text under its name gets another."""
    files = SourceFiles()
    first = files.add("a.nc", ["G0 X1"])
    assert files.add("a.nc", ["G0 X1"]) == first
    assert files.add("a.nc", ["G0 X2"]) != first
    assert len(files) == 2
