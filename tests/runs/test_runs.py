# SPDX-License-Identifier: MIT
"""Runs whole programs and compares them with traces that were worked out by hand.

Each folder beside this file is a test: programs, ``run.toml`` with values and limits where needed,
and ``expected.trace``. Its README derives the trace from the rules. Lines of ``expected.trace``:
``value <tick> <signal> <number>`` and ``event <tick> <kind> <text>``; all events are listed.
"""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from nctakt.controller import Controller
from nctakt.plc import load_plc
from nctakt.results.run import Run
from nctakt.stimuli import Stimulus

HERE = Path(__file__).parent
FOLDERS = sorted(folder.parent.name for folder in HERE.glob("*/expected.trace"))


def perform(folder: Path, names: set[str]) -> Run:
    """Run the programs of a folder and record the signals ``names``."""
    settings = folder / "run.toml"
    given = tomllib.loads(settings.read_text("utf-8")) if settings.exists() else {}
    plc = given.get("plc")
    return Controller().run(
        *sorted(folder.glob("*.nc")),
        plc=None if plc is None else load_plc(folder / plc),
        initial=given.get("set", {}),
        stimuli=[Stimulus(*stimulus) for stimulus in given.get("at", ())],
        after_us=given.get("after_us", 0),
        ticks=given.get("ticks"),
        signals=sorted(names),
    )


def expectations(folder: Path) -> tuple[list[tuple[int, str, float]], list[str]]:
    """The expected values and the expected events, as ``<tick> <kind> <text>``."""
    values: list[tuple[int, str, float]] = []
    events: list[str] = []
    for line in (folder / "expected.trace").read_text("utf-8").splitlines():
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        if words[0] == "value":
            values.append((int(words[1]), words[2], float(words[3])))
        else:
            assert words[0] == "event", line
            events.append(line.removeprefix("event ").strip())
    return values, events


@pytest.mark.parametrize("name", FOLDERS)
def test_run_has_the_trace_that_was_worked_out_by_hand(name: str) -> None:
    """Every event and every listed value of the run is as the folder's README derives it."""
    folder = HERE / name
    values, events = expectations(folder)
    run = perform(folder, {signal for _, signal, _ in values})
    found = [f"{event.tick} {event}" for event in run.events if event.kind != "notice"]
    assert found == events
    assert run.trace is not None
    for tick, signal, number in values:
        assert run.trace.at(tick, signal) == pytest.approx(number, abs=1e-9), (tick, signal)
