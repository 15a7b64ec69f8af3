# SPDX-License-Identifier: MIT
"""The list syntax, line by line (manual of rtconf.lis, chapters 2.4 and 2.5)."""

from __future__ import annotations

import pytest

from nctakt.lists.declared.schemas import RTCONF
from nctakt.lists.format.list_check import load_list
from nctakt.lists.format.parameter import with_indices
from nctakt.lists.format.values import Values
from nctakt.messages import Collector

HASH_BLANK, HASH_INDENT, END_CASE, AFTER_END, NO_END = 900001, 900002, 900003, 900004, 900005
NUL, BLANK, UNKNOWN, NEAREST, INDEX, FOREIGN = 900006, 900007, 900008, 900009, 2009, 900012
NO_VALUE, NO_NUMBER, QUOTED, QUOTE_OPEN, TRAILING = 900013, 2022, 900015, 900016, 900017
SPECIAL, ABOVE, BELOW, LENGTH, NO_NAME = 900018, 1023, 1024, 1021, 2021
DUPLICATE, ALIAS = 900023, 900024

NOTHING: dict[str, object] = {}
NAME = "thread[0].name"

LINES: list[tuple[str, dict[str, object], list[int]]] = [
    ("# comment", NOTHING, []),
    ("#", NOTHING, []),
    ("#no blank", NOTHING, [HASH_BLANK]),
    ("   # indented", NOTHING, [HASH_INDENT]),
    ("*****", NOTHING, [UNKNOWN]),
    ("cycle_time 2000", {"cycle_time": 2000}, []),
    ("cycle_time 2000 Comment", {"cycle_time": 2000}, []),
    ("cycle_time 2000 # Comment", {"cycle_time": 2000}, []),
    ("cycle_time 2000 ( Comment", {"cycle_time": 2000}, []),
    ("cycle_time 2000 /* Comment", {"cycle_time": 2000}, []),
    ("cycle_time 2000# Comment", NOTHING, [NO_NUMBER]),
    ("cycle_time 2000(Comment", NOTHING, [NO_NUMBER]),
    ("cycle_time", NOTHING, [NO_VALUE]),
    ("cycle_time # 2000", NOTHING, [NO_NUMBER]),
    ("cycle_time = 2000", NOTHING, [NO_NUMBER]),
    ("cycle_time -1", NOTHING, [BELOW]),
    ("cycle_time +2000", {"cycle_time": 2000}, []),
    ("cycle_time 0x7D0", NOTHING, [NO_NUMBER]),
    ("cycle_time 2000.0", NOTHING, [2006]),
    ('cycle_time "2000"', {"cycle_time": 2000}, [QUOTED]),
    ("cycle_time\t2000\ttab comment", {"cycle_time": 2000}, []),
    ("Cycle_Time 2000", NOTHING, [NEAREST]),
    ("cycle_time[0] 2000", NOTHING, [NEAREST]),
    ("thread[0].name GEO", {NAME: "GEO"}, []),
    ("thread[0].name GEO (comment)", {NAME: "GEO"}, []),
    ("thread[0].name GEO(comment", {NAME: "GEO"}, [BLANK]),
    ("thread[0].name GEO # HIGHEST", {NAME: "GEO # HIGHEST"}, [SPECIAL]),
    ("thread[0].name GEO /* x", {NAME: "GEO /* x"}, [SPECIAL]),
    ("thread[0].name TWO WORDS", {NAME: "TWO WORDS"}, [SPECIAL]),
    ('thread[0].name "TWO WORDS"', {NAME: "TWO WORDS"}, []),
    ('thread[0].name "TRAIL   "', {NAME: "TRAIL"}, []),
    ('thread[0].name " LEAD"', {NAME: " LEAD"}, []),
    ('thread[0].name "A( # /*)B" (real comment', {NAME: "A( # /*)B"}, []),
    ('thread[0].name "A" # not allowed', {NAME: "A"}, [TRAILING]),
    ('thread[0].name"GLUED"', {NAME: "GLUED"}, [BLANK]),
    ('thread[0].name "open', {NAME: "open"}, [QUOTE_OPEN]),
    ('thread[0].name ""', {NAME: ""}, []),
    ("thread[0].name (only comment", NOTHING, [NO_VALUE]),
    ("thread[0].name", NOTHING, [NO_VALUE]),
    ("thread[0].name STANDARD!", {NAME: "STANDARD!"}, []),
    ('thread[0].name A"B', {NAME: 'A"B'}, [SPECIAL]),
    ("thread[6].name LAST", {"thread[6].name": "LAST"}, []),
    ("thread[10].name X", NOTHING, [INDEX]),
    ("thread[0].function[6].name task_int", {"thread[0].function[6].name": "task_int"}, []),
    ("thread[0].function[10].name task_int", NOTHING, [INDEX]),
    ("external_thread[3].cycle 2000", {"external_thread[3].cycle": 2000}, []),
    ("external_thread[4].cycle 2000", NOTHING, [INDEX]),
    ("thread[0].context 1", {"thread[0].context_info": 1}, [ALIAS]),
    ("thread[0].context_info 1", {"thread[0].context_info": 1}, []),
    ("schedule.context.geo 1", NOTHING, [FOREIGN]),
    ("thread[0].error_on_overflow TRUE", NOTHING, [NO_NUMBER]),
    ("thread[0].error_on_overflow 2", NOTHING, [ABOVE]),
    ("schedule STANDARD # ok", {"schedule": "STANDARD"}, []),
    ("schedule standard", NOTHING, [NO_NAME]),
    ("schedule 0", NOTHING, [NO_NAME]),
    (
        "thread[0].function[0].calls_per_cycle 4 (HSC",
        {"thread[0].function[0].calls_per_cycle": 4},
        [],
    ),
    ("thread.name X", NOTHING, [NEAREST]),
    ("thread[ 0 ].name X", NOTHING, [NEAREST]),
    ("thread[00].name X", {NAME: "X"}, []),
    ("thread[].name X", NOTHING, [NEAREST]),
    ("thread[-1].name X", NOTHING, [NEAREST]),
    ("thread[0]name X", NOTHING, [NEAREST]),
    ("cycle_time   \t ", NOTHING, [NO_VALUE]),
    ("thread[0].name \t ", NOTHING, [NO_VALUE]),
    ("(cycle_time 2000", NOTHING, [NEAREST]),
    ("/* cycle_time 2000", NOTHING, [UNKNOWN]),
    ("thread[0].name 'single'", {NAME: "'single'"}, []),
    ("Endeffekt 1", NOTHING, [UNKNOWN]),
    ("cycle_time 20\x0000", NOTHING, [NUL]),
    ("cycle_time " + "9" * 5000, NOTHING, [ABOVE]),
    ("cycle_time ²", NOTHING, [NO_NUMBER]),
    ('"quoted" 1', NOTHING, [UNKNOWN]),
    ("thread[0].name " + "x" * 127, {NAME: "x" * 127}, []),
    ("thread[0].name " + "x" * 128, NOTHING, [LENGTH]),
]


