# SPDX-License-Identifier: MIT
"""The report of a study, its sensitivities, and the study as a test."""

from __future__ import annotations

import base64
import os
import re
from importlib.metadata import entry_points
from pathlib import Path
from xml.etree import ElementTree

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.messages.files import NOT_A_REGULAR_FILE
from nctakt.studies.plans.verdicts import limits_of, wilson
from nctakt.studies.report import sensitivities
from nctakt.studies.rows.results import StreamedRows, read_rows, write_rows
from nctakt.studies.runs.study_runner import Row
from nctakt.studies.study import Study

pytest_plugins = ["pytester"]

PLAN = """\
program = "part.nc"
until = "3 s"
expect = ["duration < 1.2 s"]
[measure]
time = "duration"
late = "time of M100"
[[vary]]
name = "override"
variable = "HLI.OVERRIDE"
from = 40
to = 100
step = 10
[[vary]]
variable = "V.E.VALUE"
values = [1, 2, 3]
"""


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """A plan of 21 runs with its program."""
    (tmp_path / "part.nc").write_text("G01 X100 F6000\nM30\n")
    path = tmp_path / "plan.toml"
    path.write_text(PLAN)
    return path


def test_the_page_has_its_plan(plan: Path) -> None:
    """Whoever reads the page later knows what was varied; characters of HTML are escaped."""
    page = plan.with_name("page.html")
    main(["study", str(plan), "--report", str(page), "--quiet", "-j", "1"])
    assert f"<pre>{PLAN.replace('<', '&lt;').replace(chr(34), '&quot;')}</pre>" in page.read_text()


def test_the_page_stands_alone(plan: Path) -> None:
    """All pictures are well-formed SVG; nothing is fetched and nothing is run."""
    page, rows = plan.with_name("page.html"), plan.with_name("rows.csv")
    words = ["study", str(plan), "--out", str(rows), "--report", str(page), "--quiet", "-j", "1"]
    assert main(words) == 1
    text = page.read_text("utf-8")
    for svg in re.findall(r"<svg.*?</svg>", text):
        ElementTree.fromstring(svg)
    for heading in ("Measures", "Pairs of inputs", "Sensitivities", "Failed runs"):
        assert f"<h2>{heading}</h2>" in text
    assert "<script" not in text
    assert "http" not in text
    again = plan.with_name("again.html")
    assert main(["study", "report", str(plan), str(rows), "--report", str(again)]) == 0
    assert again.read_text("utf-8").count("<svg") == text.count("<svg")


def test_the_page_has_pictures_of_extreme_runs(plan: Path) -> None:
    """One of each run with a least or greatest value; the same from the rows of a file.

    With ``--record``, there are tapes of these, too: ``test_tapes_of_extreme_runs``.
    """
    pytest.importorskip("matplotlib")
    page, rows = plan.with_name("page.html"), plan.with_name("rows.csv")
    words = ["study", str(plan), "--out", str(rows), "--report", str(page), "--quiet", "-j", "1"]
    assert main(words) == 1
    text = page.read_text("utf-8")
    pictures = re.findall(r'<img alt="([^"]*)" src="data:image/png;base64,([^"]*)">', text)
    # 18: V.E.VALUE is 1 and the override 100; 0: it is 40. M100 never comes.
    assert [alt for alt, _ in pictures] == ["run 18: least time", "run 0: greatest time"]
    study = Study(plan)
    for (_, data), number in zip(pictures, (18, 0), strict=True):
        assert base64.b64decode(data) == study.picture(number)
    again = plan.with_name("again.html")
    assert main(["study", "report", str(plan), str(rows), "--report", str(again)]) == 0
    assert again.read_text("utf-8") == text


