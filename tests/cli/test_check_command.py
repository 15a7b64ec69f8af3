# SPDX-License-Identifier: MIT
"""``nctakt check`` as a user meets it: files, lists, folders, selection, exit codes, odd input."""

from __future__ import annotations

import io
import json
import os
import re
import shutil
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import nctakt
from nctakt import machines
from nctakt.cli import main

pytestmark = pytest.mark.slow

DEMO = Path(machines.__path__[0]) / "demo"
GOOD = "G00 X10\nM30\n"
BAD = "G00 X10 Q5\nG200 X1\nM30\n"
FROZEN = """\
#RT CYCLE [SCOPE=PROG]
  $IF V.E.ASYNC == 1 && V.E.VALUE > 2
    V.E.COUNT = 1
  $ENDIF
#RT CYCLE END
"""
_FINDING = re.compile(
    r"^(?:(.+):(\d+):\d+: )?(?:error|warning|note|Fehler|Warnung|Hinweis) (\d+): "
)


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The command runs in its own folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def write(path: str, content: str | bytes) -> Path:
    """A file with its folders."""
    file = Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    return file


class Checked:
    """Exit code and text of one check."""

    def __init__(self, capsys: pytest.CaptureFixture[str], words: tuple[str, ...]) -> None:
        self.code = main(["check", *words])
        captured = capsys.readouterr()
        self.out, self.err = captured.out, captured.err
        self.lines = captured.out.splitlines()

    @property
    def found(self) -> list[tuple[str, int, int]]:
        """File, line and number of the findings in their order."""
        matches = (_FINDING.match(line) for line in self.lines)
        return [(one[1] or "", int(one[2] or 0), int(one[3])) for one in matches if one]

    @property
    def ids(self) -> list[int]:
        """Their numbers, without the remark on the machine."""
        return [number for _, _, number in self.found if number != 900585]


Check = Callable[..., Checked]


@pytest.fixture
def check(capsys: pytest.CaptureFixture[str]) -> Check:
    """Runs the command."""
    return lambda *words: Checked(capsys, words)


# --- programs ------------------------------------------------------------------------------------


def test_findings_come_by_path_and_line(check: Check) -> None:
    """Also those of lists that the start-up list names by another path."""
    shutil.copytree(DEMO, "listen")
    startup = Path("listen/hochlauf.lis")
    text = startup.read_text("utf-8").replace("./sda_mds1.lis", "..\\listen\\SDA_MDS1.LIS")
    startup.write_text(text, "utf-8")
    for name in ("achs_mds1.lis", "sda_mds1.lis"):
        file = Path("listen", name)
        file.write_bytes("# für\n".encode("cp1252") + file.read_bytes())
    write("a.nc", "G01 X1 F6000 M99999\nV.E.NOWHERE = 1\n")
    found = check(".").found[:-1]  # the remark on the machine is the last one
    assert found == sorted(found)
    places = [(file, line) for file, line, _ in found]
    assert ("listen/achs_mds1.lis", 1) in places
    assert ("listen/sda_mds1.lis", 1) in places


def test_a_program_without_mistakes(check: Check) -> None:
    """Nothing found: exit code 0, for which machine it was checked, and one closing line."""
    write("good.nc", GOOD)
    checked = check("good.nc")
    assert checked.code == 0
    assert checked.out == (
        "note 900585: programs are checked for the demo machine\n"
        "  remedy: --machine FOLDER checks them for yours.\n"
        "1 file: 0 errors, 0 warnings, 0 notes\n"
    )


def test_errors_are_shown_with_line_caret_and_remedy(check: Check) -> None:
    """Each with its place and the line; exit code 1."""
    write("bad.nc", BAD)
    checked = check("bad.nc")
    assert checked.code == 1
    assert checked.found[:2] == [("bad.nc", 1, 20797), ("bad.nc", 2, 900200)]
    assert checked.lines[1:3] == ["    G00 X10 Q5", "            ^^"]
    assert checked.lines[-1] == "1 file: 2 errors, 0 warnings, 0 notes"


