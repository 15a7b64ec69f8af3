# SPDX-License-Identifier: MIT
"""Suites in Structured Text as tests of pytest, and ``nctakt test`` (ST-904)."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from xml.etree import ElementTree

import pytest
from support.plc_text import pou_file

from nctakt.base.python_process import python_command, python_environment
from nctakt.cli import main

pytestmark = pytest.mark.slow

SUITES = """\
FUNCTION_BLOCK FB_Suite EXTENDS FB_TestSuite
VAR n : INT; END_VAR
n := n + 1;
TEST('right'); IF n = 3 THEN TEST_FINISHED(); END_IF
TEST('wrong'); AssertEquals_INT(2, 3, 'number'); TEST_FINISHED();
TEST('disabled_later'); TEST_FINISHED();
IF FALSE THEN TEST('never'); END_IF
TEST(CONCAT('computed ', INT_TO_STRING(1))); TEST_FINISHED();
END_FUNCTION_BLOCK
PROGRAM MAIN VAR fbSuite : FB_Suite; END_VAR TcUnit.RUN(); END_PROGRAM
"""
#: pytest-asyncio warns without its configuration; no file is left behind.
WORDS = ("--", "-p", "no:asyncio", "-p", "no:cacheprovider")

#: A conftest that notes which process has run which file.
NOTED = """\
import os
from pathlib import Path
from nctakt.testing.suites import SuiteFile
run = SuiteFile.run
def noted(file):
    Path(f"{os.getpid()}.{file.path.name}.note").touch()
    return run(file)
SuiteFile.run = noted
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder that the command works in, with suites and an NC file."""
    (tmp_path / "pytest.ini").write_text("[pytest]\n", "utf-8")
    (tmp_path / "suites.st").write_text(SUITES, "utf-8")
    (tmp_path / "part.nc").write_text("M100 ; expect: M100\nM30\n", "utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_each_test_of_a_suite_is_one_test(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """ST-904: with place, the machine's times in the JUnit file, exit code 1; NC files, too."""
    assert main(["test", ".", "--junit", "report.xml", *WORDS, "-rs"]) == 1
    shown = capsys.readouterr().out
    assert "3 passed, 1 failed" in shown or "1 failed, 3 passed, 2 skipped" in shown
    failure = "suites.st:5: number\n    EXP: 2\n    ACT: 3\n    at 0 s, tick 0"
    assert failure in shown
    assert "suites.st:7: the suite never opens this test" in shown
    cases = {one.get("name"): one for one in ElementTree.parse("report.xml").iter("testcase")}
    assert list(cases) == [
        "expectations", "right", "wrong", "later", "never", "tests with computed names",
    ]  # fmt: skip
    assert cases["right"].get("classname") == "MAIN.fbSuite"
    assert cases["right"].get("time") == "0.020"
    assert (cases["wrong"].get("file"), cases["wrong"].get("line")) == ("suites.st", "5")
    assert cases["wrong"][0].text == failure
    assert cases["wrong"][0].get("type") == "AssertionError"
    shown_as = [cases[name].get("status") for name in ("right", "wrong", "later", "expectations")]
    assert shown_as == ["PASS", "FAIL", "SKIP", None]
    other, suite = ElementTree.parse("report.xml").getroot()
    assert (other.get("tests"), other.get("failures")) == ("1", "0")
    counts = ("MAIN.fbSuite", "5", "1", "2", "0.020")
    assert counts == tuple(
        suite.get(name) for name in ("name", "tests", "failures", "skipped", "time")
    )


