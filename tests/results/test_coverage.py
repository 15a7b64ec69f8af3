# SPDX-License-Identifier: MIT
"""Branch coverage of realtime cycles: counts worked out by hand from the rules, sums of runs.

Ticks of 1 ms; a stimulus at tick n is seen in tick n (RC-002). #TIME 0.014 takes the ticks 0 … 13,
M30 is taken in tick 14, in which no PROG cycle runs (RC-106).
"""

from __future__ import annotations

import json

import pytest
from support.why_runs import EDGE, NESTED, NESTED_AT, TOGGLE

from nctakt.base.failure import Failure
from nctakt.results import probe_log
from nctakt.results.coverage import BranchCounts, Coverage
from nctakt.results.coverage_files import as_json, as_lcov, from_json
from nctakt.results.coverage_text import CoverageText
from nctakt.run.controller import Controller, NcText

#: An error breaks the second condition off in tick 3: division by zero (RC-207).
FAULT = """\
#RT CYCLE
  $IF V.E.VALUE >= 3
    V.E.COUNT = 1
  $ENDIF
  $IF 1 / [3 - V.E.VALUE] > 5 && V.E.COUNT == 0
    V.E.COUNT = 2
  $ENDIF
#RT CYCLE END
#TIME 0.014
M30
"""

#: Each pass defines a cycle that runs in its own dwell of two ticks.
LOOP = """\
$FOR P1 = 1, 3, 1
#RT CYCLE [SCOPE = BLOCK]
  $IF V.E.COUNT == 2
    V.E.COUNT = 3
  $ELSEIF V.E.COUNT < 2
    V.E.COUNT += 1
  $ELSE
    V.E.VALUE = 1
  $ENDIF
#RT CYCLE END
#TIME 0.002
$ENDFOR
M30
"""


def cover(
    text: str,
    *,
    at: list[tuple[int, str, float]] | None = None,
    controller: Controller | None = None,
    file: str = "part.nc",
) -> Coverage:
    """The coverage of one run; ``at`` are stimuli in ticks."""
    stimuli = [(f"{tick} ticks", name, value) for tick, name, value in at or ()]
    run = (controller or Controller()).run(
        NcText(file, text), at=stimuli, memory_trace=False, why=True
    )
    assert run.coverage is not None
    return run.coverage


def counts(branch: BranchCounts) -> tuple[int, int, int, int]:
    """Evaluated, true, false, body."""
    return branch.evaluated, branch.condition.true, branch.condition.false, branch.bodies


def test_nested_frequencies_are_counted_tick_by_tick() -> None:
    """Manual 2.7.2.4, RC-204: reached in ticks 2 … 7 and 11 … 13, latched from tick 4 on."""
    (cycle,) = cover(NESTED, at=NESTED_AT).cycles
    assert (cycle.runs, cycle.instances, cycle.ran) == (14, 1, 2)
    assert [counts(one) for one in cycle.branches] == [(14, 9, 5, 9), (3, 1, 2, 7)]
    assert [cycle.state(one) for one in cycle.branches] == ["ran", "ran"]


def test_an_edge_is_true_longer_than_its_body_runs() -> None:
    """RC-203: true above 200 mm; the body runs at each change only.

    Manual 2.7.2.2: 0 → 300 → 0 → 300, each way of 725 ticks; the cycle runs in 0 … 2174. True in
    463 … 987 (down again at 725 + 263 = 988: 199.75), and from 1450 + 463 = 1913 on.
    """
    (cycle,) = cover(EDGE).cycles
    true = (988 - 463) + (2175 - 1913)
    assert counts(cycle.branches[0]) == (2175, true, 2175 - true, 2)


def test_a_change_in_each_tick_is_counted_beyond_what_histories_keep() -> None:
    """100 s: 100,000 evaluations with as many changes; histories keep the newest 1000."""
    (cycle,) = cover(TOGGLE).cycles
    assert [counts(one) for one in cycle.branches] == [
        (100_000, 50_000, 50_000, 50_000),
        (0, 0, 0, 50_000),
    ]


def test_what_an_error_broke_off_is_neither_true_nor_false() -> None:
    """RC-207, RC-505: ticks 0 … 2 are false, tick 3 ends the cycle."""
    coverage = cover(FAULT, at=[(3, "V.E.VALUE", 3.0)])
    (cycle,) = coverage.cycles
    first, second = cycle.branches
    assert counts(first) == (4, 1, 3, 1)
    assert counts(second) == (4, 0, 3, 0)
    assert cycle.state(second) == "never true"
    at_once = cover(FAULT, at=[(0, "V.E.VALUE", 3.0)])
    assert counts(at_once.cycles[0].branches[1]) == (1, 0, 0, 0)
    assert at_once.count("fault") == 1