def load(data: bytes) -> tuple[Values, list[int], Collector]:
    """The values of ``data``, the numbers of what was found, and the findings."""
    collector = Collector()
    values = load_list(RTCONF, "rtconf.lis", data, collector)
    return values, [found.id for found in collector.diagnostics], collector


def taken(values: Values) -> dict[str, object]:
    """What the list gave, by name."""
    return {with_indices(*key): item.value for key, item in values.entry_values.items()}


@pytest.mark.parametrize(("line", "expected", "numbers"), LINES)
def test_line(line: str, expected: dict[str, object], numbers: list[int]) -> None:
    """Each line of the syntax table gives its value and its findings, and no others."""
    values, found, _ = load(f"{line}\nEnd\n".encode())
    if UNKNOWN in numbers or NEAREST in numbers:
        assert found in ([UNKNOWN], [NEAREST])
    else:
        assert found == numbers
    assert taken(values) == expected


@pytest.mark.parametrize(
    ("line", "numbers"),
    [("End", []), ("Ende", []), ("END", [END_CASE]), ("End # trailer", []), ("  Ende", [])],
)
def test_end(line: str, numbers: list[int]) -> None:
    """End and Ende close a list, in other spellings with a note."""
    assert load(f"{line}\n".encode())[1] == numbers


def test_byte_order_mark_and_windows_line_ends() -> None:
    """A byte order mark and CR LF change nothing."""
    values, found, _ = load(b"\xef\xbb\xbfcycle_time 2000\r\nEnde\r\n")
    assert (taken(values), found) == ({"cycle_time": 2000}, [])


