# SPDX-License-Identifier: MIT
"""The PLC to derive from: policies, times, conditions, functions, inputs from a file (RC-002)."""

from __future__ import annotations

from datetime import timedelta
from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
from nctakt.plc import (
    ALL,
    NONE,
    Plc,
    PlcError,
    Policy,
    SpindlePolicy,
    after,
    at,
    load_plc,
    on,
    only,
    run_up,
    when,
)
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

FOUR = "#RT CYCLE\n$IF ONCE TRUE\nM100\nM101\nH100\n$ENDIF\n#RT CYCLE END\nM102\nG04 X0.020\nM30"


def run(text: str, plc: object, **named: object) -> Run:
    """Run a program with a PLC."""
    return Controller().run(NcText("p.nc", text), plc=plc, **named)  # type: ignore[arg-type]


class Observer(Plc):
    """Notes which functions wait after each tick."""

    def __init__(self) -> None:
        self.waiting: list[tuple[int, list[str]]] = []

    def each_tick(self, hli: PlcView) -> None:
        """Called before the acknowledgements."""
        self.waiting.append((hli.tick, [one.name for one in hli.functions()]))


@pytest.mark.parametrize(
    ("policy", "expected"),
    [
        (ALL, {0: 4, 1: 0}),
        (NONE, {0: 4, 1: 4, 19: 4}),
        (after("3 ticks"), {0: 4, 3: 4, 4: 0}),
        (only("M100", "h100"), {0: 4, 1: 2, 19: 2}),
        (only("M102", then=after("2 ms")), {1: 4, 2: 4, 3: 3}),
    ],
)
def test_policies_acknowledge_when_they_say(policy: Policy, expected: dict[int, int]) -> None:
    """What is acknowledged after tick n waits no longer after tick n + 1."""

    class Cell(Observer):
        acknowledge = policy

    plc = Cell()
    run(FOUR, plc)
    counts = {tick: len(names) for tick, names in plc.waiting}
    assert {tick: counts[tick] for tick in expected} == expected


def test_after_takes_no_negative_time() -> None:
    """900510: a function cannot be acknowledged before it appears."""
    with pytest.raises(Failure) as failure:
        after(-1)
    assert [one.id for one in failure.value.diagnostics] == [900510]


class Timed(Plc):
    """Sets a variable at times."""

    @at("10ms")
    def first(self, hli: PlcView) -> None:
        """In force in tick 10."""
        hli.write("V.E.COUNT", 1)

    @at(timedelta(microseconds=12_500))
    def second(self, hli: PlcView) -> None:
        """No tick begins at 12.5 ms: in force in tick 13."""
        hli.write("V.E.COUNT", 2)

    @at(0)
    def begin(self, hli: PlcView) -> None:
        """The first call comes after tick 0: in force in tick 1."""
        hli.write("V.E.TRIGGER", 1)


def test_values_at_times_are_in_force_as_those_of_the_command_line() -> None:
    """In the first tick that begins at or after the time (RC-001, RC-002)."""
    trace = run("G04 X0.020\nM30", Timed(), signals=["V.E.COUNT", "V.E.TRIGGER"]).trace
    assert trace is not None
    counts = trace["V.E.COUNT"].tolist()
    assert (counts.index(1.0), counts.index(2.0)) == (10, 13)
    assert trace["V.E.TRIGGER"].tolist()[:2] == [0.0, 1.0]


def test_times_count_from_the_begin_of_the_run() -> None:
    """Also where the controller has run before."""
    controller = Controller()
    controller.step(7)
    text = NcText("p.nc", "G04 X0.020\nM30")
    trace = controller.run(text, plc=Timed(), signals=["V.E.COUNT"]).trace
    assert trace is not None
    assert trace["V.E.COUNT"].tolist().index(1.0) == 10


class Watching(Plc):
    """Reacts to conditions and to functions."""

    def __init__(self) -> None:
        self.seen: list[tuple[int, str]] = []

    @when(lambda hli: hli.axis("X")["command"] > 5)
    def passed(self, hli: PlcView) -> None:
        """Each time that X gets beyond 5 mm."""
        self.seen.append((hli.tick, "passed"))

    @on("M100", "m101")
    @on("H100")
    def function(self, hli: PlcView, function: TechnologyEntry) -> None:
        """Once for each function."""
        self.seen.append((hli.tick, function.name))