def test_parts_of_a_condition_are_counted_for_themselves() -> None:
    """RC-501: both sides of ``&&`` are evaluated each time."""
    text = NESTED.replace("V.E.CONDITION == 1", "V.E.CONDITION == 1 && V.E.VALUE == 0")
    (cycle,) = cover(text, at=NESTED_AT).cycles
    parts = [(one.text, one.true, one.false) for one in cycle.branches[0].parts]
    # V.E.CONDITION is 1 in 2 … 7 and from 11 on, V.E.VALUE is 150 in 4 and 5
    assert parts == [("V.E.CONDITION == 1", 9, 5), ("V.E.VALUE == 0", 12, 2)]
    assert counts(cycle.branches[0]) == (14, 7, 7, 7)


def test_a_definition_that_is_executed_again_is_one_entry() -> None:
    """RC-105: three instances of two ticks: COUNT 0 → 1 → 2, then 3 once, then the ``$ELSE``."""
    coverage = cover(LOOP)
    (cycle,) = coverage.cycles
    assert (cycle.instances, cycle.runs, cycle.line) == (3, 6, 2)
    assert [counts(one) for one in cycle.branches] == [(6, 1, 5, 1), (5, 2, 3, 2), (0, 0, 0, 3)]
    assert coverage.percent == 100


def test_cycles_that_histories_drop_still_count(monkeypatch: pytest.MonkeyPatch) -> None:
    """Memory is bounded, counts are whole."""
    monkeypatch.setattr(probe_log, "CYCLES_KEPT", 1)
    (cycle,) = cover(LOOP).cycles
    assert (cycle.instances, cycle.runs) == (3, 6)
    assert [one.bodies for one in cycle.branches] == [1, 2, 3]


def test_a_global_cycle_counts_in_each_run_what_it_did_there() -> None:
    """RC-107: it lives on; the second program adds its own ticks, to the first one's file."""
    text = NESTED.replace("SCOPE = PROG", "ID = 5 SCOPE = GLOBAL")
    controller = Controller()
    first = cover(text, controller=controller, at=[(3, "V.E.CONDITION", 1.0)])
    assert counts(first.cycles[0].branches[0]) == (15, 12, 3, 12)
    second = cover("#TIME 0.01\nM30\n", controller=controller, file="other.nc")
    assert [(one.file, one.runs) for one in second.cycles] == [("part.nc", 11)]
    assert counts(second.cycles[0].branches[0]) == (11, 11, 0, 11)
    whole = first.plus(second)
    assert first.outdated_by(second) == ()
    assert counts(whole.cycles[0].branches[0]) == (26, 23, 3, 23)


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("$IF V.E.COUNT == 0\nM100\n$ENDIF", "never false"),
        ("$IF ONCE V.E.COUNT == 0\nM100\n$ENDIF", "ran"),
        ("$IF V.E.COUNT == 1\nM100\n$ENDIF", "never true"),
        ("$IF V.E.COUNT == 1\n$IF 1 == 1\nM100\n$ENDIF\n$ENDIF", "not reached"),
        ("$IF V.E.COUNT == 0\n$ELSE\nM100\n$ENDIF", "not reached"),
    ],
)
def test_states_of_a_branch(text: str, state: str) -> None:
    """Never reached is another thing than never true (RC-201, RC-204)."""
    (cycle,) = cover(f"#RT CYCLE\n{text}\n#RT CYCLE END\n#TIME 0.003\nM30\n").cycles
    assert cycle.state(cycle.branches[-1]) == state


def test_a_definition_that_is_not_reached_is_reported() -> None:
    """It has its branches, and none of them ran."""
    text = "$IF V.E.COUNT == 1\n#RT CYCLE\n$IF V.E.COUNT == 1\nM100\n$ENDIF\n#RT CYCLE END\n$ENDIF"
    coverage = cover(f"{text}\n#TIME 0.003\nM30\n")
    (cycle,) = coverage.cycles
    assert (cycle.instances, cycle.runs, cycle.state(cycle.branches[0])) == (0, 0, "cycle")
    assert coverage.percent == 0
    assert "part.nc:2  realtime cycle, never defined" in CoverageText(coverage, "en").table()


def test_runs_add_up_and_the_nearest_miss_is_kept() -> None:
    """Two runs of one program: sums of all counts; the nearer one of two misses stays."""
    text = "#RT CYCLE\n$IF V.E.VALUE > 100\nM100\n$ENDIF\n#RT CYCLE END\n#TIME 0.003\nM30\n"
    far, near = cover(text), cover(text, at=[(1, "V.E.VALUE", 90.0)])
    for whole in (far.plus(near), near.plus(far)):
        assert (whole.runs, whole.cycles[0].instances, whole.cycles[0].runs) == (2, 2, 6)
        condition = whole.cycles[0].branches[0].condition
        assert (condition.true, condition.false) == (0, 6)
        assert condition.nearest is not None
        assert (condition.nearest.left, condition.nearest.distance) == (90, 10)
    hit = far.plus(cover(text, at=[(1, "V.E.VALUE", 150.0)]))
    assert counts(hit.cycles[0].branches[0]) == (6, 2, 4, 2)
    assert hit.cycles[0].branches[0].condition.nearest is None


