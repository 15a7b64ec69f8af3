# SPDX-License-Identifier: MIT
"""Where the time goes: each tick has one purpose, and causes are those of the rules.

The demo machine: X and Y reach 100 mm/s (F6000) with 4000 mm/s² in 25 ticks of 1 ms.
"""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from nctakt import Controller, NcText, Plc
from nctakt.timing.account import account_for
from nctakt.timing.entries import TimeAccount
from nctakt.timing.exports import as_csv, as_speedscope
from nctakt.timing.table import time_text

EXAMPLES = Path(__file__).parent.parent.parent / "examples"


def account_of(text: str, **options: object) -> TimeAccount:
    """The account of a program on the demo machine."""
    return account_for(Controller(), {1: [NcText("part.nc", text)]}, **options)  # type: ignore[arg-type]


def phases(account: TimeAccount) -> list[tuple[int, str, str, str, int]]:
    """Line, phase, cause, its particulars and ticks of each stretch."""
    found = []
    for one in account.stretches:
        own = one.purpose
        line = 0 if own.span is None else own.span.line
        found.append((line, own.phase, own.limit.cause, own.limit.detail.en, one.ticks))
    return found


def test_a_line_accelerates_keeps_its_feed_and_brakes() -> None:
    """MO-1: 100 mm at 100 mm/s take 1 s and 25 ms; one tick takes M30."""
    account = account_of("G01 X100 F6000\nM30")
    assert phases(account) == [
        (1, "accelerating", "acceleration", "X", 25),
        (1, "constant", "feed", "", 975),
        (1, "braking", "standstill", "line 1", 25),
        (0, "standing", "none", "", 1),
    ]
    assert account.run.ticks == 1026


def test_axis_that_limits_is_named() -> None:
    """On a line of 3 to 4, Y has 4/5 of the speed: its 4000 mm/s² allow 5000 along the path."""
    account = account_of("G01 X60 Y80 F6000\nM30")
    assert phases(account)[0] == (1, "accelerating", "acceleration", "Y", 20)


def test_corner_stops_the_path() -> None:
    """MO-3: a right angle between two lines cannot be passed: the path brakes for line 2."""
    account = account_of("G01 X100 F6000\nY100\nM30")
    assert (1, "braking", "corner", "line 2", 25) in phases(account)


def test_lower_feed_ahead() -> None:
    """From 100 to 50 mm/s take 12.5 ms, which end in the tick in which line 2 begins."""
    account = account_of("G01 X100 F6000\nX200 F3000\nM30")
    braking = [one for one in phases(account) if one[1] == "braking"]
    assert {one[2:4] for one in braking[:-1]} == {("next feed", "line 2")}
    assert sum(one[4] for one in braking[:-1]) == 13


def test_exact_stop() -> None:
    """G60 stops at the end of its block (MO-2)."""
    account = account_of("G01 X100 F6000\nG60 X200\nX300\nM30")
    assert (2, "braking", "exact stop", "line 2", 25) in phases(account)


@pytest.mark.parametrize(
    ("percent", "cause", "detail"), [(50, "override operator", "50 %"), (100, "feed", "")]
)
def test_operators_override(percent: int, cause: str, detail: str) -> None:
    """RC-305: the operator's override lowers the speed."""
    account = account_of("G01 X100 F6000\nM30", set={"HLI.OVERRIDE": percent})
    assert {one[2:4] for one in phases(account) if one[1] == "constant"} == {(cause, detail)}


def test_override_of_a_realtime_cycle_is_named() -> None:
    """RC-305: cycle 17 halves the speed in line 9, once X has passed 200 mm in tick 463."""
    path = EXAMPLES / "crossing.nc"
    account = account_for(Controller(), {1: [path]})
    slow = [one for one in phases(account) if one[2] == "override cycle"]
    assert {one[3] for one in slow} == {"cycle 17, line 9"}
    assert account.stretches[2].first_tick == 463


def test_dwell_and_subprograms() -> None:
    """G04 takes its time; ticks of a subprogram have the programs that called it."""
    text = "%L UP\nG01 X10 F6000\nM17\n%MAIN\nG04 X0.05\nLL UP\nM30"
    account = account_of(text)
    ticks = account.by(lambda one: (one.calls, one.kind))
    assert ticks[("MAIN",), "dwell"] == 50
    assert ticks[("MAIN", "UP"), "feed"] == 125


class Slow(Plc):
    """Acknowledges after 200 ms."""

    def cycle(self, hli: object) -> None:
        """Acknowledge what has waited for 200 ms."""
        for function in hli.functions():  # type: ignore[attr-defined]
            if hli.time_us - function.time_us >= 200_000:  # type: ignore[attr-defined]
                hli.acknowledge(function)  # type: ignore[attr-defined]


def test_waiting_for_a_function_names_it() -> None:
    """The path waits for the PLC's acknowledgement of M10 (MVS_SVS)."""
    account = account_of("G01 X10 F6000\nM10\nG01 X20\nM30", plc=Slow())
    waits = {
        text.en: ticks
        for (kind, text), ticks in account.by(lambda one: (one.kind, one.limit.detail)).items()
        if kind == "wait"
    }
    assert list(waits) == ["the PLC's acknowledgement of M10"]
    assert waits["the PLC's acknowledgement of M10"] in range(199, 203)


@pytest.mark.parametrize("name", ["contour", "shapes", "thread", "short_blocks"])
def test_sums_are_those_of_the_run(name: str) -> None:
    """Each tick counts once, in each of the files; running tick by tick changes nothing."""
    path = EXAMPLES / f"{name}.nc"
    account = account_for(Controller(), {1: [path]}, ticks=700)
    run = Controller().run(path, ticks=700, memory_trace=False)
    assert (account.run.ticks, account.run.state) == (run.ticks, run.state)
    assert sum(one.ticks for one in account.stretches) == run.ticks
    rows = list(csv.DictReader(io.StringIO(as_csv(account, "en"))))
    assert sum(int(row["time_us"]) for row in rows) == run.virtual_time_us
    (profile,) = json.loads(as_speedscope(account, "en"))["profiles"]
    assert sum(profile["weights"]) == profile["endValue"] == run.virtual_time_us
    assert "100.0 %" in time_text(account, "en")
