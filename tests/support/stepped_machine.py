# SPDX-License-Identifier: MIT
"""``demo5`` with further kinematics in both steps, for tests of what programs make of them."""

from __future__ import annotations

import shutil
from pathlib import Path

import nctakt
from nctakt.results.run import ProgramMessage, Run
from nctakt.run.controller import Controller, NcText

DEMO5 = Path(nctakt.__file__).parent / "machines" / "demo5"
#: A table C (type 34) about X50 Y-20 in either step, and a type that is not there.
KINEMATICS = """trafo[1].id 34
trafo[1].param[1] 500000
trafo[1].param[2] -200000
trafo[2].id 77
kin_step[1].trafo[0].id 340
kin_step[1].trafo[0].type 34
kin_step[1].trafo[0].param[1] 500000
kin_step[1].trafo[0].param[2] -200000
"""

#: A tool for the table C, 50 mm long.
TOOL = "wz[4].gueltig 1\nwz[4].laenge 500000\nwz[4].kin_id 34\n"


def machine_with_steps(folder: Path, more: str = "") -> Path:
    """Write the machine into a folder; ``more`` lines of its channel list."""
    shutil.copytree(DEMO5, folder)
    file = folder / "sda_mds1.lis"
    file.write_text(KINEMATICS + more + file.read_text("utf-8"), "utf-8")
    tools = folder / "werkz_d1.lis"
    tools.write_text(TOOL + tools.read_text("utf-8"), "utf-8")
    return folder


def run(machine: Path, text: str) -> tuple[Run, list[str]]:
    """A program's run, and what it says."""
    said: list[ProgramMessage] = []
    found = Controller(machine).run(NcText("p.nc", text + "M30\n"), on_message=said.append)
    return found, [one.text for one in said]


def numbers(text: str) -> list[float]:
    """The numbers of a message."""
    return [float(word) for word in text.split()]
