# SPDX-License-Identifier: MIT
"""The pytest plugin: fixtures, NC files as tests, what a failing expectation shows."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from dataclasses import dataclass
from importlib.metadata import entry_points
from pathlib import Path

import pytest

import nctakt
from nctakt.base.failure import Failure
from nctakt.results.coverage_files import from_json
from nctakt.testing.expectations import read_script

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parent.parent.parent
SOURCES = Path(nctakt.__file__).parent.parent

MOTION = "G00 X10\nM100\nM30\n"
CYCLE = """\
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X >= 5 {first}
    M101 {second}
  $ENDIF
#RT CYCLE END
G00 X10
M30
"""

#: Words of each call: no files left behind, warnings are errors; pytest-asyncio would give one.
WORDS = ("-p", "no:asyncio", "-p", "no:cacheprovider", "-q", "-W", "error")


def plugin_words() -> list[str]:
    """How pytest finds the plugins: by entry points, by ``-p`` where they are not installed."""
    known = {one.name for one in entry_points(group="pytest11")}
    if "nctakt" in known:
        return []
    return ["-p", "nctakt.testing.plugin", "-p", "nctakt.studies.fixture"]


def run_pytest(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Run pytest in a folder in its own process."""
    command = [sys.executable, "-m", "pytest", *plugin_words(), *WORDS]
    path = os.pathsep.join(filter(None, [str(SOURCES), os.environ.get("PYTHONPATH", "")]))
    return subprocess.run(
        [*command, *words],
        cwd=folder,
        check=False,
        capture_output=True,
        text=True,
        encoding="utf-8",
        env={**os.environ, "PYTHONPATH": path, "PYTHONIOENCODING": "utf-8"},
        timeout=300,
    )


@dataclass
class Sessions:
    """Sessions of pytest in this process and in one folder: most tests need no other process."""

    folder: Path
    capsys: pytest.CaptureFixture[str]

    def run(self, *words: str) -> tuple[int, str]:
        """Run pytest; return its exit code and what it prints."""
        # Collecting the garbage of this process after each session would take most of the time.
        left_out = ("-p", "no:faulthandler", "-p", "no:unraisableexception")
        here = (*left_out, "--import-mode=importlib")
        # A module of the same name that another test has imported would be taken for this one.
        for path in self.folder.glob("*.py"):
            sys.modules.pop(path.stem, None)
        code = pytest.main([*plugin_words(), *WORDS, *here, *words])
        return code, "".join(self.capsys.readouterr())


