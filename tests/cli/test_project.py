# SPDX-License-Identifier: MIT
"""The project file and the environment: which machine, PLC and language a command takes."""

from __future__ import annotations

import json
import os
import struct
import subprocess
import sys
from collections.abc import Callable
from importlib.util import cache_from_source
from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import DEMO_FOLDER
from nctakt.project.machine_choice import machine_of
from nctakt.project.project_file import find_project

#: A program that runs on demo5 only, where C is an axis, and needs some ticks.
PROGRAM = "G01 C10 F1000\nM30\n"

Reported = Callable[..., tuple[int, str, str]]


@pytest.fixture
def reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Reported:
    """Run a command in a project with the program ``programs/a.nc``; exit code and both outputs."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("NCTAKT_MACHINE", raising=False)
    monkeypatch.delenv("NCTAKT_LANGUAGE", raising=False)
    write("programs/a.nc", PROGRAM)

    def command(*words: str) -> tuple[int, str, str]:
        code = main(words)
        shown = capsys.readouterr()
        return code, shown.out, shown.err

    return command


def write(name: str, text: str) -> None:
    """A file in the working directory."""
    Path(name).parent.mkdir(parents=True, exist_ok=True)
    Path(name).write_text(text, "utf-8")


@pytest.mark.parametrize(
    ("name", "header"), [("nctakt.toml", ""), ("pyproject.toml", "[tool.nctakt]\n")]
)
def test_all_commands_take_the_same_machine(reported: Reported, name: str, header: str) -> None:
    """run, check, why, coverage and list run the program on the machine of the file, and say so."""
    write(name, f'{header}machine = "demo5"\n')
    for command in ("run", "check", "why", "coverage", "disassemble"):
        code, out, err = reported(command, "programs/a.nc")
        assert code == 0, (command, out, err)
        assert f"note 901064: the machine is demo5, as {name} says" in out + err, command
    code, out, err = reported("run", "programs/a.nc", "--quiet")
    assert (code, err) == (0, "")


def test_the_command_line_comes_before_environment_and_file(
    reported: Reported, monkeypatch: pytest.MonkeyPatch
) -> None:
    """--machine, then NCTAKT_MACHINE, then the file; NCTAKT_LANGUAGE before the file's."""
    write("nctakt.toml", 'machine = "demo"\nlanguage = "de"\n')
    assert reported("run", "programs/a.nc")[0] == 1
    assert "Fehler 20797" in reported("check", "programs/a.nc")[1]
    monkeypatch.setenv("NCTAKT_MACHINE", "demo5")
    for command in ("run", "check"):
        code, out, err = reported(command, "programs/a.nc")
        assert code == 0
        assert "Hinweis 901064: die Maschine ist demo5, wie NCTAKT_MACHINE es angibt" in out + err
        assert reported(command, "programs/a.nc", "--machine", "demo")[0] == 1
        assert "901064" not in "".join(reported(command, "programs/a.nc", "--machine", "demo")[1:])
    monkeypatch.setenv("NCTAKT_LANGUAGE", "en")
    assert "note 901064" in reported("run", "programs/a.nc")[2]
    assert "Hinweis 901064" in reported("run", "programs/a.nc", "--lang", "de")[2]


def test_a_language_that_is_none(reported: Reported, monkeypatch: pytest.MonkeyPatch) -> None:
    """900908 names the environment variable."""
    monkeypatch.setenv("NCTAKT_LANGUAGE", "fr")
    code, _, err = reported("run", "programs/a.nc")
    assert code == 2
    assert "error 900908: fr is not a valid value for NCTAKT_LANGUAGE" in err
    monkeypatch.setenv("NCTAKT_LANGUAGE", "de")
    assert "Fehler 900907" in reported("run", "programs/a.nc", "--nothing")[2]


