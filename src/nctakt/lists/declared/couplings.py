# SPDX-License-Identifier: MIT
"""Channel and axis lists: axes that follow others, by programs or for ever."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, ValueType

#: Pairs of a group.
MAX_PAIRS = 15

_PAIR = f"synchro_data.koppel_gruppe[0..0].paar[0..{MAX_PAIRS - 1}]"
_POSITION = "0.1 µm, 1e-4°"

COUPLINGS = (
    Parameter(
        "P-CHAN-00037",
        f"{_PAIR}.log_achs_nr_master",
        ValueType.UNS16,
        0,
        Text(
            "Logical number of the master of a pair of group 0",
            "Logische Nummer des Masters eines Paars der Gruppe 0",
        ),
    ),
    Parameter(
        "P-CHAN-00038",
        f"{_PAIR}.log_achs_nr_slave",
        ValueType.UNS16,
        0,
        Text(
            "Logical number of the slave of a pair of group 0",
            "Logische Nummer des Slaves eines Paars der Gruppe 0",
        ),
    ),
    Parameter(
        "P-CHAN-00061",
        f"{_PAIR}.mode",
        ValueType.UNS16,
        0,
        Text("The pair: 0 axes of the path, 1 spindles", "Das Paar: 0 Bahnachsen, 1 Spindeln"),
        low=0,
        high=1,
    ),
    Parameter(
        "P-CHAN-00104",
        "synchro_data.restore_coupling_after_reset",
        ValueType.BOOLEAN,
        False,
        Text(
            "What a reset has released is coupled again by the next program",
            "Was ein Reset gelöst hat, koppelt das nächste Programm wieder",
        ),
    ),
    Parameter(
        "P-CHAN-00105",
        "synchro_data.preserve_coupling_after_prog_end",
        ValueType.BOOLEAN,
        False,
        Text(
            "What is coupled at the end of a program is coupled again by the next one",
            "Was am Ende eines Programms gekoppelt ist, koppelt das nächste wieder",
        ),
    ),
)

AXIS_GANTRY = (
    Parameter(
        "P-AXIS-00070",
        "kenngr.gantry_ax_nr",
        ValueType.UNS16,
        0,
        Text(
            "Logical number of the axis that this one follows for ever; 0: none",
            "Logische Nummer der Achse, der diese für immer folgt; 0: keine",
        ),
    ),
    Parameter(
        "P-AXIS-00072",
        "kenngr.gantry_max_diff_resetable",
        ValueType.UNS32,
        0,
        Text(
            "How far the actual positions of master and slave may differ; 0: any way",
            "Wie weit die Istpositionen von Master und Slave abweichen dürfen; 0: beliebig",
        ),
        unit=_POSITION,
    ),
    Parameter(
        "P-AXIS-00073",
        "kenngr.gantry_offset",
        ValueType.SGN32,
        0,
        Text(
            "Position of the slave beside that of its master",
            "Position des Slaves neben der seines Masters",
        ),
        unit=_POSITION,
    ),
)
