# SPDX-License-Identifier: MIT
"""``nctakt check`` over the programs of several channels: signals nobody sends, axes nobody gives.

Sources: pages 207409035 (#SIGNAL), 207421579 (#WAIT), 206987659 (#CALL AX), 206995083 (#PUT AX).
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from support.insides import machine_of

from nctakt.checking.check import CheckResult, check_files
from nctakt.run.controller import Controller

MACHINE = Path(__file__).parent / "exchange_machine"


def checked(folder: Path, **programs: str) -> CheckResult:
    """The result for programs in ``one`` and ``two``, the folders of the two channels."""
    machine = folder / "machine"
    shutil.copytree(MACHINE, machine)
    for number, name in ((1, "one"), (2, "two")):
        path = machine / f"kanal{number}.lis"
        text = path.read_text("utf-8")
        rows = f"path[0].dir ./{name}\npath[0].type 3\nEnde"
        path.write_text(text.replace("Ende", rows), "utf-8")
    for name, text in programs.items():
        (folder / name).mkdir()
        (folder / name / f"{name}.nc").write_text(f"%{name}\n{text}\nM30\n", "utf-8")
    return check_files([folder / name for name in programs], machine_of(Controller(machine)))


def warnings(result: CheckResult) -> list[int]:
    """The numbers of all but notes."""
    return [one.diagnostic.id for one in result.findings if one.diagnostic.severity.name != "NOTE"]


@pytest.mark.parametrize(
    ("one", "two", "expected"),
    [
        ("#WAIT [ID=1 CH=2]", "#SIGNAL [ID=1 CH=1]", []),
        ("#WAIT [ID=1 CH=2]", "#SIGNAL [ID=2 CH=1]", [901811]),
        ("#WAIT [ID=1 CH=2]", "P1=1\n#SIGNAL [ID=P1 CH=1]", []),
        ("#WAIT [ID=P1 CH=2]", "G04 1", []),
        ("G04 1", "#CALL AX [C, 5, 3]", [901810]),
        ("#PUT AX [C]", "#CALL AX [C, 5, 3]", []),
        ("#PUT AX [X]", "#CALL AX [C, 5, 3]", [901810]),
        ("#PUT AX ALL", "#CALL AX [C, 5, 3]\nG01 C5 F100", []),
        ("#AX RELEASE NBR [5]", "#AX REQUEST [C, 5, 3]", []),
        ("#AX RELEASE NBR [P1]", "#AX REQUEST [C, 5, 3]", []),
        ("#SET AX [X, 1, 0]", "#SET AX [C, 5, 3]", []),
        ("G04 1", "#CALL AX [W, 6, 3]\n#CALL AX [X, 4, 0]", []),
    ],
)
def test_programs_of_two_channels(tmp_path: Path, one: str, two: str, expected: list[int]) -> None:
    assert warnings(checked(tmp_path, one=one, two=two)) == expected


def test_a_single_program_is_not_judged(tmp_path: Path) -> None:
    """Those of the other channels are elsewhere."""
    assert warnings(checked(tmp_path, two="#WAIT [ID=1 CH=1]\n#CALL AX [C, 5, 3]")) == []


def test_names_of_fetched_axes_are_known_after_the_command(tmp_path: Path) -> None:
    result = checked(tmp_path, two="#CALL AX [W1, 6, 3]\nG01 W1=5 F100\nP1=V.A.ABS.W1")
    assert warnings(result) == []
    other = tmp_path / "other"
    other.mkdir()
    assert warnings(checked(other, two="G01 W1=5 F100\n#CALL AX [W1, 6, 3]")) == [20797]
