# SPDX-License-Identifier: MIT
"""Each run folder, recorded and replayed from its tape: the same bytes without the PLC."""

from __future__ import annotations

import io
import shutil
from pathlib import Path

import pytest
from support.run_folders import FOLDERS, HERE, perform, settings

from nctakt.files.access import FileAccess
from nctakt.results.trace.sinks import JsonlSink
from nctakt.run.access.tape import TapeComparison, TapeWriter, read_tape

pytestmark = pytest.mark.slow

SIGNALS = {"X.ACS.ACT_POS", "PATH.SPEED", "BLOCK"}


@pytest.mark.parametrize("name", FOLDERS)
def test_a_replay_gives_the_same_bytes(name: str, tmp_path: Path) -> None:
    """Trace with all events, messages, diagnostics but those about the PLC's file, end."""
    folder, tape_file = HERE / name, tmp_path / "run.tape"
    work = tmp_path / "work"
    recorded, replayed = io.StringIO(), io.StringIO()
    with tape_file.open("w", encoding="utf-8") as file:
        writer = TapeWriter(file.write, {}, {}, "plc" in settings(folder))
        first = perform(
            folder,
            SIGNALS,
            work,
            record=writer.note,
            sinks=[JsonlSink(_Kept(recorded)), writer],
        )
        writer.finish(first.state, first.ticks, {})
    tape = read_tape(tape_file, FileAccess())
    shutil.rmtree(work, ignore_errors=True)
    comparison = TapeComparison(tape)
    second = perform(
        folder, SIGNALS, work, replay=tape, sinks=[JsonlSink(_Kept(replayed)), comparison]
    )
    assert comparison.first is None
    assert replayed.getvalue() == recorded.getvalue()
    assert (second.state, second.ticks, second.messages) == (
        first.state,
        first.ticks,
        first.messages,
    )
    assert [one.id for one in second.errors] == [one.id for one in first.errors]


class _Kept(io.TextIOBase):
    """A file that stays open for who reads it."""

    name = "trace.jsonl"

    def __init__(self, kept: io.StringIO) -> None:
        self._kept = kept

    def write(self, text: str) -> int:
        """Keep a text."""
        return self._kept.write(text)