def test_findings_beyond_errors_do_not_fail_but_with_strict(check: Check) -> None:
    """Warnings make exit code 1 only with --strict; a run does not report them."""
    write("frozen.nc", FROZEN)
    assert check("frozen.nc").ids == [900235]
    assert check("frozen.nc").code == 0
    assert check("frozen.nc", "--strict").code == 1
    assert main(["run", "frozen.nc"]) == 0


def test_notes_never_fail(check: Check) -> None:
    """Not even with --strict; --quiet leaves them out, and the closing line."""
    write("notes.nc", FROZEN.replace("V.E.ASYNC", "P1"))
    assert check("notes.nc").ids == [900236]
    assert check("notes.nc", "--strict").code == 0
    assert check("notes.nc", "--quiet").out == ""


def test_german(check: Check) -> None:
    """--lang de: findings, remedies and the closing line."""
    write("frozen.nc", FROZEN)
    out = check("frozen.nc", "--lang", "de").out
    assert "Warnung 900235: V.E.ASYNC ist asynchron" in out
    assert "Abhilfe: " in out
    assert out.endswith("1 Datei: 0 Fehler, 1 Warnung, 0 Hinweise\n")


def test_any_suffix_may_be_named(check: Check) -> None:
    """A file that is named is a program, whatever its name is."""
    write("program", BAD)
    write("PROGRAM.TXT", GOOD)
    assert check("program", "PROGRAM.TXT").lines[-1].startswith("2 files: 2 errors")


def test_a_file_named_twice_is_checked_once(check: Check) -> None:
    """Also by another path, and through its folder."""
    write("sub/bad.nc", BAD)
    checked = check("sub/bad.nc", "sub/../sub/bad.nc", "sub")
    assert checked.ids == [20797, 900200]
    assert checked.lines[-1].startswith("1 file:")


def test_the_set_of_programs_decides_about_global_cycles(check: Check) -> None:
    """A GLOBAL cycle is reported where no checked program deletes it."""
    write("define.nc", "#RT CYCLE [ID=7 SCOPE=GLOBAL]\n#RT CYCLE END\nM30\n")
    write("delete.nc", "#RT CYCLE DELETE [ID=7]\nM30\n")
    assert check("define.nc").ids == [900245]
    assert check("define.nc", "delete.nc").ids == []


def test_findings_have_one_order(check: Check) -> None:
    """By file, line, column and number, however the files are named."""
    for name in ("b.nc", "a.nc", "c/a.nc"):
        write(name, BAD)
    expected = [(name, line, 0) for name in ("a.nc", "b.nc", "c/a.nc") for line in (1, 2)]
    for words in (("b.nc", "c", "a.nc"), (".",), ("c/a.nc", "a.nc", "b.nc")):
        found = [(file, line, 0) for file, line, _ in check(*words).found[:-1]]
        assert found == expected


# --- machines and lists --------------------------------------------------------------------------


def test_programs_are_checked_for_the_machine_that_is_named(check: Check) -> None:
    """--machine: its axes, and its limits; no remark on the demo machine then."""
    shutil.copytree(DEMO, "mine")
    channel = Path("mine/sda_mds1.lis")
    channel.write_text(
        channel.read_text("utf-8").replace("Ende", "rt_cycles.max_steps 3\nEnde"), "utf-8"
    )
    write("part.nc", FROZEN)
    assert check("part.nc", "--machine", "mine").ids == [900246, 900235]
    assert "demo" not in check("part.nc", "--machine", "mine").out


@pytest.mark.parametrize(
    ("machine", "number"), [("gone", 900060), ("empty", 900061), ("part.nc", 900077)]
)
def test_a_machine_that_cannot_be_had_is_wrong_usage(
    check: Check, machine: str, number: int
) -> None:
    """Nothing is checked then."""
    Path("empty").mkdir()
    write("part.nc", GOOD)
    checked = check("part.nc", "--machine", machine)
    assert checked.code == 2
    assert f"error {number}" in checked.err
    assert checked.out == ""


