# SPDX-License-Identifier: MIT
"""Several PLCs of one machine: on the command line, in the project file, in Python and in tests."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import pytest
from support.plc_rig import EACH_TICK

from nctakt import Controller, HliView, NcText, Study
from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.debugger.arguments import Arguments
from nctakt.debugger.launch import read_configuration
from nctakt.files.access import FileAccess
from nctakt.fmu.cell import Cell
from nctakt.plc import load_plc
from nctakt.project.run_settings import run_settings
from nctakt.session.session import Session
from nctakt.testing.expectations import read_script
from nctakt.testing.queries import run_program

OPEN = "IF NOT fbHli.Initialized THEN fbHli(); RETURN; END_IF\n"
CELL = "PROGRAM MAIN VAR RETAIN n : UDINT; END_VAR n := n + {step}; END_PROGRAM" + EACH_TICK
OVERRIDE = (
    "PROGRAM MAIN VAR fbHli : MCV_HliInterface; END_VAR "
    + OPEN
    + "gpCh[0]^.head.plc_present_w := TRUE; "
    "gpCh[0]^.bahn_mc_control.override.enable_w := TRUE; "
    "gpCh[0]^.bahn_mc_control.override.command_w := {override}; END_PROGRAM" + EACH_TICK
)
PYTHON = """
class Cell:
    def cycle(self, hli):
        hli.acknowledge_all()
"""
PLCS = ("one/cell.st", "two/cell.st", "cell.py")
WORDS = [word for plc in PLCS for word in ("--plc", plc)]


@pytest.fixture(name="cell", autouse=True)
def _cell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for folder, step in (("one", 1), ("two", 10)):
        Path(folder).mkdir()
        Path(folder, "cell.st").write_text(CELL.format(step=step), "utf-8")
    Path("cell.py").write_text(PYTHON, "utf-8")
    Path("part.nc").write_text("N10 M7\nN20 G04 0.01\nM30\n", "utf-8")


def _counts(*words: str) -> list[list[int]]:
    """Both counters in the ticks of a run with these words."""
    signals = "MAIN.n,cell_2.MAIN.n"
    assert (
        main(["run", "part.nc", *words, "--signals", signals, "--trace", "run.csv", "--quiet"]) == 0
    )
    lines = Path("run.csv").read_text("utf-8").splitlines()
    rows = [line.split(",") for line in lines if line[:1].isdigit()]
    return [[int(row[2]), int(row[3])] for row in rows]


def test_all_files_of_the_command_line_run() -> None:
    """ST-803: two projects of one name count by 1 and 10 a tick; Python acknowledges M7."""
    assert _counts(*WORDS)[:3] == [[1, 10], [2, 20], [3, 30]]


def test_a_tape_has_what_all_of_them_do() -> None:
    """ST-820: the projects run again, and the tape gives what the PLC in Python does."""
    assert main(["run", "part.nc", *WORDS, "--record", "run.tape", "--quiet"]) == 0
    head = json.loads(Path("run.tape").read_text("utf-8").splitlines()[0])
    assert [head["words"]["plc"], head["has_plc"]] == [["one/cell.st", "two/cell.st"], True]
    Path("cell.py").unlink()
    assert main(["replay", "run.tape"]) == 0
    with Session.of_tape("run.tape") as session:
        session.step(8)
        assert list(session.read("MAIN.n", "cell_2.MAIN.n")) == [8, 80]
        session.step(50)  # M7 waits for the acknowledgement of the tape
        assert session.tick == 12


def test_the_project_file_names_several(capsys: pytest.CaptureFixture[str]) -> None:
    """A list of files, alone or in the table of the PLC; one that is missing is named."""
    for entry in (f"plc = {json.dumps(PLCS)}", f"[plc]\nfile = {json.dumps(PLCS)}"):
        Path("nctakt.toml").write_text(entry + "\n", "utf-8")
        assert _counts("--trust")[1] == [2, 20]
    Path("nctakt.toml").write_text('plc = ["one/cell.st", "three.st"]\n', "utf-8")
    assert main(["run", "part.nc", "--trust"]) == 2
    assert "three.st" in capsys.readouterr().err


def test_retained_values_of_one_path_are_reported_apart() -> None:
    """ST-406: the second project's variable has the project before its path, in the file, too."""
    for ticks in (3, 6):
        words = ["--ticks", "3", "--retain", "kept.json", "--quiet"]
        assert main(["run", "part.nc", *WORDS, *words]) == 0
        kept = json.loads(Path("kept.json").read_text("utf-8"))
        assert kept == {"MAIN.n": ticks, "cell_2.MAIN.n": 10 * ticks}