@pytest.fixture
def sessions(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Sessions:
    """Sessions in the test's folder."""
    monkeypatch.chdir(tmp_path)
    return Sessions(tmp_path, capsys)


def project(folder: Path, **files: str) -> Path:
    """A folder with an empty configuration and these files, ``_`` for the dot in their names."""
    (folder / "pytest.ini").write_text("[pytest]\n", "utf-8")
    for name, text in files.items():
        stem, _, suffix = name.rpartition("_")
        (folder / f"{stem}.{suffix}").write_text(text, "utf-8")
    return folder


def failure(sessions: Sessions, text: str, **files: str) -> str:
    """What pytest shows of a program whose expectations are not met."""
    project(sessions.folder, part_nc=text, **files)
    code, shown = sessions.run()
    assert code == 1, shown
    return shown


def passes(sessions: Sessions, text: str, **files: str) -> None:
    """The expectations of a program are met."""
    project(sessions.folder, part_nc=text, **files)
    code, shown = sessions.run()
    assert code == 0, shown
    assert "1 passed" in shown


# --- the example project ------------------------------------------------------------------------


@pytest.mark.nightly
@pytest.mark.slow
def test_the_example_project_passes() -> None:
    """Everything in ``examples/testing``: three programs and five tests."""
    done = run_pytest(ROOT / "examples" / "testing")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "8 passed" in done.stdout


@pytest.mark.nightly
def test_beside_other_plugins(sessions: Sessions) -> None:
    """pytest-lsp, which looks into each item for fixtures, and pytest-asyncio are active."""
    pytest.importorskip("pytest_lsp", reason="a plugin that looks into each item")
    text = "import pytest\n\ndef test_it(pytestconfig):\n"
    text += "    assert pytestconfig.pluginmanager.has_plugin('pytest-lsp')\n"
    project(sessions.folder, part_nc="M100 ; expect: M100\nM30\n", test_it_py=text)
    (sessions.folder / "wrong.nc").write_text("M100 ; expect: M101\nM30\n", "utf-8")
    words = [*plugin_words(), "-p", "no:cacheprovider", "-q", "--import-mode=importlib"]
    assert pytest.main(words) == 1
    shown = "".join(sessions.capsys.readouterr())
    assert "1 failed, 2 passed" in shown
    assert "wrong.nc:1: expect: M101" in shown
    assert "wrap_controller" not in shown


#: A mistake in what a test asks for, and the line that makes it.
MISTAKES = {
    'run_nc("a.nc", set={"V.E.NOPE": 1})': "error 900540",
    'run_nc("a.nc", set={"V.E.VALUE": "x"})': "error 9005",
    'run_nc("a.nc", set=["V.E.VALUE"])': "error 9005",
    'run_nc("a.nc", at=[("soon", "V.E.VALUE", 1)])': "error 900510",
    'run_nc("a.nc", plc="none.py")': "error 9",
    'run_nc("none.nc")': "error 9005",
    'run_nc("a.nc", until="1 s", nothing=1)': "unexpected keyword argument 'nothing'",
    'run_nc("a.nc").fired(line=9)': "error 900663",
    'run_nc("a.nc").value_at("X.ACS.ACT_POS", "soon")': "error 900510",
    'run_nc("a.nc").value_at("V.E.NOPE", 1)': "KeyError",
    'run_nc("a.nc").axis("Q")': "KeyError",
    'run_nc("a.nc").m_function(7).at': "AssertionError",
    'study(program="a.nc", expect=["nonsense"])': "error 901307",
}


def test_a_mistake_shows_the_line_of_the_test(sessions: Sessions) -> None:
    """No frame of nctakt: neither its files nor its code, unless --full-trace asks for it."""
    lines = [f"def test_{i}(run_nc, study):\n    {line}\n" for i, line in enumerate(MISTAKES)]
    project(sessions.folder, a_nc="M100\nM30\n", test_a_py="\n".join(lines))
    code, shown = sessions.run()
    assert code == 1
    assert f"{len(MISTAKES)} failed" in shown
    for line, found in MISTAKES.items():
        assert f">       {line}" in shown
        assert found in shown
    assert "src/nctakt" not in shown
    assert "raise Failure" not in shown
    assert "raise Failure" in sessions.run("--full-trace", "-k", "test_0")[1]


def test_a_machine_that_cannot_be_used_has_no_traceback(sessions: Sessions) -> None:
    """The fixtures say what is wrong with the lists, and nothing else."""
    project(sessions.folder, test_a_py="def test_a(run_nc):\n    pass\n")
    (sessions.folder / "pytest.ini").write_text("[pytest]\nnctakt_machine = none\n", "utf-8")
    code, shown = sessions.run()
    assert code == 1
    assert "error 900060: the machine folder" in shown
    assert "def machine" not in shown


def test_the_plugin_loads_nothing_before_a_test_asks_for_it(tmp_path: Path) -> None:
    """A session without NC programs has of nctakt only the plugins."""
    text = (
        "import sys\n\ndef test_it():\n"
        "    found = sorted(one for one in sys.modules if one.startswith('nctakt'))\n"
        "    assert found == ['nctakt', 'nctakt.base', 'nctakt.base.lazy_names',\n"
        "                     'nctakt.base.version', 'nctakt.studies', 'nctakt.studies.fixture',\n"
        "                     'nctakt.testing', 'nctakt.testing.plugin']\n"
        "    assert 'numpy' not in sys.modules\n"
    )
    done = run_pytest(project(tmp_path, test_light_py=text))
    assert done.returncode == 0, done.stdout


# --- expectations that are met ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("; expect: fired", "; expect: M101"),
        ("; expect: fired 1", "; expect: m101 once"),
        ("; expect: fired at 50ms", "; expect: M101 at 50 ticks"),
        ("; expect: fired 1 line 2 once at 0.05s", "; expect: M101 before 0.1s; X = 5 at 50ms"),
        ("; expect: fired never after 51ms", "; expect: M101 1 times after 49ms"),
        ("; expect: ended; X = 10", "; expect: X = 7.5 within 2.6 at 50ms"),
        ("; expect: PATH.SPEED = 200 at 50ms", "; expect: V.E.COUNT = 0 at end"),
    ],
)
def test_expectations_that_are_met(sessions: Sessions, first: str, second: str) -> None:
    """After 50 ticks X reads 5 (MO-14): the cycle fires in tick 50, M101 goes out in it."""
    passes(sessions, CYCLE.format(first=first, second=second))


