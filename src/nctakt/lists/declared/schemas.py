# SPDX-License-Identifier: MIT
"""The kinds of lists: each with its dialect and the table of its parameters.

A parameter is one line of its table; ``lists/format/table.py`` explains the columns. Units are
those of the lists: positions 0.1 µm or 1e-4°, speeds µm/s or 1e-3°/s, accelerations mm/s² or °/s²,
ramp times µs; lengths of linear and angles of rotary axes share their parameters. ``trafo[j]`` and
``kin_step[0].trafo[j]`` are the same.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.declared.technology_functions import FLAGS
from nctakt.lists.format.reader import ListDialect
from nctakt.lists.format.schema import ForeignName, Schema
from nctakt.lists.format.table import ParameterTable
from nctakt.messages.machines.lists import INVALID_SYNCHRONISATION_TYPE
from nctakt.messages.machines.variables import INVALID_SCOPE

#: Entries whose value is a synchronisation type.
_SYNCHRONISED = (
    *(f"spindel[].{function}_synch" for function in ("s", "m3", "m4", "m5", "m19")),
    "m_synch[]",
    "h_synch[]",
    "tool.synch",
)


def _schema(kind: str, en: str, de: str) -> Schema:
    return Schema(kind, Text(en, de), ListDialect(), ParameterTable(f"{kind}.tsv"))


STARTUP = _schema("startup", "Start-up list", "Hochlaufliste")
CHANNEL = Schema(
    "channel",
    Text("Channel list", "Kanalliste"),
    ListDialect(),
    ParameterTable(
        "channel.tsv",
        {"synchronisation": FLAGS},
        {entry: INVALID_SYNCHRONISATION_TYPE for entry in _SYNCHRONISED},
    ),
)
AXIS = _schema("axis", "Axis list", "Achsliste")
VARIABLES = Schema(
    "variables",
    Text("Variables list", "Variablenliste"),
    ListDialect(),
    ParameterTable("variables.tsv", defects={"var[].scope": INVALID_SCOPE}),
)
TOOLS = _schema("tools", "Tool list", "Werkzeugliste")
ZERO_OFFSETS = _schema("zero_offsets", "List of zero offsets", "Liste der Nullpunktverschiebungen")
CLAMP_OFFSETS = _schema("clamp_offsets", "List of clamp offsets", "Liste der Platzverschiebungen")
RTCONF = Schema(
    "rtconf",
    Text("Realtime configuration", "Echtzeitkonfiguration"),
    ListDialect(
        hexadecimal=False,
        references=False,
        boolean_words=False,
        expects_end=True,
        comment_notes=True,
    ),
    ParameterTable("rtconf.tsv"),
    foreign=(
        ForeignName("schedule.context.geo", "channel", "P-CHAN-00410"),
        ForeignName("schedule.context.sda", "channel", "P-CHAN-00411"),
        ForeignName("schedule.context.com", "channel", "P-CHAN-00409"),
    ),
)
AXIS_COMPENSATION = _schema(
    "axis_compensation", "List of axis compensations", "Liste der Achskompensationen"
)
VOLUMETRIC_COMPENSATION = _schema(
    "volumetric_compensation",
    "List of a volumetric compensation",
    "Liste einer volumetrischen Kompensation",
)
MANUAL_MODE = _schema("manual_mode", "Manual mode list", "Handbetriebsliste")
SCENE = _schema("scene", "List of a scene with its collisions", "Liste einer Szene mit Kollisionen")
HARDWARE = _schema("hardware", "Hardware list", "Hardwareliste")
LIST_DESCRIPTION = _schema(
    "list_description", "Description of a technology list", "Beschreibung einer Technologieliste"
)