def test_the_machine_around_a_program_counts_after_the_file(reported: Reported) -> None:
    """run takes the machine in whose folder the program lies (900816), unless a file names one."""
    assert reported("new", "shop", "--from", "demo5")[0] == 0
    write("shop/nc/b.nc", PROGRAM)
    code, _, err = reported("run", "shop/nc/b.nc")
    assert code == 0
    assert "note 900816: the program runs on the machine of shop/hochlauf.lis" in err
    write("nctakt.toml", 'machine = "demo"\n')
    assert reported("run", "shop/nc/b.nc")[0] == 1
    assert reported("check", "shop/nc/b.nc")[0] == 1
    write("shop/nctakt.toml", "")
    assert reported("run", "shop/nc/b.nc")[0] == 0
    code, _, err = reported("run", "programs/a.nc", "shop/nc/b.nc")
    assert code == 2
    assert "error 901065: " in err
    assert "programs/a.nc runs on demo, shop/nc/b.nc on shop/hochlauf.lis" in err


def test_a_start_up_list_of_another_name_beside_a_program_is_named(reported: Reported) -> None:
    """The program runs on the demo machine, and 902944 names the list and its option."""
    assert reported("new", "shop", "--from", "demo5")[0] == 0
    Path("shop/hochlauf.lis").rename("shop/cell7.lis")
    write("shop/b.nc", "N10 G01 X1 F1000\nM30\n")
    code, _, err = reported("run", "shop/b.nc")
    assert code == 0
    assert (
        "note 902944: the program runs on the demo machine: shop/cell7.lis has no usual name" in err
    )
    assert "--machine shop/cell7.lis" in err
    assert "902944" not in reported("run", "shop/b.nc", "--machine", "shop/cell7.lis")[2]
    write("other/b.nc", "N10 G01 X1 F1000\nM30\n")
    write("other/achse.lis", "getriebe[0].slope_profil.a_beschl 1000\n")
    assert "902944" not in reported("run", "other/b.nc")[2]


def test_a_machine_near_a_program_is_named(reported: Reported) -> None:
    """902967 names lists in a folder below or beside that of the program, which runs on demo."""
    assert reported("new", "lists", "--from", "demo5")[0] == 0
    write("b.nc", "N10 G01 X1 F1000\nM30\n")
    write("nc/c.nc", "N10 G01 X1 F1000\nM30\n")
    for program in ("b.nc", "nc/c.nc"):
        code, _, err = reported("run", program)
        assert code == 0
        assert (
            "note 902967: the program runs on the demo machine, not on that of lists/hochlauf.lis"
            in err
        )
        assert "--machine lists takes that one" in err
        for words in (("--machine", "lists"), ("--machine", "demo"), ("--quiet",)):
            assert "902967" not in reported("run", program, *words)[2]
    assert "nctakt run b.nc --machine lists" in "".join(map(str, reported()[1:]))
    write("nctakt.toml", 'machine = "lists"\n')
    assert "902967" not in reported("run", "b.nc")[2]
    assert "--machine" not in "".join(map(str, reported()[1:]))


@pytest.mark.parametrize("words", ["run partt.nc", "why partt.nc", "check partt.nc"])
def test_a_misspelt_program_names_the_one_that_is_meant(words: str, reported: Reported) -> None:
    """902941 with the name beside it; 900500 where none is near."""
    write("part.nc", "N10 G01 X1 F1000\nM30\n")
    code, out, err = reported(*words.split())
    assert code == 2
    assert "error 902941: partt.nc does not exist\n  remedy: Did you mean part.nc?" in out + err
    code, out, err = reported(*words.replace("partt", "gate").split())
    assert code == 2
    assert "error 900500: gate.nc does not exist" in out + err


def test_a_misspelt_machine_names_the_one_that_is_meant(reported: Reported) -> None:
    """The same for --machine."""
    assert reported("new", "lists")[0] == 0
    write("part.nc", "N10 G01 X1 F1000\nM30\n")
    assert "Did you mean lists?" in reported("run", "part.nc", "--machine", "list")[2]