def test_what_is_given_is_there(sessions: Sessions) -> None:
    """Values before and at times, a PLC, a limit, START, time after the end."""
    plc = "class Slow:\n    def cycle(self, hli):\n        pass\n"
    text = (
        "; given: V.E.VALUE = 4; given: V.E.TRIGGER = 1 at 30ms; given: plc slow.py\n"
        "; given: start; HLI.START = 1 at 20ms; until 200ms; after 10ms\n"
        "; expect: V.E.VALUE = 4 at 0s; V.E.TRIGGER = 0 at 30ms; V.E.TRIGGER = 1 at 31ms\n"
        "; expect: X = 0 at 21ms; X = 0.002 at 22ms; M100 at 121ms; ended\n"
    )
    passes(sessions, text + MOTION, slow_py=plc)


def test_a_program_without_expectations_is_no_test(sessions: Sessions) -> None:
    """Comments that only sound like one are passed over."""
    text = "; what to expect from it: nothing\n; given the time\n" + MOTION
    project(sessions.folder, part_nc=text)
    assert sessions.run()[0] == pytest.ExitCode.NO_TESTS_COLLECTED


def test_the_configuration_names_machine_and_files(sessions: Sessions) -> None:
    """``nctakt_machine`` is a folder under the root, ``nctakt_files`` are patterns."""
    machine = Path(nctakt.__file__).parent / "machines" / "demo"
    project(sessions.folder, part_nc="M100 ; expect: M100\nM30\n", other_nc="M9 ; expect: M9\n")
    ini = f"[pytest]\nnctakt_machine = {machine}\nnctakt_files = p*.nc\n"
    (sessions.folder / "pytest.ini").write_text(ini, "utf-8")
    assert "1 passed" in sessions.run()[1]


# --- expectations that are not met --------------------------------------------------------------


def test_a_wrong_time_shows_both(sessions: Sessions) -> None:
    """Place of the comment, what was expected, what has happened and where."""
    shown = failure(sessions, CYCLE.format(first="", second="; expect: M101 at 49ms"))
    assert "part.nc:3: expect: M101 at 49ms" in shown
    assert "- M101 at 0.049 s, tick 49 (line 3)" in shown
    assert "+ M101 at 0.05 s, tick 50 (line 3)" in shown
    assert "Traceback" not in shown


def test_a_wrong_value_shows_both(sessions: Sessions) -> None:
    """The value at that time."""
    shown = failure(sessions, "; expect: X = 5.1 at 50ms\n" + MOTION)
    assert "- X = 5.1 at 0.05 s" in shown
    assert "+ X = 5" in shown


def test_what_never_happens_shows_what_did(sessions: Sessions) -> None:
    """The functions that went out instead."""
    shown = failure(sessions, "; expect: M102\n" + MOTION)
    assert "- M102\n" in shown
    assert "+ M102: never; but M100 at 0.1 s, tick 100 (line 3)" in shown


def test_what_must_not_happen(sessions: Sessions) -> None:
    """``never`` before a function that went out."""
    shown = failure(sessions, MOTION.replace("M100", "M100 ; expect: M100 never"))
    assert "- M100 never (line 2)" in shown
    assert "+ M100 at 0.1 s, tick 100 (line 2)" in shown


def test_all_that_is_wrong_is_reported_at_once(sessions: Sessions) -> None:
    """Three expectations that are not met, in their order."""
    shown = failure(sessions, '; expect: M102; M103; message "a; b"\n' + MOTION)
    found = re.findall(r"part\.nc:1: expect: (.*)", shown)
    assert found[:3] == ["M102", "M103", 'message "a; b"']


def test_an_unexpected_error_fails(sessions: Sessions) -> None:
    """With its place and its remedy; the other expectations are looked at all the same."""
    shown = failure(sessions, "; expect: ended\nG01 X10 F0\nM30\n")
    assert "error 20176" in shown
    assert "unexpected error" in shown
    assert "+ error after 0" in shown


def test_an_expected_error_in_another_line(sessions: Sessions) -> None:
    """The line counts where the expectation is after a block."""
    shown = failure(sessions, "M100 ; expect: error 20176\nG01 X10 F0\nM30\n")
    assert "- 20176 (line 1)" in shown
    assert "+ line 2: 20176" in shown


