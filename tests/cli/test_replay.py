# SPDX-License-Identifier: MIT
"""``nctakt run --record`` and ``nctakt replay``."""

from __future__ import annotations

import io
import json
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from nctakt.cli import main

PROGRAM = """\
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF ONCE V.E.TRIGGER == 1
    M100
  $ENDIF
#RT CYCLE END
G01 X10 F1000
#MSG ["value %d", V.E.VALUE]
M110
M30
"""

PLC = """\
class Cell:
    def cycle(self, hli):
        if hli.tick == 10:
            hli.write("V.E.TRIGGER", True)
            hli.write("V.E.VALUE", 7)
            hli.override_pct = 50
        if hli.tick % 7 == 0:
            hli.acknowledge_all()
"""

Reported = Callable[..., tuple[int, str, str]]


@pytest.fixture
def reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Reported:
    """Run a command beside ``a.nc`` and ``plc.py``; exit code and both outputs."""
    monkeypatch.chdir(tmp_path)
    Path("a.nc").write_text(PROGRAM, "utf-8")
    Path("plc.py").write_text(PLC, "utf-8")

    def command(*words: str) -> tuple[int, str, str]:
        code = main(words)
        shown = capsys.readouterr()
        return code, shown.out, shown.err

    return command


def record(reported: Reported, *words: str) -> tuple[int, str, str]:
    """Record a run with the PLC."""
    return reported(
        "run", "a.nc", "--plc", "plc.py", "--at", "0.1s", "V.E.VALUE=9", "--record", "run.tape",
        *words,
    )  # fmt: skip


def test_a_replay_needs_no_plc(reported: Reported) -> None:
    """The same trace, the same messages and summary, byte for byte; a note says so (901075)."""
    code, out, _ = record(reported, "--trace", "a.csv", "--messages", "a.txt")
    assert code == 0
    Path("plc.py").unlink()
    words = ("replay", "run.tape", "--trace", "b.csv", "--messages", "b.txt")
    again = reported(*words)
    assert again[:2] == (0, out)
    assert "note 901075: " in again[2]
    assert Path("b.csv").read_bytes() == Path("a.csv").read_bytes()
    assert Path("b.txt").read_bytes() == Path("a.txt").read_bytes()
    assert reported("replay", "run.tape", "--quiet")[2] == ""


def test_all_inputs_are_on_the_tape(reported: Reported) -> None:
    """Head, inputs by tick and source, checksums of events, end with digests."""
    record(reported)
    head, *middle, end = map(json.loads, Path("run.tape").read_text("utf-8").splitlines())
    assert (head["tape"], head["has_plc"], head["words"]["programs"]) == (1, True, ["a.nc"])
    assert end["end"] == "ended"
    assert "a.nc" in end["files"]
    assert "nctakt:machines/demo/hochlauf.lis" in end["files"]
    assert "plc.py" not in end["files"]
    inputs = {one["tick"]: one["inputs"] for one in middle if "inputs" in one}
    assert inputs[11][:2] == [
        ["plc", "write", "V.E.TRIGGER", 1.0],
        ["plc", "write", "V.E.VALUE", 7.0],
    ]
    assert ["stimuli", "write", "V.E.VALUE", 9.0] in inputs[100]
    kinds = {one[1] for own in inputs.values() for one in own}
    assert kinds == {"write", "ack"}


def test_a_changed_program_is_reported(reported: Reported) -> None:
    """901073 and nothing runs; --anyway runs it and shows the first difference (901074)."""
    record(reported)
    Path("a.nc").write_text(PROGRAM.replace("X10", "X5"), "utf-8")
    code, out, err = reported("replay", "run.tape")
    assert (code, out) == (2, "")
    assert "error 901073: changed since the tape was recorded: a.nc" in err
    code, out, err = reported("replay", "run.tape", "--anyway")
    assert code == 1
    assert "a.nc: ended" in out
    assert "warning 901073: " in err
    assert "warning 901074: the events differ" in err
    Path("a.nc").write_text(f"{PROGRAM}; a remark\n", "utf-8")
    code, _, err = reported("replay", "run.tape", "--anyway")
    assert code == 0
    assert "note 901075: " in err


