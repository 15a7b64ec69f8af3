# SPDX-License-Identifier: MIT
"""Messages about tools in programs and tool radius compensation."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

UNKNOWN_TOOL = error(
    900865,
    en="the tool list has no tool {tool}",
    de="die Werkzeugliste hat kein Werkzeug {tool}",
    remedy_en="Add wz[{tool}] to the tool list of the channel, or call another tool.",
    remedy_de="wz[{tool}] in die Werkzeugliste des Kanals aufnehmen oder ein anderes Werkzeug "
    "anwählen.",
    tool=("the number of the tool", "die Nummer des Werkzeugs"),
)
TOOL_NOT_VALID = error(
    900866,
    en="tool {tool} is not valid",
    de="Werkzeug {tool} ist nicht gültig",
    remedy_en="Set wz[{tool}].gueltig (P-TOOL-00005) to 1, or call another tool.",
    remedy_de="wz[{tool}].gueltig (P-TOOL-00005) auf 1 setzen oder ein anderes Werkzeug anwählen.",
    tool=("the number of the tool", "die Nummer des Werkzeugs"),
)
INVALID_TOOL_NUMBER = error(
    900867,
    en="{value} is no number of a tool",
    de="{value} ist keine Werkzeugnummer",
    remedy_en="Write a whole number behind {word}, 0 or more.",
    remedy_de="Hinter {word} eine ganze Zahl schreiben, 0 oder größer.",
    word=("the word: T or D", "das Wort: T oder D"),
    value=("the value as programmed", "der Wert, wie programmiert"),
)
TOOL_LENGTH_WITHOUT_AXIS = error(
    900868,
    en="the length {length} mm of the tool has no axis: the channel has none beside plane G{plane}",
    de="die Werkzeuglänge {length} mm hat keine Achse: der Kanal hat keine neben der Ebene "
    "G{plane}",
    remedy_en="Choose a plane whose third axis the channel has, or a tool without length.",
    remedy_de="Eine Ebene wählen, deren dritte Achse der Kanal hat, oder ein Werkzeug ohne Länge.",
    length=("the length of the tool in mm", "die Länge des Werkzeugs in mm"),
    plane=("the number of the plane", "die Nummer der Ebene"),
)
NO_RADIUS_TO_COMPENSATE = error(
    900869,
    en="{word} has no radius to compensate",
    de="{word} hat keinen Radius zu korrigieren",
    remedy_en="Call a tool with a radius by D, or write V.G.WZ_AKT.R, before {word}.",
    remedy_de="Vor {word} mit D ein Werkzeug mit Radius anwählen oder V.G.WZ_AKT.R beschreiben.",
    word=("G41 or G42", "G41 oder G42"),
)
COMPENSATION_NEEDS_LINE = error(
    900870,
    en="the motion to or from a compensated contour is no straight line",
    de="die Bewegung an eine korrigierte Kontur oder von ihr weg ist keine Gerade",
    remedy_en="Put a motion with G00 or G01 between the arc and the contour.",
    remedy_de="Zwischen Kreisbogen und Kontur eine Bewegung mit G00 oder G01 setzen.",
    cause_en="The first motion in the plane behind G41 or G42 leads to the contour, the first one "
    "behind G40 from it, the one with the change from G41 to G42 does both.",
    cause_de="Die erste Bewegung in der Ebene hinter G41 oder G42 führt an die Kontur, die erste "
    "hinter G40 von ihr weg, die mit dem Wechsel von G41 auf G42 beides.",
)
TOOL_TOO_LARGE_FOR_ARC = error(
    900871,
    en="the tool does not fit into the arc: its radius of {radius} mm is not smaller",
    de="das Werkzeug passt nicht in den Kreisbogen: sein Radius von {radius} mm ist nicht kleiner",
    remedy_en="Use a smaller tool, or a larger radius in the contour.",
    remedy_de="Ein kleineres Werkzeug oder einen größeren Radius in der Kontur verwenden.",
    radius=("the radius in mm", "der Radius in mm"),
)
TOO_MANY_COMMANDS_IN_CONTOUR = error(
    900872,
    en="more than {count} commands stand between two motions of a compensated contour",
    de="zwischen zwei Bewegungen einer korrigierten Kontur stehen mehr als {count} Befehle",
    remedy_en="Program a motion in the plane between them, or leave the contour with G40 before.",
    remedy_de="Dazwischen eine Bewegung in der Ebene programmieren oder die Kontur vorher mit G40 "
    "verlassen.",
    cause_en="Where a motion of the contour ends only the next one shows, and what stands between "
    "waits for that.",
    cause_de="Wo eine Bewegung der Kontur endet, zeigt erst die nächste, und was dazwischen steht, "
    "wartet darauf.",
    count=("the most commands", "die meisten Befehle"),
)
PLANE_CHANGE_DURING_COMPENSATION = error(
    900873,
    en="{word} changes the plane while a contour is compensated in G{plane}",
    de="{word} wechselt die Ebene, während eine Kontur in G{plane} korrigiert wird",
    remedy_en="Leave the contour with G40 and a motion before.",
    remedy_de="Vorher die Kontur mit G40 und einer Bewegung verlassen.",
    word=("the word as written", "das Wort, wie geschrieben"),
    plane=("the number of the plane", "die Nummer der Ebene"),
)
TOOL_RADIUS_LOST = error(
    900874,
    en="{command} leaves the tool no radius while {word} is active",
    de="{command} lässt dem Werkzeug keinen Radius, während {word} aktiv ist",
    remedy_en="Write it before {word} or behind G40, or call a tool with a radius.",
    remedy_de="Vor {word} oder hinter G40 schreiben oder ein Werkzeug mit Radius anwählen.",
    command=("the word or command", "das Wort oder der Befehl"),
    word=("G41 or G42", "G41 oder G42"),
)
LINE_REVERSED_BY_RADIUS = error(
    90019,
    en="with the tool radius of {radius} mm this line would be passed backwards",
    de="mit dem Werkzeugradius von {radius} mm würde diese Gerade rückwärts durchfahren",
    remedy_en="Use a smaller tool, or a contour without places narrower than the tool.",
    remedy_de="Ein kleineres Werkzeug verwenden oder eine Kontur ohne Stellen, die enger sind als "
    "das Werkzeug.",
    cause_en="Between its two corners there is no room for the tool, so that it would cut into the "
    "contour.",
    cause_de="Zwischen ihren beiden Ecken ist kein Platz für das Werkzeug: es würde die Kontur "
    "verletzen.",
    radius=("the radius in mm", "der Radius in mm"),
    reaction=2,
    clearing=6,
)
ARC_REVERSED_BY_RADIUS = error(
    90038,
    en="with the tool radius of {radius} mm this arc would be passed backwards",
    de="mit dem Werkzeugradius von {radius} mm würde dieser Kreisbogen rückwärts durchfahren",
    remedy_en="Use a smaller tool, or a contour without places narrower than the tool.",
    remedy_de="Ein kleineres Werkzeug verwenden oder eine Kontur ohne Stellen, die enger sind als "
    "das Werkzeug.",
    cause_en="Between its two corners there is no room for the tool, so that it would cut into the "
    "contour.",
    cause_de="Zwischen ihren beiden Ecken ist kein Platz für das Werkzeug: es würde die Kontur "
    "verletzen.",
    radius=("the radius in mm", "der Radius in mm"),
    reaction=2,
    clearing=6,
)
TOOL_CUTS_CONTOUR = warning(
    900950,
    en="the tool cuts into the contour: its way crosses the one beside line {line}",
    de="das Werkzeug verletzt die Kontur: sein Weg kreuzt den neben Zeile {line}",
    remedy_en="Use a smaller tool, or leave out with G141 what it does not fit into.",
    remedy_de="Ein kleineres Werkzeug verwenden oder mit G141 ausblenden, wohin es nicht passt.",
    cause_en="Each motion fits by itself, but the way beside it crosses the way beside an earlier "
    "one: the place between both is narrower than the tool, or a closed contour begins in an "
    "inner corner.",
    cause_de="Jede Bewegung passt für sich, aber der Weg neben ihr kreuzt den Weg neben einer "
    "früheren: die Stelle zwischen beiden ist enger als das Werkzeug, oder eine geschlossene "
    "Kontur beginnt in einer Innenecke.",
    line=("the line of the earlier motion", "die Zeile der früheren Bewegung"),
)
TOOL_WOULD_CUT_CONTOUR = error(
    900951,
    en="the tool would cut into the contour: its way crosses the one beside line {line}",
    de="das Werkzeug würde die Kontur verletzen: sein Weg kreuzt den neben Zeile {line}",
    remedy_en="Use a smaller tool, or leave out with G141 what it does not fit into.",
    remedy_de="Ein kleineres Werkzeug verwenden oder mit G141 ausblenden, wohin es nicht passt.",
    cause_en="Each motion fits by itself, but the way beside it crosses the way beside an earlier "
    "one: the place between both is narrower than the tool, or a closed contour begins in an "
    "inner corner. It is an error since P-CHAN-00219 is set.",
    cause_de="Jede Bewegung passt für sich, aber der Weg neben ihr kreuzt den Weg neben einer "
    "früheren: die Stelle zwischen beiden ist enger als das Werkzeug, oder eine geschlossene "
    "Kontur beginnt in einer Innenecke. Ein Fehler ist es, weil P-CHAN-00219 gesetzt ist.",
    line=("the line of the earlier motion", "die Zeile der früheren Bewegung"),
)
RADIUS_CHANGE_IN_ARC = error(
    900952,
    en="the radius of the tool changes in an arc",
    de="der Radius des Werkzeugs ändert sich in einem Kreisbogen",
    remedy_en="Change it in front of a motion with G00 or G01.",
    remedy_de="Ihn vor einer Bewegung mit G00 oder G01 ändern.",
    cause_en="The motion behind the change leads from the old distance to the new one, which only "
    "a straight line can.",
    cause_de="Die Bewegung hinter der Änderung führt vom alten Abstand zum neuen, was nur eine "
    "Gerade kann.",
)
TOOL_CUTS_INNER_CORNER = warning(
    900953,
    en="the closed contour begins in an inner corner: beside line {line} the tool cuts in here",
    de="die geschlossene Kontur beginnt in einer Innenecke: neben Zeile {line} wird sie hier "
    "verletzt",
    remedy_en="Begin and end the contour within a line or at an outer corner, or use G238.",
    remedy_de="Die Kontur innerhalb einer Geraden oder an einer Außenecke beginnen und beenden, "
    "oder G238 verwenden.",
    cause_en="The tool comes to beside the begin of the first line of the contour. Where it begins "
    "in an inner corner the last line is nearer to that place than the radius; where both ways "
    "meet the control does not know before the contour is over.",
    cause_de="Das Werkzeug fährt neben den Anfang der ersten Zeile der Kontur. Beginnt sie in "
    "einer Innenecke, ist die letzte Zeile näher an dieser Stelle als der Radius; wo beide Wege "
    "sich treffen, weiß die Steuerung erst, wenn die Kontur zu Ende ist.",
    line=("the line that the contour begins with", "die Zeile, mit der die Kontur beginnt"),
)
TOOL_WOULD_CUT_INNER_CORNER = error(
    900954,
    en="the closed contour begins in an inner corner: beside line {line} the tool would cut in "
    "here",
    de="die geschlossene Kontur beginnt in einer Innenecke: neben Zeile {line} würde sie hier "
    "verletzt",
    remedy_en="Begin and end the contour within a line or at an outer corner, or use G238.",
    remedy_de="Die Kontur innerhalb einer Geraden oder an einer Außenecke beginnen und beenden, "
    "oder G238 verwenden.",
    cause_en="The tool comes to beside the begin of the first line of the contour. Where it begins "
    "in an inner corner the last line is nearer to that place than the radius; where both ways "
    "meet the control does not know before the contour is over. It is an error since P-CHAN-00219 "
    "is set.",
    cause_de="Das Werkzeug fährt neben den Anfang der ersten Zeile der Kontur. Beginnt sie in "
    "einer Innenecke, ist die letzte Zeile näher an dieser Stelle als der Radius; wo beide Wege "
    "sich treffen, weiß die Steuerung erst, wenn die Kontur zu Ende ist. Ein Fehler ist es, weil "
    "P-CHAN-00219 gesetzt ist.",
    line=("the line that the contour begins with", "die Zeile, mit der die Kontur beginnt"),
)
CONTOUR_NOT_CLOSED = error(
    900955,
    en="the contour does not end where it begins, as G238 wants it",
    de="die Kontur endet nicht, wo sie beginnt, wie es G238 verlangt",
    remedy_en="Let the last motion before G40 end where the one behind G41 or G42 ends.",
    remedy_de="Die letzte Bewegung vor G40 dort enden lassen, wo die hinter G41 oder G42 endet.",
    cause_en="With G238 the tool begins and ends the contour where the ways beside its first and "
    "its last motion meet.",
    cause_de="Mit G238 beginnt und beendet das Werkzeug die Kontur dort, wo sich die Wege neben "
    "ihrer ersten und ihrer letzten Bewegung treffen.",
)
CLOSED_CONTOUR_TOO_LONG = error(
    900956,
    en="the contour has more than {count} motions, and with G238 all of them wait for the last one",
    de="die Kontur hat mehr als {count} Bewegungen, und mit G238 warten alle auf die letzte",
    remedy_en="Begin it within a line or at an outer corner, with G138 or G139.",
    remedy_de="Sie innerhalb einer Geraden oder an einer Außenecke beginnen, mit G138 oder G139.",
    count=("the most motions", "die meisten Bewegungen"),
)
G238_DURING_COMPENSATION = error(
    900957,
    en="{word} comes while compensation is active: G238 is chosen and left only without it",
    de="{word} steht bei aktiver Korrektur: G238 wird nur ohne sie gewählt und verlassen",
    remedy_en="Write it before G41 or G42, or behind G40 and the motion from the contour.",
    remedy_de="Vor G41 oder G42 schreiben, oder hinter G40 und die Bewegung von der Kontur weg.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
SIDE_OR_RADIUS_CHANGE_WITH_G238 = error(
    900958,
    en="with G238 the tool keeps its side and its radius up to G40",
    de="mit G238 behält das Werkzeug Seite und Radius bis G40",
    remedy_en="Change between G41 and G42, or the radius, behind G40.",
    remedy_de="Zwischen G41 und G42 wechseln oder den Radius ändern erst hinter G40.",
)