def test_comments_that_are_not_understood_are_all_reported(sessions: Sessions) -> None:
    """900660 and 900661 with place and remedy; times and values by their own numbers."""
    text = "; expect: M100 soon\n; given: tea\n; expect: fired at 1parsec\nM30\n"
    with pytest.raises(Failure) as caught:
        read_script(Path("p.nc"), text)
    assert [found.id for found in caught.value.diagnostics] == [900660, 900661, 900660]
    assert "part.nc:1:11: error 900660" in failure(sessions, text)


@pytest.mark.parametrize(
    ("first", "second", "name"),
    [
        ("V.E.VALUE = 1", "V.E.VALUE = 2", "V.E.VALUE"),
        ("until 1s", "until 2s", "until"),
        ("ticks 500", "ticks 600", "ticks"),
        ("skip 1", "skip 2", "skip"),
        ("machine a", "machine b", "machine"),
    ],
)
def test_an_input_that_counts_once_is_given_twice(first: str, second: str, name: str) -> None:
    """902953 at the second one; values at times, PLCs and programs of channels may be several."""
    with pytest.raises(Failure) as caught:
        read_script(Path("p.nc"), f"; given: {first}\n; given: {second}\nM30\n")
    found = caught.value.diagnostics[0]
    assert (found.id, found.span.line, found.values["option"]) == (902953, 2, f"given: {name}")
    several = "; given: V.E.VALUE = 1 at 1ms; given: V.E.VALUE = 2 at 1ms\n; given: plc a.py\n"
    assert len(read_script(Path("p.nc"), several + "; given: plc b.py\nM30\n").plcs) == 2


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("; given: plc none.py; expect: ended\n", "902940"),
        ("; given: V.E.NOTHING = 1; expect: ended\n", "V.E.NOTHING"),
        ("; expect: V.E.NOTHING = 1\n", "V.E.NOTHING"),
        ("; given: machine nowhere; expect: ended\n", "nowhere"),
        ("; given: V.E.VALUE = part; expect: ended\n", "900512"),
    ],
)
def test_what_cannot_be_had_is_a_diagnostic(sessions: Sessions, text: str, words: str) -> None:
    """Not a traceback through our code."""
    shown = failure(sessions, text + MOTION)
    assert words in shown
    assert "Traceback" not in shown


# --- fixtures -----------------------------------------------------------------------------------


FIXTURES = '''
import pytest

TEXT = """
#RT CYCLE [ID = 1 SCOPE = PROG]
$IF ONCE V.RTA.ACS.ACT_POS.X >= 5
M101
H7
$ENDIF
#RT CYCLE END
G00 X10
#MSG ["there"]
M30
"""


def test_questions(run_nc):
    run = run_nc(TEXT.replace("H7", "H100"))
    assert run.ended
    assert run.fired(cycle=1, line=3).times == [0.05]
    assert run.m_function(101).tick == 50
    assert run.h_function(100, line=5)
    assert not run.m_function(101, line=9)
    assert run.message("there").at == 0.1
    assert run.messages == ["there"]
    assert run.axis("X").position_at(0) == 0
    assert run.axis("X").position_at(0.05) == pytest.approx(5)
    assert run.axis("X").actual_position_at(0.05) == pytest.approx(5)
    assert run.axis("X").end_position == 10
    assert run.errors == []


def test_wrong_time(run_nc):
    run = run_nc(TEXT.replace("H7", "H100"))
    assert run.m_function(102), "shows what was put out"


def test_wrong_ending(run_nc):
    assert run_nc("G01 X1 F0\\nM30\\n").ended


def test_two_runs_on_one_controller(run_nc, controller, machine):
    assert run_nc("V.E.COUNT = 3\\nM30\\n").ended
    assert run_nc("G00 X1\\nM30\\n", signals=["V.E.COUNT"]).value_at("V.E.COUNT", 0) == 3
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 1
    assert controller.machine is machine
'''


def test_the_fixtures_answer_in_the_words_of_the_shop_floor(sessions: Sessions) -> None:
    """What fails shows what has happened instead."""
    project(sessions.folder, test_shop_py=FIXTURES)
    _, shown = sessions.run()
    assert "2 failed, 2 passed" in shown
    assert "<M102: never; but M101 at 0.05 s, tick 50 (line 4)" in shown
    assert "<error after 0" in shown
    assert "error 20176" in shown


# --- coverage -----------------------------------------------------------------------------------