def test_tests_tell_in_the_language_of_the_command(reported: Reported) -> None:
    """``nctakt test --lang de``: errors of a program and the note of its machine are German."""
    write("nctakt.toml", 'machine = "demo"\n')
    write("part.nc", "N10 G01 Q1 F1000 ; expect: ended\nM30\n")
    code, out, _ = reported("test", "part.nc", "--lang", "de")
    assert code == 1
    assert "Fehler 20797: unbekanntes Wort Q1" in out
    assert "unerwarteter Fehler" in out
    assert "nctakt: die Maschine ist demo, wie nctakt.toml es angibt" in out
    assert "error 20797: unknown word Q1" in reported("test", "part.nc", "--lang", "en")[1]


def test_a_check_of_folders_takes_each_project(reported: Reported) -> None:
    """Programs in one folder, checked for the machines of their own projects."""
    write("one/nctakt.toml", 'machine = "demo"\n')
    write("one/a.nc", PROGRAM)
    write("two/nctakt.toml", 'machine = "demo5"\n')
    write("two/a.nc", PROGRAM)
    code, out, _ = reported("check", "one", "two")
    assert code == 1
    assert "one/a.nc:1:5: error 20797" in out
    assert "two/a.nc" not in out.replace("two/nctakt.toml", "")
    assert out.count("note 901064") == 2


def test_plc_signals_and_paths(reported: Reported) -> None:
    """The PLC of runs, what a trace records, what is checked where nothing is named."""
    write(
        "nctakt.toml",
        'machine = "demo5"\nplc = "plc/cell.py"\nsignals = ["BLOCK"]\npaths = ["programs"]\n',
    )
    write("plc/cell.py", "class Cell:\n    def cycle(self, hli):\n        hli.override_pct = 50\n")
    slow = reported("run", "programs/a.nc", "--trace", "out.csv")[1]
    fast = reported("run", "programs/a.nc", "--plc", "default")[1]
    assert slow != fast
    assert "BLOCK" in Path("out.csv").read_text("utf-8")
    assert "ACT_POS" not in Path("out.csv").read_text("utf-8")
    code, out, _ = reported("check")
    assert code == 0
    assert "1 file: " in out


def test_nothing_to_check(reported: Reported) -> None:
    """901066 where neither words nor a project file say what."""
    code, _, err = reported("check")
    assert code == 2
    assert "error 901066: " in err


@pytest.mark.parametrize(
    ("text", "first_line", "excerpt"),
    [
        ("machine = \n", "nctakt.toml:1:11: error 901060: ", "machine ="),
        ("a = [\n", "error 901060: ", ""),
        ('\nmashine = "lists"\n', "nctakt.toml:2:1: error 901061: ", "Did you mean machine?"),
        ("machine = 3\n", "nctakt.toml:1:1: error 901062: ", "machine = 3"),
        ("machine = true\n", "nctakt.toml:1:1: error 901062: ", "a text"),
        ('signals = ["X", 1]\n', "nctakt.toml:1:1: error 901062: ", "a list of texts"),
        ('paths = "programs"\n', "nctakt.toml:1:1: error 901062: ", "a list of texts"),
        ('language = "fr"\n', "nctakt.toml:1:1: error 901062: ", "a language"),
        ('machine = "none"\n', "nctakt.toml:1:1: error 901063: ", "does not exist"),
        ('# x\nplc = "none.py"\n', "nctakt.toml:2:1: error 901063: ", "does not exist"),
        ('paths = ["none"]\n', "nctakt.toml:1:1: error 901063: ", "does not exist"),
        ("[machine]\nfolder = 1\n", "error 901062: ", "machine"),
        ('until = "soon"\n', "nctakt.toml:1:1: error 900510: ", "soon"),
        ("until = true\n", "nctakt.toml:1:1: error 901062: ", "a time above 0"),
        ('until = "0 s"\n', "nctakt.toml:1:1: error 901062: ", "a time above 0"),
        ("set = 5\n", "nctakt.toml:1:1: error 901062: ", "a table"),
        ('set = {"V.E.WORD" = []}\n', "nctakt.toml:1:9: error 901062: ", "a number or a text"),
        ("[set]\nV.E.WORD = inf\n", "nctakt.toml:2:1: error 901062: ", "V.E.WORD = inf"),
        ("[" * 5000, "error 901060: ", ""),
    ],
)
def test_what_is_wrong_with_the_file(
    reported: Reported, text: str, first_line: str, excerpt: str
) -> None:
    """Number, file, line, remedy; nothing runs."""
    write("nctakt.toml", text)
    for command in ("run", "check"):
        code, out, err = reported(command, "programs/a.nc")
        assert code == 2
        assert out == ""
        assert first_line in err
        assert excerpt in err
        assert "remedy: " in err
        assert "Traceback" not in err


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("text", "first_line"),
    [
        ("[set]\nV.E.WORD = 1\nV.E.NOPE = 1\n", "nctakt.toml:3:1: error 900540: "),
        ('set = {"V.E.WORD" = 1, "V.E.NOPE" = 1}\n', "nctakt.toml:1:25: error 900540: "),
        ("set.V.E.WORD = 1e30\n", "nctakt.toml:1:5: error 20847: "),
        ('machine = "demo5"\n[set]\n"V.E.WORD" = "a"\n', "nctakt.toml:3:2: error 900543: "),
    ],
)
def test_values_that_the_machine_does_not_take(
    reported: Reported, text: str, first_line: str
) -> None:
    """At the place of the value, whichever command runs; not where a word names the variable."""
    write("nctakt.toml", text)
    for command in (("run",), ("why",), ("live", "--port", "0")):
        code, out, err = reported(*command, "programs/a.nc")
        assert (code, out) == (2, "")
        assert first_line in err
    assert "nctakt.toml" not in reported("run", "programs/a.nc", "--set", "V.E.NOPE=1", "--set",
                                     "V.E.WORD=x")[2]  # fmt: skip


