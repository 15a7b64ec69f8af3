# SPDX-License-Identifier: MIT
"""Runs that go on after a common beginning are those of a new controller, whatever they do."""

from __future__ import annotations

from collections import Counter, deque
from pathlib import Path
from typing import Any

import pytest

from nctakt import Controller, Function, HliView, NcText, Plc, after, at, on, when
from nctakt.base.failure import Failure
from nctakt.results.run import Run
from nctakt.run.beginning import Beginning
from nctakt.run.kept_objects import KeptObjects, NotKeptError
from nctakt.run.realtime.realtime_parts import RealtimeParts
from nctakt.studies.runs.study_runner import StudyRunner
from nctakt.studies.study import Study

RUNS = Path(__file__).parent.parent / "runs"
PROGRAMS = sorted(RUNS.glob("*/program*.nc"))[::3]
#: Programs whose decoder holds what cannot be kept: they begin as any other run.
BEGIN_ANEW = ("mo_009_neck_left_out",)
EXAMPLES = RUNS.parent.parent / "examples"
#: The values of runs that follow each other, and whether they have one at a time.
VALUES: tuple[tuple[dict[str, float], bool], ...] = (
    ({"V.E.COUNT": 1.0, "V.E.ASYNC": 4.0}, False),
    ({"V.E.COUNT": 3.0, "V.E.ASYNC": 2.0, "HLI.OVERRIDE": 50.0}, True),
    ({}, False),
)
READS = """G01 X10 F6000
N20 #MSG ["%d", V.E.COUNT]
M30"""


def beginning(program: str | Path | NcText, **options: Any) -> Beginning[Controller]:
    """The beginning of the runs of a program on the demo machine."""
    first = Controller()
    loaded = first.load(program)
    return Beginning(
        lambda part: Controller(first.machine, None, None, part),
        RealtimeParts().lend(first.machine),
        loaded,
        options,
        keeps_results=True,
    )


def run_of(begun: Beginning[Controller], **options: Any) -> Run:
    """The result of a run that goes on after a beginning."""
    run = begun.begin(options)
    assert run is not None
    run.advance()
    run.close()
    begun.give_back()
    return run.result()


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.parent.name)
def test_runs_are_those_of_new_controllers(program: Path) -> None:
    """State, trace with events, messages and counts are the same, also after the next run.

    A program with mistakes, for this machine, has no beginning and the same diagnostics.
    """
    try:
        begun = beginning(program, ticks=1500, memory_trace=True)
    except Failure as failure:
        refused = Controller().run(program)
        assert list(refused.diagnostics) == list(failure.diagnostics)
        return
    assert begun.is_possible == (program.parent.name not in BEGIN_ANEW)
    pairs = []
    for values, has_time in VALUES:
        at = [("20 ms", "V.E.TRIGGER", 1)] if has_time else []
        other = Controller().run(program, ticks=1500, set=values, at=at)
        if begun.is_possible:
            pairs.append((run_of(begun, set=values, at=at, memory_trace=True), other))
    for found, expected in pairs:
        assert found == expected
        assert found.trace == expected.trace
        assert found.diagnostics == expected.diagnostics


@pytest.mark.parametrize(
    ("text", "line"),
    [
        # The message waits for the value; the block before it does not depend on any.
        (READS, 2),
        # A program that waits for nothing is decoded up to its last statement.
        ("G01 X10 F6000\nG01 X20\nM30", 3),
        # An asynchronous value is frozen when the cycle is defined (RC-302): the runs part there.
        (
            "G01 X10 F6000\n#RT CYCLE [ID = 1 SCOPE = PROG]\n"
            "$IF V.RTA.ACS.ACT_POS.X > V.E.ASYNC\nV.E.COUNT = 1\n$ENDIF\n#RT CYCLE END\nM30",
            2,
        ),
    ],
)
def test_beginning_ends_where_runs_part(text: str, line: int) -> None:
    """The beginning reaches up to the statement that waits or uses a value of the run."""
    begun = beginning(NcText("part.nc", text))
    assert begun.is_possible
    assert begun.statement is not None
    assert begun.statement.span.line == line


def test_reusable_runs_share_their_beginning_and_keep_their_results() -> None:
    """From the second run on; names in earlier results stay what they were."""
    program = NcText("part.nc", READS)
    with Controller().reusable() as controller:
        runs = [controller.run(program, set={"V.E.COUNT": i}) for i in range(5)]
    for i, run in enumerate(runs):
        assert run == Controller().run(program, set={"V.E.COUNT": i})
        assert [message.text for message in run.messages] == [str(i)]
        assert [one.text for one in run.trace.events if one.kind == "message"] == [str(i)]  # type: ignore[attr-defined]


class Watching(Plc):
    """Waits for times, functions and a condition, and acknowledges late."""

    acknowledge = after("3 ticks")

    @at("4 ms")
    def slow_down(self, hli: HliView) -> None:
        """Halve the speed."""
        hli.override_pct = 50

    @when("V.RTA.ACS.ACT_POS.X > 4")
    def go_on(self, hli: HliView) -> None:
        """Take the full speed again."""
        hli.override_pct = 100

    @on("M100")
    def count(self, hli: HliView, _function: Function) -> None:
        """Count the functions."""
        hli.write("V.E.COUNT", hli.read("V.E.COUNT") + 1)  # type: ignore[operator]


class Cyclic:
    """Works after each tick, with its own state."""

    def __init__(self) -> None:
        self.calls = 0

    def cycle(self, hli: HliView) -> None:
        """Write how often it was called."""
        self.calls += 1
        hli.write("V.E.VALUE1", self.calls % 5)
        hli.acknowledge_all()