COVERED = CYCLE.format(first="; expect: fired", second="; expect: X = 5 at 50ms")
TWO_MORE = """\
def test_short(run_nc):
    assert run_nc("part.nc", ticks=40)

def test_text(run_nc):
    assert run_nc("#RT CYCLE\\n$IF 1 == 1\\nM100\\n$ENDIF\\n#RT CYCLE END\\nG00 X1\\nM30\\n")
"""


@pytest.mark.nightly
@pytest.mark.slow
@pytest.mark.parametrize("workers", [0, 2])
def test_coverage_of_a_session(tmp_path: Path, workers: int) -> None:
    """The whole program, then its first 40 ticks, not the text; so from workers, too.

    X reads 5 in tick 50: the condition is evaluated in ticks 0 … 50, then in 40 more (RC-203).
    """
    words = []
    if workers:
        words = ["-n", str(workers)]
    folder = project(tmp_path, part_nc=COVERED, test_more_py=TWO_MORE)
    for name in ("all.json", "all.info", "all.txt"):
        words += ["--nctakt-coverage-file", name]
    done = run_pytest(folder, *words)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "branches of realtime cycles" in done.stdout
    assert "part.nc:1  realtime cycle 1 PROG, defined 2 times" in done.stdout
    coverage = from_json("all.json", (folder / "all.json").read_text("utf-8"))
    (cycle,) = coverage.cycles
    (branch,) = cycle.branches
    counts = (branch.evaluated, branch.condition.true, branch.condition.false, branch.bodies)
    assert counts == (91, 1, 90, 1)
    assert "BRDA:2,0,1,90" in (folder / "all.info").read_text("utf-8")
    assert "$ENDIF" in (folder / "all.txt").read_text("utf-8")


def test_coverage_that_cannot_be_written_is_reported(sessions: Sessions) -> None:
    """A suffix that says nothing before the tests, a folder that is not there after them."""
    project(sessions.folder, part_nc=COVERED)
    for file, number in (("all.xml", "900804"), ("none/all.json", "900507")):
        code, shown = sessions.run("--nctakt-coverage-file", file)
        assert code == pytest.ExitCode.USAGE_ERROR
        assert number in shown


def test_without_the_option_nothing_is_reported(sessions: Sessions) -> None:
    """And runs do not count."""
    project(sessions.folder, part_nc=COVERED)
    assert "branches of realtime cycles" not in sessions.run()[1]


FOREVER = "; expect: X = 0\nG04 700\nM30\n"
ASKING = """
import pytest
from nctakt import Failure

def test_forever(run_nc):
    with pytest.raises(Failure, match="901016"):
        run_nc("part.nc")

def test_asked(run_nc):
    assert not run_nc("part.nc", ticks=5).ended
    assert not run_nc("part.nc", until="5ms").ended
    with pytest.raises(Failure, match="901016"):
        run_nc("part.nc", ticks=5, limit_fails=True)
"""


@pytest.mark.slow
def test_a_run_at_its_limit_fails_unless_the_limit_was_given(sessions: Sessions) -> None:
    """901016 for a program that ten minutes of the machine's time do not end."""
    shown = failure(sessions, FOREVER, test_asking_py=ASKING)
    assert "part.nc: error 901016: the run reached its limit, 600 s" in shown
    assert "2 passed" in shown
    (sessions.folder / "part.nc").write_text("; given: until 5ms\n" + FOREVER, "utf-8")
    code, shown = sessions.run("part.nc")
    assert code == 0, shown


FAILING = """
def test_it_ends(run_nc):
    assert run_nc("wrong.nc").ended
"""


def test_a_failing_run_is_shown_as_elsewhere(sessions: Sessions) -> None:
    """One line in the assertion, no address; the errors with caret and remedy below it."""
    project(sessions.folder, wrong_nc="G01 X1 F0\nM30\n", test_it_py=FAILING)
    code, shown = sessions.run("-vv")
    assert code == 1
    assert "\\n" not in shown
    assert " at 0x" not in shown
    assert "Errors of a run" in shown
    assert "wrong.nc:1:8: error 20176: " in shown
    assert "    G01 X1 F0\n           ^^\n  remedy: " in shown


def test_a_test_that_passes_shows_no_errors(sessions: Sessions) -> None:
    """An error that a test awaits is no news."""
    passing = FAILING.replace("assert", "assert not")
    project(sessions.folder, wrong_nc="G01 X1 F0\nM30\n", test_it_py=passing)
    code, shown = sessions.run("-rA")
    assert code == 0
    assert "Errors of a run" not in shown