def test_a_report_is_reported_by_its_name(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """And not by that of the file that it is written to at first."""
    assert main(["test", "part.nc", "--junit", "report.xml", *WORDS]) == 0
    assert f"generated xml file: {folder / 'report.xml'} -" in capsys.readouterr().out


@pytest.mark.nightly
def test_tests_are_chosen(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """By words of their names; nothing chosen (902961) or found (902541) is wrong usage."""
    assert main(["test", "suites.st", "-k", "right", *WORDS]) == 0
    assert "1 passed, 4 deselected" in capsys.readouterr().out
    assert main(["test", "suites.st", "-k", "nothing", *WORDS]) == 2
    assert "error 902961: no test in suites.st has a name that fits -k" in capsys.readouterr().err
    (folder / "empty").mkdir()
    assert main(["test", "empty", *WORDS]) == 2
    assert "error 902541: no tests in empty" in capsys.readouterr().err


@pytest.mark.nightly
def test_mistakes_of_the_text_are_shown(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """With their place, and exit code 1; a report that would overwrite the text is refused."""
    (folder / "suites.st").write_text(SUITES.replace("n + 1", "m + 1"), "utf-8")
    assert main(["test", "suites.st", *WORDS]) == 1
    assert "suites.st:3:6: error 902190: m is not declared" in capsys.readouterr().out
    assert main(["test", "suites.st", "--junit", "suites.st", *WORDS]) == 2
    assert "error 900913" in capsys.readouterr().err


def test_the_example_passes(capsys: pytest.CaptureFixture[str]) -> None:
    """``examples/suites``: a gate and its tests."""
    folder = Path(__file__).parents[2] / "examples" / "suites"
    assert main(["test", str(folder), *WORDS]) == 0
    assert "2 passed" in capsys.readouterr().out


def test_a_file_that_is_not_there(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """902941 with the nearest name, 900500 without one; a test may be named within its file."""
    assert main(["test", "prat.nc", *WORDS]) == 2
    shown = capsys.readouterr().err
    assert "error 902941: prat.nc does not exist\n  remedy: Did you mean part.nc?" in shown
    assert main(["test", "nowhere/part.nc::expectations"]) == 2
    assert "error 900500: nowhere/part.nc does not exist" in capsys.readouterr().err
    assert main(["test", "part.nc::expectations", *WORDS]) == 0


#: What a test needs of TcUnit's own sources, written for this test: what each declares and does.
SOURCES = {
    "FB_Runner": (
        "FUNCTION_BLOCK FB_Runner VAR AllTestSuitesFinished : BOOL; n : INT; END_VAR",
        "GVL_TcUnit.pSuite^(); n := n + 1; AllTestSuitesFinished := n = 4;",
    ),
    "FB_Test": (
        "FUNCTION_BLOCK FB_Test VAR_INPUT TestName, AssertionMessage : T_MaxString;\n"
        "TestIsFinished, TestIsSkipped, TestIsFailed : BOOL; Duration : LREAL; END_VAR",
        "",
    ),
    "FB_TestSuite": (
        "FUNCTION_BLOCK FB_TestSuite\nVAR_INPUT NumberOfTests : UINT;"
        " Tests : ARRAY[1..3] OF FB_Test; nAt : UINT; END_VAR",
        "",
        '<Method Name="FB_init" Id="{1}"><Declaration>METHOD FB_init : BOOL VAR_INPUT '
        "bInitRetains, bInCopyCode : BOOL; END_VAR</Declaration><Implementation><ST>"
        "GVL_TcUnit.pSuite := THIS;</ST></Implementation></Method>"
        '<Method Name="AssertTrue" Id="{2}"><Declaration>METHOD AssertTrue VAR_INPUT '
        "Condition : BOOL; Message : T_MaxString; END_VAR</Declaration><Implementation><ST>"
        "IF NOT Condition THEN Tests[nAt].TestIsFailed := TRUE; "
        "Tests[nAt].AssertionMessage := Message; END_IF</ST></Implementation></Method>",
    ),
    "TEST": (
        "FUNCTION TEST : BOOL VAR_INPUT TestName : T_MaxString; END_VAR VAR i : UINT; END_VAR",
        "FOR i := 1 TO GVL_TcUnit.pSuite^.NumberOfTests DO"
        " IF GVL_TcUnit.pSuite^.Tests[i].TestName = TestName THEN"
        " GVL_TcUnit.pSuite^.nAt := i; RETURN; END_IF END_FOR"
        " GVL_TcUnit.pSuite^.NumberOfTests := i; GVL_TcUnit.pSuite^.nAt := i;"
        " GVL_TcUnit.pSuite^.Tests[i].TestName := TestName;"
        " GVL_TcUnit.pSuite^.Tests[i].TestIsSkipped := TestName = 'later';",
    ),
    "TEST_FINISHED": (
        "FUNCTION TEST_FINISHED : BOOL",
        "GVL_TcUnit.pSuite^.Tests[GVL_TcUnit.pSuite^.nAt].TestIsFinished := TRUE;"
        " GVL_TcUnit.pSuite^.Tests[GVL_TcUnit.pSuite^.nAt].Duration := 0.25;",
    ),
    "RUN": ("FUNCTION RUN : BOOL", "GVL_TcUnit.TcUnitRunner();"),
}
LISTS = """<?xml version="1.0" encoding="utf-8"?>
<TcPlcObject><GVL Name="GVL_TcUnit" Id="{3}"><Declaration>{attribute 'qualified_only'}
VAR_GLOBAL TcUnitRunner : FB_Runner; pSuite : POINTER TO FB_TestSuite; END_VAR</Declaration></GVL>
</TcPlcObject>
"""
OWN_SUITE = (
    "TEST('right'); AssertTrue(TRUE, ''); TEST_FINISHED();\n"
    "TEST('wrong'); AssertTrue(FALSE, 'no gate'); TEST_FINISHED();\n"
    "TEST('later');\n"
)


def project_of(names: Iterable[str], *libraries: str) -> str:
    """A project with objects and libraries."""
    items = [f'<Compile Include="{name}"/>' for name in names]
    items += [f'<PlaceholderReference Include="{name}"/>' for name in libraries]
    return f"<Project><ItemGroup>{''.join(items)}</ItemGroup></Project>"


@pytest.fixture
def own(folder: Path) -> Path:
    """The folder with a project that brings sources of TcUnit."""
    library = folder / "libraries" / "TcUnit"
    library.mkdir(parents=True)
    for name, parts in SOURCES.items():
        (library / f"{name}.TcPOU").write_text(pou_file(name, *parts), "utf-8")
    (library / "GVL_TcUnit.TcGVL").write_text(LISTS, "utf-8")
    files = ["GVL_TcUnit.TcGVL", *(f"{name}.TcPOU" for name in SOURCES)]
    (library / "TcUnit.plcproj").write_text(project_of(files, "Tc2_Standard"), "utf-8")
    (folder / "nctakt.toml").write_text('[plc]\nlibraries = ["libraries"]\n', "utf-8")
    declared = "FUNCTION_BLOCK FB_Suite EXTENDS FB_TestSuite"
    (folder / "FB_Suite.TcPOU").write_text(pou_file("FB_Suite", declared, OWN_SUITE), "utf-8")
    declared = "PROGRAM MAIN VAR fbSuite : FB_Suite; END_VAR"
    (folder / "MAIN.TcPOU").write_text(pou_file("MAIN", declared, "TcUnit.RUN();"), "utf-8")
    names = ("FB_Suite.TcPOU", "MAIN.TcPOU")
    (folder / "Cell.plcproj").write_text(project_of(names, "TcUnit"), "utf-8")
    return folder


def test_suites_of_tcunits_own_sources(own: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """ST-904: one test each, with the place where it is opened, its message, its duration."""
    assert main(["test", "Cell.plcproj", "--junit", "report.xml", *WORDS]) == 1
    shown = capsys.readouterr().out
    assert "1 failed, 1 passed, 1 skipped" in shown
    assert "FB_Suite.TcPOU:6: no gate" in shown
    cases = {one.get("name"): one for one in ElementTree.parse("report.xml").iter("testcase")}
    assert list(cases) == ["right", "wrong", "later"]
    assert cases["right"].get("time") == "0.250"


def test_tests_of_own_sources_are_chosen(own: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """ST-904: by words of their names; of a test that never ends, name and time are shown."""
    assert main(["test", "Cell.plcproj", "-k", "right", *WORDS]) == 0
    assert "1 passed, 2 deselected" in capsys.readouterr().out
    path = own / "FB_Suite.TcPOU"
    text = path.read_text("utf-8")
    path.write_text(text.replace("TRUE, ''); TEST_FINISHED();", "TRUE, '');"), "utf-8")
    runner = own / "libraries" / "TcUnit" / "FB_Runner.TcPOU"
    runner.write_text(runner.read_text("utf-8").replace("n = 4", "n = -1"), "utf-8")
    settings = 'until = "1 s"\n[plc]\nlibraries = ["libraries"]\n'
    (own / "nctakt.toml").write_text(settings, "utf-8")
    assert main(["test", "Cell.plcproj", "-k", "right", *WORDS]) == 1
    assert "902540" in capsys.readouterr().out


@pytest.mark.slow
def test_the_suites_of_a_file_run_in_one_process(tmp_path: Path) -> None:
    """``nctakt test`` gives each file to one worker as a whole: its suites run together."""
    suite = (
        "FUNCTION_BLOCK FB_Own EXTENDS FB_TestSuite\nTEST('one'); TEST_FINISHED();\n"
        "TEST('two'); TEST_FINISHED();\nEND_FUNCTION_BLOCK\n"
        "PROGRAM MAIN VAR own : FB_Own; END_VAR TcUnit.RUN(); END_PROGRAM\n"
    )
    names = ("first.st", "second.st")
    for name in names:
        (tmp_path / name).write_text(suite, "utf-8")
    words = [sys.executable, "-m", "nctakt", "test", *names, "--", "-n", "2", "-v"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert "4 passed" in done.stdout, done.stdout + done.stderr
    ended = [line for line in done.stdout.splitlines() if " PASSED " in line]
    workers = {name: {line.split()[0] for line in ended if name in line} for name in names}
    assert [len(one) for one in workers.values()] == [1, 1]


def test_suites_speak_german(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Messages, what was found and when, reasons of skipped tests, as ``--lang`` wants."""
    path = tmp_path / "suites.st"
    path.write_text(
        "FUNCTION_BLOCK FB_Own EXTENDS FB_TestSuite\n"
        "TEST('wrong'); AssertEquals_INT(1, 2, 'zu viel'); TEST_FINISHED();\n"
        "TEST('disabled_one'); TEST_FINISHED();\nTEST('open');\nEND_FUNCTION_BLOCK\n"
        "PROGRAM MAIN VAR own : FB_Own; END_VAR TcUnit.RUN(); END_PROGRAM\n",
        "utf-8",
    )
    assert main(["test", str(path), "--lang", "de", "--", "-rs", "-p", "no:cacheprovider"]) == 1
    out = capsys.readouterr().out
    assert "ACT: 2\n    bei 0 s, Takt 0" in out
    assert "Fehler 902540" in out
    assert "abgeschaltet" in out


def test_suites_of_several_files_run_at_the_same_time(tmp_path: Path) -> None:
    """``-j``: each file in a copy of the process; results and coverage are the same."""
    (tmp_path / "pytest.ini").write_text("[pytest]\n", "utf-8")
    (tmp_path / "conftest.py").write_text(NOTED, "utf-8")
    for name in ("first", "second"):
        (tmp_path / f"{name}.st").write_text(SUITES, "utf-8")
    found, makers = [], []
    for count in ("1", "2"):
        # its own process: a thread of another test would keep this one from copying itself
        words = ["test", ".", "-j", count, "--junit", f"{count}.xml", *WORDS, "-q"]
        command = [*python_command("nctakt", *words), "--nctakt-coverage-file", f"{count}.json"]
        environment = python_environment()
        done = subprocess.run(
            command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
        )
        assert done.returncode == 1
        assert "2 failed, 4 passed, 4 skipped" in done.stdout
        cases = ElementTree.parse(tmp_path / f"{count}.xml").iter("testcase")
        found.append([(*sorted(one.attrib.items()), *(part.text for part in one)) for one in cases])
        notes = list(tmp_path.glob("*.note"))
        makers.append(len({one.name.partition(".")[0] for one in notes}))
        assert len(notes) == 2
        for note in notes:
            note.unlink()
    assert makers == [1, 2]
    assert found[0] == found[1]
    counted = [(tmp_path / f"{count}.json").read_text("utf-8") for count in ("1", "2")]
    assert counted[0] == counted[1]
