# SPDX-License-Identifier: MIT
"""Sessions on tapes: saved, replayed on the command line, lived through again; chosen programs."""

from __future__ import annotations

import contextlib
import json
import struct
from pathlib import Path

import pytest

from nctakt import Failure, NcText
from nctakt.cli import main
from nctakt.session import Session
from nctakt.session.growing_tape import GrowingTape
from nctakt.session.setup import Setup

pytestmark = pytest.mark.slow

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.E.VALUE > 0.5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
M100
G01 X100 F6000
M30
"""

PLC = """\
class Cell:
    def cycle(self, hli):
        hli.write("V.E.VALUE", hli.tick // 50 % 2)
        if hli.tick == 30:
            hli.acknowledge_all()
"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Its own folder, with a program and a PLC."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text(PROGRAM, "utf-8")
    Path("cell.py").write_text(PLC, "utf-8")
    return tmp_path


def replayed(tape: str, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    """Return exit code and diagnostics of ``nctakt replay``."""
    code = main(["replay", tape])
    return code, capsys.readouterr().err


def test_a_saved_session_is_replayed_with_the_same_events(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with Session("part.nc", at=[("20 ms", "V.E.VALUE", 1)], acknowledges=False) as session:
        session.run("100 ms")
        ((channel, entry),) = session.waiting()
        session.acknowledge(channel, entry)
        session.run("300 ms")
        session.write({"HLI.OVERRIDE": 50.0, "V.E.VALUE": 0})
        session.step(10)
        session.write({"V.E.VALUE": 1})
        session.run()
        count, ticks = session.evaluate("V.E.COUNT"), session.tick
        session.save("lived.tape")
    assert count == 2
    end = json.loads(Path("lived.tape").read_text("utf-8").splitlines()[-1])
    assert end["end"] == "ended"
    assert end["ticks"] == ticks
    assert [Path(name).name for name in end["files"] if name.endswith("part.nc")] == ["part.nc"]
    code, err = replayed("lived.tape", capsys)
    assert code == 0
    assert "901075" in err


def test_a_session_with_a_plc_and_texts_is_replayed_up_to_where_it_was(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with Session(NcText("mine.nc", PROGRAM), plc="cell.py", set={"V.E.COUNT": 5}) as session:
        session.run("400 ms")
        session.back(100)
        session.save("lived.tape")
    code, err = replayed("lived.tape", capsys)
    assert code == 0
    assert "901075" in err
    assert "901074" not in err


def test_a_recorded_run_is_lived_through_without_its_plc() -> None:
    assert main(["run", "part.nc", "--plc", "cell.py", "--record", "run.tape", "--quiet"]) == 0
    with Session("part.nc", plc="cell.py") as session:
        session.run("500 ms")
        expected = session.evaluate("V.E.COUNT"), session.read("X.ACS.ACT_POS")
        inputs = [one for one in session.tape() if one.tick <= 400]
    Path("cell.py").unlink()
    with Session.of_tape("run.tape") as session:
        session.run("500 ms")
        assert (session.evaluate("V.E.COUNT"), session.read("X.ACS.ACT_POS")) == expected
        assert [one for one in session.tape() if one.tick <= 400] == inputs
        session.back(200)
        session.write({"V.E.COUNT": 100})
        session.run()
        assert session.is_over
        assert session.branches[2] == session.tick
        session.save("again.tape")
    assert main(["replay", "again.tape", "--quiet"]) == 0


def with_line(tape: str, number: int, line: str) -> None:
    """Put a line into a tape after its first ``number`` lines."""
    lines = Path(tape).read_text("utf-8").split("\n")
    Path(tape).write_text("\n".join([*lines[:number], line, *lines[number:]]), "utf-8")


def test_what_a_plc_in_another_process_wrote_is_lived_through_without_it() -> None:
    assert main(["run", "part.nc", "--record", "run.tape", "--quiet"]) == 0
    digits = struct.pack("=H", 500).hex()  # 0.1 %
    written = ["hli", "image", "command[1].override", digits]
    with_line("run.tape", 1, json.dumps({"tick": 4, "inputs": [written]}))
    with Session.of_tape("run.tape") as session:
        assert session.run("4 ticks").tick == 4
        assert session.read("HLI.OVERRIDE") == [100.0]
        session.run("20 ticks")
        assert session.read("HLI.OVERRIDE") == [50.0]
        session.back(16)
        assert session.read("HLI.OVERRIDE") == [100.0]
        session.step(2)
        assert session.read("HLI.OVERRIDE") == [50.0]


def test_a_tape_does_not_widen_the_allowed_folders() -> None:
    """902024: it may read the its own files folder, whatever folders it names itself."""
    assert main(["run", "part.nc", "--record", "run.tape", "--quiet", "--confine", "/"]) == 0
    Path("tapes").mkdir()
    tape = Path("run.tape").rename("tapes/run.tape")
    for folders in ([], ["tapes"]):
        with pytest.raises(Failure, match="902024"):
            Session.of_tape(tape, folders=folders)
    with Session.of_tape(tape, folders=["."]) as session:
        assert session.run().run_state == "ended"


def test_a_tape_of_changed_programs_is_reported() -> None:
    """901073."""
    assert main(["run", "part.nc", "--record", "run.tape", "--quiet"]) == 0
    Path("part.nc").write_text(PROGRAM + "; changed\n", "utf-8")
    with pytest.raises(Failure) as caught:
        Session.of_tape("run.tape")
    assert caught.value.diagnostics[0].id == 901073
    with Session.of_tape("run.tape", anyway=True) as session:
        session.run()
        assert session.is_over


def test_a_program_is_chosen_while_the_session_stays(capsys: pytest.CaptureFixture[str]) -> None:
    Path("other.nc").write_text("G01 Y10 F6000\nM30\n", "utf-8")
    with Session("part.nc", stays=True, wait_for_start=True) as session:
        session.write({"HLI.START": True})
        session.run("3 s")
        assert session.latest.state == "ready"
        assert session.read("X.ACS.ACT_POS") == [100.0]
        session.select("other.nc")
        session.run("4 s")
        assert session.read("Y.ACS.ACT_POS") == [0.0]  # it waits for START
        session.write({"HLI.START": True})
        session.run("5 s")
        assert session.read("Y.ACS.ACT_POS") == [10.0]
        assert not session.is_over
        session.back(1500)
        assert session.read("Y.ACS.ACT_POS") == [0.0]
        session.run("5 s")
        assert session.read("Y.ACS.ACT_POS") == [10.0]
        session.save("lived.tape")
    _, err = replayed("lived.tape", capsys)
    assert "901075" in err


def test_a_session_without_programs_takes_one_at_once() -> None:
    with Session(stays=True) as session:
        session.run("1 s")
        session.select("part.nc")
        session.run("3 s")
        assert session.read("X.ACS.ACT_POS") == [100.0]


def test_a_program_with_mistakes_or_no_file_is_not_chosen() -> None:
    Path("wrong.nc").write_text("G01 X10 F\nM30\n", "utf-8")
    with Session(stays=True) as session:
        for name, text in (("wrong.nc", "wrong.nc:1"), ("none.nc", "none.nc")):
            with pytest.raises(Failure) as caught:
                session.select(name)
            assert text in str(caught.value)
        assert session.tape() == []


def test_a_channel_that_runs_keeps_its_program() -> None:
    """901148."""
    Path("other.nc").write_text("G01 Y10 F6000\nM30\n", "utf-8")
    with Session("part.nc", stays=True) as session:
        session.run("200 ms")
        session.select("other.nc")
        reported = [found.id for found in session.run("3 s").diagnostics]
        assert reported == [901148]
        assert session.read("X.ACS.ACT_POS", "Y.ACS.ACT_POS") == [100.0, 0.0]


def test_start_waits_for_the_end_of_a_reset() -> None:
    """RC-007: all three come between two ticks, once at rest and once while the path brakes."""
    Path("other.nc").write_text("G01 Y10 F6000\nM30\n", "utf-8")
    with Session("part.nc", stays=True, wait_for_start=True) as session:
        session.run("10 ms")
        session.write({"HLI.RESET": 1})
        session.select("other.nc")
        session.write({"HLI.START": 1})
        session.run("1 s")
        assert session.read("HLI.ARMED", "X.ACS.ACT_POS", "Y.ACS.ACT_POS") == [0.0, 0.0, 10.0]
        session.select("part.nc")
        session.write({"HLI.START": 1})
        session.run("1.2 s")
        session.write({"HLI.RESET": 1, "HLI.START": 1})
        session.run("1.202 s")
        assert session.read("HLI.START") == [1.0]
        session.run("5 s")
        assert session.read("HLI.START", "X.ACS.ACT_POS") == [0.0, 100.0]


def test_a_tape_of_a_schedule_is_refused() -> None:
    """901149."""
    assert main(["run", "part.nc", "--record", "run.tape", "--quiet"]) == 0
    lines = Path("run.tape").read_text("utf-8").splitlines()
    head = json.loads(lines[0])
    head["words"]["rtconf"] = "rtconf.lis"
    Path("run.tape").write_text("\n".join([json.dumps(head), *lines[1:]]) + "\n", "utf-8")
    with pytest.raises(Failure) as caught, contextlib.closing(Session.of_tape("run.tape")):
        pass
    assert caught.value.diagnostics[0].id == 901149


def test_a_growing_tape_is_whole_at_any_time(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is on it when the process is killed is replayed (901531); a full disk passes."""
    setup = Setup({1: ["part.nc"]}, options={"stays": True})
    Path("run.growing.tape").write_text("of an earlier process", "utf-8")
    with Session.of_setup(setup) as session:
        Path("run.growing-2.new.tape").write_text("of somebody", "utf-8")
        tape = GrowingTape("run.tape", session, setup, {"part.nc": Path("part.nc")})
        for value in (1, 2):
            session.write({"V.E.VALUE": value})
            session.step(10)
            tape.look()
        assert replayed("run.growing-2.tape", capsys)[1].startswith("note 901531: ")
        lines = list(map(json.loads, Path("run.growing-2.tape").read_text("utf-8").splitlines()))
        assert [line["tick"] for line in lines[1:-1]] == [0, 10]
        assert lines[-1]["ticks"] == 20
        session.back(10)
        session.write({"V.E.VALUE": 7})  # another branch
        session.step(5)
        write = GrowingTape._write

        def refuse(*_: object) -> None:
            raise OSError(28, "No space left on device")

        monkeypatch.setattr(GrowingTape, "_write", refuse)
        with pytest.raises(OSError, match="No space"):
            tape.look()
        assert replayed("run.growing-2.tape", capsys)[0] == 0
        monkeypatch.setattr(GrowingTape, "_write", write)
        tape.look()
        lines = list(map(json.loads, Path("run.growing-2.tape").read_text("utf-8").splitlines()))
        assert [line["inputs"][0][3] for line in lines[1:-1]] == [1.0, 7.0]
        assert lines[-1]["ticks"] == 15
        tape.close()
    assert Path("run.growing.tape").read_text("utf-8") == "of an earlier process"
    assert Path("run.growing-2.new.tape").read_text("utf-8") == "of somebody"
    assert {path.name for path in Path().glob("run*")} == {
        "run.growing.tape",
        "run.growing-2.new.tape",
    }
