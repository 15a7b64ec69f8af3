# SPDX-License-Identifier: MIT
"""Spindles that follow others (``#AX LINK``); the machine is that of ``test_couplings.py``.

``docs/conformance/couplings.md`` says what is decided.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest
from support.coupled_axes import FOLDER, numbers, run
from support.geared_machine import machine as machine_with_gears
from support.run_folders import changed_machine

import nctakt
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.run.controller import Controller

DEMO5 = Path(nctakt.__file__).parent / "machines" / "demo5"
SPEEDS = ("S.SPEED", "S2.SPEED", "S3.SPEED")


def changed(folder: Path, **entries: Sequence[str]) -> Machine:
    """The machine with these entries of its lists."""
    lists = {f"{name}.lis": lines for name, lines in entries.items()}
    return load_machine(changed_machine(lists, folder / "machine", base=FOLDER))


def speeds(*lines: str, machine: Machine | None = None) -> list[float]:
    """The speeds of the three spindles at the end, 1/min."""
    controller = Controller(machine) if machine is not None else None
    found = run(*lines, controller=controller, signals=SPEEDS)
    assert numbers(found) == []
    assert found.trace is not None
    return [round(float(found.trace[name][-1]), 6) for name in SPEEDS]


def test_the_main_spindle_is_the_programs() -> None:
    """``S`` is the spindle that ``#MAIN SPINDLE`` has made it, also as a master."""
    begin = ("#MAIN SPINDLE [S2]", "#AX LINK [1, S3=S]", "#AX LINK ON [1]")
    assert speeds(*begin, "M3 S300", "G04 5") == [0.0, 300.0, 300.0]
    assert numbers(run("#MAIN SPINDLE [S2]", "#AX LINK [1, S2=S]")) == [20475]


@pytest.mark.parametrize("words", ["G97 S500 M3", "G97 M3 S500", "G196 S3000\nM3 S500"])
def test_other_speeds_than_cutting_ones(words: str) -> None:
    """Only G96 is excluded."""
    begin = ("#AX LINK [1, S2=S]", "#AX LINK ON [1]")
    assert speeds(*begin, words, "G04 5") == [500.0, 500.0, 0.0]


def test_cutting_speeds_exclude_followers(tmp_path: Path) -> None:
    """901884 for G96, whichever comes first; another pair may be coupled."""
    face = {name: ["kenngr.achs_mode 65"] for name in ("x1", "u4")}
    controller = Controller(changed(tmp_path, **face))
    begin = ("G18", "#AX LINK [1, S2=S]", "#AX LINK [2, S3=S2]", "G01 X50 F6000")
    link = ("#AX LINK ON [1]",)
    cutting = ("G96 S100", "M3")
    assert numbers(run(*begin, *link, *cutting, controller=controller)) == [901884]
    assert numbers(run(*begin, *cutting, *link, controller=controller)) == [901884]
    assert numbers(run(*begin, *cutting, "#AX LINK ON [2]", controller=controller)) == []


def test_followers_are_reported_of_their_limits(tmp_path: Path) -> None:
    """900905 for a slave that cannot turn so fast, as for one that is programmed itself."""
    slow = changed(tmp_path, s12=["getriebe[0].dynamik.vb_max 600000"])
    found = run("#AX LINK [1, S2=S]", "#AX LINK ON [1]", "M3 S500", controller=Controller(slow))
    assert numbers(found) == [900905]


@pytest.mark.parametrize("pair", ["[S2=S, -1, 1]", "[S2=S, G, 1, 2]", "[S2=S, G]"])
def test_followers_have_no_factor(pair: str) -> None:
    """287570315: they get the same jobs; set points are not coupled."""
    assert numbers(run(f"#AX LINK [1, {pair}]")) == [901889]
    assert numbers(run("#AX LINK [1, [S2=S, 1, 1]]", "#AX LINK ON [1]")) == []


def test_gear_steps_exclude_followers(tmp_path: Path) -> None:
    """M41 would turn the master alone to the position where it changes."""
    machine = machine_with_gears(tmp_path)
    begin = ("#AX LINK [1, S2=S]", "#AX LINK ON [1]")
    assert numbers(run(*begin, "M3 S500", "M41", controller=Controller(machine), signals=())) == [
        901884
    ]
    assert numbers(run("M3 S500", "M41", *begin, controller=Controller(machine), signals=())) == []


def test_transformations_are_for_axes(tmp_path: Path) -> None:
    """A group of spindles may be active under one, and be released there."""
    entries = {
        "sda_mds1.lis": [
            "spdl_anzahl 2",
            "spindel[1].bezeichnung S2",
            "spindel[1].log_achs_nr 31",
            "spindel[1].plc_control 1",
        ]
    }
    machine = load_machine(changed_machine(entries, tmp_path / "machine", base=DEMO5))
    link = ("#AX LINK [1, S2=S]", "#AX LINK ON [1]")
    for lines in ((*link, "#TRAFO ON", "#AX LINK OFF ALL"), ("#TRAFO ON", *link)):
        assert numbers(run(*lines, controller=Controller(machine), signals=())) == []
