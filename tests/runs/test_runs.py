# SPDX-License-Identifier: MIT
"""Runs whole programs and compares them with traces that were worked out by hand.

Each folder next to this file is a test: programs, ``run.toml`` with values and limits where needed,
and ``expected.trace``. Programs of other channels than the first are named in ``run.toml``
(``[channels]``), a machine folder of the test's own as well (``machine_folder``), a schedule with
its load (``rtconf``, ``load``). Its README derives the trace from the rules. Lines of
``expected.trace``: ``value <tick> <signal> <number>``; ``event <tick> <kind> <text>``, where all
events are listed, and all notices if there is one; ``diagnostic <number> <line> <words>``, where
all errors are listed if there is one. Without ``exit = 1`` in ``run.toml`` a run has no errors.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from support.run_folders import FOLDERS, HERE, expectations, perform, settings, settled


@pytest.mark.parametrize("name", FOLDERS)
def test_run_has_the_trace_that_was_worked_out_by_hand(name: str, tmp_path: Path) -> None:
    """Every event and every listed value of the run is as the folder's README derives it."""
    folder = HERE / name
    values, events, diagnostics = expectations(folder)
    run = perform(folder, {signal for _, signal, _ in values}, tmp_path)
    with_notices = any(event.split()[1] == "notice" for event in events)
    found = [
        settled(f"{event.tick} {event}")
        for event in run.events
        if with_notices or event.kind != "notice"
    ]
    assert found == [settled(event) for event in events]
    assert run.trace is not None
    for tick, signal, number in values:
        assert run.trace.at(tick, signal) == pytest.approx(number, abs=1e-9), (tick, signal)
    assert bool(run.errors) == bool(settings(folder).get("exit", 0))
    if diagnostics:
        assert len(run.errors) == len(diagnostics)
    for error, expected in zip(run.errors, diagnostics, strict=False):
        number, line, words = expected.split(" ", 2)
        assert error.span is not None
        assert (error.id, error.span.line) == (int(number), int(line))
        assert words in error.text("en"), expected
