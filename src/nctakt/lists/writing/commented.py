# SPDX-License-Identifier: MIT
"""The lists of the demo machine with comments, as a start for a user's own machine.

In: a language. Out: names of files and their texts. The first entry of each parameter in a list has
its meaning as a comment, from its declaration; headings are translated here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from nctakt.base.diagnostics import Language
from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import DEMO_FOLDER, ListSearch
from nctakt.lists.machine.machine import load_machine
from nctakt.lists.writing.conversion import Conversion, convert_lists
from nctakt.lists.writing.list_items import Comment, Item
from nctakt.lists.writing.list_writer import ListFormat

_GERMAN: Mapping[str, str] = MappingProxyType(
    {
        "Actual position = command position": "Istposition = Sollposition",
        "Axes": "Achsen",
        "Axes X Y Z A, spindles S and S2": "Achsen X Y Z A, Spindeln S und S2",
        "Channel": "Kanal",
        "Channel of the demo machine": "Kanal der Demo-Maschine",
        "Channel variables": "Kanalvariablen",
        "Clamp offsets of the demo machine: axes 0 X, 1 Y, 2 Z, 3 A": (
            "Platzverschiebungen der Demo-Maschine: Achsen 0 X, 1 Y, 2 Z, 3 A"
        ),
        "Controller": "Steuerung",
        "G54": "G54",
        "G55": "G55",
        "G159 = 7: Y stays as it is": "G159 = 7: Y bleibt, wie es ist",
        "H functions, one of each synchronisation type from H111 on": (
            "H-Funktionen, ab H111 eine jeder Synchronisationsart"
        ),
        "Jerk-limited slope": "Ruckbegrenzter Slope",
        "Linear axis X": "Linearachse X",
        "Linear axis Y": "Linearachse Y",
        "Linear axis Z": "Linearachse Z",
        "M functions of usual machines: tool change, coolant, clamping, gear steps": (
            "M-Funktionen üblicher Maschinen: Werkzeugwechsel, Kühlmittel, Klemmen, Getriebestufen"
        ),
        "H functions of usual machines": "H-Funktionen üblicher Maschinen",
        "M functions, one of each synchronisation type from M111 on": (
            "M-Funktionen, ab M111 eine jeder Synchronisationsart"
        ),
        "Program start: G00 G17 G71 G90 G162, 1000 mm/min, exact stop after each G00": (
            "Programmstart: G00 G17 G71 G90 G162, 1000 mm/min, Genauhalt hinter jedem G00"
        ),
        "Realtime configuration of the demo machine: a tick of 1 ms": (
            "Echtzeit-Konfiguration der Demo-Maschine: ein Takt von 1 ms"
        ),
        "Realtime cycles and V.CH variables": "Echtzeit-Zyklen und V.CH-Variablen",
        "Rotary axis A, modulo 360°": "Rundachse A, modulo 360°",
        "Spindle S2: 6000 revolutions a minute, reached in a second": (
            "Spindel S2: 6000 Umdrehungen je Minute, in einer Sekunde erreicht"
        ),
        "Spindle S: 6000 revolutions a minute, reached in a second": (
            "Spindel S: 6000 Umdrehungen je Minute, in einer Sekunde erreicht"
        ),
        "Spindles: S the main spindle, S2, and S3 that the PLC turns": (
            "Spindeln: S die Hauptspindel, S2, und S3, die die SPS dreht"
        ),
        "Start-up list of the demo machine": "Hochlaufliste der Demo-Maschine",
        "Structures": "Strukturen",
        "Tool 1: end mill, 10 mm in diameter": "Werkzeug 1: Schaftfräser, 10 mm Durchmesser",
        "Tool 2: end mill, 6 mm in diameter": "Werkzeug 2: Schaftfräser, 6 mm Durchmesser",
        "Tool 3: drill, beside the middle of the spindle by 1 mm in X": (
            "Werkzeug 3: Bohrer, um 1 mm in X neben der Spindelmitte"
        ),
        "Tools of the demo machine": "Werkzeuge der Demo-Maschine",
        "Trapezoid slope": "Linearer Slope",
        "Variables of the demo machine: those of the manuals' examples, and some of each type": (
            "Variablen der Demo-Maschine: die der Handbuch-Beispiele und einige jeden Typs"
        ),
        "What all channels of the demo machine have in common: M and H functions": (
            "Was alle Kanäle der Demo-Maschine gemeinsam haben: M- und H-Funktionen"
        ),
        "What the axes of the demo machine have in common": (
            "Was die Achsen der Demo-Maschine gemeinsam haben"
        ),
        "Zero offsets of the demo machine: axes 0 X, 1 Y, 2 Z, 3 A": (
            "Nullpunktverschiebungen der Demo-Maschine: Achsen 0 X, 1 Y, 2 Z, 3 A"
        ),
    }
)


def commented_lists(language: Language, list_format: ListFormat = "ascii") -> dict[str, bytes]:
    """Return the demo machine's lists by file name, each parameter explained at its first entry.

    In German the headings are translated as well.
    """

    def edit(item: Comment | Item) -> Comment | Item:
        if isinstance(item, Comment):
            return replace(item, text=_heading(item.text, language))
        return replace(item, comment="")

    access = FileAccess()
    machine = load_machine(access=access)
    search = ListSearch(DEMO_FOLDER / "hochlauf.lis", access)
    lists = convert_lists(machine, search, access, Conversion(list_format, language, edit))
    return dict(lists.files)


def _heading(text: str, language: Language) -> str:
    return _GERMAN[text] if language == "de" and text else text