def test_a_machine_folder_is_checked_as_a_whole(check: Check) -> None:
    """All lists that its start-up list names, once; a list next to them alone."""
    shutil.copytree(DEMO, "mine/lists")
    write("mine/lists/achs_mds1.lis", "kopf.achs_nr 1\ngetriebe[0].dynamik.a_max -5\nEnde\n")
    write("mine/lists/spare.lis", "kopf.achs_nr 1\nkopf.achs_nr 2\nEnde\n")
    write("mine/part.nc", GOOD)
    checked = check("mine")
    assert checked.found == [
        ("mine/lists/achs_mds1.lis", 2, 1024),
        ("mine/lists/spare.lis", 1, 900583),
        ("mine/lists/spare.lis", 2, 900023),
        ("", 0, 900585),
    ]
    assert "--machine mine/lists checks them for yours" in checked.out
    assert checked.lines[-1].startswith("17 files: ")


def test_tools_and_offsets_that_a_machine_names_are_checked(check: Check) -> None:
    """Tools and offsets belong to the machine: not checked alone; missing ones are reported."""
    shutil.copytree(DEMO, "mine")
    startup = Path("mine/hochlauf.lis")
    text = startup.read_text("utf-8")
    text = text.replace("./werkz_d1.lis", "./tools.lis").replace("./nullp_d1.lis", "./gone.lis")
    startup.write_text(text, "utf-8")
    Path("mine/werkz_d1.lis").unlink()
    Path("mine/nullp_d1.lis").unlink()
    write("mine/tools.lis", "wz[0].laenge 5\nEnde\n")
    checked = check("mine")
    assert checked.ids == [2001, 900740]
    assert checked.lines[-1].startswith("14 files: ")


def test_what_a_machine_cannot_do_without_is_reported_with_its_folder(check: Check) -> None:
    """A machine without channel lists: the reason, and its start-up list counts as checked."""
    write("mine/hochlauf.lis", "listen ASCII\nkanal_anzahl 1\nEnde\n")
    checked = check("mine")
    assert 900077 in checked.ids
    assert checked.code == 1
    assert checked.lines[-1].startswith("1 file: ")


@pytest.mark.parametrize(
    ("name", "content", "kind"),
    [
        ("x.lis", "rt_cycles.max_steps 5\n", "Channel list"),
        ("x.lis", "kopf.achs_nr 1\nfoo 1\nbar 2\n", "Axis list"),
        ("x.LIS", "number_used_variables 0\n", "Variables list"),
        ("x.lis", "cycle_time 1000\n", "Realtime configuration"),
        ("sda_mds3.lis", "foo 1\n", "Channel list"),
        ("default_achs.lis", "", "Axis list"),
    ],
)
def test_a_list_alone_tells_its_kind(check: Check, name: str, content: str, kind: str) -> None:
    """The kind whose parameters it names, else that of its name."""
    write(name, content + "Ende\n")
    checked = check(name)
    assert f"{name}:1:1: note 900583: this list is checked alone, as {kind}" in checked.out


def test_a_start_up_list_of_any_name_stands_for_its_machine(check: Check) -> None:
    """Its references are looked for; other formats than ASCII are refused."""
    write("start.lis", "listen ASCII\nkanal_anzahl 1\nsda_mds[0] ./gone.lis\nEnde\n")
    assert check("start.lis").ids == [900068, 900077, 2001]
    write("start.lis", "listen BINARY\nEnde\n")
    assert 900064 in check("start.lis").ids


def test_the_start_up_list_of_a_folder_stands_for_its_machine(check: Check) -> None:
    """All lists that it names are checked, as if the folder had been named."""
    shutil.copytree(DEMO, "mine")
    assert check("mine/hochlauf.lis").lines == ["15 files: 0 errors, 0 warnings, 0 notes"]
    Path("mine/achs_mds2.lis").unlink()
    assert 2001 in check("mine").ids
    assert check("mine/hochlauf.lis").ids == check("mine").ids