def test_windows_1252_text_is_read_with_a_note() -> None:
    """Bytes that are no UTF-8 are read as Windows-1252."""
    values, found, _ = load(b'thread[0].name "Vorschub\xfc"\nEnd\n')
    assert (taken(values), found) == ({NAME: "Vorschubü"}, [900000])


@pytest.mark.parametrize(
    "text", ["cycle_time 2000\rtime_slice 500\rEnd", "cycle_time 2000\r\ntime_slice 500\nEnd\r"]
)
def test_all_line_ends(text: str) -> None:
    """CR alone and mixed ends separate lines."""
    values, found, _ = load(text.encode())
    assert (taken(values), found) == ({"cycle_time": 2000, "time_slice": 500}, [])


def test_last_duplicate_counts_and_both_lines_are_named() -> None:
    """The second of two entries counts; the warning names both lines."""
    values, found, collector = load(b"cycle_time 2000\n# between\ncycle_time 4000\nEnd\n")
    assert (taken(values), found) == ({"cycle_time": 4000}, [DUPLICATE])
    diagnostic = collector.diagnostics[0]
    assert (diagnostic.values["first"], diagnostic.values["second"]) == (1, 3)
    assert "line 1" in diagnostic.text("en") and "Zeile 3" in diagnostic.text("de")


def test_leading_zeros_in_an_index_are_the_same_key() -> None:
    """thread[00] and thread[0] are one thread."""
    values, found, _ = load(b"thread[00].name A\nthread[0].name B\nEnd\n")
    assert (taken(values), found) == ({NAME: "B"}, [DUPLICATE])


@pytest.mark.parametrize("order", [("context", "context_info"), ("context_info", "context")])
def test_present_name_beats_the_old_one(order: tuple[str, str]) -> None:
    """context_info wins over context, wherever it is."""
    text = "".join(f"thread[0].{name} {len(name)}\n" for name in order) + "End\n"
    values, found, _ = load(text.encode())
    assert taken(values) == {"thread[0].context_info": len("context_info")}
    assert sorted(found) == [DUPLICATE, ALIAS]


def test_missing_end_is_a_warning() -> None:
    """A list without End may be cut off."""
    assert load(b"cycle_time 2000\n")[1] == [NO_END]
    assert load(b"")[1] == [NO_END]


def test_text_after_end_is_ignored_with_one_note() -> None:
    """Nothing after End counts; blank lines and comments there are not worth a note."""
    values, found, _ = load(b"Ende\n\n# comment\ncycle_time 9\ntime_slice 9\n")
    assert (taken(values), found) == ({}, [AFTER_END])
    assert load(b"Ende\n\n# comment\n")[1] == []


def test_form_feed_and_other_separators_do_not_split_a_line() -> None:
    """A form feed, NEL or U+2028 inside a comment leaves the line whole."""
    text = "cycle_time 2000 a\x0cb\x0bc\x85d\u2028time_slice 5\nEnd\n"
    values, found, _ = load(text.encode())
    assert (taken(values), found) == ({"cycle_time": 2000}, [])


def test_control_z_ends_the_file() -> None:
    """Ctrl-Z is the end of the file as on old systems."""
    values, found, _ = load(b"cycle_time 2000\nEnd\n\x1atime_slice 500\n")
    assert (taken(values), found) == ({"cycle_time": 2000}, [])
    assert load(b"cycle_time 2000\n\x1aEnd\n")[1] == [NO_END]


def test_unknown_name_suggests_the_nearest() -> None:
    """The remedy of an unknown entry names the known one with the same index."""
    _, _, collector = load(b"thread[3].priorty 5\nEnd\n")
    assert "thread[3].priority" in collector.diagnostics[0].remedy("de")


def test_findings_come_in_the_order_of_the_lines() -> None:
    """What the reader and what the checker found is sorted by line."""
    _, _, collector = load(b"cycle_time x\n#a\nbogus 1\ntime_slice\nEnd\n")
    lines = [found.span.line for found in collector.diagnostics if found.span]
    assert lines == [1, 2, 3, 4]


def test_spans_point_at_the_value() -> None:
    """A defective value is marked from its first to its last character, at least one wide."""
    _, _, collector = load(b"  cycle_time   20x0  comment\nEnd\n")
    span = collector.diagnostics[0].span
    assert span is not None
    assert (span.line, span.column, span.end_column) == (1, 16, 20)
    assert collector.diagnostics[0].render("en").splitlines()[2].strip() == "^^^^"
