# SPDX-License-Identifier: MIT
"""The curves of a picture are what the axes did; the picture is the same for the same run."""

from __future__ import annotations

from pathlib import Path

import numpy
import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.plots.motion import (
    ACCELERATION,
    JERK,
    SPEED,
    Curve,
    Motion,
    motion_of,
    signals,
    thinned,
)
from nctakt.plots.picture import check_picture, write_picture
from nctakt.run.controller import Controller, NcText
from nctakt.schedule.open_schedule import open_schedule
from nctakt.trace.reading import read_trace

pytestmark = pytest.mark.slow

PART = """\
#RT CYCLE [ID = 17 SCOPE = PROG]
$IF ONCE V.RTA.ACS.ACT_POS.X > 5
M100
$ENDIF
#RT CYCLE END
G00 X20
G01 X10 Y10 Z5 F6000
M101
M30
"""


def motion(text: str) -> Motion:
    """The curves of a program on the demo machine."""
    controller = Controller()
    axes = controller.channel_axes
    run = controller.run(NcText("part.nc", text), signals=signals([axis.name for axis in axes]))
    assert run.trace is not None
    return motion_of(run.trace, axes, limits_jerk=controller.has_limited_jerk)


def test_the_jerk_has_a_limit_where_the_slope_gives_it_one() -> None:
    """MO-2: 4000 mm/s² in 50 ms; the axis keeps to it, and a trapezoid draws no line."""
    axis = motion("#SLOPE [TYPE=TRAPEZ]\nG00 X20\nM30\n").axes[0]
    assert axis.limits == (500.0, 4000.0, 80_000.0)
    assert abs(axis.derivatives[JERK - 1].values).max() == pytest.approx(80_000.0)
    assert motion("G00 X20\nM30\n").axes[0].limits == (500.0, 4000.0, 0.0)


def test_speed_acceleration_and_jerk_are_those_of_the_positions() -> None:
    """G00 X20: 4000 mm/s² up and down, 0.1414 s; each difference stands in its middle."""
    axis = motion("G00 X20\nM30\n").axes[0]
    assert (axis.name, axis.unit, axis.moves) == ("X", "mm", True)
    assert axis.position.time_s[0] == pytest.approx(0.001)
    speed, acceleration, jerk = axis.derivatives
    assert len(speed.values) == len(axis.position.values) - 1
    # From 1 ms to 2 ms the axis goes from 0.002 mm to 0.008 mm.
    assert speed.time_s[0] == pytest.approx(0.0015)
    assert speed.values[0] == pytest.approx(6.0)
    assert acceleration.time_s[0] == pytest.approx(0.002)
    assert acceleration.values[:60] == pytest.approx(4000.0)
    assert abs(jerk.values[:60]).max() < 1.0
    assert axis.limits[SPEED - 1] == 500.0
    assert axis.limits[ACCELERATION - 1] == 4000.0
    assert len(axis.derivatives) == JERK


def test_what_happened_has_a_lane_each() -> None:
    """Reactions, M and H functions of both sides, the program's end."""
    lanes = motion(PART).lanes
    assert [(lane.kind, lane.label, len(lane.spans)) for lane in lanes] == [
        ("fired", "17: 2", 1),
        ("M", "M100", 1),
        ("output", "M101", 1),
        ("end", "end", 1),
    ]
    # √(2·5/4000) s are 50 ms: X is at 5 mm behind tick 49, beyond it behind tick 50.
    assert lanes[0].spans == ((pytest.approx(0.051), pytest.approx(0.051)),)


def test_what_goes_on_from_tick_to_tick_is_one_span() -> None:
    """X is beyond 1 mm from 22.4 ms on; M100 goes out in each tick as long as there is room."""
    text = PART.replace("$IF ONCE V.RTA.ACS.ACT_POS.X > 5", "$IF V.RTA.ACS.ACT_POS.X > 1")
    lane = next(one for one in motion(text).lanes if one.label == "M100")
    assert len(lane.spans) == 1
    begin, end = lane.spans[0]
    assert begin == pytest.approx(0.023)
    assert end > 0.2


