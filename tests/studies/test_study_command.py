# SPDX-License-Identifier: MIT
"""``nctakt study``: what it shows, what it keeps, its exit codes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.cli.results import study_progress
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.runs.study_runner import Row

Captured = pytest.CaptureFixture[str]

PLAN = """\
program = "part.nc"
expect = ["X at end < 4.5"]
[measure]
end = "X at end"
[[vary]]
variable = "V.E.VALUE"
from = 1
to = 6
step = 1
"""


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """A plan of six runs, of which the last two do not hold."""
    (tmp_path / "part.nc").write_text("G01 X[V.E.VALUE] F6000\nM30\n")
    path = tmp_path / "plan.toml"
    path.write_text(PLAN)
    return path


def test_the_summary_names_the_broken_runs(plan: Path, capsys: Captured) -> None:
    """Counts, the span of the measure, each failed run with its command; exit code 1."""
    assert main(["study", str(plan), "--quiet"]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == f"{plan}: 6 runs: 4 passed, 2 failed"
    assert lines[1] == "  end  minimum 1  maximum 6"
    assert lines[2] == "4: V.E.VALUE = 5: failed: X at end < 4.5 (5)"
    assert lines[3] == f"    nctakt run {plan.with_name('part.nc')} --set V.E.VALUE=5"
    assert main(["study", str(plan), "--only", "2", "--quiet"]) == 0


def test_the_summary_fits_a_screen(plan: Path, capsys: Captured) -> None:
    """Of many measures, expectations and blocks it shows the first ones, and counts the others."""
    count = 60
    measures = "".join(f'm{number} = "X at {number} ms"\n' for number in range(1, count + 1))
    expected = [f"m{number} < 0" for number in range(1, count + 1)]
    text = PLAN.replace('["X at end < 4.5"]', str(expected)).replace('end = "X at end"', measures)
    plan.write_text(text)
    assert main(["study", str(plan), "--quiet"]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert (len(lines), lines[11]) == (24, "  … 50 more measures")
    assert max(map(len, lines[12::2])) < 300
    program = plan.with_name("part.nc")
    program.write_text("".join(f"G01 X{number} F60000\n" for number in range(1, 41)) + "M30\n")
    words = ["--each-tick", "V.E.VALUE=1", "--expect", "X < 20 within 1 ms", "--quiet"]
    assert main(["study", str(program), *words]) == 1
    shown = capsys.readouterr().out.splitlines()
    assert len(shown) < 40
    blocks = [line.split()[0] for line in shown if " G01 X" in line]
    assert (len(blocks), blocks[0]) == (6, "21")
    assert "… 35 more blocks, 15 of them with failed runs" in shown


def test_a_part_without_runs_says_so(plan: Path, capsys: Captured) -> None:
    """There may be more parts than runs; measures without values are left out."""
    words = ["study", str(plan), "--part", "1/9", "--out", str(plan.with_name("parts")), "--quiet"]
    assert main(words) == 0
    assert capsys.readouterr().out == f"{plan}: 0 runs\n"


def test_a_run_that_the_study_does_not_have(plan: Path, capsys: Captured) -> None:
    """Exit code 2 instead of a run with the values of another number."""
    assert main(["study", str(plan), "--only", "6", "--quiet"]) == 2
    assert "0 to 5" in capsys.readouterr().err


@pytest.mark.parametrize("option", ["--out", "--report"])
@pytest.mark.parametrize("name", ["part.nc", "plan.toml", "own.py", "helper.py"])
def test_no_output_replaces_an_input(plan: Path, capsys: Captured, option: str, name: str) -> None:
    """Plan, program, measures and what they import stay as they are, and nothing runs."""
    (plan.parent / "own.py").write_text("import helper\ndef f(run):\n    return 1\n")
    (plan.parent / "helper.py").write_text("")
    plan.write_text(PLAN.replace("[[vary]]", 'f = "python own.py:f"\n[[vary]]'))
    file = plan.with_name(name)
    before = file.read_bytes()
    assert main(["study", str(plan), option, str(file), "--quiet"]) == 2
    assert f"{option} would overwrite" in capsys.readouterr().err
    assert file.read_bytes() == before
    assert not list(plan.parent.glob("*.rows"))


def test_results_and_report_are_two_files(plan: Path, capsys: Captured) -> None:
    """The report does not replace the results, nor ``study report`` what it reads."""
    page = str(plan.with_name("a.html"))
    assert main(["study", str(plan), "--out", page, "--report", page, "--quiet"]) == 2
    results = str(plan.with_name("a.csv"))
    assert main(["study", str(plan), "--out", results, "--quiet"]) == 1
    assert main(["study", "report", str(plan), results, "--report", results]) == 2
    assert "would overwrite" in capsys.readouterr().err


def test_rows_are_written_in_a_known_format_only(plan: Path, capsys: Captured) -> None:
    """Another suffix is refused before any run, instead of JSON lines under a wrong name."""
    assert main(["study", str(plan), "--out", str(plan.with_name("rows.xls")), "--quiet"]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "a file of --out must end in .parquet, .csv or .jsonl" in captured.err
    assert not list(plan.parent.glob("rows*"))


def test_one_run_is_counted_as_one(plan: Path, capsys: Captured) -> None:
    """A program without a plan is one run."""
    assert main(["study", str(plan.with_name("part.nc")), "--quiet"]) == 0
    assert "part.nc: 1 run: 1 passed" in capsys.readouterr().out
    assert main(["study", str(plan.with_name("part.nc")), "--quiet", "--lang", "de"]) == 0
    assert "part.nc: 1 Lauf: 1 bestanden" in capsys.readouterr().out


@pytest.mark.parametrize("content", [None, b"\xff", b'{"run":'])
def test_results_that_cannot_be_read(plan: Path, capsys: Captured, content: bytes | None) -> None:
    """A missing or damaged file of results: a message with the file's name, exit code 2."""
    results = plan.with_name("results.jsonl")
    if content is not None:
        results.write_bytes(content)
    assert main(["study", "report", str(plan), str(results)]) == 2
    assert "results.jsonl" in capsys.readouterr().err


