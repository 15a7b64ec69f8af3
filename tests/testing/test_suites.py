# SPDX-License-Identifier: MIT
"""Suites in Structured Text as tests of pytest, and ``nctakt test`` (ST-904)."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pytest

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
    assert "suites.st:5: number\n    - 2\n    + 3 at 0 s, tick 0" in shown
    assert "the suite never opens this test" in shown
    cases = {one.get("name"): one for one in ElementTree.parse("report.xml").iter("testcase")}
    assert list(cases) == [
        "expectations", "right", "wrong", "later", "never", "tests with computed names",
    ]  # fmt: skip
    assert cases["right"].get("classname") == "suites.st.MAIN.fbSuite"
    assert cases["right"].get("time") == "0.020"


@pytest.mark.nightly
def test_tests_are_chosen(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """By words of their names; nothing chosen is wrong usage (902541)."""
    assert main(["test", "suites.st", "-k", "right", *WORDS]) == 0
    assert "1 passed, 4 deselected" in capsys.readouterr().out
    assert main(["test", "suites.st", "-k", "nothing", *WORDS]) == 2
    assert "error 902541: no tests in suites.st" in capsys.readouterr().err


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