def test_a_list_of_no_known_kind_is_reported(check: Check) -> None:
    """A note; where nothing else is checked that is exit code 2."""
    write("magazine.lis", "magazine[0].place 5\nEnde\n")
    assert (check("magazine.lis").ids, check("magazine.lis").code) == ([900584], 2)
    write("good.nc", GOOD)
    assert check(".").code == 0


def test_verbose_names_each_unknown_entry(check: Check) -> None:
    """A misspelt one too, whether verbose or not."""
    write("sda_mds1.lis", "rt_cycles.max_steps 5\nfoo 1\nrt_cycles.max_stepz 2\nEnde\n")
    assert check("sda_mds1.lis").ids == [900583, 900008, 900009]
    assert check("sda_mds1.lis", "--verbose").ids == [900583, 900008, 900009]


# --- folders -------------------------------------------------------------------------------------


def test_folders_are_searched(check: Check) -> None:
    """Programs by their suffixes in any letter case, in all folders but hidden ones."""
    for name in ("a.nc", "x/B.NC", "x/y/c.ncp", "x/d.cyc", "x/e.ecy", "x/f.cnc", "x/g.sub"):
        write(name, GOOD)
    for name in ("readme.txt", ".git/h.nc", "x/.i.nc", "x/j.nc.bak"):
        write(name, BAD)
    assert check(".").lines[-1] == "7 files: 0 errors, 0 warnings, 0 notes"