def test_extreme_runs_are_those_of_all_rows(plan: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures of many runs show a selection; least and greatest values are those of all runs."""
    monkeypatch.setattr("nctakt.studies.report.MAX_RUNS", 5)
    assert Study(plan).run().extreme_runs == [18, 0]


def test_tapes_of_extreme_runs(plan: Path) -> None:
    """``--record`` with a report: the run with the least time has passed and has its tape."""
    page, tapes = plan.with_name("page.html"), plan.with_name("tapes")
    words = ["study", str(plan), "--report", str(page), "--record", str(tapes), "--quiet"]
    assert main([*words, "-j", "1"]) == 1
    assert {tape.name for tape in tapes.iterdir()} >= {"run-0.tape", "run-18.tape"}
    assert f"<code>nctakt replay {tapes / 'run-18.tape'}" in page.read_text("utf-8")


def test_page_of_a_search_names_its_runs_by_their_values(plan: Path) -> None:
    """A run of a search has no number in the plan: its row says what it was."""
    text = PLAN.partition("[[vary]]")[0]
    plan.write_text(
        f'{text}[[vary]]\nvariable = "HLI.OVERRIDE"\nfrom = 40\nto = 100\n'
        '[[find]]\nboundary = "HLI.OVERRIDE"\n'
    )
    page, rows = plan.with_name("page.html"), plan.with_name("rows.csv")
    words = ["study", str(plan), "--out", str(rows), "--report", str(page), "--quiet", "-j", "1"]
    assert main(words) == 0
    again = plan.with_name("again.html")
    assert main(["study", "report", str(plan), str(rows), "--report", str(again)]) == 0
    pages = page.read_text("utf-8"), again.read_text("utf-8")
    commands = [re.findall(r"<code>(.*?)</code>", text) for text in pages]
    assert commands[0] == commands[1]
    assert "--set HLI.OVERRIDE=40 " in commands[0][1]


def test_shares_have_wilsons_interval() -> None:
    """Newcombe (1998), table I: 81 of 263 is 0.2553 … 0.3662, 0 of 20 is 0 … 0.1611."""
    assert wilson(81, 263) == pytest.approx((0.2553, 0.3662), abs=5e-5)
    assert wilson(0, 20) == pytest.approx((0.0, 0.1611), abs=5e-5)
    assert wilson(20, 20)[1] == 1.0


def test_limits_are_lines(plan: Path) -> None:
    """``duration < 1.2 s`` is a line at 1.2 of the measure with this text, of no other one."""
    study = Study(plan)
    assert limits_of(study.plan, "time") == [1.2]
    assert limits_of(study.plan, "late") == []
    page = study.run().report()
    assert "<title>1.2</title></line>" in page
    assert "Passed and failed over two inputs" in page
    assert "least time" in page
    assert "time in s" in page


def test_what_matters_is_on_top() -> None:
    """The measure is the first input; the second one has no part in it."""
    first = [float(number % 10) for number in range(100)]
    second = [float(number // 10) for number in range(100)]
    shares, _ = sensitivities([first, second], first)
    assert shares[0] > 0.5 > shares[1]


def test_a_study_is_a_test(pytester: pytest.Pytester, plan: Path) -> None:
    """It fails with the counts and the first failed run."""
    (pytester.path / "part.nc").write_text((plan.parent / "part.nc").read_text())
    (pytester.path / "plan.toml").write_text(PLAN)
    pytester.makepyfile('def test_it(study):\n    assert study("plan.toml")\n')
    known = {one.name for one in entry_points(group="pytest11")}
    words = [] if "nctakt_studies" in known else ["-p", "nctakt.studies.fixture"]
    words += ["-p", "no:asyncio", "-p", "no:cacheprovider"]
    done = pytester.runpytest_inprocess(*words)
    done.assert_outcomes(failed=1)
    done.stdout.fnmatch_lines(["*first run 0: duration < 1.2 s*"])


@pytest.mark.parametrize("name", ["rows.parquet", "rows.jsonl", "rows.csv"])
def test_rows_of_a_file_are_read_again_and_again(tmp_path: Path, name: str) -> None:
    """They are never all in memory: a report of many takes what pictures need."""
    if name.endswith("parquet"):
        pytest.importorskip("pyarrow")
    made: list[Row] = [
        {"run": number, "end": number / 8, "verdict": "passed", "digest": f"d{number}"}
        for number in range(50)
    ]
    write_rows(made, list(made[0]), tmp_path / name)
    rows = read_rows(tmp_path / name)
    assert isinstance(rows, StreamedRows)
    assert (len(rows), rows, rows[-1], rows[3:5]) == (50, made, made[-1], made[3:5])
    (tmp_path / name).write_bytes(b"run\n1\n")
    with pytest.raises(Failure) as raised:
        read_rows(tmp_path / name)
    assert raised.value.diagnostics[0].id == 900503


def test_verdicts_of_earlier_versions_are_read(tmp_path: Path) -> None:
    """``held`` and ``broken`` are ``passed`` and ``failed``; no other row changes."""
    earlier = ("held", "broken", "crashed")
    lines = [f'{{"run": {number}, "verdict": "{word}"}}' for number, word in enumerate(earlier)]
    (tmp_path / "rows.jsonl").write_text("\n".join(lines), "utf-8")
    rows = read_rows(tmp_path / "rows.jsonl")
    assert [row["verdict"] for row in rows] == ["passed", "failed", "crashed"]


def test_rows_are_read_from_a_file_only(tmp_path: Path) -> None:
    """A device or a pipe could be read once, and may never end (901483)."""
    with pytest.raises(Failure) as raised:
        read_rows(Path("/dev/zero" if os.name == "posix" else tmp_path / "none"))
    assert raised.value.diagnostics[0].id in (900500, NOT_A_REGULAR_FILE.id)