def test_python_and_tests_take_a_list() -> None:
    """``plc=[…]`` of objects, classes and files; a variable is found by its project as well."""
    plcs = [load_plc(path) for path in PLCS]
    signals = ["cell.MAIN.n", "cell_2.MAIN.n"]
    nc = NcText("part.nc", "N10 M7\nM30")
    trace = Controller().run(nc, plc=plcs, signals=signals).trace
    assert [int(trace[name][1]) for name in signals] == [2, 20]
    for given in (list(PLCS), [*PLCS[:2], load_plc("cell.py")]):
        found = run_program(Controller(), "part.nc", Path(), plc=given, signals=signals).run.trace
        assert [int(found[name][1]) for name in signals] == [2, 20]


def test_comments_of_a_program_name_several() -> None:
    """``; given: plc`` on each line adds one, in this order."""
    text = "".join(f"; given: plc {plc}\n" for plc in PLCS)
    named = read_script(Path("part.nc"), text).named(Path())
    assert [
        named.plcs,
        run_settings([], FileAccess(), named).plcs,
    ] == [PLCS, tuple(map(Path, PLCS))]


@pytest.mark.parametrize(("first", "second", "percent"), [(500, 800, 80), (800, 500, 50)])
def test_the_last_one_of_a_tick_wins(first: int, second: int, percent: int) -> None:
    """Decision: where two projects write one element in a tick, the second one's value counts."""
    for folder, override in (("one", first), ("two", second)):
        Path(folder, "cell.st").write_text(OVERRIDE.format(override=override), "utf-8")
    controller = Controller()
    nc = NcText("part.nc", "G04 1\nM30")
    controller.run(nc, plc=[load_plc(path) for path in PLCS[:2]], ticks=10)
    assert controller.hli.override_pct == percent


@pytest.mark.parametrize("order", [("one", "two"), ("two", "one")])
def test_each_of_them_has_its_own_places_in_events(order: tuple[str, str]) -> None:
    """An acknowledgement and a message have file and line of the PLC that they come from."""
    gate = OPEN + (
        "gpCh[0]^.head.plc_present_w := TRUE;\n"
        "IF gpCh[0]^.techno_unit_std_sync[0].please_rw THEN\n"
        "gpCh[0]^.techno_unit_std_sync[0].please_rw := FALSE;\n"
        "gpCh[0]^.techno_unit_std_sync[0].done_w := TRUE;\n"
        "END_IF\nEND_PROGRAM"
    )
    Path("one/gate.st").write_text(
        f"PROGRAM MAIN VAR fbHli : MCV_HliInterface; END_VAR\n{gate}{EACH_TICK}", "utf-8"
    )
    Path("two/gate.st").write_text(
        "PROGRAM MAIN\nVAR n : UDINT; END_VAR\nn := n + 1;\nIF n = 2 THEN\n"
        f"ADSLOGSTR(1, 'two', '');\nEND_IF\nEND_PROGRAM{EACH_TICK}",
        "utf-8",
    )
    plcs = [f"{folder}/gate.st" for folder in order]
    with Session(NcText("part.nc", "G04 0.02\nM7\nM30"), plc=plcs) as session:
        events = session.run().events
    places = {
        one.kind: f"{one.span.file}:{one.span.line}"
        for one in events
        if one.kind in ("acknowledged", "message") and one.span is not None
    }
    assert places == {"acknowledged": "one/gate.st:6", "message": "two/gate.st:5"}


def test_a_project_wins_over_python() -> None:
    """Decision: Python writes after tick n, and the project in tick n + 1 before its end."""

    class Slow:
        def cycle(self, hli: HliView) -> None:
            hli["gpCh[0]^.bahn_mc_control.override.command_w"] = 300

    Path("one", "cell.st").write_text(OVERRIDE.format(override=500), "utf-8")
    controller = Controller()
    nc = NcText("part.nc", "G04 1\nM30")
    controller.run(nc, plc=[Slow, load_plc(PLCS[0])], ticks=10)
    assert controller.hli.override_pct == 50


def test_two_in_python_are_refused(capsys: pytest.CaptureFixture[str]) -> None:
    """902761: two PLCs in Python do not run together, which is reported before the first tick."""
    assert main(["run", "part.nc", "--plc", "cell.py", "--plc", "cell.py"]) == 2
    assert "902761" in capsys.readouterr().err
    with pytest.raises(Failure, match="902761"):
        Controller().run(NcText("a.nc", "M30"), plc=[load_plc("cell.py"), load_plc("cell.py")])
    study = {"program": "part.nc", "plc": ["cell.py", "cell.py"], "measure": {"t": "duration"}}
    with pytest.raises(Failure, match="902761"):
        Study(**study).run(processes=1)


