# SPDX-License-Identifier: MIT
"""A PLC that acknowledges late, twice, or what was never there (RC-002, RC-403)."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import pytest

from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
from nctakt.plc import NONE, Plc, load_plc
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

REALISTIC = Path(__file__).parent.parent / "machines" / "centre"
WAITING = "M100\nG04 X0.005\nM101\nG04 X0.005\nM102\nG04 X0.005\nM30"


class KeepsTheFirst(Plc):
    """Acknowledges the first function again and again, whatever waits by now."""

    acknowledge = NONE

    def __init__(self) -> None:
        self.kept: TechnologyEntry | None = None
        self.waiting: dict[int, list[str]] = {}

    def each_tick(self, hli: PlcView) -> None:
        """Called after each tick."""
        functions = hli.functions()
        self.waiting[hli.tick] = [one.name for one in functions]
        if self.kept is None and functions:
            self.kept = functions[0]
        if self.kept is not None:
            hli.acknowledge(self.kept)


def test_a_kept_function_does_not_acknowledge_the_next_one_in_its_slot() -> None:
    """Only M100 is acknowledged; that the others still wait is reported once, with the tick."""
    plc = KeepsTheFirst()
    run = Controller().run(NcText("p.nc", WAITING), plc=plc)
    assert plc.waiting[0] == ["M100"]
    assert plc.waiting[13] == ["M101", "M102"]
    assert [one.id for one in run.diagnostics] == [900671]
    assert run.diagnostics[0].values == {"name": "M100", "tick": 1}


def test_a_function_acknowledged_twice_after_one_tick_is_acknowledged() -> None:
    """A method of the PLC and its policy may both do it."""

    class Twice(Plc):
        def each_tick(self, hli: PlcView) -> None:
            hli.acknowledge_all()
            hli.acknowledge_all()

    run = Controller().run(NcText("p.nc", WAITING), plc=Twice())
    assert run.state == "ended"
    assert run.diagnostics == ()


def test_a_function_that_a_reset_has_cleared_is_stale() -> None:
    """What comes after the reset still waits."""
    controller = Controller()
    plc = KeepsTheFirst()
    controller.run(NcText("p.nc", WAITING), plc=plc, ticks=5)
    controller.reset()
    controller.run(NcText("p.nc", "M101\nM30"), plc=plc, ticks=5)
    assert plc.waiting[controller.tick - 1] == ["M101"]
    assert 900671 in [one.id for one in controller.diagnostics]


@pytest.mark.parametrize("slot", [-1, 20, 10**9, -(10**9), 1 << 62, 10**30])
def test_a_forged_function_is_refused(slot: int) -> None:
    """No memory outside of the slots is touched."""
    hli = Controller().hli
    entry = TechnologyEntry("M", 100, 1, 0, True, 0.0, "", slot)
    with pytest.raises(ValueError, match=r"^slot -?\d+ is not in 0 … 19$"):
        hli.acknowledge(entry)
    with pytest.raises(ValueError, match="slot"):
        hli.acknowledge(dataclasses.replace(entry, is_realtime=False))


@pytest.mark.parametrize("place", [-1, 99, 10**9, -(10**9), 10**30])
def test_a_forged_job_of_a_spindle_is_refused(place: int) -> None:
    """The same for spindles."""
    hli = Controller().hli
    job = SpindleEntry("S9", 3, 100.0, 0.0, 0, 0, 0.0, place)
    with pytest.raises(ValueError, match=rf"^spindle {place} is not in 0 … "):
        hli.acknowledge_spindle(job)


def test_requests_of_axes_that_cannot_be_are_refused() -> None:
    """Kind, mode and direction are numbers of a list; an owner is that of a request."""
    hli = Controller().hli
    with pytest.raises(ValueError, match="kind of request 99 is not in 1 … 8"):
        hli.request_axis(99, "X", 0.0, 1.0, 0, 0)
    with pytest.raises(ValueError, match="buffer mode 7 is not in 0 … 1"):
        hli.request_axis(1, "X", 0.0, 1.0, 7, 0)
    with pytest.raises(ValueError, match="direction -9 is not in -1 … 2"):
        hli.request_axis(1, "X", 0.0, 1.0, 0, -9)
    for owner in (-(10**9), 0, 1_000_000, 10**30):
        with pytest.raises(ValueError, match=f"request {owner} is not in "):
            hli.axis_answer(owner)


def test_the_file_of_the_plc_is_named_where_it_forges(tmp_path: Path) -> None:
    """900523 with the line of the PLC."""
    file = tmp_path / "plc.py"
    file.write_text(
        "class Forger:\n    def cycle(self, hli):\n        hli.axis_answer(-10**9)\n", "utf-8"
    )
    with pytest.raises(Exception, match="request -1000000000 is not in") as caught:
        Controller().run(NcText("p.nc", WAITING), plc=load_plc(file))
    assert "line 3" in str(caught.value)
