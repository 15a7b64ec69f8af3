# SPDX-License-Identifier: MIT
"""Classes in Python replace blocks of libraries: ``[plc.stubs]``.

T = 1 ms. Cycle n of the PLC is that after tick n; a class is called after it, and what it sets is
there in cycle n + 1 (ST-803, RC-002).
"""

from __future__ import annotations

import os
import random
import re
from pathlib import Path

import pytest
from click.testing import CliRunner
from support.plc_rig import EACH_TICK, run
from support.random_seeds import seeds_in_parts

from nctakt.base.failure import Failure
from nctakt.cli.check import command
from nctakt.cli.run import command as run_command
from nctakt.lists.machine.machine import load_machine
from nctakt.plc import Plc
from nctakt.plc.error import PlcError
from nctakt.plc.structured_text import StructuredPlc, load_structured
from nctakt.plc.unit_tests import load_suites, run_suites
from nctakt.run.access.inputs import unpack
from nctakt.run.access.tape import Tape
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView
from nctakt.run.plcs.realtime_plc import PlcGroup
from nctakt.session.core import SessionCore
from nctakt.session.setup import Setup
from nctakt.session.tapes import read_setup

SETTINGS = '[plc]\nfile = "cell.st"\n\n[plc.stubs]\nFB_Sdo = "stubs.py:Sdo"\n'
CELL = """
FUNCTION_BLOCK FB_Drive
VAR fbSdo : FB_Sdo; nGot : UDINT; END_VAR
fbSdo(bExecute := TRUE, nIndex := 16#1018);
IF fbSdo.bDone THEN nGot := fbSdo.nData; END_IF
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR aDrives : ARRAY[1..2] OF FB_Drive; fbSdo : FB_Sdo; nGot : UDINT; n : INT; END_VAR
n := n + 1;
aDrives[1](); aDrives[2]();
fbSdo(bExecute := n >= 3, nIndex := 7);
IF fbSdo.bDone THEN nGot := fbSdo.nData; END_IF
END_PROGRAM
"""
STUBS = '''"""Blocks of the fieldbus."""


class Sdo:
    """Answers in the second tick in which it is asked."""

    declaration = """
        VAR_INPUT bExecute : BOOL; nIndex : UINT; END_VAR
        VAR_OUTPUT
            bDone : BOOL;
            nData : UDINT;
            aData : ARRAY[0..2] OF BYTE;
            stPart : ARRAY[1..2] OF TIME;
        END_VAR
        VAR nOwn : INT := 5; END_VAR
    """

    def __init__(self):
        self.asked = 0

    def cycle(self, block, hli):
        self.asked += bool(block.bExecute)
        if self.asked == 2:
            block.nData = 10 * block.nIndex
            block.bDone = True
            block.aData = [1, 2, 3]
            block["stPart[2]"] = 7
'''


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A project with a PLC whose block ``FB_Sdo`` is a class in Python."""
    write(tmp_path, {"nctakt.toml": SETTINGS, "cell.st": CELL + EACH_TICK, "stubs.py": STUBS})
    return tmp_path


def write(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        (folder / name).write_text(text, "utf-8")


def changed(folder: Path, file: str, old: str, new: str) -> None:
    """Replace the first occurrence of a text in a file."""
    text = (folder / file).read_text("utf-8")
    assert old in text
    (folder / file).write_text(text.replace(old, new, 1), "utf-8")


def plc_in(folder: Path) -> StructuredPlc:
    return load_structured(folder / "cell.st")


NC = NcText("part.nc", "N10 G04 1\nM30")
SIGNALS = ["MAIN.fbSdo.bDone", "MAIN.nGot", "MAIN.aDrives[2].nGot"]


def test_each_instance_has_its_object(folder: Path) -> None:
    """ST-803: instances in MAIN, in arrays, and in other blocks; the answer is there a cycle later.

    The drives ask from cycle 0 on: answered after tick 1, done in cycle 2. MAIN asks from cycle 2
    (n = 3) on: answered after tick 3, done in cycle 4.
    """
    plc = plc_in(folder)
    done = Controller().run(NC, plc=plc, ticks=6, signals=SIGNALS)
    bits, own, drive = ([int(one) for one in done.trace[name]] for name in SIGNALS)
    assert bits == [0, 0, 0, 0, 1, 1]
    assert own == [0, 0, 0, 0, 70, 70]
    assert drive == [0, 0, 41200, 41200, 41200, 41200]
    assert [plc.read(f"MAIN.fbSdo.aData[{i}]") for i in range(3)] == [1, 2, 3]
    assert (plc.read("MAIN.fbSdo.stPart[2]"), plc.read("MAIN.fbSdo.nOwn")) == (7, 5)


def test_each_run_has_new_objects(folder: Path) -> None:
    """ST-820: nothing stays of the run before, not even in the module."""
    changed(folder, "stubs.py", "class Sdo:", "calls = []\n\n\nclass Sdo:")
    changed(folder, "stubs.py", "10 * block.nIndex", "10 * block.nIndex + len(calls)")
    changed(folder, "stubs.py", "self.asked += ", "calls.append(1)\n        self.asked += ")
    plc = plc_in(folder)
    first, second = (Controller().run(NC, plc=plc, ticks=6, signals=SIGNALS) for _ in range(2))
    assert all((first.trace[name] == second.trace[name]).all() for name in SIGNALS)


def test_a_tape_has_what_they_set_and_replays_without_python(folder: Path) -> None:
    """ST-820: a replay runs no class; the tape names the variables as they are declared."""
    noted = list[object]()
    done = Controller().run(NC, plc=plc_in(folder), ticks=6, signals=SIGNALS, record=noted.extend)
    inputs = tuple(unpack(noted))
    drives = [f"MAIN.aDrives[{i}].fbSdo" for i in (1, 2)]
    names = ("nData", "bDone", "aData[0]", "aData[1]", "aData[2]", "stPart[2]")
    expected = [(2, f"{path}.{name}") for path in drives for name in names]
    expected += [(4, f"MAIN.fbSdo.{name}") for name in names]
    assert [(one.tick, one.values[0]) for one in inputs] == expected
    changed(folder, "stubs.py", "def __init__(self):", "def __init__(self):\n        1 / 0")
    tape = Tape({}, {}, False, inputs, {}, 6, "", {})
    plc = plc_in(folder)
    again = Controller().run(NC, plc=plc, ticks=6, signals=SIGNALS, replay=tape)
    assert all((again.trace[name] == done.trace[name]).all() for name in SIGNALS)
    with pytest.raises(PlcError, match="900522"):
        run(plc, 2)


def test_functions_still_acknowledge_themselves(folder: Path) -> None:
    """ST-763: a class that replaces a block is no PLC that functions wait for."""
    nc = NcText("part.nc", "N10 M7\nN20 G04 0.01\nM30")
    assert Controller().run(nc, plc=plc_in(folder), until="1 s").state == "ended"


class _Counter(Plc):
    """Sees what the classes have set a tick later, and is called before them."""

    def __init__(self) -> None:
        self.seen: list[object] = []

    def cycle(self, hli: PlcView) -> None:
        self.seen.append(hli.read("MAIN.fbSdo.nData"))
        hli.acknowledge_all()


def test_they_run_beside_a_plc_in_python(folder: Path) -> None:
    """ST-803: both are called after each tick."""
    counter = _Counter()
    Controller().run(NC, plc=PlcGroup([plc_in(folder), counter]), ticks=6)
    assert counter.seen == [0, 0, 0, 0, 70, 70]


def test_two_projects_have_their_own(folder: Path) -> None:
    """ST-803: paths of the second project of a name are distinguished on the tape as well."""
    noted = list[object]()
    both = PlcGroup([plc_in(folder), plc_in(folder)])
    Controller().run(NC, plc=both, ticks=6, record=noted.extend)
    names = [str(one.values[0]) for one in unpack(noted)]
    assert "MAIN.fbSdo.bDone" in names
    assert "cell_2.MAIN.fbSdo.bDone" in names
    assert [one.read("MAIN.nGot") for one in both.realtime if isinstance(one, StructuredPlc)] == [
        70,
        70,
    ]


def test_objects_go_back_with_their_machine(folder: Path) -> None:
    """ST-820: forward again after a step back, the objects are as they were there."""
    core = SessionCore(Setup({1: [NC]}, plc=folder / "cell.st", options={}))
    try:
        core.step(6)
        there = core.read(SIGNALS)
        assert there == [1, 70, 41200]
        core.go_to(2)
        assert core.read(SIGNALS) == [0, 0, 0]
        core.step(4)
        assert core.read(SIGNALS) == there
    finally:
        core.close()


def test_a_block_of_a_known_library_is_replaced_by_its_name(folder: Path) -> None:
    """ST-107: what nctakt refuses to run, runs with a class; other names of the library stay."""
    write(
        folder,
        {
            "nctakt.toml": '[plc.stubs]\nTc2_Utilities.FB_LocalSystemTime = "stubs.py:Clock"\n',
            "cell.st": "PROGRAM MAIN VAR fb : FB_LocalSystemTime; n : UDINT; s : STRING; END_VAR\n"
            "s := F_ToUCase('a'); fb(bEnable := TRUE); n := fb.dwCycle; END_PROGRAM" + EACH_TICK,
            "stubs.py": "class Clock:\n    declaration = 'VAR_INPUT bEnable : BOOL; END_VAR '\\\n"
            "        'VAR_OUTPUT dwCycle : UDINT; END_VAR'\n"
            "    def cycle(self, block, hli):\n        block.dwCycle = hli.tick\n",
        },
    )
    plc = plc_in(folder)
    assert not run(plc, 9).errors
    assert (plc.read("MAIN.n"), plc.read("MAIN.s")) == (7, "A")


def test_suites_run_with_them(folder: Path) -> None:
    """ST-904: a suite of TcUnit waits for the answer of a class."""
    suite = """
    FUNCTION_BLOCK FB_Test EXTENDS FB_TestSuite
    VAR fbSdo : FB_Sdo; END_VAR
    TEST('reads');
    fbSdo(bExecute := TRUE, nIndex := 4);
    IF fbSdo.bDone THEN
        AssertEquals_UDINT(Expected := 40, Actual := fbSdo.nData, Message := 'data');
        TEST_FINISHED();
    END_IF
    END_FUNCTION_BLOCK
    PROGRAM MAIN
    VAR fbTest : FB_Test; END_VAR
    TcUnit.RUN();
    END_PROGRAM
    """
    (folder / "cell.st").write_text(suite + EACH_TICK, "utf-8")
    results = run_suites(load_suites(folder / "cell.st"), load_machine(None))
    ((outcome,),) = (tests.values() for tests in results.outcomes.values())
    assert (outcome.name, outcome.problems, outcome.asserts) == ("reads", [], 1)


# --- mistakes ------------------------------------------------------------------------------------


def found_in(folder: Path) -> list[tuple[str, int, int]]:
    """File, line and number of each error that ``nctakt check`` reports."""
    done = CliRunner().invoke(command, [str(folder / "cell.st")])
    assert done.exception is None or isinstance(done.exception, SystemExit)
    found = re.findall(r"^(?:(\S+?):(\d+):\d+: )?error (\d+):", done.output, re.MULTILINE)
    return [(Path(file).name, int(line or 0), int(number)) for file, line, number in found]


def test_a_check_runs_nothing(folder: Path) -> None:
    """What is around the declaration is not run, and the block is known."""
    (folder / "stubs.py").write_text(f"raise SystemExit(9)\n{STUBS}", "utf-8")
    assert found_in(folder) == []


@pytest.mark.parametrize(
    ("file", "old", "new", "where"),
    [
        ("cell.st", "nIndex := 7", "nIndx := 7", ("cell.st", 11, 902229)),
        ("cell.st", "nIndex := 7", "nIndex := 'a'", ("cell.st", 11, 902204)),
        ("cell.st", "nGot := fbSdo.nData", "nGot := fbSdo.nDat", ("cell.st", 5, 902196)),
        ("stubs.py", "nIndex : UINT;", "nIndex : UINTT;", ("stubs.py", 8, 902191)),
        ("stubs.py", "nData : UDINT;", "nData UDINT;", ("stubs.py", 11, 902177)),
        ("stubs.py", "nOwn : INT := 5", "nOwn : INT := 'a'", ("stubs.py", 15, 902204)),
        ("stubs.py", "END_VAR\n", "END_VAR n := 1;\n", ("stubs.py", 8, 902188)),
        ("stubs.py", "declaration =", "declared =", ("stubs.py", 4, 902974)),
        ("stubs.py", 'declaration = """', 'declaration = f"""', ("stubs.py", 4, 902974)),
        ("stubs.py", "def cycle", "def cykle", ("stubs.py", 4, 902975)),
        ("stubs.py", "self.asked = 0", "self.asked = (", ("stubs.py", 19, 902973)),
        ("nctakt.toml", "stubs.py:Sdo", "stubs.py:Sdoo", ("nctakt.toml", 5, 902972)),
        ("nctakt.toml", "stubs.py:Sdo", "gone.py:Sdo", ("nctakt.toml", 5, 901063)),
        ("nctakt.toml", "stubs.py:Sdo", "stubs.py", ("nctakt.toml", 5, 901062)),
        ("nctakt.toml", '"stubs.py:Sdo"', "5", ("nctakt.toml", 4, 901062)),
        ("nctakt.toml", "FB_Sdo =", '"FB Sdo" =', ("nctakt.toml", 5, 901062)),
        (
            "nctakt.toml",
            "FB_Sdo =",
            'TON = "stubs.py:Sdo"\nFB_Sdo =',
            ("nctakt.toml", 5, 902976),
        ),
        (
            "nctakt.toml",
            "FB_Sdo =",
            'fb_drive = "stubs.py:Sdo"\nFB_Sdo =',
            ("nctakt.toml", 5, 902976),
        ),
        (
            "nctakt.toml",
            "FB_Sdo =",
            'fb_sdo = "stubs.py:Sdo"\nFB_Sdo =',
            ("nctakt.toml", 6, 902976),
        ),
    ],
)
def test_each_mistake_has_its_place(
    folder: Path, file: str, old: str, new: str, where: tuple[str, int, int]
) -> None:
    """One mistake, one message (ST-1001), at its line of settings, class or code."""
    changed(folder, file, old, new)
    assert found_in(folder) == [where]
    if file != "cell.st":
        with pytest.raises(Failure, match=str(where[2])):
            plc_in(folder)


def test_a_class_has_the_declaration_of_its_base(folder: Path) -> None:
    """Of one in the same file; a method may come from a base that only a run knows."""
    changed(folder, "nctakt.toml", ":Sdo", ":Own")
    text = STUBS + "\n\nclass Own(Sdo):\n    pass\n"
    (folder / "stubs.py").write_text(text, "utf-8")
    assert found_in(folder) == []
    assert not run(plc_in(folder), 6).errors


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("10 * block.nIndex", "-1", "902262: MAIN.aDrives[1].fbSdo.nData of type UDINT"),
        ("10 * block.nIndex", "1 << 40", "902262"),
        ("10 * block.nIndex", "10 ** 400", "902262"),
        ("10 * block.nIndex", "1.5", "902262"),
        ("10 * block.nIndex", "'ok'", "902262"),
        ("10 * block.nIndex", "None", "902262"),
        ("[1, 2, 3]", "[1, 2]", "902262"),
        ("[1, 2, 3]", "[1, 2, 256]", "902262: MAIN.aDrives[1].fbSdo.aData[2]"),
        ("block.nData =", "block.nIndex =", "902977"),
        ("block.nData =", "block.nOwn =", "902977"),
        ("block.nData =", "block.nDat =", "did you mean nData"),
        ("block.nIndex", "block.nIndx", "did you mean nIndex"),
        ("block.nIndex", "block['stPart[3]']", "FB_Sdo has no stPart[3]"),
        ("block.nData =", "block[''] =", "FB_Sdo has no"),
        ("10 * block.nIndex", "1 / 0", "ZeroDivisionError"),
        ("block.bDone = True", "raise SystemExit", "SystemExit"),
        ("def cycle(self, block, hli)", "def cycle(self, block)", "TypeError"),
    ],
)
def test_what_a_class_does_wrong_is_reported_with_its_line(
    folder: Path, old: str, new: str, reason: str
) -> None:
    """902978: which instance, after which tick, and why."""
    changed(folder, "stubs.py", old, new)
    with pytest.raises(PlcError) as caught:
        run(plc_in(folder), 6)
    text = str(caught.value)
    assert "902978" in text
    assert "MAIN.aDrives[1].fbSdo failed after tick" in text
    assert reason in text
    if "TypeError" not in reason:
        assert "stubs.py" in text


def test_what_a_class_raises_when_it_is_made_is_reported(folder: Path) -> None:
    """900522, before the first tick."""
    changed(folder, "stubs.py", "self.asked = 0", "self.asked = nothing")
    with pytest.raises(PlcError, match="900522"):
        run(plc_in(folder), 6)


def test_a_stopped_plc_has_no_blocks(folder: Path) -> None:
    """ST-560: after a fault of the PLC no class is called."""
    changed(folder, "cell.st", "n := n + 1;", "n := n + 1; nGot := 1 / (2 - n);")
    changed(folder, "stubs.py", "if self.asked == 2:", "if self.asked == 1 + hli.tick > 1:")
    changed(folder, "stubs.py", "block.nData =", "raise ValueError\n            block.nData =")
    assert [one.id for one in run(plc_in(folder), 6).errors] == [902265]


def test_instances_without_a_path_are_reported(folder: Path) -> None:
    """902980: what lives in a call or is shared by all instances; such outputs stay as they are."""
    text = """
    FUNCTION F : UDINT VAR fbLocal : FB_Sdo; END_VAR
    fbLocal(nIndex := 1); F := fbLocal.nData;
    END_FUNCTION
    PROGRAM MAIN
    VAR fbSdo : FB_Sdo; n : UDINT; END_VAR
    VAR_TEMP aTemp : ARRAY[1..2] OF FB_Sdo; END_VAR
    VAR_STAT fbStat : FB_Sdo; END_VAR
    n := F() + aTemp[1].nData + fbStat.nData; fbSdo(bExecute := TRUE);
    END_PROGRAM
    """
    (folder / "cell.st").write_text(text + EACH_TICK, "utf-8")
    plc = plc_in(folder)
    reported = [(one.id, one.values["path"]) for one in plc.notes()]
    assert reported == [(902980, name) for name in ("F.fbLocal", "MAIN.aTemp", "MAIN.fbStat")]
    assert not run(plc, 6).errors
    assert (plc.read("MAIN.n"), plc.read("MAIN.fbSdo.bDone")) == (0, True)


@pytest.mark.skipif(os.name != "posix", reason="no owners")
def test_a_project_of_others_runs_no_class(folder: Path) -> None:
    """902025: code that others may have written is checked, but not run."""
    (folder / "stubs.py").chmod(0o666)
    plc = plc_in(folder)
    with pytest.raises(Failure, match="902025"):
        run(plc, 2)
    assert found_in(folder) == []


@seeds_in_parts(400, 40, 40)
def test_damaged_tables_and_classes_end_in_messages(folder: Path, seeds: range) -> None:
    """Deleted, doubled and exchanged parts: never a traceback of nctakt's own."""
    for one in seeds:
        rng = random.Random(one)
        for file, text in (("stubs.py", STUBS), ("nctakt.toml", SETTINGS)):
            damaged = _damaged(rng, text)
            (folder / file).write_bytes(damaged.encode("utf-8", "surrogatepass"))
            found_in(folder)
            try:
                plc_in(folder)
            except Failure:
                pass
            (folder / file).write_text(text, "utf-8")


def _damaged(rng: random.Random, text: str) -> str:
    for _ in range(rng.randint(1, 3)):
        first = rng.randrange(len(text) + 1)
        last = min(len(text), first + rng.randint(0, 30))
        part = rng.choice([text[last : last + 30], "\0", '"""', "{", "END_VAR", "[", "\ufeff", "("])
        text = text[:first] + part + text[last if rng.random() < 0.6 else first :]
    return text


def test_a_session_of_a_tape_runs_no_class(folder: Path) -> None:
    """ST-820: the tape has what the class did, in a session that lives through it as well."""
    (folder / "part.nc").write_text("N10 G04 0.006\nM30\n", "utf-8")
    tape = folder / "run.tape"
    words = ["part.nc", "--record", str(tape)]
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        assert CliRunner().invoke(run_command, words).exit_code == 0
        changed(folder, "stubs.py", "def __init__(self):", "def __init__(self):\n        1 / 0")
        core = SessionCore(read_setup(tape, anyway=True))
        try:
            core.step(6)
            there = core.read(SIGNALS)
            core.go_to(3)
            core.step(3)
            assert core.read(SIGNALS) == there == [1, 70, 41200]
        finally:
            core.close()
