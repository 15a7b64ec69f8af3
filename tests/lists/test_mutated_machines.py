# SPDX-License-Identifier: MIT
"""Machine folders with mistakes that chance has made: where ``check`` is content, ``run`` runs.

The lists of the built-in machine, each folder with one to six changes, are checked together with a
program that uses what the lists describe. Whatever is in them, nothing ends in a traceback; where
the check finds no error, the program is not refused by its machine either, and it ends within its
ticks. ``NCTAKT_SEEDS=100000`` makes as many folders.
"""

from __future__ import annotations

import re
import traceback
from pathlib import Path
from random import Random

import pytest
from support.machine_mutations import mutated, write
from support.random_seeds import seeds_in_parts

from nctakt.base.diagnostics import Severity
from nctakt.base.failure import Failure
from nctakt.base.text import decode_text
from nctakt.checking.check import check_files
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.assembly import AssembledMachine

DEMO = {
    path.name: decode_text(path.read_bytes()).text
    for path in sorted(load_machine(None).folder.glob("*.lis"))
}
TICKS = 40
#: Words of all axes and spindles of the built-in machine, its variables, functions, offsets, tools.
PROGRAMS = (
    "G00 X1 Y1 Z1 A1\nG01 X2 F1000\nG02 X3 Y1 I0.5 J0\nM30\n",
    "#RT CYCLE [ID = 1 SCOPE = PROG]\n$IF ONCE V.RTA.ACS.ACT_POS.Y > 0\nM100\nV.E.COUNT += 1\n"
    "$ENDIF\n#RT CYCLE END\nG01 Y5 F2000\nM30\n",
    "S1000 M3\nS[M19 POS=90 REV=100]\nT1 D1\nG54\nG00 X1 Z2\nG41 G01 X3 Y3 F500\nG40 X5\nM30\n",
    "#RT CYCLE [ID = 2]\nA[INDP G90 POS=10 FEED=1000]\n#RT CYCLE END\nG04 X0.01\nM100\nH10\nM30\n",
    "V.E.VALUE = V.E.LIST[2] + V.CH.Total\n#SLOPE [TYPE=TRAPEZ]\nG61\nG01 X1 F9000\nY1\nZ1\nM30\n",
)


def outcome(lists: dict[str, str], program: str, folder: Path) -> str:
    """What is wrong with how a folder is treated; empty if nothing is."""
    write(lists, folder)
    try:
        found = check_files([folder], AssembledMachine(load_machine(None))).findings
        [one.diagnostic.render("de") for one in found]
        is_wrong = any(one.diagnostic.severity is Severity.ERROR for one in found)
        text = NcText("part.nc", program)
        try:
            machine = AssembledMachine(load_machine(folder))
        except Failure:
            return "" if is_wrong else "no error of the check, and no machine"
        checked = check_files([text], machine).findings
        is_wrong_program = any(one.diagnostic.severity is Severity.ERROR for one in checked)
        run = Controller(folder).run(text, ticks=TICKS)
        [one.render("de") for one in run.diagnostics]
        if run.ticks and is_wrong_program and not run.errors:
            return "an error of the check, and none of the run"
        if not run.ticks and not is_wrong and not is_wrong_program:
            return f"no error of the check, and no run: {run.errors}"
    except Exception:  # noqa: BLE001 - what ends in a traceback is what is looked for
        return traceback.format_exc()
    return ""


@pytest.mark.nightly
@seeds_in_parts(75, 75, 25)
def test_where_the_check_finds_no_error_the_machine_runs(tmp_path: Path, seeds: range) -> None:
    """The seed of a folder that is treated wrongly is before what happens to it."""
    wrong = []
    for seed in seeds:
        chance = Random(seed)
        lists = mutated(DEMO, chance)
        reported = outcome(lists, chance.choice(PROGRAMS), tmp_path / str(seed))
        if reported:
            wrong.append(f"seed {seed}: {reported}")
    assert wrong == []


@pytest.mark.parametrize("entry", [r"achs_mds\[1\]", r"achs_mds\[5\]"])
def test_an_axis_without_its_list_is_no_word_of_a_program(tmp_path: Path, entry: str) -> None:
    """The check says so, and the run does not begin."""
    lists = dict(DEMO)
    lists["hochlauf.lis"] = re.sub(rf"(?m)^{entry}.*\n", "", lists["hochlauf.lis"])
    assert lists != DEMO
    write(lists, tmp_path / "machine")
    machine = AssembledMachine(load_machine(tmp_path / "machine"))
    text = NcText("part.nc", "G00 Y1\nM30\n")
    numbers = [one.diagnostic.id for one in check_files([text], machine).findings]
    run = Controller(tmp_path / "machine").run(text)
    if "1" in entry:
        assert numbers == [20797]
        assert run.ticks == 0
        assert [one.id for one in run.errors] == [20312, 20797]
    else:
        assert run.state == "ended"
