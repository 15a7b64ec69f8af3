# SPDX-License-Identifier: MIT
"""Channel lists (P-CHAN): what T and D do, and which tools they accept."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, ValueType

CHANNEL_TOOLS = (
    *(
        Parameter(id_, path, ValueType.BOOLEAN, False, Text(en, de))
        for id_, path, en, de in (
            (
                "P-CHAN-00014",
                "einrechnen_mit_t",
                "T also selects the offsets D of the same number",
                "T wählt zugleich die Korrektur D gleicher Nummer an",
            ),
            (
                "P-CHAN-00087",
                "t_info_to_wzv",
                "T is told to an external tool management",
                "T wird einer externen Werkzeugverwaltung gemeldet",
            ),
            (
                "P-CHAN-00100",
                "move_tool_offsets_directly",
                "The axes move by new tool offsets in the block of D, not with their next position",
                "Die Achsen fahren neue Werkzeugversätze im Satz von D heraus, nicht erst mit "
                "ihrer nächsten Position",
            ),
            (
                "P-CHAN-00106",
                "t_with_implicit_flush",
                "The channel is emptied in front of each T, with P-CHAN-00087",
                "Vor jedem T wird der Kanal geleert, zusammen mit P-CHAN-00087",
            ),
            (
                "P-CHAN-00076",
                "tool_life_to_wzv",
                "The tool life goes to an external tool management with each change of the tool",
                "Die Standgröße geht bei jedem Werkzeugwechsel an eine externe Verwaltung",
            ),
            (
                "P-CHAN-00243",
                "tool_life_to_wzv_suppress_zero",
                "A tool life of 0 s and 0 mm is not sent",
                "Eine Standgröße von 0 s und 0 mm wird nicht gesendet",
            ),
            (
                "P-CHAN-00255",
                "tool_life_capture_all_movements",
                "Rapid motions count in the tool life, too",
                "Auch Eilgangbewegungen zählen zur Standgröße",
            ),
            (
                "P-CHAN-00482",
                "tool_life_with_d",
                "The tool life of another tool begins with D, not with T",
                "Die Standgröße eines anderen Werkzeugs beginnt mit D statt mit T",
            ),
            (
                "P-CHAN-00420",
                "remain_tool_length_in_ax",
                "The length of the tool acts along the third main axis in every plane",
                "Die Werkzeuglänge wirkt in jeder Ebene in der dritten Hauptachse",
            ),
        )
    ),
    Parameter(
        "P-CHAN-00271",
        "flush.d_cmd",
        ValueType.NAME,
        "D",
        Text(
            "FAW_D: the channel is emptied, and waited for, in front of each D",
            "FAW_D: vor jedem D wird der Kanal geleert und darauf gewartet",
        ),
        names={"D": None, "FAW_D": None},
    ),
    *(
        Parameter(id_, path, ValueType.UNS32, 0, Text(en, de), unit="0.1 µm")
        for id_, path, en, de in (
            (
                "P-CHAN-00156",
                "tool.minimum_length",
                "Least length of a tool that D selects; 0: any",
                "Kleinste Länge eines Werkzeugs, das D anwählt; 0: beliebig",
            ),
            (
                "P-CHAN-00157",
                "tool.minimum_radius",
                "Least radius of a tool that D selects; 0: any",
                "Kleinster Radius eines Werkzeugs, das D anwählt; 0: beliebig",
            ),
        )
    ),
)