def test_a_folder_is_listed_once_however_many_programs_it_has(
    check: Check, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The time of a check grows with the number of files, not with its square."""
    for number in range(30):
        write(f"programs/p{number}.nc", GOOD)
    listed: list[Path] = []
    iterdir = Path.iterdir
    monkeypatch.setattr(Path, "iterdir", lambda path: listed.append(path) or iterdir(path))
    assert check("programs").lines[-1].startswith("30 files: ")
    assert len([path for path in listed if path.name == "programs"]) <= 2


def test_a_folder_without_anything_to_check(check: Check) -> None:
    """A warning that names the suffixes; exit code 2 where nothing else is checked."""
    write("docs/readme.txt", "")
    checked = check("docs")
    assert (checked.ids, checked.code) == ([900580], 2)
    assert ".ncp" in checked.out
    assert checked.lines[-1] == "0 files: 0 errors, 1 warning, 0 notes"
    write("good.nc", GOOD)
    assert check("docs", "good.nc").code == 0


@pytest.mark.skipif(os.name != "posix", reason="links and rights as POSIX has them")
def test_links_of_a_folder(check: Check) -> None:
    """A link to a program is followed, a broken one is reported, one to a folder is not."""
    write("real/part.nc", BAD)
    Path("set").mkdir()
    Path("set/part.nc").symlink_to("../real/part.nc")
    Path("set/gone.nc").symlink_to("nowhere.nc")
    Path("set/again").symlink_to("..")
    assert check("set").ids == [900500, 20797, 900200]


# --- what cannot be read -------------------------------------------------------------------------


def test_a_missing_file_does_not_keep_others_from_being_checked(check: Check) -> None:
    """Exit code 2 only where nothing could be checked."""
    checked = check("gone.nc")
    assert (checked.ids, checked.code) == ([900500], 2)
    write("good.nc", GOOD)
    checked = check("gone.nc", "good.nc")
    assert (checked.ids, checked.code) == ([900500], 1)


@pytest.mark.parametrize(
    ("name", "number"), [("part.nc", 900581), ("x.lis", 900581), ("part.ecy", 900582)]
)
def test_binary_files_are_refused(check: Check, name: str, number: int) -> None:
    """A NUL near the start is no text, but in UTF-16; encrypted programs are so by their suffix."""
    write(name, b"\x01\x02\x00G00 X1")
    assert (check(name).ids, check(name).code) == ([number], 2)
    write("utf16.nc", "G00 X1\n".encode("utf-16"))
    assert check("utf16.nc").ids == [21798]
    write("utf8.nc", b"\xef\xbb\xbfG00 X1\n")
    assert check("utf8.nc").ids == [21798]


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="rights do not bind root")
def test_what_may_not_be_read(check: Check) -> None:
    """Files and folders without the right are reported."""
    write("part.nc", GOOD).chmod(0)
    write("locked/part.nc", GOOD).parent.chmod(0)
    try:
        assert 900503 in check("part.nc").ids
        assert 900503 in check("locked").ids
    finally:
        Path("locked").chmod(0o700)


def test_a_file_that_fails_while_it_is_read(check: Check, monkeypatch: pytest.MonkeyPatch) -> None:
    """What the system says is reported."""

    plain_open = Path.open

    def fail(path: Path, *words: Any, **named: Any) -> Any:
        if path.suffix == ".nc":
            raise OSError(5, "Input/output error")
        return plain_open(path, *words, **named)

    write("part.nc", GOOD)
    monkeypatch.setattr(Path, "open", fail)
    checked = check("part.nc")
    assert (checked.ids, checked.code) == ([900503], 2)
    assert "Input/output error" in checked.out


def test_a_folder_that_fails_while_it_is_read(
    check: Check, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The others are searched all the same."""
    scan = os.scandir

    def fail(path: str) -> object:
        if str(path).endswith("locked"):
            raise PermissionError(13, "Permission denied", str(path))
        return scan(path)

    write("set/locked/part.nc", BAD)
    write("set/part.nc", GOOD)
    monkeypatch.setattr(os, "scandir", fail)
    checked = check("set")
    assert (checked.ids, checked.code) == ([900503], 1)
    assert checked.lines[-1].startswith("1 file: 1 error")


def test_standard_input(check: Check, monkeypatch: pytest.MonkeyPatch) -> None:
    """'-' is a program, once."""
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(BAD.encode())))
    assert check("-").found[0] == ("<stdin>", 1, 20797)
    checked = check("-", "-")
    assert checked.code == 2
    assert "error 900504" in checked.err


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_named_pipe_is_read_once(check: Check) -> None:
    """As a shell gives it: check <(generate)."""
    os.mkfifo("pipe")
    writer = threading.Thread(target=Path("pipe").write_text, args=(BAD,))
    writer.start()
    checked = check("pipe")
    writer.join()
    assert checked.ids == [20797, 900200]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_named_pipe_in_a_folder_is_left_alone(check: Check) -> None:
    """Nobody may be writing to it."""
    write("set/good.nc", GOOD)
    os.mkfifo("set/pipe.nc")
    assert check("set").lines[-1].startswith("1 file: 0 errors")


def test_an_empty_program_is_reported(check: Check) -> None:
    """As a run reports it."""
    write("empty.nc", "")
    assert check("empty.nc").ids == [900109]


# --- selection, output ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "ids"),
    [
        (("--select", "20797"), [20797]),
        (("--select", "900203"), [20797]),
        (("--ignore", "900203"), [900200, 900235]),
        (("--ignore", "110087"), [20797, 900200, 900235]),
        (("--select", "NCTAKT900203,900235"), [20797, 900235]),
        (("--select", "90020", "--select", "90023"), [20797, 900200, 900235]),
        (("--select", "900203-900300"), [20797, 900235]),
        (("--ignore", "9002"), []),
        (("--ignore", "900200 , 900235"), [20797]),
        (("--select", "9002", "--ignore", "20797"), [900200, 900235]),
        (("--ignore", "900585"), [20797, 900200, 900235]),
    ],
)
def test_select_and_ignore(check: Check, words: tuple[str, ...], ids: list[int]) -> None:
    """Numbers, how they begin, ranges; what is ignored neither shows nor counts."""
    write("a.nc", BAD)
    write("b.nc", FROZEN)
    checked = check(".", *words)
    assert checked.ids == ids
    assert checked.code == (1 if {20797, 900200} & set(ids) else 0)
    assert ("900585" in checked.out) == ("900585" not in words and "--select" not in words)