def test_bytes_that_are_no_text(reported: Reported) -> None:
    """901060 at the first of them; a byte order mark is none of them."""
    Path("nctakt.toml").write_bytes(b'language = "en"\nmachine = "\xff"\n')
    assert "nctakt.toml:2:12: error 901060: " in reported("run", "programs/a.nc")[2]
    Path("nctakt.toml").write_bytes(b'\xef\xbb\xbfmachine = "demo5"\n')
    assert reported("run", "programs/a.nc")[0] == 0


def test_a_place_in_a_python_project(reported: Reported) -> None:
    """The line within the table, not one of another table with the same name."""
    write("pyproject.toml", "[tool.other]\nmachine = 1\n\n[tool.nctakt]\nmachine = 2\n")
    assert "pyproject.toml:5:1: error 901062: " in reported("run", "programs/a.nc")[2]
    write("pyproject.toml", "[tool]\nnctakt = 3\n")
    assert "pyproject.toml: error 901062: " in reported("run", "programs/a.nc")[2]


def test_a_python_project_of_others_is_passed_over(reported: Reported) -> None:
    """Without the table the search goes on above, even past one that is not valid TOML."""
    write("nctakt.toml", 'machine = "demo5"\n')
    write("programs/pyproject.toml", "name = \n")
    assert reported("run", "programs/a.nc")[0] == 0
    write("programs/pyproject.toml", '[project]\nname = "nctakt-cell"\n')
    assert reported("run", "programs/a.nc")[0] == 0


@pytest.mark.usefixtures("reported")
def test_both_files_in_a_folder(tmp_path: Path) -> None:
    """nctakt.toml counts."""
    write("nctakt.toml", 'machine = "demo5"\n')
    write("pyproject.toml", '[tool.nctakt]\nmachine = "demo"\n')
    choice = machine_of(tmp_path / "programs" / "a.nc", FileAccess())
    assert (choice.path, choice.setting) == (DEMO_FOLDER.parent / "demo5", "nctakt.toml")


def test_confined_runs_take_no_file_from_outside(reported: Reported) -> None:
    """With --confine neither a project file nor a machine outside of the folder counts."""
    write("nctakt.toml", 'machine = "demo5"\n')
    write("hochlauf.lis", "kanal_anzahl 1\n")
    write("programs/b.nc", "G01 A10 F1000\nM30\n")
    code, _, err = reported("run", "programs/b.nc", "--confine", "programs")
    assert (code, err) == (0, "")
    assert find_project(Path("programs"), FileAccess(["programs"])) is None


