# SPDX-License-Identifier: MIT
"""``study --cover``: guided search for branches of realtime cycles, and its corpus."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.run.controller import NcText
from nctakt.studies.plans.coordinates import PlanCoordinates
from nctakt.studies.searching.branch_distance import distances
from nctakt.studies.searching.corpus import MAX_POINTS, Corpus
from nctakt.studies.searching.cover import covered
from nctakt.studies.searching.unreachable import unreachable
from nctakt.studies.study import Study

Captured = pytest.CaptureFixture[str]

PLAN = """\
program = "part.nc"
[[vary]]
variable = "V.E.COUNT_POS"
from = 0
to = 99999
step = 1
"""


def program(cycle: str, blocks: str = "G04 X0.003") -> str:
    """A program with a realtime cycle."""
    return f"#RT CYCLE [ID=1 SCOPE=PROG]\n{cycle}\n#RT CYCLE END\n{blocks}\nM30\n"


def on(condition: str) -> str:
    """A branch with this condition."""
    return f"$IF {condition}\nV.E.COUNT = 1\n$ENDIF"


def study_of(text: str, *names: str, **entries: object) -> Study:
    """A study of variables from 0 to 99,999."""
    vary = [{"variable": name, "from": 0, "to": 99_999, "step": 1} for name in names]
    return Study(program=NcText("part.nc", text), vary=[*vary, *entries.pop("vary", ())], **entries)


@pytest.mark.parametrize(
    ("cycle", "names", "budget"),
    [
        (on("V.E.COUNT_POS == 77777"), ["V.E.COUNT_POS"], 40),
        (on("V.E.COUNT_POS == 4711 && V.E.COUNT_NEG == 815"),
         ["V.E.COUNT_POS", "V.E.COUNT_NEG"], 80),
        (on("V.E.COUNT_POS != 5").replace("$ENDIF", "$ELSE\nV.E.COUNT = 2\n$ENDIF"),
         ["V.E.COUNT_POS"], 40),
        (on("V.E.COUNT_POS < 700 || V.E.COUNT_POS > 700").replace(
            "$ENDIF", "$ELSEIF V.E.COUNT_NEG == 31\nV.E.COUNT = 2\n$ENDIF"),
         ["V.E.COUNT_POS", "V.E.COUNT_NEG"], 80),
        (on("V.E.COUNT_POS == 30000").replace("V.E.COUNT = 1", on("V.E.COUNT_NEG == 9")),
         ["V.E.COUNT_POS", "V.E.COUNT_NEG"], 80),
        ("V.E.COUNT = 0\n" + on("V.E.COUNT_POS > 99000") + "\n"
         + on("V.E.COUNT_NEG > 99000").replace("= 1", "+= 1") + "\n" + on("V.E.COUNT == 2"),
         ["V.E.COUNT_POS", "V.E.COUNT_NEG"], 200),
    ],
    ids=["equal", "both", "else", "elseif", "nested", "flag"],
)  # fmt: skip
def test_guided_search_reaches_rare_branches(cycle: str, names: list[str], budget: int) -> None:
    """One input in 100,000 or in 10^10: by the distances of the comparisons, not by luck."""
    reached = study_of(program(cycle), *names).cover(budget)
    assert reached.is_whole
    assert len(reached.first) == reached.coverage.branches


@pytest.mark.parametrize(
    ("condition", "low", "high"),
    [
        ("V.E.VALUE == 77777", 0, 100_000),
        ("V.E.VALUE == 12.34", 0.5, 99.9),
        ("V.E.VALUE == -0.3", -0.3, 1 / 3),  # a bound that is not among the round numbers
        ("V.E.VALUE == 123456789", 0, 1e9),
    ],
)
def test_round_numbers_of_a_range_are_reached(condition: str, low: float, high: float) -> None:
    """A dimension that takes any number is tried at round ones: programs compare with these."""
    vary = [{"variable": "V.E.VALUE", "from": low, "to": high}]
    entries = {"method": "random", "count": 100}
    reached = study_of(program(on(condition)), vary=vary, **entries).cover(100)
    assert reached.is_whole
    assert reached.first[-1].point == (float(condition.rpartition(" ")[2]),)


@pytest.mark.parametrize(
    ("low", "high", "values"),
    [
        (0, 100_000, {0: 0, 1: 0.1, 777_770: 77_777, 1_000_000: 100_000}),
        (0.123, 1.5, {0: 0.123, 1: 0.123002, 688_500: 1.5}),
        (-1e12, 1e12, {0: -1e12, 10**12: 0, 2 * 10**12: 1e12}),
    ],
)
def test_round_numbers(low: float, high: float, values: dict[int, float]) -> None:
    """Steps of 0.1, of 0.000002, the finest of at most 2^20; whole numbers in a wide range."""
    vary = [{"variable": "V.E.VALUE", "from": low, "to": high}]
    study = study_of(program("V.E.COUNT = 1"), vary=vary, method="random", count=10)
    space = PlanCoordinates(study.plan)
    assert space.sizes == (max(values) + 1,)
    for number, value in values.items():
        assert space.point((number,)) == (value,)
        assert space.of_point((value,)) == (number,)


def test_branches_of_several_plcs_are_reached(tmp_path: Path) -> None:
    """Each PLC in Structured Text has targets: of one comparison, of two, after an ELSIF.

    The values of comparisons lead there: no run of a hundred hits 77,777 or 4711 by chance.
    """
    codes = {
        "first.st": "IF nPart = 77777 THEN n := 1; ELSIF nPart > 99000 THEN n := 2; END_IF",
        "second.st": "IF nGate > 4000 AND fWay * 2.0 < 91.5 THEN IF nGate = 4711 THEN\n"
        "n := 3; END_IF END_IF",
    }
    variables = "nPart, nGate : DINT; fWay : LREAL := 1000; n : INT;"
    plcs = [tmp_path / name for name in codes]
    for plc, code in zip(plcs, codes.values(), strict=True):
        name = f"P_{plc.stem.title()}"
        text = f"PROGRAM {name}\nVAR {variables} END_VAR\n{code}\nEND_PROGRAM\n"
        plc.write_text(text, "utf-8")
    names = ("P_First.nPart", "P_Second.nGate", "P_Second.fWay")
    study = study_of(program(""), *names, plc=[str(plc) for plc in plcs])
    reached = study.cover(150)
    files = {Path(one.file).name for one in reached.first}
    assert (reached.is_whole, files) == (True, set(codes))
    assert reached.coverage.branches == 4


def test_labels_of_case_are_reached(tmp_path: Path) -> None:
    """The distance to labels leads to them, and to the only value without one (ST-511)."""
    plc = tmp_path / "labels.st"
    plc.write_text(
        "PROGRAM MAIN\nVAR nPart, nGate : DINT; n : INT; END_VAR\nCASE nPart OF\n"
        "77777: n := 1;\n4000..4010: CASE nGate OF 4711: n := 2; END_CASE\nEND_CASE\n"
        "CASE nGate OF\n-2147483648..31415, 31417..2147483647: n := 3;\nELSE n := 4;\nEND_CASE\n"
        "END_PROGRAM\n"
    )
    study = study_of(program(""), "MAIN.nPart", "MAIN.nGate", plc=[str(plc)])
    reached = study.cover(150)
    assert (reached.is_whole, reached.coverage.branches) == (True, 5)


def test_a_pulse_is_moved_to_where_the_axis_is() -> None:
    """A value of one tick, while X is between 15 and 15.2: the time of one beside the other."""
    cycle = on("V.E.TRIGGER == 1 && V.RTA.ACS.ACT_POS.X > 15 && V.RTA.ACS.ACT_POS.X < 15.2")
    pulse = {"time_of": "V.E.TRIGGER = 1", "for": "1 tick", "from": "0 s", "to": "20 s"}
    study = study_of(program(cycle, "G01 X20 F6000"), vary=[pulse], method="random", count=1)
    assert study.cover(100).is_whole


def test_a_pulse_in_the_tick_of_another_branch_is_found() -> None:
    """No distance says when: each time is tried in turn, one tick of 400 with one input in 100."""
    moving = "V.RTA.ACS.ACT_POS.X > 12.5 && V.RTA.ACS.ACT_POS.X < 12.6"
    cycle = on("V.E.COUNT_POS > 99000").replace("V.E.COUNT = 1", nested(moving, "V.E.TRIGGER == 1"))
    pulse = {"time_of": "V.E.TRIGGER = 1", "for": "1 tick", "from": "0 s", "to": "400 ms"}
    study = study_of(
        program(cycle, "G01 X20 F6000"), "V.E.COUNT_POS", vary=[pulse], method="random", count=1
    )
    assert study.cover(600).is_whole


def test_a_run_is_nearer_with_less_left() -> None:
    """First by the branches around it, then by the sides of the comparison."""
    cycle = on("V.E.COUNT_POS > 10").replace("V.E.COUNT = 1", on("V.E.COUNT_POS == 40"))
    runner = study_of(program(cycle), "V.E.COUNT_POS").runner
    inner = [[*distances(covered(runner, [value])).values()][1] for value in (0, 9, 12, 39, 40)]
    assert [one.levels for one in inner] == [2, 2, 1, 1, 0]
    assert inner == sorted(inner, key=lambda one: one.key, reverse=True)


def test_what_was_found_is_kept_and_grows(tmp_path: Path, capsys: Captured) -> None:
    """The next call begins with it: one run is enough; a changed program adds to it."""
    plan, corpus = tmp_path / "plan.toml", tmp_path / "plan.corpus"
    plan.write_text(PLAN)
    part = tmp_path / "part.nc"
    part.write_text(program(on("V.E.COUNT_POS == 77777")))
    words = ["study", str(plan), "--cover", "--corpus", str(corpus), "--sample"]
    assert main([*words, "300"]) == 0
    assert '{"V.E.COUNT_POS": 77777}' in corpus.read_text()
    assert main([*words, "1"]) == 0
    assert f"{part}:2: nctakt run {part} --set V.E.COUNT_POS=77777" in capsys.readouterr().out
    part.write_text(program(on("V.E.COUNT_POS == 77777") + "\n" + on("V.E.COUNT_POS == 123")))
    assert main([*words, "300"]) == 0
    assert main([*words, "2"]) == 0
    assert corpus.read_text().splitlines()[:2] == [
        '{"V.E.COUNT_POS": 77777}', '{"V.E.COUNT_POS": 123}',
    ]  # fmt: skip


def test_points_of_other_plans_stay(tmp_path: Path) -> None:
    """A corpus serves several plans; values that a plan no longer has are passed over."""
    corpus = tmp_path / "corpus"
    corpus.write_text('{"V.E.OTHER": 1}\n\n{"V.E.COUNT_POS": 1e9}\n{"V.E.COUNT_POS": "never"}\n')
    study = study_of(program(on("V.E.COUNT_POS == 3")), "V.E.COUNT_POS")
    assert study.cover(200, corpus).is_whole
    kept = Corpus(corpus)
    assert kept.points(study.plan)[0] == (3,)
    assert '{"V.E.OTHER": 1}' in corpus.read_text()
    kept.add(study.plan, [(number,) for number in range(MAX_POINTS + 5)])
    assert len(Corpus(corpus).points(study.plan)) == MAX_POINTS


def test_each_wrong_line_of_a_corpus_is_reported(tmp_path: Path) -> None:
    """902530 with line and caret; the file stays as it is."""
    corpus = tmp_path / "corpus"
    corpus.write_text('{"V.E.COUNT_POS": 1}\n{"V.E.COUNT_POS": true}\n[1]\n{"V.E\n')
    study = study_of(program(on("V.E.COUNT_POS == 3")), "V.E.COUNT_POS")
    with pytest.raises(Failure) as raised:
        study.cover(5, corpus)
    spans = [found.span for found in raised.value.diagnostics if found.id == 902530]
    assert [span.line for span in spans if span is not None] == [2, 3, 4]


def test_runs_that_are_not_possible_end_no_search(tmp_path: Path, capsys: Captured) -> None:
    """A text for a number, after the fifty values that are checked before any run (902531)."""
    plan = tmp_path / "plan.toml"
    plan.write_text(
        f'program = "part.nc"\n[[vary]]\nvariable = "V.E.COUNT_POS"\n'
        f"values = {[*range(50), 'many']}\n"
    )
    (tmp_path / "part.nc").write_text(program(on("V.E.COUNT_POS == 99")))
    assert main(["study", str(plan), "--cover"]) == 1
    shown = capsys.readouterr()
    assert "902531" in shown.err
    assert "all 51 points" in shown.out


def test_a_corpus_without_a_search_is_refused(tmp_path: Path, capsys: Captured) -> None:
    """It would have no effect."""
    (tmp_path / "plan.toml").write_text(PLAN)
    assert main(["study", str(tmp_path / "plan.toml"), "--corpus", "x"]) == 2
    assert "--corpus" in capsys.readouterr().err


def nested(outer: str, inner: str) -> str:
    """A branch in a branch."""
    return on(outer).replace("V.E.COUNT = 1", on(inner))


@pytest.mark.parametrize(
    ("cycle", "proven"),
    [
        (on("V.E.COUNT_POS > 99999"), [True]),
        (on("V.E.COUNT_POS >= 99999"), [False]),
        (on("2 * V.E.COUNT_POS + 1 < 0 || ABS[V.E.COUNT_POS] == 100001"), [True]),
        (on("SIN[V.RTA.ACS.ACT_POS.X] > 1 && V.E.COUNT_POS > 5"), [True]),
        (on("V.RTA.ACS.ACT_POS.X > V.E.COUNT_POS + 99999"), [False]),
        (nested("V.E.COUNT_POS > 50", "V.E.COUNT_POS < 40"), [False, True]),
        (nested("V.E.COUNT_POS > 50", "V.E.COUNT_POS < 60"), [False, False]),
        (nested("V.E.COUNT_POS > 50", "V.E.COUNT_POS < 40").replace("$IF", "$IF ALWAYS", 1),
         [False, False]),
        (on("V.E.COUNT_POS > 7").replace(
            "$ENDIF", "$ELSEIF V.E.COUNT_POS > 8\nV.E.COUNT = 2\n$ENDIF"), [False, True]),
        (on("V.E.COUNT_POS >= 0").replace("$ENDIF", "$ELSE\nV.E.COUNT = 2\n$ENDIF"), [False, True]),
        (on("NOT[V.E.COUNT_POS < 100000]"), [True]),
        (on("1 / V.E.COUNT_POS > 2"), [False]),
        ("V.E.COUNT_POS = V.E.COUNT_POS + 1\n" + on("V.E.COUNT_POS > 99999"), [False]),
        (on("V.E.COUNT_NEG > 5"), [False]),
    ],
)  # fmt: skip
def test_branches_that_no_values_reach_are_proven(cycle: str, proven: list[bool]) -> None:
    """COUNT_POS is from 0 to 99,999 and nothing else writes it; other values may be anything."""
    study = study_of(program(cycle), "V.E.COUNT_POS")
    proofs = unreachable(study.runner)
    assert [index in {key[2] for key in proofs} for index in range(len(proven))] == proven


def test_nothing_is_proven_where_others_may_write(tmp_path: Path) -> None:
    """A PLC, an assignment of the program, a program whose name is computed."""
    text = program(on("V.E.COUNT_POS > 99999"))
    assert unreachable(study_of(text, "V.E.COUNT_POS").runner)
    written = text.replace("G04", "V.E.COUNT_POS = 5\nG04")
    assert not unreachable(study_of(written, "V.E.COUNT_POS").runner)
    plc = tmp_path / "plc.py"
    plc.write_text("class Plc:\n    def cycle(self, hli):\n        pass\n")
    assert not unreachable(study_of(text, "V.E.COUNT_POS", plc=str(plc)).runner)


def test_a_proven_branch_ends_the_search(tmp_path: Path, capsys: Captured) -> None:
    """No runs are wasted on it; the proof names the variables and their bounds; exit code 1."""
    (tmp_path / "plan.toml").write_text(PLAN)
    part = tmp_path / "part.nc"
    part.write_text(program(on("V.E.COUNT_POS == 77777") + "\n" + on("V.E.COUNT_POS > 100000")))
    assert main(["study", str(tmp_path / "plan.toml"), "--cover", "--sample", "300"]) == 1
    shown = capsys.readouterr().out
    assert f"{part}:5: cannot be reached, proven for V.E.COUNT_POS from 0 to 99999" in shown
    assert "all " not in shown
