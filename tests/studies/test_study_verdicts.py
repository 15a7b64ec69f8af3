# SPDX-License-Identifier: MIT
"""Verdicts of studies: exact at a tick's edge, with what was instead, and what changes nothing.

The program dwells for 200 ms and ends in the tick after that, after 201 ms; M100 goes out in the
tick that begins when V.E.TRIGGER is set (RC-001, RC-002). So the margin between both, in whole
ticks of 1 ms, is 201 ms less the time of the trigger.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from nctakt.cli import main
from nctakt.studies.plans.plan import Plan
from nctakt.studies.runs.effects import without_effect
from nctakt.studies.study import Study

PROGRAM = """\
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF ONCE V.E.TRIGGER == 1
    M100
  $ENDIF
#RT CYCLE END
G04 0.2
M30
"""
END_MS = 201
TRIGGER = {"time_of": "V.E.TRIGGER = 1", "name": "at", "from": "150 ms", "to": "195 ms"}
MARGIN = {"margin": "duration - time of M100"}

Captured = pytest.CaptureFixture[str]


@pytest.fixture
def program(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """The program in the working directory."""
    monkeypatch.chdir(tmp_path)
    Path("a.nc").write_text(PROGRAM, "utf-8")
    return "a.nc"


def study(program: str, **entries: Any) -> Study:
    """A study of the time of the trigger, tick by tick."""
    return Study(**{"program": program, "vary": [{**TRIGGER, "step": "1 tick"}], **entries})


@pytest.mark.parametrize("margin_ms", [20, 21, 33])
def test_a_margin_of_whole_microseconds(program: str, margin_ms: int) -> None:
    """``margin > 20 ms`` does not hold at 20 ms, where the difference of the binary seconds is
    0.020000000000000018; ``=`` holds there and nowhere else."""
    plan = study(program, measure=MARGIN, expect=[f"margin > {margin_ms} ms"],
                 find=[{"boundary": "at"}])  # fmt: skip
    held, broken = plan.find()[0].rows
    assert (held["verdict"], broken["verdict"]) == ("passed", "failed")
    assert (held["at"], broken["at"]) == tuple(
        (END_MS - margin_ms - over) / 1000 for over in (1, 0)
    )
    assert broken["margin"] == margin_ms / 1000
    for text in (f"margin = {margin_ms} ms", f"margin = {margin_ms / 1000}"):
        rows = study(program, measure=MARGIN, expect=[text]).run().rows
        assert [row["at"] for row in rows if row["verdict"] == "passed"] == [broken["at"]]


@pytest.mark.parametrize(
    "text",
    [
        "time of M100 + 20 ms < duration",
        "time from M100 to ended > 0.02",
        "2 * (duration - time of M100) / 4 > 10 ms",
        "(duration - time of M100) / 20 ms > 1",
        "duration - called > 20 ms",
    ],
)
def test_what_is_computed_of_times_is_exact(program: str, text: str) -> None:
    """Sums, shares and a Python function that returns seconds: one switch-over, at 181 ms."""
    Path("late.py").write_text("def late(run):\n    return run.m_function(100).at\n", "utf-8")
    measure = {"called": "python late.py:late"}
    rows = study(program, measure=measure, expect=[text]).run().rows
    held = [row["at"] for row in rows if row["verdict"] == "passed"]
    assert held[-1] == (END_MS - 21) / 1000
    assert len(held) == END_MS - 21 - 150 + 1


def test_a_broken_run_names_what_was_instead(program: str) -> None:
    """Beside each expectation: the value, both values, the time of a reaction, what happened."""
    expected = {
        "margin > 20 ms": "0.011",
        "duration < time of M100": "0.201, 0.19",
        "V.E.TRIGGER > 0 within 100 ms": "0.191",
        "V.E.TRIGGER > 5 within 100 ms": "–",
        "time of M101 < 1 s": "–",
        "M100 before (V.E.TRIGGER < 1)": "0.19, 0",
        "M100 at 20ms": "M100 at 0.19 s, tick 190 (line 3)",
        "X = 5 at end": "X = 0",
    }
    vary = [{**TRIGGER, "values": ["190 ms"]}]
    del vary[0]["from"], vary[0]["to"]
    row = study(program, vary=vary, measure=MARGIN, expect=list(expected)).run().rows[0]
    assert row["broken"] == "; ".join(f"{text} ({found})" for text, found in expected.items())


def test_minimize_keeps_the_expectations(program: str, capsys: Captured) -> None:
    """The best point that holds, then the better one that does not; without any that holds
    901940 and exit code 1."""
    plan = """\
