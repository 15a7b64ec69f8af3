# SPDX-License-Identifier: MIT
"""Gantries of the lists (P-AXIS-00070 … 73): what slaves take over, and that each is watched.

``test_couplings.py`` has the rest; ``docs/conformance/couplings.md`` says what is decided.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from support.coupled_axes import FOLDER, numbers
from support.insides import machine_of
from support.run_folders import changed_machine

from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText


def test_a_slave_takes_over_the_modulo_range(tmp_path: Path) -> None:
    """70202, and no jump where the master comes back into its range."""
    entries = {"a6.lis": ["kenngr.achs_mode 4"], "y8.lis": ["kenngr.gantry_ax_nr 6"]}
    machine = load_machine(changed_machine(entries, tmp_path / "machine", base=FOLDER))
    controller = Controller(machine)
    lines = ("#RT CYCLE [ID=1 SCOPE=PROG]", "A[INDP G91 POS=400 FEED=6000]", "#RT CYCLE END")
    controller.start(NcText("part.nc", "\n".join([*lines, "G04 6", "M30", ""])))
    axes = machine_of(controller).axes
    found = []
    for _ in range(6000):
        controller.step()
        found.append([list(axes.positions())[index] for index in (5, 7)])
    ways = (np.diff(np.asarray(found), axis=0) + 180.0) % 360.0 - 180.0
    assert np.abs(ways).max() < 0.2
    assert np.abs(ways[:, 0] - ways[:, 1]).max() < 1e-9


def test_each_pair_is_watched(tmp_path: Path) -> None:
    """901879 in both channels, whichever slave is held back first."""
    start_up = ["zahl_mds 8", "achs_mds[6] slave7.lis", "achs_mds[7] slave8.lis"]
    folder = changed_machine(
        {"hochlauf.lis": start_up}, tmp_path / "machine", base=FOLDER.parent / "exchange_machine"
    )
    for number, master in ((7, 1), (8, 4)):
        entries = (
            f"kopf.achs_nr {number}",
            f"kenngr.gantry_ax_nr {master}",
            "kenngr.gantry_max_diff_resetable 5000",
            "antr.simu.fixed_stop 80000",
            "antr.simu.ist_gleich_soll 1",
            "Ende",
        )
        (folder / f"slave{number}.lis").write_text("\n".join(entries))
    machine = load_machine(folder)
    for first, second in ((0, 1), (1, 0)):
        programs = [f"G04 X{dwell}\nG01 X20 F6000\nM30\n" for dwell in (first, second)]
        found = Controller(machine).run(
            NcText("one.nc", programs[0]), channels={2: [NcText("two.nc", programs[1])]}, ticks=4000
        )
        assert sorted(numbers(found)) == [901879, 901879]