@pytest.mark.parametrize("text", ["abc", "123", "5-6", "", "900200-", "20797,x"])
def test_a_word_that_selects_nothing_is_wrong_usage(check: Check, text: str) -> None:
    """It is likely misspelt, and would let a check pass that was not made."""
    write("bad.nc", BAD)
    for option in ("--select", "--ignore"):
        checked = check("bad.nc", option, text)
        assert checked.code == 2
        assert "error 900586" in checked.err


def test_output_goes_to_a_file(check: Check) -> None:
    """The findings there, without colours, and the closing line on the screen."""
    write("bad.nc", BAD)
    checked = check("bad.nc", "--output", "found.txt")
    assert checked.code == 1
    assert checked.lines[-1] == "1 file: 2 errors, 0 warnings, 0 notes"
    assert "20797" not in checked.out
    lines = Path("found.txt").read_text("utf-8").splitlines()
    assert lines[0].startswith("bad.nc:1:9: error 20797")
    assert check("bad.nc", "--output", "gone/found.txt").code == 2


def test_a_reader_that_closes_early_is_no_error() -> None:
    """``nctakt check . | head -1``: the exit code is that of the check."""
    write("bad.nc", "Q1\n" * 3000)
    environment = os.environ | {"PYTHONPATH": str(Path(nctakt.__file__).parent.parent)}
    process = subprocess.Popen(
        [sys.executable, "-m", "nctakt", "check", "bad.nc"],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    assert process.stdout is not None and process.stderr is not None
    assert b"20797" in process.stdout.readline()
    process.stdout.close()
    errors = process.stderr.read()
    process.stderr.close()
    assert (process.wait(), errors) == (1, b"")


@pytest.mark.nightly
@pytest.mark.slow
def test_thousands_of_unknown_entries_are_a_few_lines(check: Check) -> None:
    """The first 20 have a line each, one more counts the others; with --verbose each has one."""
    entries = "".join(f"lr_param.group[{i % 7}].key_{i} {i}\n" for i in range(2000))
    write("x.lis", f"kopf.achs_nr 1\n{entries}Ende\n")
    checked = check("x.lis")
    assert (checked.ids, checked.code) == ([900583, *[110303] * 20, 900010], 0)
    verbose = check("x.lis", "--verbose")
    assert len(verbose.ids) == 2001
    assert verbose.lines[-1].startswith("1 file: 0 errors, 2000 warnings")


# --- what programs call --------------------------------------------------------------------------


def test_called_files_are_checked_in_their_place(check: Check) -> None:
    """A subprogram that only a call names, and what that calls: each once, by file and line."""
    write("part.nc", "%part\nL sub.nc\nL CYCLE [NAME=lib/drill.cyc @P1=2]\nL sub.nc\nM30\n")
    write("sub.nc", "G00 X1\nG200 X1\nL lib/deep.nc\nM17\n")
    write("lib/drill.cyc", "G01 Z-V.P.DEEP F100\nM17\n")
    write("lib/deep.nc", "L gone.nc\nM17\n")
    checked = check("part.nc")
    assert checked.found == [
        ("lib/deep.nc", 1, 20369),
        ("sub.nc", 2, 900200),
        ("", 0, 900585),
    ]
    assert "Searched: lib/" in checked.out
    assert checked.lines[-1].startswith("4 files: ")


def test_a_called_file_ends_with_m17(check: Check) -> None:
    """One that is only called: M30 in it ends the main program, which is a warning."""
    write("part.nc", "L sub.nc\nM30\n")
    write("sub.nc", "G00 X1\nM30\n")
    assert check("part.nc").ids == [20377]
    assert check("part.nc", "sub.nc").ids == []


def test_programs_that_call_each_other_are_checked_once(check: Check) -> None:
    """A circle of calls ends."""
    write("a.nc", "L b.nc\nM30\n")
    write("b.nc", "G200\nL a.nc\nM17\n")
    checked = check("a.nc")
    assert checked.ids == [900200]
    assert checked.lines[-1].startswith("2 files: ")


TWO_CHANNELS = (Path(__file__).parent.parent / "machines" / "centre").resolve()


def two_channels(paths: dict[int, str]) -> None:
    """A machine of two channels in ``mine``; channel -> what its list has in addition."""
    shutil.copytree(TWO_CHANNELS, "mine")
    for channel, text in paths.items():
        file = Path(f"mine/listen/sda_mds{channel}.lis")
        file.write_text(file.read_text("latin-1").replace("Ende", f"{text}\nEnde"), "latin-1")


def of_programs(checked: Checked) -> list[tuple[str, int, int]]:
    """What was found in programs."""
    return [one for one in checked.found if one[0].endswith(".nc")]


def test_programs_in_a_machines_folder_are_for_its_channels(check: Check) -> None:
    """The second channel has no A axis; path[i].dir shows which channel a folder is for."""
    two_channels({1: "path[0].dir ./one", 2: "path[0].dir ./two"})
    for folder in ("one", "two", "three"):
        write(f"mine/{folder}/{folder}.nc", "G00 A10\nM30\n")
    checked = check("mine")
    assert of_programs(checked) == [("mine/two/two.nc", 1, 20797)]
    assert 900585 not in [number for _, _, number in checked.found]


def test_a_folder_of_two_channels_is_checked_for_both(check: Check) -> None:
    """What one of them cannot run is reported; what both cannot, once."""
    two_channels({1: "path[0].dir ./nc", 2: "path[0].dir ./nc"})
    write("mine/nc/a.nc", "G00 A10\nG200\nM30\n")
    checked = check("mine", "--select", "20797,900200")
    assert checked.found == [("mine/nc/a.nc", 1, 20797), ("mine/nc/a.nc", 2, 900200)]
    reported = [number for number, line in enumerate(checked.lines) if line == "  channel: 2"]
    assert reported == [4]
    assert "  Kanal: 2" in check("mine", "--lang", "de").lines


def test_formats_name_the_channels(check: Check) -> None:
    """JSON, SARIF and GitHub name the channels that cannot run a block."""
    two_channels({1: "path[0].dir ./nc", 2: "path[0].dir ./nc"})
    write("mine/nc/a.nc", "G00 A10\nG200\nM30\n")
    words = ("mine/nc/a.nc", "--select", "20797,900200", "--format")
    found = json.loads(check(*words, "json").out)["diagnostics"]
    assert [(one["id"], one["channels"]) for one in found] == [(20797, [2]), (900200, [])]
    for format_ in ("github", "sarif"):
        assert check(*words, format_).out.count("channel: 2") == 1


@pytest.mark.parametrize("named", ["mine/nc/a.nc", "mine/nc"])
def test_the_machine_around_a_program_is_found(check: Check, named: str) -> None:
    """A program is checked for the machine in whose folder it lies, and a note names it."""
    shutil.copytree(DEMO, "mine")
    channel = Path("mine/sda_mds1.lis")
    channel.write_text(channel.read_text("utf-8").replace(" Z\n", " W\n"), "utf-8")
    write("mine/nc/a.nc", "G00 W10\nM30\n")
    checked = check(named)
    assert checked.code == 0
    assert [number for _, _, number in checked.found] == [900815]
    assert "for the machine of mine/hochlauf.lis" in checked.out
    assert of_programs(check(named, "--machine", str(DEMO))) == [("mine/nc/a.nc", 1, 20797)]
    assert 900815 not in [number for _, _, number in check("mine").found]


def test_the_nearest_machine_counts_and_its_errors_are_reported(check: Check) -> None:
    """A machine within another one's folder; a missing list is reported with the program."""
    shutil.copytree(TWO_CHANNELS, "mine")
    shutil.copytree(DEMO, "mine/inner")
    Path("mine/inner/achs_mds4.lis").unlink()
    write("mine/inner/a.nc", "G00 C10\nM30\n")
    assert check("mine/inner/a.nc").ids == [20797, 2001, 20312, 900815]


def test_a_broken_machine_around_a_program(check: Check) -> None:
    """Its start-up list names no channel list: that is reported, and the demo machine is used."""
    write("mine/hochlauf.lis", "kanal_anzahl 1\n")
    write("mine/a.nc", "G00 A10\nM30\n")
    checked = check("mine/a.nc")
    assert checked.code == 1
    numbers = [number for _, _, number in checked.found]
    assert 900077 in numbers
    assert numbers[-1] == 900585


def test_a_named_machine_counts_for_all_programs(check: Check) -> None:
    """--machine: a program in another machine's folder is checked for the one that is named."""
    two_channels({})
    shutil.copytree(DEMO, "demo")
    write("mine/c.nc", "G00 C10\nM30\n")
    assert of_programs(check("mine")) == []
    assert of_programs(check("mine", "--machine", "demo")) == [("mine/c.nc", 1, 20797)]


def test_programs_that_run_with_each_other_one_are_checked(check: Check) -> None:
    """Those of the channel list: existing ones are checked, missing ones reported each time."""
    two_channels({1: "start_init_prog_file begin.nc\nfinal_prog_file gone.nc"})
    write("mine/begin.nc", "G200\nM17\n")
    write("mine/part.nc", "%part\nM30\n")
    assert of_programs(check("mine/part.nc", "--machine", "mine")) == [
        ("mine/begin.nc", 1, 900200),
        ("mine/part.nc", 1, 20369),
    ]


# --- what lists leave out ------------------------------------------------------------------------


def test_each_machine_of_a_tree_is_loaded(check: Check) -> None:
    """Each with its own lists; none of them is checked alone."""
    for name in ("first/cnc", "second/cnc"):
        shutil.copytree(DEMO, name)
    Path("first/cnc/hochlauf.lis").rename("first/cnc/hochlauf_1.lis")
    assert check(".").lines == ["30 files: 0 errors, 0 warnings, 0 notes"]


def test_the_root_folder_is_searched(check: Check) -> None:
    """--root names the folder that the controller's paths begin with."""
    shutil.copytree(DEMO, "mine")
    Path("elsewhere/listen").mkdir(parents=True)
    Path("mine/werkz_d1.lis").rename("elsewhere/listen/werkz_d1.lis")
    assert check("mine").ids == [2001]
    assert check("mine", "--root", "elsewhere").ids == [2001]
    assert check("mine", "--root", "elsewhere/listen").ids == []


def test_entries_without_effect_that_would_change_a_run(check: Check) -> None:
    """One finding for the file, which --strict counts; --effects lists all of them."""
    shutil.copytree(DEMO, "mine")
    text = "hsc.gen.filter_deviation 7\nversch_im_durchm 1\np_param_haltend 1\nEnde\n"
    lists = Path("mine/sda_mds1.lis")
    lists.write_text(lists.read_text("utf-8").replace("Ende\n", text), encoding="utf-8")
    checked = check("mine")
    assert (checked.ids, checked.code) == ([900028, 900029], 0)
    assert ": 2 (hsc.gen.filter_deviation, versch_im_durchm)" in checked.lines[0]
    assert check("mine", "--strict").code == 1
    effects = check("mine", "--effects")
    line = lists.read_text("utf-8").splitlines().index("versch_im_durchm 1") + 1
    assert effects.lines[0] == "warning 900970: 2 entries without effect here would change a run"
    assert effects.lines[1].strip() == "mine/sda_mds1.lis"
    assert f"  {line:6}  P-CHAN-00091   versch_im_durchm is 1, not 0" in effects.lines
    assert "Zero and reference offsets of the facing" in effects.out
    assert "note 900971: 1 entry without effect here may change a run" in effects.lines
    assert effects.out.count("remedy: Expect other positions") == 2
    german = check("mine", "--effects", "--lang", "de")
    assert "P-CHAN-00091   versch_im_durchm ist 1, nicht 0" in german.out
    assert "Hinweis 900971: 1 Eintrag ohne Wirkung hier kann einen Lauf ändern" in german.lines
