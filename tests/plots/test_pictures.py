# SPDX-License-Identifier: MIT
"""What a picture of a run shows, in each format; the same run gives the same bytes."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from support.runs_to_draw import PART, drawn, timeline

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.plots.lanes import Bar, joined
from nctakt.plots.page import MAX_POINTS
from nctakt.plots.picture import check_picture
from nctakt.plots.scene import Scene, scene_of
from nctakt.results.run import Run
from nctakt.results.trace.reading import read_trace
from nctakt.run.controller import Controller, NcText

pytestmark = pytest.mark.slow


def scene(run: Run, chosen: list[str] | None = None) -> Scene:
    """What the pictures of a run show."""
    assert run.trace is not None
    axes = Controller().channel_axes
    return scene_of(
        run.trace,
        timeline(run),
        axes,
        limits_jerk=False,
        chosen=chosen,
        title="part.nc",
        language="en",
    )


def page_data(path: Path) -> dict[str, object]:
    """The data of a page."""
    found = re.search(r'id="run">(.*?)</script>', path.read_text("utf-8"), re.DOTALL)
    assert found is not None
    data: dict[str, object] = json.loads(found[1])
    return data


def test_by_default_the_motion_and_what_conditions_read_are_drawn() -> None:
    """Panels without a change are left out: V.E.COUNT stays 0."""
    picture = scene(drawn())
    titles = [panel.title for panel in picture.panels]
    assert titles == ["position", "speed", "acceleration", "jerk", "override", "distance to go"]
    assert "constant: V.E.COUNT" in picture.notes
    changed = PART.replace("M100", "V.E.COUNT += 2")
    assert scene(drawn(changed)).panels[-1].title == "V.E.COUNT"


def test_signals_choose_what_is_drawn() -> None:
    """Those of one unit share a panel; a signal of 0 and 1 is a lane."""
    run = drawn()
    picture = scene(run, ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "PATH.RAPID", "V.E.COUNT"])
    assert [[line.name for line in panel.lines] for panel in picture.panels] == [
        ["X.ACS.ACT_POS", "Y.ACS.ACT_POS"],
    ]
    assert [lane.label for lane in picture.lanes if lane.kind == "signal"] == [
        "PATH.RAPID",
        "V.E.COUNT",
    ]


def test_reactions_have_numbers_on_the_path() -> None:
    """Each mark is where the axes were when the reaction began."""
    path = scene(drawn()).path
    assert path is not None
    assert path.axes == ("X", "Y", "Z")
    assert [mark.number for mark in path.marks] == [1, 2]
    assert path.marks[0].point[0] == pytest.approx(5.0, abs=0.3)


def test_feed_and_rapid_motion_are_reported_apart() -> None:
    """G00, then G01."""
    path = scene(drawn()).path
    assert path is not None
    assert [is_rapid for is_rapid, _ in path.stretches()] == [True, False]


def test_a_reaction_lies_over_its_condition() -> None:
    """One lane for both."""
    lanes = {lane.label: lane for lane in scene(drawn()).lanes}
    lane = lanes["17: 5"]
    assert lane.number == 2
    assert lane.background[0].begin_s == lane.bars[0].begin_s
    assert lanes["M100"].bars[0].name == "M100"


def test_bars_close_together_are_joined() -> None:
    """No more bars than can be seen, and how many each represents."""
    bars = [Bar(i / 1000, i / 1000 + 0.0005, "x") for i in range(10_000)]
    few, are_joined = joined(bars, 100, 10.0)
    assert are_joined
    assert len(few) <= 100
    assert few[0].name.endswith(" ×")


@pytest.mark.nightly
@pytest.mark.parametrize("suffix", ["png", "svg", "html"])
def test_the_same_run_gives_the_same_bytes(tmp_path: Path, suffix: str) -> None:
    """Each format; no time, no number of the process in it."""
    for name in ("one", "two"):
        drawn().plot(tmp_path / f"{name}.{suffix}")
    data = (tmp_path / f"one.{suffix}").read_bytes()
    assert data == (tmp_path / f"two.{suffix}").read_bytes()
    assert len(data) > 10_000


@pytest.mark.parametrize("suffix", [".svg", ".png"])
def test_settings_of_the_working_directory_change_no_picture(tmp_path: Path, suffix: str) -> None:
    """A "matplotlibrc" may be anybody's: TeX would be run, and the same run drawn otherwise."""
    (tmp_path / "part.nc").write_text(PART, "utf-8")
    (tmp_path / "matplotlibrc").write_text("text.usetex: True\nlines.linewidth: 9\n", "utf-8")
    (tmp_path / "empty").mkdir()
    environment = {name: value for name, value in os.environ.items() if name != "MATPLOTLIBRC"}
    words = (sys.executable, "-P", "-m", "nctakt", "run", str(tmp_path / "part.nc"), "--quiet")
    pictures = []
    for folder in (tmp_path, tmp_path / "empty"):
        picture = folder / f"part{suffix}"
        done = [*words, "--plot", str(picture)]
        subprocess.run(done, cwd=folder, env=environment, check=True, timeout=120)
        pictures.append(picture.read_bytes())
    assert pictures[0] == pictures[1]


