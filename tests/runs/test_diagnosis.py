# SPDX-License-Identifier: MIT
"""The diagnosis data of whole runs, as the command writes them (manual chapter 5, RC-601, RC-603).

A run folder may hold ``diagnosis.en.txt`` and ``diagnosis.de.txt``: all of it, to the last blank.
Times and levels are derived in the folder's README.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from support.run_folders import HERE, changed_machine, settings

from nctakt.cli import main

FILES = sorted(HERE.glob("*/diagnosis.*.txt"))

PROGRAM = """V.RTG.CYCLES.DIAG_LEVEL = {level}
#RT CYCLE [ID = 7 SCOPE = GLOBAL]
  M100
#RT CYCLE END
#TIME 0.001
#RT CYCLE CONTINUE [ID = 7]
#TIME 0.001
#RT CYCLE HOLD [ID = 7]
#RT CYCLE [ID = 8 SCOPE = PROG]
  V.E.VALUE1 = 1 / V.E.VALUE
#RT CYCLE END
M30
"""

#: Level, time, label and words of what happens; tick 1 takes the write of the level.
LINES = [
    (3, "0", "INFO", "Realtime cycle manager was initialised"),
    (3, "0", "INFO", "Realtime cycle manager: 0 cycles"),
    (3, "1000", "INFO", "Cycle 7 was created with GLOBAL validity"),
    (3, "1000", "INFO", "Cycle 7 was started"),
    (4, "1000", "ACTION", "M100"),
    (2, "2000", "WARNING", "900412"),
    (4, "2000", "ACTION", "M100"),
    (3, "3000", "INFO", "Cycle 7 was put on hold"),
    (3, "3000", "INFO", "Cycle 8 was created with PROG validity"),
    (3, "3000", "INFO", "Cycle 8 was started"),
    (1, "3000", "ERROR", "50879"),
    (3, "3000", "INFO", "Cycle 8 was ended by an error"),
]


def words_of(folder: Path) -> list[str]:
    """The command's words for the values and stimuli of a run folder."""
    given = settings(folder)
    words = [str(program) for program in sorted(folder.glob("*.nc"))]
    for name, value in given.get("set", {}).items():
        words += ["--set", f"{name}={value}"]
    for time, name, value in given.get("at", ()):
        words += ["--at", time, f"{name}={value}"]
    return words


@pytest.mark.parametrize("file", FILES, ids=lambda file: f"{file.parent.name}-{file.stem[-2:]}")
def test_the_diagnosis_data_of_a_run(file: Path, tmp_path: Path) -> None:
    """RC-601: header, rule, note, columns and lines, in the language asked for."""
    written = tmp_path / "diagnosis.txt"
    language = file.stem.rsplit(".", 1)[1]
    words = ["--quiet", "--diagnosis", str(written), "--lang", language]
    assert main(["run", *words_of(file.parent), *words]) == settings(file.parent).get("exit", 0)
    assert written.read_text("utf-8") == file.read_text("utf-8")


@pytest.mark.parametrize("level", [-3, 0, 1, 2, 3, 4, 99])
def test_each_level_adds_its_kind_of_lines(level: int, tmp_path: Path) -> None:
    """RC-603: 1 errors, 2 + warnings, 3 + management, 4 + actions; filtered when they are shown.

    Ticks: the write's flush ends tick 0; tick 1 takes the write, cycle 7 and a dwell; tick 2 a
    CONTINUE without effect and a dwell; tick 3 HOLD and cycle 8, which divides by zero at once. The
    manager's two lines are older than the write, and shown by the same level.
    """
    program = tmp_path / "levels.nc"
    program.write_text(PROGRAM.format(level=level), "utf-8")
    written = tmp_path / "diagnosis.txt"
    assert main(["run", str(program), "--quiet", "--diagnosis", str(written)]) == 1
    lines = written.read_text("utf-8").splitlines()
    body = [line.split(None, 2) for line in lines[lines.index("-" * 63) + 1 :]]
    expected = [line for line in LINES if line[0] <= level]
    assert [line[:2] for line in body] == [[time, label] for _, time, label, _ in expected]
    for found, (_, _, _, words) in zip(body, expected, strict=True):
        assert words in found[2]


def test_a_channel_without_realtime_cycles_has_no_diagnosis_data(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """RC-603, manual 5: only where P-CHAN-00406 is on; that there are none is reported (901040)."""
    lines = {"sda_mds1.lis": ["configuration.rt_cycles.enable 0"]}
    machine = changed_machine(lines, tmp_path / "machine")
    program, written = tmp_path / "part.nc", tmp_path / "diagnosis.txt"
    program.write_text("M30\n", "utf-8")
    words = ["run", str(program), "--machine", str(machine), "--diagnosis", str(written)]
    assert main(words) == 0
    assert written.read_text("utf-8") == ""
    assert "901040" in capsys.readouterr().err


ACTIONS = """V.RTG.CYCLES.DIAG_LEVEL = 4
#RT CYCLE [ID = 7 SCOPE = PROG]
  $IF ONCE 1
    S[M3 REV=600]
    S2[M3 M19 REV=60 POS=90]
    #TIMER START SYN [ID = 3]
    #ERROR [ID = 455 RC = 0]
    Z[INDP G90 G00 POS=0.1]
    V.E.COUNT = 5
    M100
  $ENDIF
  $IF ONCE V.RTG.TIMER[3] == 0 && V.E.TRIGGER
    #TIMER READ SYN [ID = 3]
    S[M5]
  $ENDIF
#RT CYCLE END
#TIME 0.04
M30
"""


def test_level_4_lists_all_actions_of_cycles(tmp_path: Path) -> None:
    """RC-603, manual 5: spindle jobs, timers, #ERROR, motions, writes, M functions."""
    program, written = tmp_path / "actions.nc", tmp_path / "diagnosis.txt"
    program.write_text(ACTIONS, "utf-8")
    words = ["--at", "11 ms", "V.E.TRIGGER=1", "--quiet", "--diagnosis", str(written)]
    assert main(["run", str(program), *words]) == 0
    lines = [line.split(None, 2) for line in written.read_text("utf-8").splitlines()]
    actions = [(line[0], line[2].removeprefix("Cycle 7: ")) for line in lines if "ACTION" in line]
    assert actions[:8] == [
        ("1000", "the branch in line 3 runs"),
        ("1000", "spindle S: M3 with 600 1/min"),
        ("1000", "spindle S2: M19 with 60 1/min"),
        ("1000", "spindle S2 is positioned at 90 degrees"),
        ("1000", "#TIMER START of timer 3"),
        ("1000", "#ERROR with ID 455 and RC 0"),
        ("1000", "axis Z moves to 0.1"),
        ("1000", "V.E.COUNT = 5"),
    ]
    assert ("11000", "#TIMER READ of timer 3: 10 ms") in actions
    assert ("11000", "spindle S: M5") in actions
