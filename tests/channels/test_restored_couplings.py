# SPDX-License-Identifier: MIT
"""Couplings that the next program begins with (P-CHAN-00104, P-CHAN-00105).

The machine is that of ``test_couplings.py``; ``docs/conformance/couplings.md`` has the decisions.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from support.coupled_axes import FOLDER, numbers, path_of, run
from support.run_folders import changed_machine

import nctakt
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.run.controller import Controller, NcText

DEMO5 = Path(nctakt.__file__).parent / "machines" / "demo5"
KEEPS = "synchro_data.preserve_coupling_after_prog_end 1"


@pytest.fixture(scope="module", name="keeping")
def fixture_keeping(tmp_path_factory: pytest.TempPathFactory) -> Machine:
    folder = tmp_path_factory.mktemp("keeping") / "machine"
    return load_machine(changed_machine({"kanal.lis": [KEEPS]}, folder, base=FOLDER))


def test_block_search_does_not_begin_with_them(keeping: Machine) -> None:
    """The axes go to the start block as they are: 901884, also before it."""
    controller = Controller(keeping)
    run("#AX LINK ON", "G01 X10 F6000", controller=controller)
    program = NcText("part.nc", "G01 X15 F6000\nX20\nX30\nM30\n")
    found = controller.run(program, from_line=3)
    assert [one.id for one in found.diagnostics] == [901884]


def test_transformations_of_the_list_exclude_them(tmp_path: Path) -> None:
    """P-CHAN-00151 switches one on at the start of each program."""
    entries = {
        "sda_mds1.lis": [KEEPS, "auto_enable_kin_trafo 1"],
        "achs_mds4.lis": ["kenngr.achs_mode 1"],
    }
    machine = load_machine(changed_machine(entries, tmp_path / "machine", base=DEMO5))
    controller = Controller(machine)
    coupled = ("#TRAFO OFF", "G01 X10 Y20 A30 F6000", "#AX LINK [1, A=C]", "#AX LINK ON [1]")
    assert numbers(run(*coupled, controller=controller, signals=())) == []
    assert numbers(run("G01 C20 F6000", controller=controller, signals=())) == [901884]


def test_another_main_spindle_is_left_out(keeping: Machine) -> None:
    """The main spindle of the list, which cannot be a slave, is so again: 901888."""
    controller = Controller(keeping)
    link = ("#MAIN SPINDLE [S2]", "#AX LINK [1, S1=S2]", "#AX LINK [2, U=X]", "#AX LINK ON [1]")
    assert numbers(run(*link, "#AX LINK ON [2]", controller=controller)) == []
    found = run("G01 X5 F6000", controller=controller)
    assert numbers(found) == [901888]
    assert path_of(found, "U")[-1] == 5.0
    assert numbers(run("G01 X6 F6000", controller=controller)) == []


def test_an_axis_that_went_is_left_out(tmp_path: Path) -> None:
    """The axes of the list are there again at the start; one that was fetched is not."""
    base = FOLDER.parent / "exchange_machine"
    machine = load_machine(changed_machine({"kanal1.lis": [KEEPS]}, tmp_path / "m", base=base))
    controller = Controller(machine)
    begin = ("#CALL AX [W, 6, 4]", "#AX LINK [1, W=X]", "#AX LINK ON [1]")
    assert numbers(run(*begin, "G01 X10 F6000", controller=controller, signals=())) == []
    assert numbers(run("G01 X20 F6000", controller=controller, signals=())) == [901888]
