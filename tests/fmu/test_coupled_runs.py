# SPDX-License-Identifier: MIT
"""A run with an FMU next to it: what it gets and when, what counts from when on, how it fails.

The FMU is built here: y = gain * u with u and y in m, n counts its steps, ``above.ten`` is y > 10.
"""

from __future__ import annotations

import importlib
import itertools
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.small_fmus import ABSENT, SMALL, build_library, description, write_fmu

from nctakt.cli import main
from nctakt.fmu import Fmu, FmuError
from nctakt.run.controller import Controller, NcText

PROGRAM = "G01 X20 F6000\nM30\n"
SIGNALS = ["X.ACS.ACT_POS", "V.E.VALUE", "V.E.COUNT", "V.E.FLAG"]
OUTPUTS = {"y": "V.E.VALUE", "n": "V.E.COUNT", "above.ten": "V.E.FLAG"}


@pytest.fixture(scope="module")
def libraries(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    """The libraries for FMI 2.0 and 3.0."""
    return {
        version: build_library(version, tmp_path_factory.mktemp("library")) for version in (2, 3)
    }


@pytest.fixture(params=[pytest.param(2, marks=pytest.mark.nightly), 3], ids=["FMI 2.0", "FMI 3.0"])
def plant(request: pytest.FixtureRequest, libraries: dict[int, Path], tmp_path: Path) -> Path:
    """The FMU."""
    version = int(request.param)
    return write_fmu(tmp_path / "plant.fmu", description(version), libraries[version])


def run_with(fmu: Fmu, text: str = PROGRAM) -> Any:
    return Controller().run(NcText("part.nc", text), fmu=fmu, signals=SIGNALS)


def test_an_output_counts_from_the_tick_after_its_inputs(plant: Path) -> None:
    """RC-002: what tick n has left is in the FMU's step, and its output in tick n + 1.

    Units are converted: u is in m, the position in mm. The outputs of the first tick are those
    before the first step.
    """
    fmu = Fmu(plant, inputs={"u": "X.ACS.ACT_POS"}, outputs=OUTPUTS, start={"gain": 1000.0})
    run = run_with(fmu)
    assert run.state == "ended"
    position, value = run.trace["X.ACS.ACT_POS"], run.trace["V.E.VALUE"]
    assert value[0] == 0.0
    np.testing.assert_allclose(value[1:], position[:-1], rtol=1e-12)
    assert list(run.trace["V.E.COUNT"]) == list(range(run.ticks))
    assert list(run.trace["V.E.FLAG"]) == [0, *(position[:-1] > 10.0)]


def test_a_communication_step_is_a_number_of_ticks(plant: Path) -> None:
    """Its outputs change with each step alone; each run begins a new instance."""
    fmu = Fmu(plant, every="5 ms", inputs={"u": "X.ACS.ACT_POS"}, outputs={"n": "V.E.COUNT"})
    for _ in range(2):
        run = run_with(fmu)
        assert list(run.trace["V.E.COUNT"]) == [tick // 5 for tick in range(run.ticks)]
    with pytest.raises(FmuError, match=r"902611.*every 0\.0025 s.*multiple of 0\.001 s"):
        run_with(Fmu(plant, every="2.5 ms", outputs={"n": "V.E.COUNT"}))


def test_variables_of_equal_names_are_connected(libraries: dict[int, Path], tmp_path: Path) -> None:
    """Without a mapping; what has no such name is left alone."""
    text = description(3).replace('"u"', '"X.ACS.ACT_POS"').replace('"n"', '"V.E.COUNT"')
    run = run_with(Fmu(write_fmu(tmp_path / "p.fmu", text, libraries[3])))
    assert list(run.trace["V.E.COUNT"]) == list(range(run.ticks))
    with pytest.raises(FmuError, match=r"902608: .*inputs: u; outputs: y, n, above\.ten"):
        run_with(Fmu(write_fmu(tmp_path / "q.fmu", description(3), libraries[3])))


def test_the_fmu_and_its_plc_run_side_by_side(plant: Path) -> None:
    """The PLC is called as ever, and before it: of one variable the FMU's value counts."""

    class Cell:
        def cycle(self, hli: Any) -> None:
            hli.write("V.E.COUNT", 1000)
            hli.write("V.E.WORD", hli.tick)

    controller = Controller()
    fmu = Fmu(plant, inputs={"u": "X.ACS.ACT_POS"}, outputs={"n": "V.E.COUNT"})
    run = controller.run(NcText("p.nc", PROGRAM), plc=Cell(), fmu=fmu, signals=SIGNALS)
    assert controller.read("V.E.WORD") == run.ticks - 1
    assert list(run.trace["V.E.COUNT"]) == list(range(run.ticks))


def test_several_fmus_live_in_one_process(libraries: dict[int, Path], tmp_path: Path) -> None:
    """Each has its own state, whatever its version, also of one library."""
    counts = []
    for version, gain in itertools.product((2, 3), (500.0, 1000.0)):
        file = write_fmu(tmp_path / f"{version}.fmu", description(version), libraries[version])
        controller = Controller()
        fmu = Fmu(file, inputs={"u": "X.ACS.ACT_POS"}, outputs=OUTPUTS, start={"gain": gain})
        run = controller.begin({1: [NcText("p.nc", PROGRAM)]}, fmu=fmu)
        counts.append((controller, run, gain))
    for end in range(0, 300, 50):
        for _, run, _ in counts:
            run.advance(end)
    for controller, run, gain in counts:
        assert controller.read("V.E.VALUE") == pytest.approx(20.0 * gain / 1000.0)
        run.close()


# --- what is refused

WRONG: dict[str, tuple[dict[str, Any], str]] = {
    "unknown": ({"inputs": {"v": "X.ACS.ACT_POS"}}, "902605: .* no variable v"),
    "output as input": ({"inputs": {"y": "X.ACS.ACT_POS"}}, "902606: .*y is output, and not an in"),
    "parameter as output": ({"outputs": {"gain": "V.E.VALUE"}}, "902606: .*gain is parameter"),
    "unknown to us": ({"inputs": {"u": "X.ACS.ACT_PSO"}}, "ACT_POS"),
    "not settable": ({"outputs": {"y": "X.ACS.ACT_POS"}}, "X.ACS.ACT_POS"),
    "units": ({"inputs": {"u": "HLI.OVERRIDE"}}, "902607: .*u is in m, HLI.OVERRIDE in %"),
    "start": (
        {"start": {"fault": 1e12}, "outputs": OUTPUTS},
        r"902951: .*fault cannot begin with 1e\+12: it is Int",
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_wrong_connections_are_refused(plant: Path, name: str) -> None:
    """All mistakes before the first tick."""
    tables, text = WRONG[name]
    with pytest.raises(FmuError, match=text):
        run_with(Fmu(plant, **tables))


@pytest.mark.parametrize(
    ("start", "text"),
    [
        ({"gain": 20.5}, r"gain cannot begin with 20\.5: it is (Real|Float64), 0\.5 … 20"),
        ({"gain": 0.4}, r"gain cannot begin with 0\.4: it is (Real|Float64), 0\.5 … 20"),
        ({"gain": True}, "gain cannot begin with true: it is"),
        ({"gain": "much"}, 'gain cannot begin with "much": it is'),
        ({"fault": 2.5}, r"fault cannot begin with 2\.5: it is Int"),
        ({"fault": True}, "fault cannot begin with true: it is Int"),
    ],
)
def test_start_values_of_another_type_or_beyond_the_limits_are_refused(
    libraries: dict[int, Path], tmp_path: Path, start: dict[str, Any], text: str
) -> None:
    """902951: min and max belong to 20.5, and a whole number is no 2.5; the limits are values."""
    for version, library in libraries.items():
        limited = description(version).replace('start="1"', 'start="1" min="0.5" max="20"', 1)
        file = write_fmu(tmp_path / f"{version}.fmu", limited, library)
        with pytest.raises(FmuError, match=f"902951: .*{text}"):
            run_with(Fmu(file, outputs=OUTPUTS, start=start))
        for gain in (0.5, 20):
            assert run_with(Fmu(file, outputs=OUTPUTS, start={"gain": gain})).state == "ended"


@pytest.mark.parametrize("is_isolated", [False, True])
def test_a_library_that_refuses_the_token_is_reported(
    libraries: dict[int, Path], tmp_path: Path, is_isolated: bool
) -> None:
    """902952 with the token and the model's own words, in both versions; nothing is left behind."""
    for version, library in libraries.items():
        text = description(version).replace('"{1}"', '"{other}"')
        file = write_fmu(tmp_path / f"{version}.fmu", text, library)
        with pytest.raises(FmuError, match=r"902952: .*token \{other\} .*made for another token"):
            run_with(Fmu(file, outputs=OUTPUTS, isolate=is_isolated))


def test_a_reference_of_two_variables(libraries: dict[int, Path], tmp_path: Path) -> None:
    """FMI 3.0 forbids it (902601); FMI 2.0 has aliases of one unit, one of which can be set."""

    def shared(version: int, *changes: tuple[str, str]) -> Fmu:
        text = description(version)
        for before, after in changes:
            assert before in text
            text = text.replace(before, after, 1)
        file = write_fmu(tmp_path / "p.fmu", text, libraries[version])
        return Fmu(file, inputs={"u": "X.ACS.ACT_POS"}, outputs={"y": "V.E.VALUE"})

    y_as_u = ('"y" valueReference="2"', '"y" valueReference="1"')
    gain_as_u = ('"gain" valueReference="3"', '"gain" valueReference="1"')
    with pytest.raises(FmuError, match=r"902601: .*\"gain\".* same value reference as .*\"u\""):
        shared(3, gain_as_u)
    with pytest.raises(FmuError, match=r"902950: .*u and gain share .* only one can be set"):
        shared(2, gain_as_u)
    with pytest.raises(FmuError, match=r"902950: .*u and y share .* one unit"):
        shared(2, y_as_u, ('<Real unit="m"/>', "<Real/>"))
    run = run_with(shared(2, y_as_u))  # y is u, in m
    np.testing.assert_allclose(
        1000.0 * run.trace["V.E.VALUE"][1:], run.trace["X.ACS.ACT_POS"][:-1], rtol=1e-12
    )
    # types have their own references in FMI 2.0
    assert shared(2, ('"n" valueReference="4"', '"n" valueReference="1"')) is not None


def test_aliases_of_fmi_3(libraries: dict[int, Path], tmp_path: Path) -> None:
    """An <Alias> has the reference of its variable, and is one."""
    text = description(3).replace(
        'start="1" variability="fixed"/>',
        'start="1" variability="fixed"><Alias name="factor"/></Float64>',
        1,
    )
    file = write_fmu(tmp_path / "p.fmu", text, libraries[3])
    fmu = Fmu(file, inputs={"u": "X.ACS.ACT_POS"}, outputs=OUTPUTS, start={"factor": 1000.0})
    run = run_with(fmu)
    assert run.trace["V.E.VALUE"][-1] == run.trace["X.ACS.ACT_POS"][-2]


def test_an_fmu_that_fails_is_reported(plant: Path) -> None:
    """902609 with the function, the time of the run and the model's own words."""
    fmu = Fmu(plant, outputs={"n": "V.E.COUNT"}, start={"fault": 1})
    with pytest.raises(FmuError) as failed:
        run_with(fmu)
    text = str(failed.value)
    assert "902609" in text
    assert "DoStep failed at 0.003 s of the run: status 3 (error)" in text
    assert "the spring is broken" in text


def test_an_fmu_that_wants_to_end_is_reported(plant: Path) -> None:
    """902610 in FMI 3.0; FMI 2.0 discards the step (902609)."""
    with pytest.raises(FmuError, match=r"902610.*at 0\.003 s|902609.*\(discard\)"):
        run_with(Fmu(plant, outputs={"n": "V.E.COUNT"}, start={"fault": 2}))


def test_a_value_that_the_machine_cannot_have_is_reported(plant: Path) -> None:
    """902612 at its time, followed by the machine's reason."""
    fmu = Fmu(
        plant,
        inputs={"u": "X.ACS.ACT_POS"},
        outputs={"y": "V.E.BYTE"},
        start={"gain": -1e9},
    )
    with pytest.raises(FmuError, match=r"902612: .* at 0\.001 s .* of y .* for V\.E\.BYTE"):
        run_with(fmu)


def test_values_that_do_not_fit_a_type_are_reported(
    libraries: dict[int, Path], tmp_path: Path
) -> None:
    """A whole number of 8 bits does not silently become another one; arrays are refused."""
    file = write_fmu(tmp_path / "p.fmu", description(3, SMALL, ABSENT), libraries[3])
    with pytest.raises(FmuError, match=r"902612: .* 300 of V\.E\.VALUE .* for small"):
        Controller().run(
            NcText("p.nc", PROGRAM), fmu=Fmu(file, inputs={"small": "V.E.VALUE"}),
            set={"V.E.VALUE": 300},
        )  # fmt: skip
    with pytest.raises(FmuError, match=r"902609: .*GetFloat64 .*no such variable"):
        run_with(Fmu(file, outputs={"absent": "V.E.VALUE"}))
    text = description(3).replace('<Float64 name="u" valueReference="1"', "<Float64 X")
    text = text.replace("/><Float64 X", '/><Float64 name="u" valueReference="1"')
    text = text.replace('start="0" unit="m"/>', 'start="0 0"><Dimension start="2"/></Float64>', 1)
    with pytest.raises(FmuError, match=r"902606: .*u is Float64\[\]"):
        run_with(Fmu(write_fmu(tmp_path / "q.fmu", text, libraries[3]), inputs={"u": "V.E.VALUE"}))


@pytest.mark.parametrize(
    "name", ["../out.txt", "/out.txt", "resources/../../out.txt", "c:out.txt", "a\\..\\out.txt"]
)
def test_paths_that_leave_the_folder_are_refused(tmp_path: Path, name: str) -> None:
    """902602, before anything is unpacked."""
    pytest.importorskip("fmpy", reason="FMUs need FMPy (extra fmi)")
    file = tmp_path / "bad.fmu"
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("modelDescription.xml", description(3))
        archive.writestr(name, "x")
    with pytest.raises(FmuError, match="902602"):
        Fmu(file)


def _linked(file: Path) -> None:
    with zipfile.ZipFile(file, "a") as archive:
        entry = zipfile.ZipInfo("resources")
        entry.external_attr = 0o120777 << 16
        archive.writestr(entry, "/etc")


BROKEN: dict[str, tuple[Callable[[str], str], str]] = {
    "no XML": (lambda text: text[:-9], "902601"),
    "FMI 1.0": (lambda text: text.replace('"3.0"', '"1.0"'), "90260[13]"),
    "a document type": (lambda text: "<!DOCTYPE a>" + text, "902601: .*document type"),
    "model exchange": (lambda text: text.replace("CoSimulation", "ModelExchange"), "902603: .*mod"),
    "no library": (lambda text: text, "902604: .* has no library for .*; it has: -"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_files_that_are_no_fmu_for_this_computer_are_refused(tmp_path: Path, name: str) -> None:
    """Each with its own message."""
    change, number = BROKEN[name]
    with pytest.raises(FmuError, match=number):
        Fmu(write_fmu(tmp_path / "p.fmu", change(description(3)), None))


LIES: dict[str, tuple[str, str, str]] = {
    "a reference that no variable has": (
        'y" valueReference="2',
        'y" valueReference="47',
        "902601: .*reference 2,",
    ),
    "two of one name": ('name="n"', 'name="y"', '902601: .*"y".* not unique'),
    "a unit that it does not define": (
        'start="0" unit="m"',
        'start="0" unit="ell"',
        '902601: .*"ell"',
    ),
    "a causality that there is not": ('"output"', '"sideways"', "902601: .*sideways"),
    "a start value that is no number": ('start="1"', 'start="much"', "902601: .*much"),
    "a start value beyond its limits": (
        'start="1"',
        'start="1" max="0.5"',
        "902601: gain begins with 1|902601: .* gain begins with 1",
    ),
    "a library that is not there": (
        'modelIdentifier="m"',
        'modelIdentifier="other"',
        "902609: .*load failed",
    ),
    "a variable that the library lacks": ('valueReference="1"', 'valueReference="99"', "902609"),
}


@pytest.mark.parametrize("is_isolated", [False, True])
@pytest.mark.parametrize("name", LIES)
def test_an_fmu_that_lies_about_itself_is_reported(
    libraries: dict[int, Path], tmp_path: Path, name: str, is_isolated: bool
) -> None:
    """With a number, in this process and in its own."""
    before, after, number = LIES[name]
    text = description(3)
    assert before in text
    file = write_fmu(tmp_path / "p.fmu", text.replace(before, after, 1), libraries[3])
    with pytest.raises(FmuError, match=number):
        run_with(
            Fmu(
                file, inputs={"u": "X.ACS.ACT_POS"}, outputs={"y": "V.E.VALUE"}, isolate=is_isolated
            )
        )


#: A model in Python whose step raises; the libraries of pythonfmu log it only if logging is on.
RAISING = """\
from {package} import {slave}, {causality}, {number}


class Stuck({slave}):
    def __init__(self, **keywords):
        super().__init__(**keywords)
        self.time = self.position = 0.0
        {time}
        self.register_variable({number}("position", causality={causality}.input))

    def do_step(self, time, step):
        raise ValueError("the valve is stuck")
"""
PACKAGES = {
    "pythonfmu": {
        "slave": "Fmi2Slave",
        "causality": "Fmi2Causality",
        "number": "Real",
        "time": "",
    },
    "pythonfmu3": {
        "slave": "Fmi3Slave",
        "causality": "Fmi3Causality",
        "number": "Float64",
        "time": 'self.register_variable(Float64("time", causality=Fmi3Causality.independent))',
    },
}


@pytest.mark.parametrize("is_isolated", [False, True])
@pytest.mark.parametrize("package", PACKAGES)
def test_an_error_of_a_model_is_reported_in_its_words(
    tmp_path: Path, package: str, is_isolated: bool
) -> None:
    """902609 has the text that the model gives to the log."""
    pytest.importorskip(package, reason="needs the extra fmi")
    builder = importlib.import_module(f"{package}.builder").FmuBuilder
    script = tmp_path / f"stuck_{package}.py"  # LG-505: one process knows one module of a name
    script.write_text(RAISING.format(package=package, **PACKAGES[package]), "utf-8")
    builder.build_FMU(script, dest=tmp_path)
    fmu = Fmu(tmp_path / "Stuck.fmu", inputs={"position": "X.ACS.ACT_POS"}, isolate=is_isolated)
    with pytest.raises(FmuError, match=r"902609: .*DoStep failed at 0 s.*the valve is stuck"):
        run_with(fmu)


def test_a_description_in_another_encoding_is_refused(tmp_path: Path) -> None:
    """There a document type could not be seen."""
    pytest.importorskip("fmpy", reason="FMUs need FMPy (extra fmi)")
    file = tmp_path / "p.fmu"
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("modelDescription.xml", ("<!DOCTYPE a>" + description(3)).encode("utf-16"))
    with pytest.raises(FmuError, match=r"902601: .*UTF-8"):
        Fmu(file)


def test_archives_that_are_none_are_refused(tmp_path: Path) -> None:
    """A text, a missing file, a link, a cut off archive."""
    file = write_fmu(tmp_path / "p.fmu", description(3), None)
    data = file.read_bytes()
    for content in (b"", b"no zip", data[:-30]):
        file.write_bytes(content)
        with pytest.raises(FmuError, match="902601"):
            Fmu(file)
    with pytest.raises(FmuError, match="902601"):
        Fmu(tmp_path / "missing.fmu")
    file.write_bytes(data)
    _linked(file)
    with pytest.raises(FmuError, match="902602"):
        Fmu(file)


# --- commands

Reported = Callable[..., tuple[int, str, str]]

PROJECT = """\
[fmu]
every = "2 ms"
inputs = {u = "X.ACS.ACT_POS"}
outputs = {y = "V.E.VALUE", "above.ten" = "V.E.FLAG"}
start = {gain = 1000}
"""
REACTION = """\
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF ONCE V.E.VALUE > 5
    M100
  $ENDIF
#RT CYCLE END
G01 X20 F6000
M30
"""


@pytest.fixture
def reported(
    plant: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Reported:
    """Run a command beside ``a.nc``, ``plant.fmu`` and its project; exit code and both outputs."""
    monkeypatch.chdir(plant.parent)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(plant.parent / "settings"))
    Path("a.nc").write_text(REACTION, "utf-8")
    Path("nctakt.toml").write_text(PROJECT, "utf-8")
    for path in (Path(), Path("nctakt.toml"), plant):
        path.chmod(0o700)

    def command(*words: str) -> tuple[int, str, str]:
        code = main(words)
        shown = capsys.readouterr()
        return code, shown.out, shown.err

    return command


def test_a_tape_needs_no_fmu(reported: Reported) -> None:
    """The outputs are inputs on the tape; the replay has the events of the run without it."""
    code, _, err = reported(
        "run", "a.nc", "--fmu", "plant.fmu", "--record", "a.tape", "--trace", "a.csv"
    )
    assert (code, err) == (0, "")
    assert '"fmu","write","V.E.VALUE"' in Path("a.tape").read_text("utf-8").replace(" ", "")
    assert "M100" not in reported("run", "a.nc", "--trace", "without.csv")[1]
    Path("plant.fmu").unlink()
    code, _, err = reported("replay", "a.tape", "--trace", "b.csv")
    assert code == 0
    assert "901072" in err or "900" not in err
    assert Path("a.csv").read_bytes() == Path("b.csv").read_bytes()
    assert Path("a.csv").read_bytes() != Path("without.csv").read_bytes()


def test_the_project_names_it(reported: Reported) -> None:
    """It runs as with ``--fmu``; who cannot run it says so (902614), where no code may run it is
    left out (902613).
    """
    assert reported("run", "a.nc", "--fmu", "plant.fmu", "--trace", "a.csv")[0] == 0
    Path("nctakt.toml").write_text(PROJECT + 'file = "plant.fmu"\n', "utf-8")
    assert reported("run", "a.nc", "--trace", "b.csv")[0] == 0
    assert Path("a.csv").read_bytes() == Path("b.csv").read_bytes()
    assert reported("why", "a.nc")[0] == 0
    code, _, err = reported("study", "a.nc", "--each-tick", "V.E.WORD=1")
    assert (code, err.partition(": an FMU")[0]) == (
        2,
        "nctakt.toml:1:1: error 902614: project file",
    )
    assert "902613" in reported("disassemble", "a.nc")[2]


def test_code_that_others_may_have_written_is_not_run(reported: Reported) -> None:
    """902025: an FMU is foreign code, as a PLC is."""
    Path("nctakt.toml").write_text(PROJECT + 'file = "plant.fmu"\n', "utf-8")
    Path("plant.fmu").chmod(0o777)
    code, out, err = reported("run", "a.nc")
    assert (code, out) == (2, "")
    assert err.startswith("nctakt.toml:1:1: error 902025: project file: fmu is not run")
    assert reported("run", "a.nc", "--trust")[0] == 0
    assert reported("run", "a.nc", "--fmu", "plant.fmu")[0] == 0


def test_slips_in_the_project_file_are_reported_at_their_place(reported: Reported) -> None:
    """Unknown entries, wrong kinds, times that are none."""
    text = '[fmu]\nevery = "0 ms"\ninput = {}\noutputs = {y = 5}\nfile = "missing.fmu"\n'
    Path("nctakt.toml").write_text(text, "utf-8")
    code, _, err = reported("run", "a.nc")
    assert code == 2
    found = [line.partition(": project")[0] for line in err.splitlines() if "error 9" in line]
    assert found == [
        "nctakt.toml:2:1: error 901062",
        "nctakt.toml:3:1: error 901061",
        "nctakt.toml:4:1: error 901062",
        "nctakt.toml:5:1: error 901063",
    ]


@pytest.mark.parametrize(
    ("text", "place"),
    [
        (PROJECT.replace("gain = 1000", 'gain = "much"'), "5:10"),
        (PROJECT.replace("start = {gain = 1000}", '[fmu.start]\nfault = 0\ngain = "much"'), "7:1"),
        (PROJECT.replace("gain = 1000", 'fault = 0, gain = "much"'), "5:21"),
    ],
)
def test_a_start_value_is_reported_at_its_place(reported: Reported, text: str, place: str) -> None:
    """Line and column of its name, in its own table or in a line."""
    Path("nctakt.toml").write_text(text, "utf-8")
    code, _, err = reported("run", "a.nc", "--fmu", "plant.fmu")
    assert code == 1
    assert err.startswith(f"nctakt.toml:{place}: error 902951: plant.fmu: gain cannot begin")
    assert "^^^^" in err


def test_a_failure_of_the_fmu_is_one_of_the_run(reported: Reported) -> None:
    """Exit code 1, without a traceback; what has been recorded is complete."""
    Path("nctakt.toml").write_text(PROJECT.replace("gain = 1000", "fault = 1"), "utf-8")
    code, _, err = reported("run", "a.nc", "--fmu", "plant.fmu", "--trace", "a.csv")
    assert code == 1
    assert err.startswith("error 902609: plant.fmu: fmi")
    assert len(Path("a.csv").read_text("utf-8").splitlines()) == 1 + 8