def test_counts_of_a_changed_program_do_not_add_up() -> None:
    """Another text, or another place: what was known of the file is dropped, other files stay."""
    old = cover(NESTED).plus(cover(EDGE, file="edge.nc"))
    for text in (NESTED.replace("> 100", "> 101"), f"; a line more\n{NESTED}"):
        new = cover(text)
        assert old.outdated_by(new) == ("part.nc",)
        whole = old.plus(new)
        assert [one.file for one in whole.cycles] == ["edge.nc", "part.nc"]
        assert whole.cycles[1] == new.cycles[0]


def test_json_is_read_as_it_was_written() -> None:
    """Every count comes back; the same coverage gives the same bytes."""
    coverage = cover(NESTED, at=NESTED_AT).plus(cover(LOOP, file="loop.nc"))
    text = as_json(coverage)
    assert from_json("x.json", text) == coverage
    assert as_json(from_json("x.json", text)) == text
    assert json.loads(text)["cycles"][0]["branches"][0]["state"] == "ran"
    assert from_json("x.json", "") == Coverage()


def test_spoiled_json_is_reported() -> None:
    """Each value of another kind, each missing key, is 900801 and no traceback."""
    good = json.loads(as_json(cover(LOOP)))

    def spoiled(node: object) -> list[str]:
        found = []
        entries = list(node.items()) if isinstance(node, dict) else []
        entries = list(enumerate(node)) if isinstance(node, list) else entries
        for key, value in entries:
            assert isinstance(node, dict | list)
            for wrong in (None, -1, [1], {"a": 1}, 10**400):
                node[key] = wrong  # type: ignore[index]
                found.append(json.dumps(good))
            node[key] = value  # type: ignore[index]
            found += spoiled(value)
        return found

    texts = [*spoiled(good), "[]", "1", "{", '{"nctakt-coverage": 2}', "[" * 100_000]
    for text in texts:
        try:
            read = from_json("x.json", text)
        except Failure as failure:
            assert [one.id for one in failure.diagnostics] == [900801]
        else:
            read.plus(read)
            CoverageText(read, "de").source()
            CoverageText(read, "de").table()
            as_lcov(read)


def test_lcov_has_two_branches_for_each_condition() -> None:
    """Body and false; lines count the ticks in which they ran."""
    assert as_lcov(cover(LOOP)).splitlines() == [
        "TN:",
        "SF:part.nc",
        "BRDA:3,0,0,1",
        "BRDA:3,0,1,5",
        "BRDA:5,0,0,2",
        "BRDA:5,0,1,3",
        "BRF:4",
        "BRH:4",
        "DA:2,6",
        "DA:3,6",
        "DA:4,1",
        "DA:5,5",
        "DA:6,2",
        "DA:7,3",
        "DA:8,3",
        "LF:7",
        "LH:7",
        "end_of_record",
    ]


def test_the_source_with_its_counts() -> None:
    """Each line of the definition, up to its end; what never ran is marked."""
    text = NESTED.replace("V.E.CONDITION == 1", "V.E.CONDITION == 0")
    shown = CoverageText(cover(text), "de").source().splitlines()
    assert (
        shown[0]
        == "part.nc:1  Echtzeit-Zyklus #1 PROG, 14-mal gelaufen, 1 von 2 Zweigen ausgeführt"
    )
    rows = [(line[0], line[1:47].split(), line[49:]) for line in shown[2:9]]
    assert rows == [
        (" ", ["1", "14"], "#RT CYCLE [SCOPE = PROG]"),
        ("~", ["2", "14", "14", "0", "14"], "  $IF V.E.CONDITION == 0"),
        ("!", ["3", "14", "0", "14", "0"], "    $IF ALWAYS V.E.VALUE > 100"),
        ("!", ["4", "0"], "      V.E.COUNT += 1"),
        (" ", ["5"], "    $ENDIF"),
        (" ", ["6"], "  $ENDIF"),
        (" ", ["7"], "#RT CYCLE END"),
    ]
    assert shown[-1] == "insgesamt: 1 von 2 Zweigen ausgeführt, 50 %; Läufe: 1"


def test_without_realtime_cycles_there_is_nothing_to_cover() -> None:
    """No branch at all is not too little."""
    coverage = cover("G00 X1\nM30\n")
    assert coverage.percent == 100
    assert CoverageText(coverage, "en").table() == "no realtime cycles\n"


def test_a_run_that_was_not_asked_counts_nothing() -> None:
    """Counting has its price, so it is asked for."""
    assert Controller().run(NcText("part.nc", LOOP)).coverage is None
