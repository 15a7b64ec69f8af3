# SPDX-License-Identifier: MIT
"""``nctakt compare`` as a user meets it; the logs are runs of our own with known changes."""

from __future__ import annotations

import json
from pathlib import Path

import numpy
import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.comparison.mapping import read_mapping
from nctakt.files.access import FileAccess
from nctakt.run.controller import Controller

PART = "N10 G01 X100 Y50 F6000\nN20 X0\nN30 G04 0.2\nN40 Y0 X30\nN50 X80 F3000\nM30\n"
#: N40 begins after 1.226 + 1.025 + 0.2 s or so: what comes later than this is late in the log.
LATE_FROM_S = 2.6


@pytest.fixture(name="scope", autouse=True)
def _scope(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A log of 2 ms that begins 1.2345 s before the run; Y is 3 ms late in the end."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text(PART, "utf-8")
    trace = Controller().run("part.nc", signals=["X.ACS.ACT_POS", "Y.ACS.ACT_POS"]).trace
    ours = numpy.arange(trace.ticks) * 0.001
    stamps = numpy.arange(0.0, ours[-1] + 2.5, 0.002)
    in_run = stamps - 1.2345
    noise = numpy.random.default_rng(1).normal(0.0, 0.002, (2, len(stamps)))
    x = numpy.interp(in_run, ours, trace["X.ACS.ACT_POS"]) + noise[0]
    y = (
        numpy.interp(in_run - 0.003 * (in_run > LATE_FROM_S), ours, trace["Y.ACS.ACT_POS"])
        + noise[1]
    )
    rows = [
        f"{1000 * t:.3f}\t{a / 1000:.9f}\t{b:.6f}".replace(".", ",")
        for t, a, b in zip(stamps, x, y, strict=True)
    ]
    head = "Name\tcell\nFile\tD:\\a.csv\n\n\nName\tAxis X ActPos\tAxis Y ActPos\n"
    head += "Unit\tm (Length)\tmm (Length)\n\n"
    Path("scope.csv").write_text(head + "\n".join(rows) + "\nEOF\n", "utf-8")
    return tmp_path


def test_a_delay_is_found_with_its_block(capsys: pytest.CaptureFixture[str]) -> None:
    """Y is late by 3 ms from N40 on, at up to 91 mm/s: 0.26 mm; X is within its noise."""
    assert main(["compare", "scope.csv", "part.nc", "--tolerance", "0.05"]) == 1
    text = capsys.readouterr().out
    assert "the run begins 1.2345" in text
    assert "X.ACS.ACT_POS  Axis X ActPos*" in text
    assert "Y.ACS.ACT_POS leaves its tolerance first at 2." in text
    assert "block in part.nc:4" in text
    assert "from the block in part.nc:4 on" in text
    assert text.endswith("beyond the tolerances\n")


def test_ticks_earlier_or_later(capsys: pytest.CaptureFixture[str]) -> None:
    """Four ticks of 1 ms cover a delay of 3 ms, one does not."""
    assert main(["compare", "scope.csv", "part.nc", "--tolerance", "0.05+4ticks"]) == 0
    assert main(["compare", "scope.csv", "part.nc", "--tolerance", "0.05+1ticks"]) == 1
    capsys.readouterr()


def test_tolerances_mapping_and_data(capsys: pytest.CaptureFixture[str]) -> None:
    """A tolerance for each signal; the mapping's counts; the figures as JSON."""
    Path("map.toml").write_text(
        '[signals]\n"X.ACS.ACT_POS" = "Axis X ActPos"\n'
        '"Y.ACS.ACT_POS" = { log = "Axis Y ActPos", tolerance = "0.4" }\n',
        "utf-8",
    )
    words = ["compare", "scope.csv", "part.nc", "--map", "map.toml", "--format", "json"]
    assert main([*words, "--tolerance", "Y.ACS.ACT_POS=0.01", "--tolerance", "0.05"]) == 0
    found = json.loads(capsys.readouterr().out)["comparison"]
    assert found["within"] is True
    assert found["alignment"]["offset_us"] == pytest.approx(1_234_500.0, abs=20.0)
    x, y = found["signals"]
    assert (x["signal"], x["suggested"], x["block"]["file"]) == ("X.ACS.ACT_POS", False, "part.nc")
    assert abs(x["greatest"]) < 0.012
    assert y["greatest"] == pytest.approx(0.26, abs=0.02)
    assert y["first_us"] is None


def test_a_picture(capsys: pytest.CaptureFixture[str]) -> None:
    """Both curves and their difference; another suffix is refused before the run."""
    assert main(["compare", "scope.csv", "part.nc", "--plot", "both.svg", "--lang", "de"]) == 0
    text = Path("both.svg").read_text("utf-8")
    for word in ("Log", "Lauf", "Y.ACS.ACT_POS [mm]", "Zeit des Laufs in s"):
        assert word in text
    assert main(["compare", "scope.csv", "part.nc", "--plot", "both.html"]) == 2
    assert "901090" in capsys.readouterr().err


def test_our_own_trace_is_the_run(capsys: pytest.CaptureFixture[str]) -> None:
    """Signals have their names, the offset is known: no deviation at all."""
    signals = "X.ACS.ACT_POS,BLOCK"
    assert main(["run", "part.nc", "--quiet", "--trace", "t.csv", "--signals", signals]) == 0
    words = ["compare", "t.csv", "part.nc", "--offset", "0s", "--tolerance", "0", "--lang", "de"]
    assert main(words) == 0
    text = capsys.readouterr().out
    assert "0.000000 s nach dem Nullpunkt des Logs, wie angegeben; Drift 0.00 ppm\n" in text
    assert "innerhalb der Toleranzen" in text


@pytest.mark.parametrize(
    ("rises", "falls", "change", "reported"),
    [
        (1020, 0, ("run", 1.0, 20_000.0), "the run becomes 1 there, the log 20 ms later"),
        (980, 0, ("log", 1.0, 20_000.0), "the log becomes 1 there, the run 20 ms later"),
        (9999, 0, ("run", 1.0, None), "the run becomes 1 there, the log never does afterwards"),
        (1000, 1100, ("log", 0.0, None), "the log becomes 0 there, the run never does afterwards"),
        (1000, 0, None, ""),
    ],
)
def test_what_happens_on_one_side_or_at_another_time(
    rises: int,
    falls: int,
    change: tuple[str, float, float | None] | None,
    reported: str,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """A reaction makes V.E.COUNT 1 in tick 1000: later or earlier in the log, never, or back."""
    Path("part.nc").write_text("G04 X1\nV.E.COUNT = 1\nG04 X0.5\nM30\n", "utf-8")
    run = Controller().run("part.nc", signals=["V.E.COUNT"])
    begin = int(numpy.flatnonzero(numpy.array(run.trace["V.E.COUNT"]) == 1.0)[0])
    rows = [
        f"{tick};{int(tick - begin >= rises - 1000 and not 0 < falls <= tick - begin + 1000)}"
        for tick in range(run.ticks)
    ]
    Path("count.csv").write_text("time_ms;V.E.COUNT\n" + "\n".join(rows) + "\n", "utf-8")
    words = ["compare", "count.csv", "part.nc", "--offset", "0s", "--tolerance", "0"]
    assert main(words) == (0 if change is None else 1)
    assert reported in capsys.readouterr().out
    assert main([*words, "--format", "json"]) == (0 if change is None else 1)
    (found,) = json.loads(capsys.readouterr().out)["comparison"]["signals"]
    assert found["change"] == (
        None if change is None else dict(zip(("side", "value", "later_us"), change, strict=True))
    )


def test_columns_without_a_signal_are_named(capsys: pytest.CaptureFixture[str]) -> None:
    """Whoever does not see a curve in the answer reads why; the first ten of many."""
    table = [f"p{at};{at}" for at in range(12)]
    names, values = (";".join(one.split(";")[part] for one in table) for part in (0, 1))
    Path("wide.csv").write_text(f"t;X.ACS.ACT_POS;{names}\n0;0;{values}\n1;1;{values}\n", "utf-8")
    assert main(["compare", "wide.csv", "part.nc", "--offset", "0s"]) == 0
    text = capsys.readouterr().out
    assert (
        "columns of the log without a signal: p0, p1, p2, p3, p4, p5, p6, p7, p8, p9 … (12)\n"
        in text
    )
    assert main(["compare", "scope.csv", "part.nc"]) == 0
    assert "without a signal" not in capsys.readouterr().out


def test_a_given_drift(capsys: pytest.CaptureFixture[str]) -> None:
    """500 ppm beside each way to say where the run begins; a log of 4 s has none by itself."""
    for words, reported in (
        (["--offset", "1.2345s"], "1.234500 s after the log's zero, as given; drift"),
        (["--align", "X.ACS.ACT_POS > 10"], "ms); drift"),
        ([], "s after the log's zero, drift"),
    ):
        command = ["compare", "scope.csv", "part.nc", *words]
        assert main(command) == main([*command, "--drift", "-500"]) == 0
        without, given = capsys.readouterr().out.split("part.nc and scope.csv")[1:]
        assert f"{reported} 0.00 ppm" in without
        assert f"{reported} -500.00 ppm as given" in given


@pytest.mark.parametrize(
    ("text", "place", "marked"),
    [
        ("[signals]\nX = \n", ":2:5:", ""),
        ("[log]\ntime = 'ms'\ntimes = 5\n", ":3:1:", "times"),
        ("[signals]\nY = 'y'\n'X' = { log = 'x', factor = 'z' }\n", ":3:20:", "factor"),
        ("[signals.X]\nlog = 'x'\ntolerance = 'wide'\n", ":3:1:", "tolerance"),
        ("[other]\na = 1\n", ":1:2:", "other"),
    ],
)
def test_a_mistake_of_the_mapping_is_marked(
    tmp_path: Path, text: str, place: str, marked: str
) -> None:
    """902521: line, column and the entry itself."""
    path = tmp_path / "map.toml"
    path.write_text(text, "utf-8")
    with pytest.raises(Failure) as raised:
        read_mapping(path, FileAccess())
    (found,) = raised.value.diagnostics
    assert f"map.toml{place} error 902521" in found.headline()
    assert found.span is not None
    line = text.splitlines()[found.span.line - 1]
    assert not marked or line[found.span.column - 1 : found.span.end_column - 1] == marked


@pytest.mark.parametrize(
    ("words", "number"),
    [
        (["--drift", "1001"], 900908),
        (["--drift", "nan"], 900908),
        (["--tolerance", "wide"], 902529),
        (["--tolerance", "X.ACS.ACT_PO=1"], 900545),
        (["--map", "unit.toml"], 902518),
        (["--map", "column.toml"], 902520),
        (["--map", "key.toml"], 902521),
        (["--map", "part.nc"], 902521),
        (["--offset", "1h"], 902522),
    ],
)
def test_wrong_words(words: list[str], number: int, capsys: pytest.CaptureFixture[str]) -> None:
    """Each is reported before the run, or with what is wrong in it."""
    signal = '[signals]\n"X.ACS.ACT_POS" = '
    Path("unit.toml").write_text(f'{signal}{{ log = "Axis X ActPos", unit = "bar" }}', "utf-8")
    Path("column.toml").write_text(f'{signal}"Axis X ActPo"', "utf-8")
    Path("key.toml").write_text(f'{signal}{{ log = "Axis X ActPos", scale = 2 }}', "utf-8")
    assert main(["compare", "scope.csv", "part.nc", *words]) == 2
    assert str(number) in capsys.readouterr().err


def test_a_log_without_a_signal(capsys: pytest.CaptureFixture[str]) -> None:
    """902519 names the columns; 902527 those that look alike."""
    Path("other.csv").write_text("t,pressure,X act,X Istwert\n0,1,1,1\n1,2,2,2\n", "utf-8")
    assert main(["compare", "other.csv", "part.nc"]) == 2
    text = capsys.readouterr().err
    assert "902519" in text
    assert "902527" in text


def changed_log(
    name: str, *, late_s: float = 0.0, gain: float = 1.0, bias: float = 0.0, step_s: float = 0.002
) -> None:
    """A log of a step from 1.2345 s on: all late from N40 on, or with a gain and a bias."""
    trace = Controller().run("part.nc", signals=["X.ACS.ACT_POS", "Y.ACS.ACT_POS"]).trace
    assert trace is not None
    ours = numpy.arange(trace.ticks) * 0.001
    stamps = numpy.arange(0.0, ours[-1] + 2.5, step_s)
    # N30 is a dwell of 0.2 s: both axes are from 2.3 s to 2.4 s
    in_run = stamps - 1.2345
    in_run = numpy.where(in_run > 2.35, numpy.maximum(in_run - late_s, 2.35), in_run)
    cells = [
        gain * numpy.interp(in_run, ours, trace[signal]) + bias
        for signal in ("X.ACS.ACT_POS", "Y.ACS.ACT_POS")
    ]
    rows = "".join(f"{1000 * t:.2f},{x},{y}\n" for t, x, y in zip(stamps, *cells, strict=True))
    Path(name).write_text("time_ms,X.ACS.ACT_POS,Y.ACS.ACT_POS\n" + rows, "utf-8")


def test_a_delay_in_the_middle_does_not_move_the_beginning(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """All is 50 ms late from N40 on: the run begins at 1.2345 s, the first deviation is in N40."""
    changed_log("late.csv", late_s=0.05)
    words = ["compare", "late.csv", "part.nc", "--tolerance", "0.05", "--format", "json"]
    assert main(words) == 1
    found = json.loads(capsys.readouterr().out)["comparison"]
    assert found["alignment"]["offset_us"] == pytest.approx(1_234_500.0, abs=20.0)
    assert {one["block"]["line"] for one in found["signals"]} == {4}
    assert [one["block"]["line"] for one in found["delays"]] == [4]
    assert found["delays"][0]["jump_us"] == pytest.approx(50_000.0, abs=3_000.0)


@pytest.mark.parametrize(
    ("gain", "bias", "step_s"), [(1.01, 0.0, 0.002), (1.01, 0.0, 40e-6), (1.0, 0.5, 0.002)]
)
def test_gain_and_bias_are_no_delays(
    gain: float, bias: float, step_s: float, capsys: pytest.CaptureFixture[str]
) -> None:
    """Both are reported as such, and the log is nowhere late, however fast it is sampled."""
    changed_log("scaled.csv", gain=gain, bias=bias, step_s=step_s)
    assert main(["compare", "scaled.csv", "part.nc"]) == 0
    text = capsys.readouterr().out
    assert f"the log is {gain:.5f} times the run, {bias:.4g} beside it" in text
    assert " ms later than before" not in text
    assert " ms earlier than before" not in text


def test_a_delay_beside_a_gain(capsys: pytest.CaptureFixture[str]) -> None:
    """1 % too far and 3 ms late from N40 on, with 25 samples a tick: each is what it is."""
    changed_log("both.csv", gain=1.01, late_s=0.003, step_s=40e-6)
    assert main(["compare", "both.csv", "part.nc", "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)["comparison"]
    assert found["alignment"]["gain"] == pytest.approx(1.01, abs=1e-4)
    assert [one["block"]["line"] for one in found["delays"]] == [4]
    assert found["delays"][0]["jump_us"] == pytest.approx(3_000.0, rel=0.05)


def test_another_override_makes_the_begin_uncertain(capsys: pytest.CaptureFixture[str]) -> None:
    """A log at 80 % fits best where it does not begin: reported, but not with an event."""
    Path("slow.nc").write_text("G01 X100 F20000\nY50 F10000\nG00 X0 Y0\nM30\n", "utf-8")
    words = ["--signals", "X.ACS.ACT_POS,Y.ACS.ACT_POS", "--quiet"]
    assert main(["run", "slow.nc", "--trace", "slow.csv", "--set", "HLI.OVERRIDE=80", *words]) == 0
    capsys.readouterr()
    assert main(["compare", "slow.csv", "slow.nc"]) == 0
    assert "902849" in capsys.readouterr().err
    assert main(["compare", "slow.csv", "slow.nc", "--align", "X.ACS.ACT_POS > 1"]) == 0
    assert "902849" not in capsys.readouterr().err


def test_a_log_that_is_not_utf_8_is_compared(capsys: pytest.CaptureFixture[str]) -> None:
    """What reading finds out comes with the answer, not in its place; ``--quiet`` hides it."""
    changed_log("plain.csv")
    head, rest = Path("plain.csv").read_text("utf-8").split("\n", 1)
    Path("latin.csv").write_text(f"{head},Kühlung\n{rest}", "latin-1")
    assert main(["compare", "latin.csv", "part.nc"]) == 0
    shown = capsys.readouterr()
    assert "the run begins 1.234500 s" in shown.out
    assert "902526" in shown.err
    assert main(["compare", "latin.csv", "part.nc", "--quiet"]) == 0
    assert "902526" not in capsys.readouterr().err