def test_an_fmu_has_all_of_them() -> None:
    """Its cell runs the three files that it holds; a state is put back with the data of both."""
    pytest.importorskip("pythonfmu3")
    outputs = "MAIN.n,cell_2.MAIN.n"
    words = ["fmu", "part.nc", *WORDS, "--outputs", outputs, "-o", "part.fmu", "--quiet"]
    assert main(words) == 0
    with zipfile.ZipFile("part.fmu") as archive:
        archive.extractall("unpacked")
    for plc in PLCS:
        Path(plc).unlink()
    cell = Cell(Path("unpacked", "resources"))
    cell.step(0.0, 0.005)
    assert cell.get([1, 2]) == [5, 50]
    state = cell.state()
    cell.step(0.005, 0.003)
    assert cell.get([1, 2]) == [8, 80]
    cell.put_back(state)
    assert cell.get([1, 2]) == [5, 50]
    cell.close()


def test_a_study_measures_all_of_them() -> None:
    """Each run restarts with all of them; a recorded run is replayed without the one in Python.

    The program waits 10 ms for M7, which is acknowledged after tick 0, and G04.
    """
    study = Study(
        program="part.nc",
        plc=list(PLCS),
        until="0.008 s",
        vary=[{"name": "first", "variable": "MAIN.n", "values": [0, 100]}],
        measure={"one": "MAIN.n at end", "two": "cell_2.MAIN.n at end"},
    )
    rows = list(study.run(processes=1).rows)
    assert [(row["one"], row["two"]) for row in rows] == [(8, 80), (108, 80)]
    study.record(1, "run.tape")
    Path("cell.py").unlink()
    assert main(["replay", "run.tape", "--quiet"]) == 0


def test_a_plan_and_its_project_name_several() -> None:
    """A list of files in the plan; what it leaves out is that of the project."""
    plan = 'program = "part.nc"\nuntil = "0.008 s"\n[measure]\ntwo = "cell_2.MAIN.n at end"\n'
    Path("plan.toml").write_text(f"plc = {json.dumps(PLCS)}\n{plan}", "utf-8")
    assert [row["two"] for row in Study("plan.toml").run(processes=1).rows] == [80]
    Path("plan.toml").write_text(plan, "utf-8")
    Path("nctakt.toml").write_text(f"plc = {json.dumps(PLCS)}\n", "utf-8")
    assert [row["two"] for row in Study("plan.toml").run(processes=1).rows] == [80]


def test_a_session_goes_back_with_all_of_them() -> None:
    """ST-820: both count in each tick, Python acknowledges; a branch is a tape."""
    names = ["MAIN.n", "cell_2.MAIN.n"]
    with Session("part.nc", plc=PLCS) as session:
        session.step(8)
        assert list(session.read(*names)) == [8, 80]
        session.go_to(3)
        assert list(session.read(*names)) == [3, 30]
        session.step(5)
        assert list(session.read(*names)) == [8, 80]
    with Session("part.nc", plc=PLCS[:2]) as session:
        session.step(20)
        session.save("both.tape")
    with Session.of_tape("both.tape") as session:
        session.step(5)
        assert list(session.read(*names)) == [5, 50]
    with Session("part.nc", plc=PLCS) as session:
        session.step(20)
        assert session.is_over
        session.save("all.tape")
    Path("cell.py").unlink()
    assert main(["replay", "all.tape", "--quiet"]) == 0
    with Session.of_tape("all.tape") as session:
        session.step(8)
        session.go_to(3)
        session.step(20)
        assert [session.tick, *session.read(*names)] == [12, 12, 120]


def test_a_session_takes_one_in_python() -> None:
    """902761: a second PLC in Python is refused by name."""
    with pytest.raises(Failure, match="902761"):
        Session("part.nc", plc=["cell.py", "cell.py"])


def test_a_launch_names_several() -> None:
    """The debugger's session has both, and a file that is missing is named."""
    launch = {"program": "part.nc", "plc": list(PLCS[:2])}
    with read_configuration(Arguments(launch, "launch"), ()).open() as session:
        session.step(4)
        assert list(session.read("MAIN.n", "cell_2.MAIN.n")) == [4, 40]
