# SPDX-License-Identifier: MIT
"""What notebooks show: tables, curves and pictures, with nothing of a program as HTML."""

from __future__ import annotations

import importlib.util
import sys
import types
from typing import Any

import pytest

from nctakt.base.notebook import curve
from nctakt.base.notebook_progress import NotebookProgress, notebook_progress
from nctakt.results.run import ExplainedRun
from nctakt.run.controller import Controller, NcText
from nctakt.session.session import Session
from nctakt.studies.study import Study

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
$IF EDGE V.RTA.ACS.ACT_POS.X > 1 && V.E.COUNT < 5 ; <b>
M100
$ENDIF
#RT CYCLE END
G01 X5 F6000
M30
"""


@pytest.fixture(scope="module")
def run() -> ExplainedRun:
    return Controller().run(NcText("<i>.nc", PROGRAM), why=True)


def is_escaped(page: str) -> bool:
    return not {"<b>", "<i>"} & {page[at : at + 3] for at in range(len(page))}


def test_a_trace_shows_its_signals_with_curves(run: ExplainedRun) -> None:
    """Unit, range and last value of each: after a tick X is at 4000 mm/s² · (1 ms)² / 2."""
    page = run.trace._repr_html_()
    row = next(one for one in page.split("<tr>") if ">X.ACS.ACT_POS<" in one)
    assert [cell.split("<")[0] for cell in row.split('left">')[1:6]] == [
        "X.ACS.ACT_POS",
        "mm",
        "0.002",
        "5",
        "5",
    ]
    assert "<polygon" in row


def test_curves_of_constants_are_level() -> None:
    """No division by a range of nothing."""
    assert "23.0" in curve([2.0, 2.0], [2.0, 2.0])


def test_a_why_report_shows_its_branches(run: ExplainedRun) -> None:
    """The line as it is, its counts, when its body ran, and that on a strip."""
    page = run.why._repr_html_()
    assert "V.RTA.ACS.ACT_POS.X &gt; 1 &amp;&amp; V.E.COUNT &lt; 5" in page
    assert is_escaped(page)
    (ran,) = run.why.cycles[0].branches[0].bodies.series
    assert f">0.0{ran.first_tick} s<" in page
    assert page.count("<rect") == 2


needs_matplotlib = pytest.mark.skipif(
    importlib.util.find_spec("matplotlib") is None, reason="needs matplotlib (extra plot)"
)


@needs_matplotlib
@pytest.mark.nightly
def test_a_run_gives_a_figure(run: ExplainedRun) -> None:
    """Without a file it is one of matplotlib, with the chosen signals."""
    from matplotlib.figure import Figure  # noqa: PLC0415 - an extra

    figure = run.plot(signals=["X.ACS.ACT_POS"])
    assert isinstance(figure, Figure)
    lines = [line for axes in figure.get_axes() for line in axes.get_lines()]
    assert any(max(line.get_ydata(), default=0) == 5 for line in lines)


@needs_matplotlib
@pytest.mark.nightly
def test_a_run_shows_a_picture(run: ExplainedRun) -> None:
    """A picture below the table, the same as the figure shows."""
    page = run._repr_html_()
    assert page.count('<img src="data:image/png;base64,') == 1
    assert is_escaped(page)
    assert run.plot()._repr_png_().startswith(b"\x89PNG")


@pytest.mark.nightly
def test_a_session_shows_where_it_is() -> None:
    """State, tick and time, block, cycles."""
    with Session(NcText("part.nc", PROGRAM)) as session:
        session.step(10)
        page = session._repr_html_()
    assert ">10, 0.01 s<" in page
    assert ">part.nc:6:1<" in page
    assert ">PROG<" in page


@needs_matplotlib
@pytest.mark.nightly
def test_a_session_shows_the_picture_of_its_run() -> None:
    """That of the run up to here: at the end the same as the run's; none before the first tick."""
    program = NcText("part.nc", PROGRAM)
    with Session(program) as session:
        assert "<img" not in session._repr_html_()
        session.run()
        page = session._repr_html_()
    assert page.count('<img src="data:image/png;base64,') == 1
    assert page.endswith(Controller().run(program, blocks=True).html_picture())


@pytest.mark.slow
def test_a_result_of_a_study_shows_counts_and_pictures() -> None:
    """What was asked for, a histogram, the rows that failed; texts escaped."""
    study = Study(
        program=NcText("move.nc", "G01 X100 F6000 M30"),
        vary=[{"variable": "HLI.OVERRIDE", "values": [50, 100]}],
        measure={"time": "duration"},
        expect=["time < 1.5 s"],
    )
    page = study.run()._repr_html_()
    assert "1 passed" in page
    assert "time &lt; 1.5 s" in page
    assert page.count("<svg") == 1
    assert "<body" not in page


def test_progress_is_shown_in_notebooks_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """After two seconds, updated in place, removed at the end."""
    assert notebook_progress("Run") is None
    shown: list[str] = []

    class Handle:
        def update(self, page: str) -> None:
            shown.append(page)

    def display(page: str, *, display_id: bool) -> Handle:
        assert display_id
        shown.append(page)
        return Handle()

    module: Any = types.ModuleType("IPython")
    module.display = types.SimpleNamespace(HTML=str, display=display)
    module.get_ipython = lambda: types.SimpleNamespace(kernel=1)
    monkeypatch.setitem(sys.modules, "IPython", module)
    assert notebook_progress("Run") is not None
    now = [0.0]
    progress = NotebookProgress("<Run>", lambda: now[0])
    progress.show(1, 10)
    assert shown == []
    for now[0] in (2.0, 2.1, 3.0):
        progress.show(5, 10)
    progress.close()
    assert len(shown) == 3
    assert shown[0] == '&lt;Run&gt;: <progress max="10" value="5"></progress> 5 / 10'
    assert shown[-1] == ""
