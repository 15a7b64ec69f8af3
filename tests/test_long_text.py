# SPDX-License-Identifier: MIT
"""Texts of any length: the same lines as if they were read at once, and no more memory."""

from __future__ import annotations

import os
import random
import tracemalloc
from pathlib import Path

import pytest

from nctakt.base import long_text
from nctakt.base.long_text import LongText, TextChanged
from nctakt.base.text import decode_text, split_lines
from nctakt.files.access import FileAccess
from nctakt.nc import outline
from nctakt.run.controller import Controller

RUNS = Path(__file__).parent / "runs"
PIECES = (b"\n", b"\r\n", b"\r", b"\r\r\n", b"G01 X1", b"\xc3\xa9", b" ", b"(a)", b"\x0c")


@pytest.fixture(autouse=True)
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every file is long, and read in small pieces."""
    monkeypatch.setattr(long_text, "SHORT_FILE_BYTES", 0)
    monkeypatch.setattr(long_text, "LINES_PER_GROUP", 3)
    monkeypatch.setattr(long_text, "_CHUNK_BYTES", 7)


@pytest.mark.parametrize("seed", range(40))
def test_lines_are_those_of_the_whole_text(tmp_path: Path, seed: int) -> None:
    """Line ends of all kinds at all places, byte order mark, bytes that are no UTF-8."""
    chance = random.Random(seed)
    more = (b"\xe9", b"\x80") if seed % 3 == 0 else ()
    data = b"".join(chance.choices((*PIECES, *more), k=chance.randrange(60)))
    if seed % 4 == 0:
        data = b"\xef\xbb\xbf" + data
    path = tmp_path / "p.nc"
    path.write_bytes(data)
    expected = split_lines(decode_text(data).text)
    lines = LongText(path)
    assert list(lines) == expected
    assert len(lines) == len(expected)
    assert [lines[number] for number in range(len(lines))] == expected
    for first in range(len(expected) + 1):
        assert list(lines.from_line(first)) == expected[first:]
    assert list(FileAccess().read_lines(path)) == expected
    assert LongText(path) == lines


def test_a_text_of_two_bytes_a_character_is_read_at_once(tmp_path: Path) -> None:
    """Its lines cannot be found by their bytes."""
    path = tmp_path / "p.nc"
    path.write_bytes("G01 X1\nM30\n".encode("utf-16"))
    assert FileAccess().read_lines(path) == ["G01 X1", "M30"]


@pytest.mark.parametrize(
    "name", ["goto_and_labels", "subprograms_of_a_file", "subprograms_in_files", "skip_levels"]
)
def test_programs_that_are_not_kept_run_alike(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Jumps and calls find their way in a text that is read again from there."""
    program = RUNS / name / "program.nc"
    expected = [str(event) for event in Controller().run(program).events]
    monkeypatch.setattr(outline, "KEPT_STATEMENTS", 0)
    assert [str(event) for event in Controller().run(program).events] == expected


def test_a_longer_program_needs_no_more_memory(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Reading, checking, decoding, running: bounded, whatever the length."""
    monkeypatch.undo()
    monkeypatch.setattr(long_text, "SHORT_FILE_BYTES", 1000)
    peaks = []
    for count in (4_000, 12_000):
        path = tmp_path / f"{count}.nc"
        lines = (f"N{n} G01 X{n % 7 / 100} Y{n % 5 / 100} F60000\n" for n in range(count))
        path.write_text("".join(lines) + "M30\n", "utf-8")
        controller = Controller()
        tracemalloc.start()
        run = controller.run(path, memory_trace=False, ticks=200)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
        assert run.errors == ()
    assert peaks[1] < 1.2 * peaks[0]


def text_of(path: Path, lines: int) -> LongText:
    path.write_text("".join(f"G01 X{number}\n" for number in range(lines)), "utf-8")
    return LongText(path)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system does not copy processes")
def test_copies_of_a_process_read_apart(tmp_path: Path) -> None:
    """A copy that reads on does not move the place where the first one reads."""
    text = text_of(tmp_path / "p.nc", 10_000)
    groups = text.groups(0)
    read = next(groups)
    copy = os.fork()
    if copy == 0:
        for _ in groups:
            pass
        os._exit(0)
    os.waitpid(copy, 0)
    for group in groups:
        read = [*read, *group]
    assert read == [f"G01 X{number}" for number in range(10_000)]


@pytest.mark.parametrize("is_replaced", [False, True])
def test_a_text_that_has_changed_is_not_read_on(tmp_path: Path, is_replaced: bool) -> None:
    path = tmp_path / "p.nc"
    text = text_of(path, 1000)
    if is_replaced:
        path.unlink()
    path.write_text("G01 X1\n" * 10, "utf-8")
    with pytest.raises(TextChanged):
        list(text)
    assert text[500] == ""


def test_a_program_that_changes_while_it_runs_ends_with_an_error(tmp_path: Path) -> None:
    path = tmp_path / "p.nc"
    path.write_text("G01 X0 F6000\n" + "X1\nX2\n" * 1000 + "M30\n", "utf-8")
    controller = Controller()
    controller.start(path)
    controller.step(10)
    path.write_text("G01 X0 F6000\n" + "Y1\nY2\n" * 1000 + "M30\n", "utf-8")
    found = controller.step(100_000).diagnostics
    assert controller.state == "error"
    assert [one.id for one in found] == [901900]
