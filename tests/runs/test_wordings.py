# SPDX-License-Identifier: MIT
"""The manuals' examples with German comments and with English ones (chapters 2, 3.1 and 5).

The two manuals differ in their comments only, but for their misprints. A folder ``german`` inside a
run folder holds the same programs with German comments, as an editor under Windows saves them: its
code page, two characters at each line's end.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from support.run_folders import HERE, expectations, perform, settled

from nctakt.run.controller import Controller, NcText

FOLDERS = sorted(folder.parent.name for folder in HERE.glob("*/german"))


@pytest.mark.parametrize("name", FOLDERS)
def test_both_wordings_have_the_same_trace(name: str, tmp_path: Path) -> None:
    """Events and values are those that were worked out for the English text."""
    folder = HERE / name
    values, events, _ = expectations(folder)
    run = perform(folder, {signal for _, signal, _ in values}, tmp_path, "german/*.nc")
    found = [settled(f"{event.tick} {event}") for event in run.events if event.kind != "notice"]
    assert found == [settled(event) for event in events]
    assert run.trace is not None
    for tick, signal, number in values:
        assert run.trace.at(tick, signal) == pytest.approx(number, abs=1e-9), (tick, signal)


def test_the_german_texts_are_not_ascii() -> None:
    """Each program has the line ends of Windows, and umlauts occur in its code page."""
    texts = [file.read_bytes() for file in sorted(HERE.glob("*/german/*.nc"))]
    assert all(text.count(b"\n") == text.count(b"\r\n") > 0 for text in texts)
    assert sum(max(text) > 127 for text in texts) > 10


def test_the_if_without_its_sign_is_an_error() -> None:
    """The English 2.8 prints ``IF`` for ``$IF``: refused before the first tick: 22002."""
    lines = ["#RT CYCLE [SCOPE = PROG]", "IF SQRT[7 * 5] < 12 * SIN[30]", "$ENDIF", "#RT CYCLE END"]
    run = Controller().run(NcText("english.nc", "\n".join([*lines, "M30"])))
    assert run.ticks == 0
    assert (22002, 2) in [(error.id, error.span and error.span.line) for error in run.errors]
