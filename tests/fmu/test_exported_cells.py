# SPDX-License-Identifier: MIT
"""``nctakt fmu``: a machine with its program as an FMU, run by FMPy and equal to ``run``."""

from __future__ import annotations

import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nctakt.cli import main
from nctakt.files.access import FileAccess
from nctakt.fmu.description import read_fmu
from nctakt.fmu.instance import FmuInstance
from nctakt.run.controller import Controller

fmpy = pytest.importorskip("fmpy", reason="FMUs need FMPy (extra fmi)")
pytest.importorskip("pythonfmu", reason="FMUs of nctakt need pythonfmu (extra fmi)")
pytest.importorskip("pythonfmu3", reason="FMUs of nctakt need pythonfmu3 (extra fmi)")

PROGRAM = """\
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 5
    V.E.COUNT = V.E.COUNT + 1
  $ENDIF
#RT CYCLE END
G01 X20 Y5 F6000
L below.nc
M30
"""
PLC = """\
from speeds import SLOW


class Cell:
    def cycle(self, hli):
        if hli.tick == 40:
            hli.override_pct = SLOW
        hli.acknowledge_all()
"""
NAMES = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "PATH.SPEED", "BLOCK", "V.E.COUNT"]

Reported = Callable[..., tuple[int, str, str]]