def test_conditions_react_to_edges_and_functions_once_each() -> None:
    """X is at 5.194 after tick 50 for the first time (MO-14); M100 comes twice."""
    plc = Watching()
    run("M100\nG00 X10\nG00 X0\nM100\nG00 X10\nM101 H100 M102\nM30", plc)
    assert plc.seen == [
        (0, "M100"),
        (50, "passed"),
        (200, "M100"),
        (250, "passed"),
        (300, "M101"),
        (300, "H100"),
    ]


def test_functions_in_the_same_slot_are_reported_apart() -> None:
    """Each tick M100 again: each is its own function."""
    plc = Watching()
    run("#RT CYCLE\nM100\n#RT CYCLE END\nG04 X0.004\nM30", plc)
    assert plc.seen == [(tick, "M100") for tick in range(4)]


def test_derived_classes_inherit_and_replace(tmp_path: Path) -> None:
    """A method without its mark does nothing by itself; marks of the base stay."""

    class Base(Plc):
        @at("2ms")
        def write(self, hli: PlcView) -> None:
            hli.write("V.E.COUNT", 5)

    class Changed(Base):
        @at("4ms")
        def write(self, hli: PlcView) -> None:
            hli.write("V.E.COUNT", 6)

    trace = run("G04 X0.010\nM30", Changed(), signals=["V.E.COUNT"]).trace
    assert trace is not None
    assert trace["V.E.COUNT"].tolist()[3:5] == [0.0, 6.0]


# --- inputs from a file --------------------------------------------------------------------------


PLC_FILE = "from nctakt.plc import Plc\n\nclass Cell(Plc):\n    inputs = 'inputs.csv'\n"


def with_inputs(tmp_path: Path, text: str) -> object:
    """A PLC from a file, with inputs beside it."""
    (tmp_path / "inputs.csv").write_text(text, "utf-8")
    (tmp_path / "plc.py").write_text(PLC_FILE, "utf-8")
    return load_plc(tmp_path / "plc.py")


def test_inputs_come_at_their_times(tmp_path: Path) -> None:
    """Empty cells leave values as they are; rows may be in any order."""
    text = "time, V.E.COUNT ,HLI.OVERRIDE\n# the door\n0.01,3,\n\n5ms,,50\n12ms,4,100\n"
    plc = with_inputs(tmp_path, text)
    trace = run("G04 X0.020\nM30", plc, signals=["V.E.COUNT", "HLI.OVERRIDE"]).trace
    assert trace is not None
    counts, overrides = trace["V.E.COUNT"].tolist(), trace["HLI.OVERRIDE"].tolist()
    assert (counts.index(3.0), counts.index(4.0)) == (10, 12)
    assert (overrides.index(50.0), overrides[12]) == (5, 100.0)


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("V.E.COUNT,time\n", [900655]),
        ("", [900655]),
        ("time\n", [900655]),
        ("time,V.E.COUNT\n1ms\nsoon,1\n2ms,much\n", [900654, 900510, 900512]),
    ],
)
def test_all_mistakes_of_a_file_of_inputs_are_reported(
    tmp_path: Path, text: str, numbers: list[int]
) -> None:
    """When the PLC is made, before the first tick."""
    with pytest.raises(PlcError) as caught:
        with_inputs(tmp_path, text)
    assert [found.id for found in caught.value.diagnostics] == [900522, *numbers]


def test_a_file_of_inputs_that_is_not_there(tmp_path: Path) -> None:
    """900500 below the error of the PLC's file."""
    (tmp_path / "plc.py").write_text(PLC_FILE, "utf-8")
    with pytest.raises(PlcError) as caught:
        load_plc(tmp_path / "plc.py")
    assert [found.id for found in caught.value.diagnostics] == [900522, 900500]


# --- mistakes in the user's code -----------------------------------------------------------------


MISTAKE = """
import json
from broken_helper import broken
from nctakt.plc import Plc, on

class Cell(Plc):
    @on("M100")
    def clamp(self, hli, function):
        broken()
"""