@pytest.mark.nightly
@pytest.mark.parametrize("suffix", ["png", "svg", "html"])
@pytest.mark.parametrize(
    "title", ["a$b$.nc", "$", "<b>&.nc", "部品.nc", "\udcff\n.nc", "{x}", "</script>.nc"]
)
def test_a_title_is_text_and_nothing_else(tmp_path: Path, title: str, suffix: str) -> None:
    """No formula, no tag, no sign that the font has to have."""
    path = tmp_path / f"part.{suffix}"
    Controller().run(NcText(title, "G00 X1\nM30\n")).plot(path)
    if suffix == "html":
        text = path.read_text("utf-8")
        assert "<b>" not in text
        assert text.count("</script>") == 2
        if title == "<b>&.nc":
            assert "<title>&lt;b&gt;&amp;.nc</title>" in text


def test_texts_of_a_program_cannot_end_the_script_of_the_page(tmp_path: Path) -> None:
    """A message with a tag is data."""
    drawn('#MSG ["</script><b>"]\nM30\n').plot(tmp_path / "part.html")
    assert (tmp_path / "part.html").read_text("utf-8").count("</script>") == 2
    assert "</script><b>" in str(page_data(tmp_path / "part.html")["texts"])


def test_a_page_needs_no_network(tmp_path: Path) -> None:
    """It loads nothing, and its policy forbids it."""
    drawn().plot(tmp_path / "part.html")
    text = (tmp_path / "part.html").read_text("utf-8")
    assert "default-src 'none'" in text
    assert not re.search(r"https?://|\bsrc=|\bhref=|@import|fetch\(", text)


def test_a_long_run_has_a_page_of_bounded_size(tmp_path: Path) -> None:
    """The lowest and highest value of each piece, and a note that says so."""
    run = drawn(f"G04 {2 * MAX_POINTS / 1000}\nG01 X1 F60\nM30\n")
    run.plot(tmp_path / "part.html", signals=["X.ACS.ACT_POS"])
    assert (tmp_path / "part.html").stat().st_size < 1_000_000
    assert "lowest and highest value of each 5 ticks" in (tmp_path / "part.html").read_text("utf-8")


def test_pictures_speak_german(tmp_path: Path) -> None:
    """Labels of panels, lanes and of the viewer."""
    drawn().plot(tmp_path / "part.html", language="de")
    text = (tmp_path / "part.html").read_text("utf-8")
    for word in ("Geschwindigkeit", "Programmende", "ganzer Lauf", "Eilgang", "in Ruhe: A"):
        assert word in text


def test_channels_have_lanes_and_signals_of_their_own(tmp_path: Path) -> None:
    """Names begin with the channel; the path is that of the first one."""
    folder = Path(__file__).parent.parent / "runs" / "two_channels"
    words = ["run", str(folder / "one.nc"), "--channel", "2", str(folder / "two.nc"), "--quiet"]
    files = ["--plot", str(tmp_path / "a.html"), "--vcd", str(tmp_path / "a.vcd")]
    assert main([*words, "--machine", str(folder / "machine"), *files]) == 0
    lanes = page_data(tmp_path / "a.html")["lanes"]
    assert isinstance(lanes, list)
    labels = [lane["label"] for lane in lanes]
    assert labels[:2] == ["block CH1", "block CH2"]
    assert not any("CYCLES.ACTIVE" in label for label in labels)