def test_a_program_from_standard_input(reported: Reported, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its text is on the tape."""
    text = io.TextIOWrapper(io.BytesIO(b'#MSG ["hello"]\nM30\n'))
    monkeypatch.setattr("sys.stdin", text)
    code, out, _ = reported("run", "-", "--record", "run.tape")
    assert code == 0
    assert reported("replay", "run.tape")[:2] == (0, out)


def test_a_plc_that_fails_leaves_a_tape(reported: Reported) -> None:
    """The replay ends in the same tick."""
    Path("plc.py").write_text(f"{PLC}        if hli.tick == 50:\n            1 / 0\n", "utf-8")
    assert record(reported)[0] == 1
    code, out, err = reported("replay", "run.tape")
    assert code == 0
    assert "51 ticks" in out
    assert "901075" in err


def with_end(**words: object) -> str:
    """Return the tape with another last line, whose files are those of ``words`` as well."""
    *lines, end = Path("run.tape").read_text("utf-8").splitlines()
    entry = json.loads(end)
    entry["files"].update(words)
    return "\n".join([*lines, json.dumps(entry), ""])


@pytest.mark.parametrize("name", ["/dev/zero", "/etc/hostname", "../secret", "nctakt:../../secret"])
def test_a_tape_reaches_the_files_of_its_folder_alone(reported: Reported, name: str) -> None:
    """902024, and nothing is read or shown; ``--root`` names further folders."""
    record(reported)
    Path("run.tape").write_text(with_end(**{name: "0" * 64}), "utf-8")
    code, out, err = reported("replay", "run.tape", "--anyway")
    assert (code, out) == (2, "")
    assert "902024" in err
    assert name in err
    Path("tapes").mkdir()
    record(reported)
    Path("run.tape").rename("tapes/run.tape")
    assert "902024" in reported("replay", "tapes/run.tape")[2]
    assert reported("replay", "tapes/run.tape", "--root", ".")[0] == 0


def test_a_tape_cannot_make_a_replay_read_forever(reported: Reported) -> None:
    """A device is not read even where it is admitted, nor a file of another size than stated."""
    record(reported)
    Path("run.tape").write_text(with_end(**{"/dev/zero": "0" * 64}), "utf-8")
    code, _, err = reported("replay", "run.tape", "--root", "/")
    assert (code, "901073" in err) == (2, True)
    os.mkfifo("pipe")
    with Path("sparse").open("wb") as file:
        file.truncate(1 << 40)
    files = {"pipe": "0" * 64, "sparse": f"{'0' * 64} 5"}
    record(reported)
    Path("run.tape").write_text(with_end(**files), "utf-8")
    code, _, err = reported("replay", "run.tape")
    assert (code, "901073" in err, "sparse" in err) == (2, True, True)


@pytest.mark.parametrize("place", ["files", "words", "texts"])
def test_a_name_with_the_character_0_is_refused(reported: Reported, place: str) -> None:
    """901070: no file has such a name."""
    record(reported)
    head, *middle, end = map(json.loads, Path("run.tape").read_text("utf-8").splitlines())
    if place == "files":
        end["files"]["a\0b"] = "0" * 64
    elif place == "words":
        head["words"]["machine"] = "a\0b"
    else:
        head["texts"]["a\0b"] = "M30"
    lines = map(json.dumps, (head, *middle, end))
    Path("run.tape").write_text("\n".join([*lines, ""]), "utf-8")
    code, _, err = reported("replay", "run.tape", "--anyway")
    assert (code, "901070" in err) == (2, True)


def with_input(tape: str, values: list[object]) -> str:
    """Return a tape with another input before the first tick."""
    head, _, rest = tape.partition("\n")
    return "\n".join([head, json.dumps({"tick": 0, "inputs": [values]}), rest])


@pytest.mark.parametrize(
    ("change", "number", "place"),
    [
        (lambda text: text[: len(text) // 2], 901072, ""),
        (lambda text: text[: text.rindex('{"end"')], 901072, ""),
        (lambda _: "", 901072, "run.tape:1:1: "),
        (lambda text: text.replace('"tape":1', '"tape":2'), 901071, "run.tape:1:1: "),
        (lambda _: "G00 X1\nM30\nM30\n", 901070, "run.tape:1:1: "),
        (lambda _: "G00 X1", 901070, "run.tape:1:1: "),
        (lambda text: text[:20], 901072, "run.tape:1:1: "),
        (lambda _: '{"tape":99}\n', 901071, "run.tape:1:1: "),
        (lambda text: text.replace('"tape":1', '"tape":true'), 901070, "run.tape:1:1: "),
        (lambda text: text.replace('"has_plc":true', '"has_plc":3'), 901070, "run.tape:1:1: "),
        (lambda text: text.replace('"programs":["a.nc"]', '"programs":3'), 901070, ""),
        (lambda text: text.replace('"plc","write"', '"plc","wrote"', 1), 901070, "run.tape:"),
        (lambda text: text.replace('"TRIGGER",1.0', '"TRIGGER"', 1), 0, ""),
        (lambda text: text.replace('{"tick":11,', '{"tick":-1,', 1), 901070, "run.tape:"),
        (lambda text: text.replace('["plc","ack",0,', '["plc","ack",9,', 1), 901077, ""),
        (lambda text: text.replace('["plc","ack",0,', '["plc","ack",-1,', 1), 901077, ""),
        (lambda text: with_input(text, ["plc", "ack_spindle", -1, 0, 1, "S"]), 901077, ""),
        (lambda text: text.replace("V.E.TRIGGER", "V.E.NOTHING", 1), 900514, ""),
        (lambda text: "[" * 100_000 + "\n" + text, 901070, "run.tape:1:1: "),
    ],
    ids=map(str, range(19)),
)
def test_a_tape_that_cannot_be_read(
    reported: Reported, change: Callable[[str], str], number: int, place: str
) -> None:
    """Cut off, of another version, no tape, garbage in it: an error with its place."""
    record(reported)
    tape = Path("run.tape")
    tape.write_text(change(tape.read_text("utf-8")), "utf-8")
    code, _, err = reported("replay", "run.tape")
    assert "Traceback" not in err
    assert "internal error" not in err
    if number == 0:
        assert code == 0
    elif number == 900514:
        assert code == 2
        assert "V.E.NOTHING" in err
    else:
        assert code == 2
        assert f"{place}error {number}: " in err or f"error {number}: " in err
        assert err.startswith(place)