program = "a.nc"
expect = ["margin > LIMIT ms"]
find = [{minimize = "margin"}]
measure.margin = "duration - time of M100"
vary = [{time_of = "V.E.TRIGGER = 1", name = "at", from = "150 ms", to = "195 ms", step = "1 tick"}]
"""
    Path("plan.toml").write_text(plan.replace("LIMIT", "20"), "utf-8")
    assert main(["study", "plan.toml"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[1].endswith("margin = 0.021: passed")
    assert lines[3].endswith("margin = 0.006: failed: margin > 20 ms (0.006)")
    Path("plan.toml").write_text(plan.replace("LIMIT", "200"), "utf-8")
    assert main(["study", "plan.toml"]) == 1
    shown = capsys.readouterr()
    assert "margin = 0.006: failed: margin > 200 ms (0.006)" in shown.out
    assert "error 901940: " in shown.err


def test_a_dimension_without_effect_is_reported(program: str, capsys: Captured) -> None:
    """Alone and beside another one, on a grid and in a search; one that matters is not."""
    dead = {"acknowledge": "M9", "values": ["5 ms", "never"]}
    alive = {**TRIGGER, "step": "15 ms"}
    assert study(program, vary=[dead]).run().without_effect == ["M9"]
    assert study(program, vary=[alive, dead]).run().without_effect == ["M9"]
    assert study(program, vary=[dead, alive]).run().without_effect == ["M9"]
    assert study(program, vary=[{**dead, "values": ["5 ms"]}]).run().without_effect == []
    assert study(program, vary=[alive]).run().without_effect == []
    found = study(program, vary=[dead], measure=MARGIN, find=[{"boundary": "M9"}]).find()[0]
    assert found.without_effect == ("M9",)
    text = 'program = "a.nc"\n[[vary]]\nacknowledge = "M9"\nvalues = ["5 ms", "10 ms"]\n'
    Path("plan.toml").write_text(text, "utf-8")
    assert main(["study", "plan.toml", "--report", "page.html"]) == 0
    assert "warning 901941: M9 has no effect" in capsys.readouterr().err
    assert "M9 has no effect" in Path("page.html").read_text("utf-8")


@pytest.mark.parametrize("method", ["random", "latin"])
def test_by_chance_runs_are_made_again_for_each_dimension(
    program: str, method: str, capsys: Captured
) -> None:
    """No two runs differ in one dimension alone: M9, which nothing gives out, and a variable that
    nothing reads are reported; the trigger is not, nor anything where a repeated run differs."""
    dead = {"acknowledge": "M9", "from": "5 ms", "to": "50 ms"}
    chance = {"method": method, "count": 12, "seed": 3, "measure": MARGIN}
    idle = {"variable": "V.E.VALUE", "from": 0.0, "to": 1.0}
    own = study(program, vary=[TRIGGER, dead, idle], **chance)
    result = own.run()
    assert result.without_effect == []
    assert own.without_shown_effect(result) == [("M9", 8), ("V.E.VALUE", 8)]
    both = study(program, vary=[{**dead, "name": "a"}, {**dead, "acknowledge": "M8"}], **chance)
    assert both.run().without_effect == ["a", "M8"]
    assert both.without_shown_effect(both.run()) == []
    text = f'program = "a.nc"\nmethod = "{method}"\ncount = 4\n'
    text += '[[vary]]\nacknowledge = "M9"\nfrom = "5 ms"\nto = "50 ms"\n'
    text += '[[vary]]\nvariable = "V.E.VALUE"\nfrom = 0.0\nto = 1.0\n'
    text += '[[vary]]\ntime_of = "V.E.TRIGGER = 1"\nfrom = "150 ms"\nto = "195 ms"\n'
    Path("plan.toml").write_text(text, "utf-8")
    assert main(["study", "plan.toml", "--report", "page.html"]) == 0
    assert "warning 902061: M9 has shown no effect: 4 runs" in capsys.readouterr().err
    assert "M9 has shown no effect: 4 runs" in Path("page.html").read_text("utf-8")


def rows_of(*runs: tuple[int, int, str]) -> list[dict[str, Any]]:
    """Rows of runs: two inputs and the digest."""
    return [{"a": a, "b": b, "digest": digest} for a, b, digest in runs]


def test_which_runs_are_compared(program: str) -> None:
    """Those that differ in one dimension alone; without such, all, if all are the same."""
    vary = [{"variable": "V.E.VALUE", "name": name, "values": [1, 2]} for name in "ab"]
    plan: Plan = study(program, vary=vary).plan
    both = rows_of((1, 1, "x"), (2, 2, "x"), (3, 4, "x"))
    assert without_effect(plan, both) == ["a", "b"]
    assert without_effect(plan, [*both, *rows_of((4, 4, "y"))]) == []
    assert without_effect(plan, rows_of((1, 1, "x"), (1, 2, "y"), (2, 1, "x"), (2, 2, "y"))) == [
        "a"
    ]
    assert without_effect(plan, rows_of((1, 1, "x"), (1, 2, "x"), (2, 1, "x"), (2, 2, "y"))) == []
    assert without_effect(plan, rows_of((1, 1, ""), (2, 1, ""))) == []


def test_times_by_chance_are_whole_ticks(program: str) -> None:
    """Without a step: what lies between two ticks would do what the next one does."""
    spans = [
        {"acknowledge": "M100", "from": "0 ms", "to": "20 ms"},
        {"plc_dies": "yes", "from": "10 ms", "to": "90.5 ms"},
        dict(TRIGGER),
    ]
    plan = study(program, vary=spans, method="random", count=40, seed=3).plan
    points = [plan.point(index) for index in range(40)]
    assert all(int(value) % 1000 == 0 for point in points for value in point)
    assert len({point[0] for point in points}) > 10
    dimension = plan.dimensions[0]
    assert (dimension.between(0.0), dimension.between(1.0)) == (0, 20_000)
    assert plan.dimensions[1].between(1.0) == 90_000


@pytest.mark.nightly
def test_an_unchanged_run_that_is_broken_already(program: str, capsys: Captured) -> None:
    """901942 is before the results; what is about the injection is not judged without it."""
    words = ["study", program, "--each-tick", "V.E.TRIGGER=1 for 2 ms"]
    code = main([*words, "--expect", "M100 never", "--expect", "duration < 0.1",
                 "--expect", "V.E.TRIGGER > 0 within 5 ms"])  # fmt: skip
    assert code == 1
    shown = capsys.readouterr()
    first = shown.err.splitlines()[0]
    assert first == (
        "warning 901942: the run without any injection already fails: duration < 0.1 (0.201)"
    )
    assert main([*words, "--expect", "V.E.TRIGGER > 0 within 5 ms", "--quiet"]) == 0
    assert "901942" not in capsys.readouterr().err


def test_a_noise_is_no_command_of_a_thousand_words(program: str, capsys: Captured) -> None:
    """The run is named by its number, and by its tape; so is a ramp."""
    noise = {"noise": "V.E.VALUE", "amount": 1, "for": "100 ms", "values": [1, 2]}
    assert study(program, vary=[noise]).command(0) is None
    assert study(program, vary=[{**noise, "for": "5 ms"}]).command(0) is not None
    text = f'program = "{program}"\nexpect = ["M100 once"]\n[[vary]]\n'
    text += 'noise = "V.E.VALUE"\namount = 1\nfor = "0.1 s"\nvalues = [1]\n'
    Path("plan.toml").write_text(text, "utf-8")
    assert main(["study", "plan.toml"]) == 1
    out = capsys.readouterr().out
    assert "--at" not in out
    assert "    nctakt study plan.toml --only 0 --record tapes\n" in out
    Path("plan.toml").write_text(
        text + '[measure]\nlong = "duration"\n[[find]]\nmaximize = "long"\n', "utf-8"
    )
    main(["study", "plan.toml"])
    assert "    nctakt study plan.toml --record tapes\n" in capsys.readouterr().out
