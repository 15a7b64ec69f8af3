# SPDX-License-Identifier: MIT
"""A machine whose spindle has gear steps."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from nctakt.lists.machine.machine import Machine, load_machine
from support.run_folders import changed_machine

SPINDLE = (
    "getriebe[0].dynamik.vb_max 6000000",
    "getriebe[0].vb_eilgang 600000",
    "getriebe[0].getr_schalt_pos 900000",
    "getriebe[1].nummer 2",
    "getriebe[1].dynamik.vb_max 24000000",
    "getriebe[1].dynamik.a_max 1000",
    "getriebe[1].lslope_profil.a_stufe_1 1000",
    "getriebe[1].lslope_profil.a_stufe_2 1000",
    "getriebe[1].lslope_profil.a_grenz_stufe_1 1000",
    "getriebe[1].lslope_profil.a_grenz_stufe_2 1000",
    "getriebe[1].vb_eilgang 600000",
    "getriebe[1].getr_schalt_pos 450000",
)


CHANNEL = (
    "main_spindle_gear_change 1",
    *(f"m_synch[{number}] MVS_SVS" for number in (40, 41, 42)),
    "m_synch[43] MOS",
    "spindel[0].range_table[0].min_speed 50",
    "spindel[0].range_table[0].max_speed 1000",
    "spindel[0].range_table[1].min_speed 500",
    "spindel[0].range_table[1].max_speed 4000",
)


def machine(folder: Path, *entries: str) -> Machine:
    """The demo machine with two gear steps of S, and these entries of its channel list."""
    changes: dict[str, Sequence[str]] = {
        "achs_mds5.lis": SPINDLE,
        "sda_mds1.lis": [*CHANNEL, *entries],
    }
    return load_machine(changed_machine(changes, folder / "machine"))