#: Tags of entries in access lists (ACL), as Linux keeps them.
_USER, _GROUP = 2, 8

PROOF_PLC = """from pathlib import Path

Path(__file__).with_name("ran").touch()


class Cell:
    def cycle(self, hli):
        hli.acknowledge_all()
"""


@pytest.fixture
def cell(reported: Reported, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project whose PLC leaves the file ``ran`` when its code is run, and no trusted folders."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(Path("settings").absolute()))
    write("nctakt.toml", 'plc = "cell.py"\nmachine = "demo5"\n')
    write("cell.py", PROOF_PLC)
    for path in (Path(), Path("nctakt.toml"), Path("cell.py")):
        path.chmod(0o700)
    return Path("ran")


def others_may_write(path: Path) -> None:
    path.chmod(0o777)


def belongs_to_another(path: Path) -> None:
    os.chown(path, 65534, -1)


RUNS = (
    ("run", "programs/a.nc"),
    ("why", "programs/a.nc"),
    ("coverage", "programs/a.nc"),
    ("live", "programs/a.nc", "--port", "0"),
    ("serve", "programs/a.nc", "--ads=127.0.0.1:0"),
    ("study", "programs/a.nc", "--each-tick", "V.E.WORD=1"),
)


@pytest.mark.skipif(os.name != "posix", reason="no owners")
@pytest.mark.parametrize("name", ["nctakt.toml", ".", "cell.py"])
@pytest.mark.parametrize(
    "change",
    [
        others_may_write,
        pytest.param(
            belongs_to_another,
            marks=pytest.mark.skipif(os.name != "posix" or os.geteuid() != 0, reason="not root"),
        ),
    ],
)
def test_code_that_others_may_have_written_is_not_run(
    reported: Reported, cell: Path, name: str, change: Callable[[Path], None]
) -> None:
    """902025 at the entry, with what is wrong; ``--plc`` and ``--trust`` run it."""
    assert reported("run", "programs/a.nc", "--quiet")[0] == 0
    cell.unlink()
    change(Path(name))
    code, out, err = reported("run", "programs/a.nc")
    assert (code, out) == (2, "")
    assert err.startswith("nctakt.toml:1:1: error 902025: ")
    assert str(Path(name).absolute()) in err
    assert not cell.exists()
    assert reported("run", "programs/a.nc", "--quiet", "--plc", "cell.py")[0] == 0
    cell.unlink()
    assert reported("run", "programs/a.nc", "--quiet", "--trust")[0] == 0
    cell.unlink()
    assert "902025" in reported("run", "programs/a.nc")[2]  # it was for one command


@pytest.mark.skipif(os.name != "posix", reason="no owners")
@pytest.mark.parametrize("words", RUNS, ids=lambda words: str(words[0]))
def test_no_kind_of_run_takes_code_that_others_may_write(
    reported: Reported, cell: Path, words: tuple[str, ...]
) -> None:
    """902025, and its code has not been run."""
    others_may_write(Path("nctakt.toml"))
    code, _, err = reported(*words)
    assert (code, "902025" in err) == (2, True)
    assert not cell.exists()


@pytest.mark.skipif(os.name != "posix", reason="no owners")
def test_a_list_names_the_trusted_folders(reported: Reported, cell: Path) -> None:
    """A folder and all below it; the list counts only where nobody else may write it."""
    others_may_write(Path("nctakt.toml"))
    trusted = Path("settings/nctakt/trusted")
    trusted.parent.mkdir(parents=True)
    for text, code in (
        (f"{Path.cwd()}\n", 0),
        (f"# mine\n\n{Path.cwd().parent}\n", 0),
        (f"{Path('programs').absolute()}\n.\n", 2),
    ):
        trusted.write_text(text, "utf-8")
        trusted.chmod(0o600)
        assert reported("run", "programs/a.nc", "--quiet")[0] == code
    trusted.write_text(f"{Path.cwd()}\n", "utf-8")
    others_may_write(trusted)
    code, _, err = reported("run", "programs/a.nc", "--quiet")
    assert (code, "others may write" in err, str(trusted.absolute()) in err) == (2, True, True)


@pytest.mark.skipif(os.name != "posix", reason="no owners")
def test_a_link_does_not_lend_its_target_to_somebody_else(reported: Reported, cell: Path) -> None:
    """A folder of somebody else with a link to a project of mine."""
    write("elsewhere/b.nc", PROGRAM)
    Path("elsewhere/nctakt.toml").symlink_to(Path("nctakt.toml").absolute())
    others_may_write(Path("elsewhere"))
    assert "902025" in reported("run", "elsewhere/b.nc")[2]
    assert not cell.exists()


@pytest.mark.skipif(os.name != "posix", reason="no owners")
@pytest.mark.parametrize("name", ["helper.py", "package/inner.py", "wave.py", "__pycache__"])
def test_what_the_code_imports_counts_too(
    reported: Reported, cell: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Beside it, in a package, in place of a module of Python's own, as Python translated it."""
    imports = "import helper\nimport package.inner\ndef later():\n    import wave\n"
    write("cell.py", imports + PROOF_PLC)
    monkeypatch.setattr(sys, "pycache_prefix", None)
    translated = cache_from_source("cell.py")
    for file in ("helper.py", "package/inner.py", "wave.py", "unused.py", translated):
        write(file, "")
    others_may_write(Path("unused.py"))
    assert reported("run", "programs/a.nc", "--quiet")[0] == 0
    cell.unlink()
    others_may_write(Path(name))
    code, _, err = reported("run", "programs/a.nc", "--quiet")
    assert (code, "902025" in err, name in err, cell.exists()) == (2, True, True, False)


@pytest.mark.skipif(sys.platform != "linux", reason="no access lists in Linux's form")
@pytest.mark.parametrize(
    ("entries", "code"),
    [
        ([(_USER, 6, 65534)], 2),
        ([(_GROUP, 6, 65534)], 2),
        ([(_USER, 4, 65534), (_GROUP, 4, 65534)], 0),
        ([(_USER, 6, os.geteuid())], 0),
    ],
    ids=["another user", "another group", "they may read", "the user"],
)
def test_access_lists_count(
    reported: Reported, cell: Path, entries: list[tuple[int, int, int]], code: int
) -> None:
    """Who may write by a list (ACL) is not seen in the mode, where the group is the owner's own."""
    own = [(1, 6, 2**32 - 1), (4, 4, 2**32 - 1), (16, 6, 2**32 - 1), (32, 4, 2**32 - 1)]
    packed = (struct.pack("<HHI", *entry) for entry in sorted([*own, *entries]))
    data = struct.pack("<I", 2) + b"".join(packed)
    try:
        os.setxattr("cell.py", "system.posix_acl_access", data)  # type: ignore[attr-defined, unused-ignore]
    except OSError:
        pytest.skip("the file system has no access lists")
    assert reported("run", "programs/a.nc", "--quiet")[0] == code
    assert cell.exists() is (code == 0)


@pytest.mark.skipif(os.name != "posix", reason="no owners")
@pytest.mark.parametrize(
    ("entry", "place"),
    [('plc = "cell.py"', "plan.toml:1:1"), ('measure.own = "python cell.py:own"', "plan.toml:1:9")],
    ids=["PLC", "measure"],
)
def test_plans_that_others_may_have_written(
    reported: Reported, cell: Path, entry: str, place: str
) -> None:
    """902970 at the entry, and its code has not been run; --trust runs it."""
    write("nctakt.toml", 'machine = "demo5"\n')
    write("cell.py", PROOF_PLC + "\n\ndef own(run):\n    return 1\n")
    write(
        "plan.toml",
        entry + '\nprogram = "programs/a.nc"\n'
        'vary = [{variable = "V.E.WORD", from = 1, to = 2, step = 1}]\nmeasure.end = "X at end"\n',
    )
    others_may_write(Path("plan.toml"))
    code, _, err = reported("study", "plan.toml", "--yes")
    assert (code, err.startswith(f"{place}: error 902970: ")) == (2, True), err
    assert not cell.exists()
    assert reported("study", "plan.toml", "--yes", "--trust")[0] == 0
    assert cell.exists()


@pytest.mark.skipif(os.name != "posix", reason="no owners")
@pytest.mark.parametrize(
    ("name", "word"),
    [
        ("conftest.py", "programs/a.nc"),
        ("programs/conftest.py", "."),
        ("pytest.ini", "programs"),
        ("programs/test_cell.py", "programs/test_cell.py::test_it"),
    ],
)
def test_tests_that_others_may_have_written(
    reported: Reported, cell: Path, name: str, word: str
) -> None:
    """902971, before pytest begins; it would take settings from any folder above, too."""
    write(name, "" if name.endswith(".ini") else PROOF_PLC)
    others_may_write(Path(name))
    code, out, err = reported("test", word)
    assert (code, out, "902971" in err, str(Path(name).absolute()) in err) == (2, "", True, True)
    assert not Path(name).with_name("ran").exists()


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="no owners")
def test_tests_in_parallel_trust_as_the_command_does(reported: Reported, cell: Path) -> None:
    """A worker of pytest-xdist is its own process: there --trust counts as well."""
    write("programs/a.nc", PROGRAM + "; expect: ended\n")
    others_may_write(Path("cell.py"))
    words = ["test", "programs", "--trust", "--", "-n", "1"]
    tested = subprocess.run(
        [sys.executable, "-m", "nctakt", *words], capture_output=True, text=True, check=False
    )
    assert (tested.returncode, "1 passed" in tested.stdout) == (0, True), tested.stdout
    assert cell.exists()


def test_what_only_reads_runs_no_code_of_a_project(reported: Reported, cell: Path) -> None:
    """check, list, explain, new and schedule; list says that the PLC is not run (902026)."""
    write("rtconf.lis", "")
    for words in (
        ("check", "programs/a.nc"),
        ("check", "."),
        ("check",),
        ("disassemble", "programs/a.nc"),
        ("explain", "20651"),
        ("new", "machine"),
        ("schedule", "show", "machine"),
        ("schedule", "analyse", "machine"),
        ("schedule", "simulate", "machine"),
    ):
        reported(*words)
        assert not cell.exists(), words
    assert "note 902026: " in reported("disassemble", "programs/a.nc")[2]
    assert reported("disassemble", "programs/a.nc", "--quiet")[0] == 0
    assert not cell.exists()
    assert reported("disassemble", "programs/a.nc", "--plc", "cell.py")[0] == 0
    assert cell.exists()


@pytest.mark.skipif(os.name != "posix", reason="no pipes with names")
def test_files_name_no_pipe_to_be_read_forever(reported: Reported) -> None:
    """A project (901063) and a plan (901302) name regular files and folders."""
    os.mkfifo("pipe.py")
    vary = '[[vary]]\nvariable = "V.E.WORD"\nvalues = [1]\n'
    for entry in ("plc", "machine"):
        write("nctakt.toml", f'{entry} = "pipe.py"\n')
        code, _, err = reported("run", "programs/a.nc")
        assert (code, "nctakt.toml:1:1: error 901063: " in err) == (2, True)
    Path("nctakt.toml").unlink()
    for entries in (
        'program = "pipe.py"',
        'program = "programs/a.nc"\nplc = "pipe.py"',
        'program = "programs/a.nc"\nmachine = "pipe.py"',
        'program = "programs/a.nc"\n[measure]\nx = "python pipe.py:f"',
    ):
        write("plan.toml", f"{entries}\n{vary}")
        assert reported("study", "plan.toml", "--quiet")[0] == 2


def test_formats_of_a_check_are_as_ever(reported: Reported) -> None:
    """The note is below the text only."""
    write("nctakt.toml", 'machine = "demo5"\n')
    found = json.loads(reported("check", "programs/a.nc", "--format", "json")[1])
    assert found["diagnostics"] == []