def test_a_run_without_motion_has_a_picture(tmp_path: Path) -> None:
    """It says that no axis moved."""
    run = drawn("M100\nM30\n")
    picture = scene(run)
    assert picture.path is None
    assert "no axis moved" in picture.notes
    run.plot(tmp_path / "still.svg", language="de")
    run.plot(tmp_path / "still.html")
    assert (tmp_path / "still.svg").exists()


def test_pictures_have_one_of_three_suffixes() -> None:
    """Another one is refused before the run (900635)."""
    with pytest.raises(Failure) as caught:
        check_picture("motion.pdf")
    assert [one.id for one in caught.value.diagnostics] == [900635]


@pytest.mark.parametrize(
    ("run", "signals", "number"),
    [
        (lambda: Controller().run(NcText("p.nc", "M30\n"), memory_trace=False), None, 901091),
        (lambda: Controller().run(NcText("p.nc", "M30\n")), ["V.E.COUNT"], 901092),
    ],
)
def test_what_was_not_recorded_cannot_be_drawn(
    run: object, signals: list[str] | None, number: int, tmp_path: Path
) -> None:
    """The message says how to record it."""
    assert callable(run)
    with pytest.raises(Failure) as caught:
        run().plot(tmp_path / "part.html", signals=signals)
    assert [one.id for one in caught.value.diagnostics] == [number]
    assert not list(tmp_path.iterdir())


FILES = ["--plot", "part.html", "--vcd", "part.vcd", "--perfetto", "part.json"]


def test_pictures_leave_trace_and_tape_as_they_are(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Beside ``--plot`` the trace has the signals and events that it has without a picture."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text(PART, encoding="utf-8")
    run = ["run", "part.nc", "--quiet", "--machine", "demo"]
    assert main([*run, "--trace", "plain.csv", "--record", "plain.tape"]) == 0
    assert main([*run, "--trace", "both.csv", "--record", "both.tape", *FILES]) == 0
    assert Path("both.csv").read_bytes() == Path("plain.csv").read_bytes()
    assert Path("both.tape").read_bytes() == Path("plain.tape").read_bytes()
    page = Path("part.html").read_bytes()
    assert main(["replay", "both.tape", "--quiet", *FILES]) == 0
    assert Path("part.html").read_bytes() == page
    words = ["--signals", "X.ACS.ACT_POS", "--trace", "one.csv", "--plot", "part.svg"]
    assert main([*run, *words]) == 0
    assert list(read_trace(Path("one.csv"))) == ["X.ACS.ACT_POS"]
    assert main([*run, "--trace", "blocks.csv", "--blocks", *FILES]) == 0
    assert "acknowledged M 100" in Path("blocks.csv").read_text("utf-8")


def test_the_signals_of_the_project_are_drawn(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """``signals`` of nctakt.toml; ``--signals`` wins over it."""
    monkeypatch.chdir(tmp_path)
    Path("nctakt.toml").write_text('signals = ["PATH.SPEED"]\n', encoding="utf-8")
    Path("part.nc").write_text(PART, encoding="utf-8")
    titles = []
    for words in ([], ["--signals", "Y.ACS.ACT_POS"]):
        assert main(["run", "part.nc", "--quiet", "--plot", "part.html", *words]) == 0
        panels = page_data(Path("part.html"))["panels"]
        assert isinstance(panels, list)
        titles.append([line["name"] for panel in panels for line in panel["lines"]])
    assert titles == [["PATH.SPEED"], ["Y.ACS.ACT_POS"]]


@pytest.mark.parametrize(
    ("words", "number"),
    [
        (["--plot", "part.gif"], 900635),
        (["--plot", "no/part.png"], 900507),
        (["--vcd", "part.txt"], 901090),
        (["--perfetto", "part.vcd"], 901090),
        (["--plot", "part.nc.svg", "--signals", "X.NONE"], 900544),
        (["--vcd", "a.vcd", "--perfetto", "a.vcd.json", "--trace", "a.vcd"], 900914),
    ],
    ids=str,
)
def test_a_picture_that_cannot_be_is_reported_before_the_run(
    words: list[str],
    number: int,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Exit code 2, no message of the program."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text('#MSG ["hello"]\nM30\n', encoding="utf-8")
    assert main(["run", "part.nc", *words]) == 2
    out, err = capsys.readouterr()
    assert str(number) in err
    assert "hello" not in out
    assert sorted(path.name for path in tmp_path.iterdir()) == ["part.nc"]
