# SPDX-License-Identifier: MIT
"""Messages of tools in programs, of tool radius compensation (900865 … 900879, 900950 … 900969)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900865,
    ERROR,
    "the tool list has no tool {tool}",
    "die Werkzeugliste hat kein Werkzeug {tool}",
    remedy_en="Add wz[{tool}] to the tool list of the channel, or call another tool.",
    remedy_de="wz[{tool}] in die Werkzeugliste des Kanals aufnehmen oder ein anderes Werkzeug "
    "anwählen.",
    parameters={"tool": "the number of the tool"},
)
_add(
    900866,
    ERROR,
    "tool {tool} is not valid",
    "Werkzeug {tool} ist nicht gültig",
    remedy_en="Set wz[{tool}].gueltig (P-TOOL-00005) to 1, or call another tool.",
    remedy_de="wz[{tool}].gueltig (P-TOOL-00005) auf 1 setzen oder ein anderes Werkzeug anwählen.",
    parameters={"tool": "the number of the tool"},
)
_add(
    900867,
    ERROR,
    "{value} is no number of a tool",
    "{value} ist keine Werkzeugnummer",
    remedy_en="Write a whole number behind {word}, 0 or more.",
    remedy_de="Hinter {word} eine ganze Zahl schreiben, 0 oder größer.",
    parameters={"word": "the word: T or D", "value": "the value as programmed"},
)
_add(
    900868,
    ERROR,
    "the length {length} mm of the tool has no axis: the channel has none beside plane G{plane}",
    "die Werkzeuglänge {length} mm hat keine Achse: der Kanal hat keine neben der Ebene G{plane}",
    remedy_en="Choose a plane whose third axis the channel has, or a tool without length.",
    remedy_de="Eine Ebene wählen, deren dritte Achse der Kanal hat, oder ein Werkzeug ohne Länge.",
    parameters={"length": "the length of the tool in mm", "plane": "the number of the plane"},
)
_add(
    900869,
    ERROR,
    "{word} has no radius to compensate",
    "{word} hat keinen Radius zu korrigieren",
    remedy_en="Call a tool with a radius by D, or write V.G.WZ_AKT.R, before {word}.",
    remedy_de="Vor {word} mit D ein Werkzeug mit Radius anwählen oder V.G.WZ_AKT.R beschreiben.",
    parameters={"word": "G41 or G42"},
)
_add(
    900870,
    ERROR,
    "the motion to or from a compensated contour is no straight line",
    "die Bewegung an eine korrigierte Kontur oder von ihr weg ist keine Gerade",
    remedy_en="Put a motion with G00 or G01 between the arc and the contour.",
    remedy_de="Zwischen Kreisbogen und Kontur eine Bewegung mit G00 oder G01 setzen.",
    cause_en="The first motion in the plane behind G41 or G42 leads to the contour, the first one "
    "behind G40 from it, the one with the change from G41 to G42 does both.",
    cause_de="Die erste Bewegung in der Ebene hinter G41 oder G42 führt an die Kontur, die erste "
    "hinter G40 von ihr weg, die mit dem Wechsel von G41 auf G42 beides.",
)
_add(
    900871,
    ERROR,
    "the tool does not fit into the arc: its radius of {radius} mm is not smaller",
    "das Werkzeug passt nicht in den Kreisbogen: sein Radius von {radius} mm ist nicht kleiner",
    remedy_en="Use a smaller tool, or a larger radius in the contour.",
    remedy_de="Ein kleineres Werkzeug oder einen größeren Radius in der Kontur verwenden.",
    parameters={"radius": "the radius in mm"},
)
_add(
    900872,
    ERROR,
    "more than {count} commands stand between two motions of a compensated contour",
    "zwischen zwei Bewegungen einer korrigierten Kontur stehen mehr als {count} Befehle",
    remedy_en="Program a motion in the plane between them, or leave the contour with G40 before.",
    remedy_de="Dazwischen eine Bewegung in der Ebene programmieren oder die Kontur vorher mit G40 "
    "verlassen.",
    cause_en="Where a motion of the contour ends only the next one shows, and what stands between "
    "waits for that.",
    cause_de="Wo eine Bewegung der Kontur endet, zeigt erst die nächste, und was dazwischen steht, "
    "wartet darauf.",
    parameters={"count": "the most commands"},
)
_add(
    900873,
    ERROR,
    "{word} changes the plane while a contour is compensated in G{plane}",
    "{word} wechselt die Ebene, während eine Kontur in G{plane} korrigiert wird",
    remedy_en="Leave the contour with G40 and a motion before.",
    remedy_de="Vorher die Kontur mit G40 und einer Bewegung verlassen.",
    parameters={"word": "the word as written", "plane": "the number of the plane"},
)
_add(
    900874,
    ERROR,
    "{command} leaves the tool no radius while {word} is active",
    "{command} lässt dem Werkzeug keinen Radius, während {word} aktiv ist",
    remedy_en="Write it before {word} or behind G40, or call a tool with a radius.",
    remedy_de="Vor {word} oder hinter G40 schreiben oder ein Werkzeug mit Radius anwählen.",
    parameters={"command": "the word or command", "word": "G41 or G42"},
)
_add(
    90019,
    ERROR,
    "with the tool radius of {radius} mm this line would be passed backwards",
    "mit dem Werkzeugradius von {radius} mm würde diese Gerade rückwärts durchfahren",
    remedy_en="Use a smaller tool, or a contour without places narrower than the tool.",
    remedy_de="Ein kleineres Werkzeug verwenden oder eine Kontur ohne Stellen, die enger sind als "
    "das Werkzeug.",
    cause_en="Between its two corners there is no room for the tool, so that it would cut into the "
    "contour.",
    cause_de="Zwischen ihren beiden Ecken ist kein Platz für das Werkzeug: es würde die Kontur "
    "verletzen.",
    parameters={"radius": "the radius in mm"},
    reaction=2,
    clearing=6,
)
_add(
    90038,
    ERROR,
    "with the tool radius of {radius} mm this arc would be passed backwards",
    "mit dem Werkzeugradius von {radius} mm würde dieser Kreisbogen rückwärts durchfahren",
    remedy_en="Use a smaller tool, or a contour without places narrower than the tool.",
    remedy_de="Ein kleineres Werkzeug verwenden oder eine Kontur ohne Stellen, die enger sind als "
    "das Werkzeug.",
    cause_en="Between its two corners there is no room for the tool, so that it would cut into the "
    "contour.",
    cause_de="Zwischen ihren beiden Ecken ist kein Platz für das Werkzeug: es würde die Kontur "
    "verletzen.",
    parameters={"radius": "the radius in mm"},
    reaction=2,
    clearing=6,
)
_CAUSE_EN = (
    "Each motion fits by itself, but the way beside it crosses the way beside an earlier one: the "
    "place between both is narrower than the tool, or a closed contour begins in an inner corner."
)
_CAUSE_DE = (
    "Jede Bewegung passt für sich, aber der Weg neben ihr kreuzt den Weg neben einer früheren: die "
    "Stelle zwischen beiden ist enger als das Werkzeug, oder eine geschlossene Kontur beginnt in "
    "einer Innenecke."
)
_add(
    900950,
    WARNING,
    "the tool cuts into the contour: its way crosses the one beside line {line}",
    "das Werkzeug verletzt die Kontur: sein Weg kreuzt den neben Zeile {line}",
    remedy_en="Use a smaller tool, or leave out with G141 what it does not fit into.",
    remedy_de="Ein kleineres Werkzeug verwenden oder mit G141 ausblenden, wohin es nicht passt.",
    cause_en=_CAUSE_EN,
    cause_de=_CAUSE_DE,
    parameters={"line": "the line of the earlier motion"},
)
_add(
    900951,
    ERROR,
    "the tool would cut into the contour: its way crosses the one beside line {line}",
    "das Werkzeug würde die Kontur verletzen: sein Weg kreuzt den neben Zeile {line}",
    remedy_en="Use a smaller tool, or leave out with G141 what it does not fit into.",
    remedy_de="Ein kleineres Werkzeug verwenden oder mit G141 ausblenden, wohin es nicht passt.",
    cause_en=f"{_CAUSE_EN} It is an error since P-CHAN-00219 is set.",
    cause_de=f"{_CAUSE_DE} Ein Fehler ist es, weil P-CHAN-00219 gesetzt ist.",
    parameters={"line": "the line of the earlier motion"},
)
_add(
    900952,
    ERROR,
    "the radius of the tool changes in an arc",
    "der Radius des Werkzeugs ändert sich in einem Kreisbogen",
    remedy_en="Change it in front of a motion with G00 or G01.",
    remedy_de="Ihn vor einer Bewegung mit G00 oder G01 ändern.",
    cause_en="The motion behind the change leads from the old distance to the new one, which only "
    "a straight line can.",
    cause_de="Die Bewegung hinter der Änderung führt vom alten Abstand zum neuen, was nur eine "
    "Gerade kann.",
)
_BEGIN_EN = (
    "The tool comes to beside the begin of the first line of the contour. Where it begins in an "
    "inner corner the last line is nearer to that place than the radius; where both ways meet the "
    "control does not know before the contour is over."
)
_BEGIN_DE = (
    "Das Werkzeug fährt neben den Anfang der ersten Zeile der Kontur. Beginnt sie in einer "
    "Innenecke, ist die letzte Zeile näher an dieser Stelle als der Radius; wo beide Wege sich "
    "treffen, weiß die Steuerung erst, wenn die Kontur zu Ende ist."
)
_add(
    900953,
    WARNING,
    "the closed contour begins in an inner corner: beside line {line} the tool cuts in here",
    "die geschlossene Kontur beginnt in einer Innenecke: neben Zeile {line} wird sie hier verletzt",
    remedy_en="Begin and end the contour within a line or at an outer corner, or use G238.",
    remedy_de="Die Kontur innerhalb einer Geraden oder an einer Außenecke beginnen und beenden, "
    "oder G238 verwenden.",
    cause_en=_BEGIN_EN,
    cause_de=_BEGIN_DE,
    parameters={"line": "the line that the contour begins with"},
)
_add(
    900954,
    ERROR,
    "the closed contour begins in an inner corner: beside line {line} the tool would cut in here",
    "die geschlossene Kontur beginnt in einer Innenecke: neben Zeile {line} würde sie hier "
    "verletzt",
    remedy_en="Begin and end the contour within a line or at an outer corner, or use G238.",
    remedy_de="Die Kontur innerhalb einer Geraden oder an einer Außenecke beginnen und beenden, "
    "oder G238 verwenden.",
    cause_en=f"{_BEGIN_EN} It is an error since P-CHAN-00219 is set.",
    cause_de=f"{_BEGIN_DE} Ein Fehler ist es, weil P-CHAN-00219 gesetzt ist.",
    parameters={"line": "the line that the contour begins with"},
)
_add(
    900955,
    ERROR,
    "the contour does not end where it begins, as G238 wants it",
    "die Kontur endet nicht, wo sie beginnt, wie es G238 verlangt",
    remedy_en="Let the last motion before G40 end where the one behind G41 or G42 ends.",
    remedy_de="Die letzte Bewegung vor G40 dort enden lassen, wo die hinter G41 oder G42 endet.",
    cause_en="With G238 the tool begins and ends the contour where the ways beside its first and "
    "its last motion meet.",
    cause_de="Mit G238 beginnt und beendet das Werkzeug die Kontur dort, wo sich die Wege neben "
    "ihrer ersten und ihrer letzten Bewegung treffen.",
)
_add(
    900956,
    ERROR,
    "the contour has more than {count} motions, and with G238 all of them wait for the last one",
    "die Kontur hat mehr als {count} Bewegungen, und mit G238 warten alle auf die letzte",
    remedy_en="Begin it within a line or at an outer corner, with G138 or G139.",
    remedy_de="Sie innerhalb einer Geraden oder an einer Außenecke beginnen, mit G138 oder G139.",
    parameters={"count": "the most motions"},
)
_add(
    900957,
    ERROR,
    "{word} comes while compensation is active: G238 is chosen and left only without it",
    "{word} steht bei aktiver Korrektur: G238 wird nur ohne sie gewählt und verlassen",
    remedy_en="Write it before G41 or G42, or behind G40 and the motion from the contour.",
    remedy_de="Vor G41 oder G42 schreiben, oder hinter G40 und die Bewegung von der Kontur weg.",
    parameters={"word": "the word as written"},
)
_add(
    900958,
    ERROR,
    "with G238 the tool keeps its side and its radius up to G40",
    "mit G238 behält das Werkzeug Seite und Radius bis G40",
    remedy_en="Change between G41 and G42, or the radius, behind G40.",
    remedy_de="Zwischen G41 und G42 wechseln oder den Radius ändern erst hinter G40.",
)