@pytest.mark.parametrize("plc", [Watching, Cyclic, None])
def test_runs_with_a_plc_are_those_of_new_controllers(plc: type[Watching | Cyclic] | None) -> None:
    """Also where the run before had another PLC: nothing of it is left."""
    program = NcText("part.nc", f"G01 X10 F6000\nM100\n{READS}")
    with Controller().reusable() as controller:
        for i, one in enumerate((None, plc, Cyclic, plc, None, plc)):
            found = controller.run(program, set={"V.E.COUNT": i}, plc=one)
            expected = Controller().run(program, set={"V.E.COUNT": i}, plc=one)
            assert found == expected
            assert found.diagnostics == expected.diagnostics


def test_study_with_faults_of_its_plc_makes_the_rows_of_single_runs(tmp_path: Path) -> None:
    """Delays of acknowledgements and the death of the PLC need no other beginning."""
    plc = tmp_path / "cell.py"
    plc.write_text("class Cell:\n    def cycle(self, hli):\n        hli.acknowledge_all()\n")
    part = tmp_path / "part.nc"
    part.write_text("G01 X10 F6000\nM8\nG01 X20\nM30\n")
    study = Study(
        program=str(part),
        plc=str(plc),
        vary=[
            {"acknowledge": "M8", "values": ["never", "twice", "1 ms", "7 ms"]},
            {"plc_dies": "dead", "values": ["1 ms", "150 ms"]},
            {"variable": "HLI.OVERRIDE", "values": [50, 100]},
        ],
        measure={"late": "time of M8", "way": "max X"},
        until="400 ms",
    )
    rows = study.run(processes=1).rows
    assert len({row["digest"] for row in rows}) > 4
    for number in range(len(rows)):
        assert StudyRunner(study.plan).row(number) == rows[number]


def test_wrong_value_harms_no_later_run() -> None:
    """A refused run is reported, and the next one is as always."""
    program = NcText("part.nc", READS)
    with Controller().reusable() as controller:
        for _ in range(2):
            controller.run(program, set={"V.E.COUNT": 1})
            with pytest.raises(Failure, match="NOWHERE"):
                controller.run(program, set={"V.E.NOWHERE": 1})
            with pytest.raises(Failure, match="NOWHERE"):
                controller.run(program, at=[("1 ms", "V.E.NOWHERE", 1)])
        found = controller.run(program, set={"V.E.COUNT": 2})
    assert found == Controller().run(program, set={"V.E.COUNT": 2})


# --- objects that are put back --------------------------------------------------------------------


class Held:
    """An object of the project, as far as its module says."""

    __module__ = "nctakt.run.held"

    def __init__(self) -> None:
        self.number = 1
        self.items: list[object] = [1, [2]]
        self.waiting: deque[int] = deque([3])
        self.names = {"a": {1, 2}}
        self.data = memoryview(bytearray(b"abcd"))
        self.own = 5


class Slotted:
    """An object with slots, one of which is empty."""

    __module__ = "nctakt.run.held"
    __slots__ = ("empty", "held")

    def __init__(self, held: Held) -> None:
        self.held = held


def test_everything_comes_back_in_place() -> None:
    """Attributes, also those that come later, and what is in containers and memory."""
    held = Held()
    outer = Slotted(held)
    kept = KeptObjects([outer], ["own"])
    inner, names, own = held.items[1], held.names["a"], object()
    held.number, held.own = 2, own  # type: ignore[assignment]
    held.late = 1  # type: ignore[attr-defined]
    inner.append(9)  # type: ignore[attr-defined]
    held.items[:] = []
    held.waiting.clear()
    names.add(7)
    held.names = {}
    held.data[0] = 0
    outer.empty = 1  # type: ignore[attr-defined]
    outer.held = Held()
    kept.put_back()
    assert outer.held is held
    assert not hasattr(outer, "empty")
    assert not hasattr(held, "late")
    assert (held.number, held.own) == (1, own)
    assert held.items == [1, [2]]
    assert held.items[1] is inner
    assert list(held.waiting) == [3]
    assert held.names == {"a": {1, 2}}
    assert held.names["a"] is names
    assert bytes(held.data) == b"abcd"


def test_order_and_kind_of_containers_come_back() -> None:
    """Entries in another order, a value for another one, counts, an attribute taken away."""
    held = Held()
    counts = Counter(a=2, b=1)
    held.names = {"a": {1}, "b": {2}}
    held.items = [counts, held.names]
    first = held.names["a"]
    kept = KeptObjects(held)
    held.names["a"] = held.names.pop("a")  # after b now
    counts["a"] += 1
    del held.number
    kept.put_back()
    assert list(held.names.items()) == [("a", {1}), ("b", {2})]
    held.names["a"] = {1}
    kept.put_back()
    assert held.names["a"] is first
    assert counts == Counter(a=2, b=1)
    assert held.number == 1


def test_copy_of_a_renewed_object_keeps_its_content() -> None:
    """Its containers are new ones afterwards."""
    held = Held()
    kept = KeptObjects(held, renewed=(Held,))
    held.items.append(4)
    before = held.items
    kept.put_back()
    assert held.items == [1, [2]]
    assert before == [1, [2], 4]


def test_unknown_objects_are_not_kept() -> None:
    """What nobody knows how to put back, such as an iterator, is refused."""
    held = Held()
    held.items.append(iter([1]))
    with pytest.raises(NotKeptError):
        KeptObjects(held)
