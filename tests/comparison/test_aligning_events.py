# SPDX-License-Identifier: MIT
"""``--align EVENT``: a log is laid on a run by an event that both have (LG-701)."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy
import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.comparison.aligning_event import AligningEvent, Edge
from nctakt.comparison.log import Samples
from nctakt.run.controller import Controller

#: M10 goes out when X is at 10; V.E.COUNT is 1 from X > 5 on.
PART = """\
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 5
    V.E.COUNT = 1
  $ENDIF
#RT CYCLE END
N40 G01 X10 F6000
N50 M10
N60 X30
M30
"""
#: How much later than the run the log begins to count.
LATE_S = 0.7


@pytest.fixture(autouse=True)
def _log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A log of the run, 0.7 s late, of 1 ms, with its own column for M10."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text(PART, "utf-8")
    run = Controller().run("part.nc", signals=["X.ACS.ACT_POS", "V.E.COUNT"])
    (out,) = [one for one in run.events if one.kind == "output"]
    x, count = run.trace["X.ACS.ACT_POS"], run.trace["V.E.COUNT"]
    late = round(LATE_S * 1000)
    rows = ["time_ms;X.ACS.ACT_POS [mm];V.E.COUNT;MAIN.bDone"]
    for at in range(late + len(x)):
        tick = max(at - late, 0)
        done = int(at - late >= out.tick)
        rows.append(f"{at};{float(x[tick])!r};{0 if at < late else count[tick]:g};{done}")
    Path("log.csv").write_text("\n".join(rows) + "\n", "utf-8")


def compared(capsys: pytest.CaptureFixture[str], *words: str) -> Any:
    assert main(["compare", "log.csv", "part.nc", "--format", "json", "--quiet", *words]) == 0
    return json.loads(capsys.readouterr().out)["comparison"]


@pytest.mark.parametrize(
    "event",
    [
        "X.ACS.ACT_POS > 7.3",
        "V.E.COUNT rises",
        "M10 @ MAIN.bDone rises",
        "part.nc:7 @ MAIN.bDone > 0.5",
        "X.ACS.ACT_POS>7.3 @ X.ACS.ACT_POS>7.3",
    ],
)
def test_the_log_lies_where_the_event_is(event: str, capsys: pytest.CaptureFixture[str]) -> None:
    """0.7 s: the log is the run, 700 samples of 1 ms later."""
    found = compared(capsys, "--align", event)
    assert found["alignment"]["offset_us"] == pytest.approx(700_000.0, abs=0.01)
    assert found["event"]["text"] == event
    assert found["event"]["apart_us"] == pytest.approx(1000.0)
    assert all(one["greatest"] == pytest.approx(0.0, abs=1e-9) for one in found["signals"])


def test_the_answer_says_by_what(capsys: pytest.CaptureFixture[str]) -> None:
    """Event, its time in the log, and how exact that is."""
    assert main(["compare", "log.csv", "part.nc", "--align", "V.E.COUNT rises"]) == 0
    text = capsys.readouterr().out
    assert "the run begins 0.700000 s after the log's zero (by V.E.COUNT rises: 0." in text
    assert "in the log, ± 1 ms)" in text


@pytest.mark.parametrize(
    ("words", "number"),
    [
        (("--align", "X.ACS.ACT_POS"), "902845"),
        (("--align", "M10"), "902845"),
        (("--align", "X.ACS.ACT_POS > much"), "902845"),
        (("--align", "X.ACS.ACT_POS > 99"), "902847"),
        (("--align", "M11 @ MAIN.bDone rises"), "902846"),
        (("--align", "M10 @ MAIN.bDo rises"), "902847"),
        (("--align", "X.ACS.ACT_PSO > 1"), "900545"),
        (("--align", "V.E.COUNT rises", "--offset", "0s"), "902848"),
    ],
)
def test_what_is_no_event(
    words: tuple[str, ...], number: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """Refused by name, with what would do."""
    assert main(["compare", "log.csv", "part.nc", *words]) == 2
    assert number in capsys.readouterr().err


def test_first_edges_by_hand() -> None:
    """From the second sample on; a curve between two samples, a number at its sample."""
    times, values = numpy.arange(5) * 1000.0, numpy.array([2.0, 0.0, 0.0, 4.0, 0.0])
    samples = Samples(times, values)
    rising = Edge("a", 1.0, True)
    assert rising.first(samples, is_whole=False) == (2250.0, 1000.0)
    assert rising.first(samples, is_whole=True) == (3000.0, 1000.0)
    assert Edge("a", 1.0, False).first(samples, is_whole=True) == (1000.0, 1000.0)
    assert Edge("a", 9.0, True).first(samples, is_whole=True) is None
    event = AligningEvent.of("M10 @ Gate [1] falls")
    assert (event.in_run, event.in_log) == ("M10", Edge("Gate [1]", 0.5, False))
    with pytest.raises(Failure):
        AligningEvent.of("X.ACS.ACT_POS > nan")