def test_a_mistake_shows_the_users_lines_only(tmp_path: Path) -> None:
    """Not the base class, not the library that was called: files next to the PLC's own."""
    (tmp_path / "plc.py").write_text(MISTAKE, "utf-8")
    helper = "import json\n\ndef broken():\n    json.loads('{')\n"
    (tmp_path / "broken_helper.py").write_text(helper, "utf-8")
    with pytest.raises(PlcError) as caught:
        run("M100\nM30", load_plc(tmp_path / "plc.py"))
    (found,) = caught.value.diagnostics
    reported = found.text()
    assert found.id == 900523
    assert "after tick 0" in reported
    assert "JSONDecodeError" in reported
    assert "broken()" in reported
    assert "json.loads('{')" in reported
    assert reported.count("File ") == 2


def test_a_write_to_an_unknown_variable_is_a_diagnostic(tmp_path: Path) -> None:
    """With its own number and the line of the user's file."""
    text = MISTAKE.replace("broken()", "hli.write('V.E.COUTN', 1)").replace(
        "from broken_helper import broken\n", ""
    )
    (tmp_path / "plc.py").write_text(text, "utf-8")
    with pytest.raises(Failure) as caught:
        run("M100\nM30", load_plc(tmp_path / "plc.py"))
    assert [found.id for found in caught.value.diagnostics] == [900523, 900541, 901006]
    assert "hli.write('V.E.COUTN', 1)" in caught.value.diagnostics[0].text()


# --- spindles that the PLC turns ------------------------------------------------------------------

#: S3 gets jobs in ticks 0, 300, 600 and 900.
JOBS = """#RT CYCLE [ID=1 SCOPE=GLOBAL]
$IF ONCE 1
S3[M3 REV=1000]
$ENDIF
$IF ONCE V.E.COUNT >= 300
S3[M4 REV=500]
$ENDIF
$IF ONCE V.E.COUNT >= 600
S3[M4 M19 REV=200 POS=90]
$ENDIF
$IF ONCE V.E.COUNT >= 900
S3[M5]
$ENDIF
V.E.COUNT += 1
#RT CYCLE END
G04 X1.5
M30"""


@pytest.mark.parametrize(
    ("policy", "reached"),
    [
        (ALL, [1, 301, 601, 901]),
        (after("3 ms"), [4, 304, 604, 904]),
        (only("S3", then=after(0.02)), [21, 321, 621, 921]),
        # 1000 in 0.1 s; 1500 in 0.15 s; from -500 to 200, then to 0: 0.09 s; at rest already
        (run_up(10_000), [100, 450, 690, 901]),
    ],
)
def test_jobs_of_plc_spindles_are_acknowledged_as_they_say(
    policy: SpindlePolicy, reached: list[int]
) -> None:
    """RC-404: the tick after the acknowledgement knows that the job is over.

    M19 has brought the spindle to a standstill, so M5 has nothing to do.
    """

    class Cell(Plc):
        spindles = policy

    made = run(JOBS, Cell())
    assert [event.tick for event in made.events if event.kind == "spindle_reached"] == reached


def test_a_spindle_that_nobody_acknowledges_is_busy() -> None:
    """60331: the second job finds the first one still there."""

    class Cell(Plc):
        spindles = NONE

    assert [found.id for found in run(JOBS, Cell()).errors] == [60331]


def test_a_method_gets_each_job_of_a_spindle() -> None:
    """Once each, after the tick that commands it, with what the spindle turned with before."""
    seen: list[tuple[int, int, float, float]] = []

    class Cell(Plc):
        spindles = run_up(10_000)

        @on("S3")
        def turn(self, hli: PlcView, job: SpindleEntry) -> None:
            """Notes the job."""
            seen.append((hli.tick, job.function, job.speed, job.speed_before))

    run(JOBS, Cell())
    assert seen == [
        (0, 3, 1000.0, 0.0),
        (300, 4, 500.0, 1000.0),
        (600, 19, 200.0, -500.0),
        (900, 5, 0.0, 0.0),
    ]


@pytest.mark.parametrize("rate", [0.0, -1.0, float("inf")])
def test_a_spindle_changes_its_speed_at_some_rate(rate: float) -> None:
    """Revolutions per minute in a second, above 0."""
    with pytest.raises(ValueError, match="per second"):
        run_up(rate)