def test_each_tick_of_a_program(plan: Path, capsys: Captured) -> None:
    """The strip has a line for each block; a mistake in the words is exit code 2."""
    program = str(plan.with_name("part.nc"))
    words = ["study", program, "--each-tick", "V.E.VALUE1=1 for 2 ms", "--quiet", "--expect"]
    assert main([*words, "PATH.SPEED >= 0 within 5 ms"]) == 0
    assert "G01 X[V.E.VALUE] F6000" in capsys.readouterr().out
    assert main([*words, "PATH.SPED >= 0 within 5 ms"]) == 2
    assert "PATH.SPEED" in capsys.readouterr().err
    assert main(["study", program, "--each-tick", "nothing", "--quiet"]) == 2
    assert "901315" in capsys.readouterr().err


def test_ctrl_c_keeps_what_is_finished(
    plan: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The rows so far stay, and ``--resume`` makes the others; then the file is the same."""
    out = plan.with_name("rows.jsonl")
    words = ["study", str(plan), "--out", str(out), "--quiet", "-j", "1"]
    assert main(words) == 1
    whole = out.read_bytes()
    out.unlink()
    with monkeypatch.context() as patch:

        def interrupt(self: study_progress.StudyProgress, block: RowBlock) -> None:
            if 2 in block.numbers:
                raise KeyboardInterrupt

        patch.setattr(study_progress.StudyProgress, "add", interrupt)
        assert main(words) == 1
    assert "901310" in capsys.readouterr().err
    assert not out.exists()
    with monkeypatch.context() as patch:

        def interrupt_writing(rows: Iterable[Row]) -> Iterator[list[Row]]:
            yield list(rows)[:2]
            raise KeyboardInterrupt

        patch.setattr("nctakt.studies.rows.results.in_groups", interrupt_writing)
        assert main([*words, "--resume"]) == 1
    assert "rows.partial.jsonl" in capsys.readouterr().err  # as of each file that is cut off
    out.with_name("rows.partial.jsonl").unlink()
    assert main([*words, "--resume"]) == 1
    assert out.read_bytes() == whole
    assert not out.with_name("rows.jsonl.rows").exists()


def test_what_takes_hours_has_to_be_confirmed(
    plan: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    """10^12 points: the estimate is reported, nothing begins; a sample does."""
    text = PLAN.replace("to = 6", "to = 1000000")
    text += '[[vary]]\nvariable = "V.E.VALUE1"\nfrom = 1\nto = 1000000\nstep = 1\n'
    plan.write_text(text)
    assert main(["study", str(plan), "--quiet"]) == 2
    found = capsys.readouterr().err
    assert "901305" in found
    assert "1000000000000 runs" in found
    assert "years" in found
    assert main(["study", str(plan), "--quiet", "--sample", "3", "-j", "1"]) == 1
    assert "3 runs" in capsys.readouterr().out


def test_inputs_are_tried_until_each_branch_has_run(plan: Path, capsys: Captured) -> None:
    """One branch needs a value of 5 or more, another one can never run."""
    text = """\
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF V.E.VALUE > 4
    V.E.VALUE1 = 1
  $ENDIF
  $IF V.E.VALUE > {limit}
    V.E.VALUE1 = 2
  $ENDIF
#RT CYCLE END
G01 X1 F6000
M30
"""
    program = plan.with_name("part.nc")
    program.write_text(text.format(limit=5))
    assert main(["study", str(plan), "--cover"]) == 0
    shown = capsys.readouterr().out
    assert f"{program}:5: nctakt run {program} --set V.E.VALUE=6" in shown
    program.write_text(text.format(limit=9))
    assert main(["study", str(plan), "--cover"]) == 1


def test_an_unexpected_error_breaks(plan: Path, capsys: Captured) -> None:
    """As in the comments of a program; unless an expectation is about errors or the state."""
    plan.write_text(
        PLAN.replace("to = 6", "to = 100001\nstep = 100000").replace("\nstep = 1\n", "\n")
    )
    assert main(["study", str(plan), "--quiet"]) == 1
    assert "1 passed, 1 failed" in capsys.readouterr().out
    plan.write_text(plan.read_text().replace("X at end < 4.5", "count of error 120000 = 0"))
    assert main(["study", str(plan), "--quiet"]) == 0


def test_answers_come_with_their_commands(plan: Path, capsys: Captured) -> None:
    """The run before and the run after a switch-over; in German with German words."""
    plan.write_text(PLAN + '[[find]]\nboundary = "V.E.VALUE"\n')
    assert main(["study", str(plan), "--quiet", "--lang", "de"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[1].endswith("V.E.VALUE = 4, end = 4: bestanden")
    assert lines[2] == f"    nctakt run {plan.with_name('part.nc')} --set V.E.VALUE=4"
    assert lines[3].endswith("V.E.VALUE = 5, end = 5: nicht bestanden: X at end < 4.5 (5)")
    folder = plan.with_name("tapes")
    assert main(["study", str(plan), "--quiet", "--record", str(folder)]) == 0
    assert len(list(folder.glob("boundary-V.E.VALUE-*.tape"))) == 2


@pytest.mark.parametrize(
    "words", [["--each-tick", "V.E.VALUE=1"], ["--until", "1 s"], ["--resume"], ["--expect", "a"]]
)
def test_options_without_effect_are_refused(plan: Path, capsys: Captured, words: list[str]) -> None:
    """What a plan has as an entry, and ``--resume`` without results."""
    assert main(["study", str(plan), "--quiet", *words]) == 2
    assert words[0] in capsys.readouterr().err