def test_a_starved_queue_is_a_span() -> None:
    """The decoder comes in each fifth NC cycle: nothing is there in tick 4, 9 and 14."""
    folder = Path(__file__).parent.parent / "runs" / "rtconf_starved_decoder"
    controller = Controller(None, open_schedule(folder / "rtconf.lis", folder / "load.toml"))
    axes = controller.channel_axes
    run = controller.run(folder / "program.nc", signals=signals([axis.name for axis in axes]))
    assert run.trace is not None
    lanes = motion_of(run.trace, axes).lanes
    assert [(lane.label, len(lane.spans)) for lane in lanes] == [("starved", 3), ("end", 1)]
    assert lanes[0].spans[0] == (pytest.approx(0.004), pytest.approx(0.005))


def test_a_modulo_axis_runs_on() -> None:
    """No jump where the position that is shown begins anew."""
    axis = motion("G00 A700\nM30\n").axes[3]
    assert axis.unit == "°"
    assert axis.position.values[-1] - axis.position.values[0] == pytest.approx(700.0, abs=0.1)
    assert abs(axis.derivatives[0].values).max() <= 360.1


def test_many_points_are_thinned_to_the_lowest_and_highest_of_each_piece() -> None:
    """A peak of one tick stays in the picture."""
    values = numpy.zeros(100_000)
    values[54_321] = 1.0
    few = thinned(Curve(numpy.arange(100_000.0), values), 1000)
    assert len(few.values) <= 1000
    assert few.values.max() == 1.0
    assert few.time_s[few.values.argmax()] == 54_321.0


@pytest.mark.slow
@pytest.mark.parametrize("ending", ["png", "svg", "html"])
def test_the_same_run_gives_the_same_bytes(tmp_path: Path, ending: str) -> None:
    """Each format; no time, no number of the process in it."""
    curves = motion(PART)
    for name in ("one", "two"):
        write_picture(curves, tmp_path / f"{name}.{ending}", "part.nc", "en")
    data = (tmp_path / f"one.{ending}").read_bytes()
    assert data == (tmp_path / f"two.{ending}").read_bytes()
    assert len(data) > 10_000


@pytest.mark.slow
@pytest.mark.parametrize("ending", ["png", "svg", "html"])
@pytest.mark.parametrize("title", ["a$b$.nc", "$", "<b>&.nc", "部品.nc", "\udcff\n.nc", "{x}"])
def test_a_title_is_text_and_nothing_else(tmp_path: Path, title: str, ending: str) -> None:
    """No formula, no tag, no sign that the font has to have."""
    path = tmp_path / f"part.{ending}"
    write_picture(motion("G00 X1\nM30\n"), path, title, "en")
    if ending == "html":
        assert "<b>" not in path.read_text("utf-8")
        if title == "<b>&.nc":
            assert "<title>&lt;b&gt;&amp;.nc</title>" in path.read_text("utf-8")


def test_a_run_without_motion_has_a_picture(tmp_path: Path) -> None:
    """It says that no axis moved."""
    curves = motion("M100\nM30\n")
    assert not any(axis.moves for axis in curves.axes)
    write_picture(curves, tmp_path / "still.svg", "part.nc", "de")
    assert (tmp_path / "still.svg").exists()


def test_pictures_have_one_of_three_endings() -> None:
    """Another one is refused before the run (900635)."""
    with pytest.raises(Failure) as caught:
        check_picture("motion.pdf")
    assert [one.id for one in caught.value.diagnostics] == [900635]


def test_the_command_draws_and_leaves_the_trace_as_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """``--plot`` beside ``--trace``: the trace has the signals that it has without a picture."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text(PART, encoding="utf-8")
    assert main(["run", "part.nc", "--quiet", "--trace", "plain.csv"]) == 0
    assert main(["run", "part.nc", "--quiet", "--trace", "both.csv", "--plot", "part.svg"]) == 0
    assert Path("both.csv").read_bytes() == Path("plain.csv").read_bytes()
    assert Path("part.svg").read_text("utf-8").startswith("<?xml")
    words = ["--signals", "X.ACS.ACT_POS", "--trace", "one.csv", "--plot", "part.html"]
    assert main(["run", "part.nc", "--quiet", *words]) == 0
    assert list(read_trace(Path("one.csv"))) == ["X.ACS.ACT_POS"]


@pytest.mark.parametrize(("name", "number"), [("part.gif", 900635), ("no/part.png", 900507)])
def test_a_picture_that_cannot_be_is_told_before_the_run(
    name: str,
    number: int,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Exit code 2, no message of the program."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text('#MSG ["hello"]\nM30\n', encoding="utf-8")
    assert main(["run", "part.nc", "--plot", name]) == 2
    out, err = capsys.readouterr()
    assert str(number) in err
    assert "hello" not in out