@pytest.fixture
def reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Reported:
    """Run a command beside ``part.nc`` and ``cell.py``; exit code and both outputs."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text(PROGRAM, "utf-8")
    Path("below.nc").write_text("G01 X3 F3000\nM17\n", "utf-8")
    Path("cell.py").write_text(PLC, "utf-8")
    Path("speeds.py").write_text("SLOW = 60\n", "utf-8")

    def command(*words: str) -> tuple[int, str, str]:
        code = main(words)
        shown = capsys.readouterr()
        return code, shown.out, shown.err

    return command


def simulated(file: str, step: float, end: float, **further: Any) -> Any:
    return fmpy.simulate_fmu(
        file, stop_time=end, step_size=step, output_interval=step, output=NAMES, **further
    )


@pytest.mark.parametrize("version", [pytest.param("2", marks=pytest.mark.nightly), "3"])
def test_an_fmu_does_what_the_run_does(reported: Reported, version: str) -> None:
    """It is valid, and each value after each step is that of the trace; so with steps of 2 ticks.

    After the end of the program the machine is (and ticks).
    """
    from fmpy.validation import validate_fmu  # noqa: PLC0415 - an extra

    names = ("--outputs", ",".join(NAMES), "--fmi", version)
    code, out, err = reported("fmu", "part.nc", "--plc", "cell.py", "-o", "cell.fmu", *names)
    assert (code, err) == (0, "")
    assert out.startswith(f"cell.fmu: FMI {version}.0, ")
    assert validate_fmu("cell.fmu") == []
    Path("cell.py").unlink()
    Path("speeds.py").write_text("SLOW = 1\n", "utf-8")
    Path("part.nc").rename("other.nc")  # it has all that it needs
    Path("cell.py").write_text(PLC.replace("SLOW", "60").partition("\n")[2], "utf-8")
    from nctakt.plc import load_plc  # noqa: PLC0415 - it is written here

    run = Controller().run("other.nc", plc=load_plc("cell.py"), signals=NAMES)
    assert run.trace["V.E.COUNT"][-1] == 1
    for ticks in (1, 2):
        found = simulated("cell.fmu", ticks / 1000, run.ticks / 1000 + 0.01)
        for name in NAMES:
            expected = run.trace[name][ticks - 1 :: ticks]
            np.testing.assert_array_equal(found[name][1 : len(expected) + 1], expected)
        assert found["X.ACS.ACT_POS"][-1] == 3.0


@pytest.mark.parametrize("version", [pytest.param("2", marks=pytest.mark.nightly), "3"])
def test_an_input_counts_from_the_next_tick(reported: Reported, version: str) -> None:
    """RC-002, as a value that is set at that time; instances follow each other in one process."""
    names = ("--outputs", ",".join(NAMES), "--inputs", "HLI.OVERRIDE", "--fmi", version)
    assert reported("fmu", "part.nc", "-o", "cell.fmu", *names)[0] == 0
    run = Controller().run("part.nc", at=[("100 ms", "HLI.OVERRIDE", 50)], signals=NAMES)
    described = read_fmu(Path("cell.fmu"), FileAccess())
    folder = fmpy.extract("cell.fmu", Path("unpacked").absolute())
    override = described.variables["HLI.OVERRIDE"]
    read = [described.variables[name] for name in NAMES[:4]]
    for _ in range(2):
        instance = FmuInstance(described, Path(folder))
        instance.begin({}, {})
        for tick in range(run.ticks):
            if tick == 100:
                instance.set({override: 50.0})
            instance.step(tick * 1000, 1000)
            assert instance.get(read) == {name: run.trace[name][tick] for name in NAMES[:4]}
        instance.end()


def test_instances_are_independent_and_can_be_reset(reported: Reported) -> None:
    """Two of one FMU in turn; a step that is no whole number of ticks is an error with its text."""
    names = ("--outputs", "X.ACS.ACT_POS", "--inputs", "HLI.OVERRIDE")
    assert reported("fmu", "part.nc", "-o", "cell.fmu", *names)[0] == 0
    described = fmpy.read_model_description("cell.fmu")
    log: list[str] = []

    def note(_: Any, status: int, category: bytes, message: bytes) -> None:
        log.append(message.decode())

    folder = fmpy.extract("cell.fmu", Path("unpacked").absolute())
    both = []
    for name in "ab":
        one = fmpy.fmi3.FMU3Slave(
            name,
            guid=described.guid,
            unzipDirectory=str(folder),
            modelIdentifier="cell",
        )
        one.instantiate(logMessage=note, loggingOn=True)
        one.enterInitializationMode()
        one.exitInitializationMode()
        both.append(one)
    first, second = both
    second.setFloat64([2], [50.0])
    for tick in range(50):
        for one in both:
            one.doStep(tick / 1000, 0.001)
    first_x, second_x = (one.getFloat64([1])[0] for one in both)
    assert first_x > second_x > 0.0
    first.reset()
    first.enterInitializationMode()
    first.exitInitializationMode()
    for tick in range(50):
        first.doStep(tick / 1000, 0.001)
    assert first.getFloat64([1]) == [first_x]
    with pytest.raises(fmpy.fmi1.FMICallException):
        second.doStep(0.05, 0.0005)
    assert "902616: a communication step of 0.0005 s is not a whole number of ticks" in log[-1]
    first.freeInstance()


@pytest.mark.nightly
def test_it_runs_beside_a_machine_of_nctakt(reported: Reported) -> None:
    """As ``--fmu`` of another run: both tick together."""
    names = ("--outputs", "X.ACS.ACT_POS", "--inputs", "V.E.VALUE")
    assert reported("fmu", "part.nc", "-o", "cell.fmu", *names)[0] == 0
    Path("nctakt.toml").write_text('[fmu.outputs]\n"X.ACS.ACT_POS" = "V.E.VALUE"\n', "utf-8")
    words = ("--trace", "a.csv", "--signals", "X.ACS.ACT_POS,V.E.VALUE")
    assert reported("run", "part.nc", "--fmu", "cell.fmu", *words)[0] == 0
    rows = [line.split(",")[:4] for line in Path("a.csv").read_text("utf-8").splitlines()[1:]]
    positions, values = ([row[column] for row in rows] for column in (2, 3))
    assert [float(one) for one in values[1:]] == [float(one) for one in positions[:-1]]


@pytest.mark.nightly
def test_the_same_run_gives_the_same_bytes_with_its_own_lists(reported: Reported) -> None:
    """Lists lie beside the program in the FMU; no clock and no path of this computer is in it."""
    assert reported("new", "mill")[0] == 0
    words = ("fmu", "part.nc", "--machine", "mill", "--quiet")
    for name in ("a/cell.fmu", "b/cell.fmu"):
        Path(name).parent.mkdir()
        assert reported(*words, "-o", name) == (0, "", "")
    assert Path("a/cell.fmu").read_bytes() == Path("b/cell.fmu").read_bytes()
    with zipfile.ZipFile("a/cell.fmu") as archive:
        listed = archive.namelist()
        described = archive.read("modelDescription.xml").decode()
    assert "resources/files/mill/hochlauf.lis" in listed
    assert 'name="X.ACS.ACT_POS" valueReference="1" description="' in described
    assert 'unit="mm"' in described


def test_what_makes_no_fmu_is_reported(reported: Reported) -> None:
    """Names, inputs, mistakes of the program; nothing is written."""
    for words, number in (
        (("-o", "9.fmu"), "902618"),
        (("-o", "cell.zip"), "902618"),
        (("-o", "cell.fmu", "--inputs", "X.ACS.ACT_POS"), "902617"),
        (("-o", "cell.fmu", "--outputs", "X.ACS.ACT_PSO"), "ACT_POS"),
    ):
        code, _, err = reported("fmu", "part.nc", *words)
        assert (code, number in err) == (2, True)
    Path("part.nc").write_text("G01 X\n", "utf-8")
    assert reported("fmu", "part.nc", "-o", "cell.fmu")[0] == 1
    assert not Path("cell.fmu").exists()


#: Instances of a test, which are freed at its end, also those that have refused something.
CELLS: list[Any] = []


@pytest.fixture(autouse=True)
def _freed() -> Iterator[None]:
    yield
    while CELLS:
        CELLS.pop().freeInstance()


def cell_of(name: str, version: str, log: list[str] | None = None) -> Any:
    """An instance in FMPy, initialised."""
    described = fmpy.read_model_description("cell.fmu")
    folder = fmpy.extract("cell.fmu", Path(f"unpacked{name}").absolute())
    kind = fmpy.fmi2.FMU2Slave if version == "2" else fmpy.fmi3.FMU3Slave
    one = kind(
        instanceName=name,
        guid=described.guid,
        unzipDirectory=str(folder),
        modelIdentifier="cell",
    )
    if log is None:
        one.instantiate()
    else:
        one.instantiate(logMessage=lambda *said: log.append(said[-1].decode()), loggingOn=True)
    if version == "2":
        one.setupExperiment(startTime=0.0)
        one.get, one.set = one.getReal, one.setReal
        one.state, one.put_back, one.free = one.getFMUstate, one.setFMUstate, one.freeFMUstate
        one.to_bytes, one.of_bytes = one.serializeFMUstate, one.deSerializeFMUstate
    else:
        one.get, one.set = one.getFloat64, one.setFloat64
        one.state, one.put_back, one.free = one.getFMUState, one.setFMUState, one.freeFMUState
        one.to_bytes, one.of_bytes = one.serializeFMUState, one.deserializeFMUState
    one.enterInitializationMode()
    one.exitInitializationMode()
    CELLS.append(one)
    return one


def values_of(cell: Any, begin: int, end: int, override: float = 100.0) -> list[list[float]]:
    """All outputs after each tick; the override changes each 7 ticks."""
    references = list(range(1, len(NAMES) + 1))
    found = []
    for tick in range(begin, end):
        if tick % 7 == 0:
            cell.set([len(NAMES) + 1], [override - tick % 5])
        cell.doStep(tick / 1000, 0.001)
        found.append(cell.get(references))
    return found


@pytest.mark.parametrize("version", ["2", "3"])
@pytest.mark.parametrize("plc", [None, "cell.py", "cell.st"])
def test_a_state_is_put_back(reported: Reported, version: str, plc: str | None) -> None:
    """Saved, run on, put back, run on again: the same values; so in another instance, from bytes.

    What is set after a state was put back belongs to that branch alone.
    """
    Path("cell.st").write_text(
        "PROGRAM MAIN\nVAR n : DINT; END_VAR\nn := n + 1;\nEND_PROGRAM\n", "utf-8"
    )
    names = ["--outputs", ",".join(NAMES), "--inputs", "HLI.OVERRIDE", "--fmi", version]
    code, _, err = reported(
        "fmu", "part.nc", "-o", "cell.fmu", *names, *(["--plc", plc] if plc else [])
    )
    assert (code, err) == (0, "")
    cell = cell_of("a", version)
    values_of(cell, 0, 100)
    early = cell.state()
    first = values_of(cell, 100, 300)
    late = cell.state()
    after = values_of(cell, 300, 330)
    cell.put_back(early)
    slow = values_of(cell, 100, 300, 50.0)
    assert slow != first
    for _ in range(2):
        cell.put_back(early)
        assert values_of(cell, 100, 300) == first
    cell.put_back(late)
    assert values_of(cell, 300, 330) == after
    data = cell.to_bytes(late)
    other = cell_of("b", version)
    read = other.of_bytes(data)
    other.put_back(read)
    assert values_of(other, 300, 330) == after
    other.free(read)
    cell.free(early)
    cell.free(late)


def test_a_state_that_does_not_come_back_is_refused(reported: Reported) -> None:
    """A PLC whose state is in another module does otherwise the second time (902843).

    A state of another FMU (902842) and bytes that are none (902841) are refused as well.
    """
    Path("counted.py").write_text("CALLS = []\n", "utf-8")
    Path("cell.py").write_text(
        "import counted\n\n\nclass Cell:\n    def cycle(self, hli):\n"
        "        counted.CALLS.append(1)\n"
        "        hli.override_pct = 50 if len(counted.CALLS) < 50 else 100\n"
        "        hli.acknowledge_all()\n",
        "utf-8",
    )
    words = ("fmu", "part.nc", "-o", "cell.fmu", "--outputs", ",".join(NAMES))
    assert reported(*words, "--plc", "cell.py")[0] == 0
    log: list[str] = []
    cell = cell_of("a", "3", log)
    for tick in range(100):
        cell.doStep(tick / 1000, 0.001)
    state = cell.state()
    data = cell.to_bytes(state)
    with pytest.raises(fmpy.fmi1.FMICallException):
        cell.put_back(state)
    assert "902843" in log[-1]
    assert "cell.py" in log[-1]
    broken = cell_of("broken", "3", log)
    unread = broken.of_bytes(data[:-1] + b"\n1")
    with pytest.raises(fmpy.fmi1.FMICallException):
        broken.put_back(unread)
    assert "902841" in log[-1]
    Path("cell.fmu").unlink()
    assert reported(*words)[0] == 0
    other = cell_of("b", "3", log)
    with pytest.raises(fmpy.fmi1.FMICallException):
        other.put_back(other.of_bytes(data))
    assert "902842" in log[-1]


def test_a_value_that_an_input_cannot_have_is_refused(reported: Reported) -> None:
    """With a message in the importer's log; the instance can be freed."""
    words = ("--outputs", ",".join(NAMES), "--inputs", "HLI.OVERRIDE")
    assert reported("fmu", "part.nc", "-o", "cell.fmu", *words)[0] == 0
    log: list[str] = []
    cell = cell_of("a", "3", log)
    with pytest.raises(fmpy.fmi1.FMICallException):
        cell.set([len(NAMES) + 1], [float("nan")])
    assert "HLI.OVERRIDE" in log[-1]
