# SPDX-License-Identifier: MIT
"""The lists of the demo machine, commented in a language, as a start for a machine of one's own.

In: a language. Out: names of files and their texts. Behind the first entry of each parameter in a
list stands what it means, from its declaration; headings are translated here.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import MappingProxyType

from nctakt.base.diagnostics import Language
from nctakt.lists.format.parameter import Parameter
from nctakt.lists.format.schema import Schema
from nctakt.lists.machine.list_kinds import kind_of

DEMO = Path(__file__).parent / "demo"

_INDEX = re.compile(r"\[[0-9]+\]")
_KEY_WIDTH, _VALUE_WIDTH = 48, 16

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
        "M functions, one of each synchronisation type from M111 on": (
            "M-Funktionen, ab M111 eine jeder Synchronisationsart"
        ),
        "Program start: G00 G17 G71 G90 G162, 1000 mm/min, exact stop behind each G00": (
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


def commented_lists(language: Language) -> dict[str, str]:
    """The demo machine's lists by file name, each parameter explained where it first stands."""
    lists: dict[str, str] = {}
    for path in sorted(DEMO.glob("*.lis")):
        schema = kind_of(path.name, path.read_bytes())
        assert schema is not None
        lines = path.read_text("utf-8").splitlines()
        lists[path.name] = "\n".join((*_commented(lines, schema, language), ""))
    return lists


def _commented(lines: list[str], schema: Schema, language: Language) -> Iterator[str]:
    explained: dict[str, None] = {}
    for line in lines:
        if line.startswith("#"):
            yield _heading(line[1:].strip(), language)
            continue
        key, _, rest = line.partition(" ")
        found = schema.find(_INDEX.sub("[]", key))
        if found is None:
            yield line
            continue
        value = re.split(r" [(#] ", rest, maxsplit=1)[0].strip()
        entry = f"{key:{_KEY_WIDTH}}{value}"
        parameter = found[0]
        if parameter.pattern in explained:
            yield entry
            continue
        explained[parameter.pattern] = None
        width = _KEY_WIDTH + _VALUE_WIDTH
        yield f"{entry:{width}} ( {_meaning(parameter, language)}"


def _heading(text: str, language: Language) -> str:
    if language == "de" and text:
        text = _GERMAN[text]
    return f"# {text}".rstrip()


def _meaning(parameter: Parameter, language: Language) -> str:
    unit = f" [{parameter.unit}]" if parameter.unit else ""
    identity = f"{parameter.id}: " if parameter.id else ""
    return f"{identity}{parameter.text.get(language)}{unit}"
