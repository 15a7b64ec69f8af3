# SPDX-License-Identifier: MIT
"""The classes of the controller's errors: the effect of an error, and its clearing.

In: ``Message.reaction`` and ``Message.clearing``, which the controller's diagnosis pages print as
two numbers (``2/3``). Out: their meaning. Class 0: the message has none.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from nctakt.base.diagnostics import Text

#: The effect of an error.
REACTIONS: Mapping[int, Text] = MappingProxyType(
    {
        1: Text("none, it is a warning", "keine, es ist eine Warnung"),
        2: Text(
            "the program is aborted; prepared blocks are still finished; error state",
            "das Programm wird abgebrochen; Vorbereitetes wird noch beendet; Fehlerzustand",
        ),
        3: Text(
            "the job is given up; the controller continues as usual",
            "der Auftrag wird abgebrochen; die Steuerung arbeitet normal weiter",
        ),
        4: Text(
            "the axes of the channel brake as for a feed hold; error state",
            "die Achsen des Kanals bremsen wie bei Vorschubhalt; Fehlerzustand",
        ),
        5: Text(
            "the axis at fault stops at once, the others brake as for a feed hold",
            "die fehlerhafte Achse hält sofort an, die anderen bremsen wie bei Vorschubhalt",
        ),
        6: Text("all axes stop; error state", "alle Achsen halten an; Fehlerzustand"),
    }
)

#: How to clear it.
CLEARINGS: Mapping[int, Text] = MappingProxyType(
    {
        1: Text("nothing: there is nothing to clear", "nicht nötig"),
        3: Text("a reset of the channel", "ein Reset des Kanals"),
        6: Text("a reset of the channel", "ein Reset des Kanals"),
        7: Text("a restart of the controller", "ein Neustart der Steuerung"),
        8: Text("a restart of controller and computer", "ein Neustart von Steuerung und Rechner"),
    }
)
