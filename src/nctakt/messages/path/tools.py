# SPDX-License-Identifier: MIT
"""Messages about tools in programs and tool radius compensation."""

from __future__ import annotations

from nctakt.messages.cases import by_beginning, by_word
from nctakt.messages.catalogue import error, warning

UNKNOWN_TOOL = error(
    20172,
    classes=(0, 0),
    known_as=(900865,),
    en="the tool list has no tool {tool}",
    de="die Werkzeugliste hat kein Werkzeug {tool}",
    remedy_en="Add wz[{tool}] to the tool list of the channel, or select another tool.",
    remedy_de="wz[{tool}] in die Werkzeugliste des Kanals aufnehmen oder ein anderes Werkzeug "
    "anwählen.",
)
UNKNOWN_TO_TOOL_MANAGEMENT = error(
    20296,
    en="the tool management has no valid data of tool {tool}",
    de="die Werkzeugverwaltung hat keine gültigen Daten von Werkzeug {tool}",
    remedy_en="Let the PLC answer for it (Plc.tool_data, HLI.TOOL_MANAGER), or add wz[{tool}] to "
    "the list.",
    remedy_de="Die SPS antworten lassen (Plc.tool_data, HLI.TOOL_MANAGER) oder wz[{tool}] in die "
    "Liste aufnehmen.",
    cause_en="With ext_wzv_vorhanden (P-CHAN-00016) D asks the tool manager of the PLC for the "
    "data of a tool; without one the tool list of the channel is used.",
    cause_de="Mit ext_wzv_vorhanden (P-CHAN-00016) fragt D die Werkzeugverwaltung der SPS nach "
    "den Daten eines Werkzeugs; ohne eine solche gilt die Werkzeugliste des Kanals.",
)
TOOL_MANAGER_SILENT = error(
    902800,
    en="{command}: the PLC has not answered for tool {tool} within {seconds} s",
    de="{command}: die SPS hat für Werkzeug {tool} nicht binnen {seconds} s geantwortet",
    remedy_en="Let it answer each HLI.TOOL_REQUEST with its number in HLI.TOOL_ANSWER, or clear "
    "HLI.TOOL_MANAGER.",
    remedy_de="Jede HLI.TOOL_REQUEST mit deren Nummer in HLI.TOOL_ANSWER beantworten "
    "oder HLI.TOOL_MANAGER löschen.",
    cause_en="The PLC has set HLI.TOOL_MANAGER: it has the tools of this channel (P-CHAN-00016).",
    cause_de="Die SPS hat HLI.TOOL_MANAGER gesetzt: sie hat die Werkzeuge dieses Kanals "
    "(P-CHAN-00016).",
    command=("D, T or the command", "D, T oder der Befehl"),
    seconds=("how long the answer was waited for", "wie lange auf die Antwort gewartet wurde"),
    classes=(2, 6),
)
TOOL_NOT_ASKED_FOR = error(
    902801,
    en="the PLC has the data of tool {tool}, and this program has not asked for them yet",
    de="die SPS hat die Daten von Werkzeug {tool}, und dieses Programm hat sie noch nicht "
    "angefordert",
    remedy_en="Read V.G.WZ[{tool}] after a D{tool}, or V.G.WZ_AKT while the tool is active.",
    remedy_de="V.G.WZ[{tool}] nach einem D{tool} lesen oder V.G.WZ_AKT bei aktivem Werkzeug.",
    cause_en="Here only D and #TOOL DATA ask the tool manager of the PLC (HLI.TOOL_MANAGER).",
    cause_de="Hier fragen nur D und #TOOL DATA die Werkzeugverwaltung der SPS (HLI.TOOL_MANAGER).",
    classes=(2, 3),
)
TOOL_NOT_VALID = error(
    20691,
    classes=(0, 0),
    known_as=(900866,),
    en="tool {tool} is not valid",
    de="Werkzeug {tool} ist nicht gültig",
    remedy_en="Set wz[{tool}].gueltig (P-TOOL-00005) to 1, or select another tool.",
    remedy_de="wz[{tool}].gueltig (P-TOOL-00005) auf 1 setzen oder ein anderes Werkzeug anwählen.",
)
TOOL_TOO_SHORT = error(
    21426,
    en="the length of tool {tool} is {length} mm, less than the minimum of {minimum} mm",
    de="die Länge von Werkzeug {tool} ist {length} mm, weniger als die Mindestlänge {minimum} mm",
    remedy_en="Correct wz[{tool}].laenge (P-TOOL-00003) or tool.minimum_length (P-CHAN-00156).",
    remedy_de="wz[{tool}].laenge (P-TOOL-00003) oder tool.minimum_length (P-CHAN-00156) "
    "korrigieren.",
    length=("the length of the tool in mm", "die Länge des Werkzeugs in mm"),
    minimum=("the minimum length in mm", "die Mindestlänge in mm"),
)
TOOL_TOO_THIN = error(
    21427,
    en="the radius of tool {tool} is {radius} mm, less than the minimum of {minimum} mm",
    de="der Radius von Werkzeug {tool} ist {radius} mm, weniger als der Mindestradius {minimum} mm",
    remedy_en="Correct wz[{tool}].radius (P-TOOL-00004) or tool.minimum_radius (P-CHAN-00157).",
    remedy_de="wz[{tool}].radius (P-TOOL-00004) oder tool.minimum_radius (P-CHAN-00157) "
    "korrigieren.",
    radius=("the radius of the tool in mm", "der Radius des Werkzeugs in mm"),
    minimum=("the minimum radius in mm", "der Mindestradius in mm"),
)
FLUSH_WITHOUT_TOOL_MANAGEMENT = warning(
    21244,
    en="t_with_implicit_flush has no effect without t_info_to_wzv",
    de="t_with_implicit_flush wirkt nicht ohne t_info_to_wzv",
    remedy_en="Set t_info_to_wzv (P-CHAN-00087) to 1, or remove the entry.",
    remedy_de="t_info_to_wzv (P-CHAN-00087) auf 1 setzen oder den Eintrag entfernen.",
)
TOOL_NOT_IN_LIST = error(
    20167,
    known_as=(900928,),
    en="T{tool}: the tool list has no such tool",
    de="T{tool}: die Werkzeugliste hat kein solches Werkzeug",
    remedy_en="Add wz[{tool}] to the tool list of the channel. A channel without one accepts any "
    "T.",
    remedy_de="wz[{tool}] in die Werkzeugliste des Kanals aufnehmen. Ein Kanal ohne Liste nimmt "
    "jedes T an.",
)
INVALID_TOOL_NUMBER = error(
    20171,
    classes=(0, 0),
    known_as=(900867, 21242),
    cases=by_word("word", {"T": 20166}),
    en="{value} is not a tool number",
    de="{value} ist keine Werkzeugnummer",
    remedy_en="Write a whole number of at least 0 after {word}.",
    remedy_de="Nach {word} eine ganze Zahl ab 0 schreiben.",
    word=("the word: T or D", "das Wort: T oder D"),
)
INVALID_TOOL_VALUE = error(
    22024,
    en="{value} is not a valid value of the tool here",
    de="{value} ist hier kein gültiger Wert des Werkzeugs",
    remedy_en="Assign a whole number of at least 0.",
    remedy_de="Eine ganze Zahl ab 0 zuweisen.",
)
INVALID_TOOL_LIFE_FACTOR = error(
    901720,
    en="{variable} cannot be {value}: the factor is at least 0",
    de="{variable} kann nicht {value} sein: der Faktor ist mindestens 0",
    remedy_en="Assign 0 or more; 1 counts time and distance as they are.",
    remedy_de="0 oder mehr zuweisen; 1 zählt Zeit und Weg, wie sie sind.",
    classes=(2, 3),
)
TOOL_LENGTH_WITHOUT_AXIS = error(
    900868,
    en="the channel has no axis across plane G{plane} for the tool length of {length} mm",
    de="der Kanal hat keine Achse quer zur Ebene G{plane} für die Werkzeuglänge {length} mm",
    remedy_en="Choose a plane whose third axis is in the channel, or a tool without length.",
    remedy_de="Eine Ebene wählen, deren dritte Achse der Kanal hat, oder ein Werkzeug ohne Länge.",
    length=("the length of the tool in mm", "die Länge des Werkzeugs in mm"),
    plane=("the number of the plane", "die Nummer der Ebene"),
)
NO_RADIUS_TO_COMPENSATE = error(
    900869,
    en="{word}: no tool radius to compensate",
    de="{word}: kein Werkzeugradius zu korrigieren",
    remedy_en="Before {word}, select a tool with a radius by D, or write V.G.WZ_AKT.R.",
    remedy_de="Vor {word} mit D ein Werkzeug mit Radius anwählen oder V.G.WZ_AKT.R beschreiben.",
    word=("G41 or G42", "G41 oder G42"),
)
COMPENSATION_NEEDS_LINE = error(
    90008,
    classes=(0, 0),
    known_as=(900870,),
    cases=by_beginning("change", {"G40": 90013, "G41/G42": 90016}),
    en="{change}: the motion to or from a compensated contour must be a straight line",
    de="{change}: die Bewegung zu einer korrigierten Kontur hin oder von ihr weg muss eine Gerade "
    "sein",
    remedy_en="Put a motion with G00 or G01 between the arc and the contour.",
    remedy_de="Zwischen Kreisbogen und Kontur eine Bewegung mit G00 oder G01 setzen.",
    cause_en="The first motion in the plane after G41 or G42 leads to the contour, the first one "
    "after G40 away from it; the one that changes from G41 to G42 does both.",
    cause_de="Die erste Bewegung in der Ebene nach G41 oder G42 führt an die Kontur, die erste "
    "nach G40 von ihr weg; die mit dem Wechsel von G41 auf G42 tut beides.",
    change=(
        "G41 or G42; G40; G41/G42 for a change of side",
        "G41 oder G42; G40; G41/G42 beim Wechsel der Seite",
    ),
)
TOOL_TOO_LARGE_FOR_ARC = error(
    90017,
    classes=(0, 0),
    known_as=(900871, 90147, 90190),
    en="the tool does not fit into the arc: its radius {radius} mm is not smaller than that of the "
    "arc",
    de="das Werkzeug passt nicht in den Kreisbogen: sein Radius {radius} mm ist nicht kleiner als "
    "der des Bogens",
    remedy_en="Use a smaller tool, or a larger radius in the contour.",
    remedy_de="Ein kleineres Werkzeug oder einen größeren Radius in der Kontur verwenden.",
)
TOO_MANY_COMMANDS_IN_CONTOUR = error(
    90109,
    classes=(0, 0),
    known_as=(900872, 90011),
    en="more than {count} commands between two motions of a compensated contour",
    de="mehr als {count} Befehle zwischen zwei Bewegungen einer korrigierten Kontur",
    remedy_en="Program a motion in the plane between them, or first leave the contour with G40.",
    remedy_de="Dazwischen eine Bewegung in der Ebene programmieren oder die Kontur vorher mit G40 "
    "verlassen.",
    cause_en="The end of a motion of the contour is known only from the next motion, and "
    "whatever is between them waits for it.",
    cause_de="Das Ende einer Bewegung der Kontur ergibt sich erst aus der nächsten, und was "
    "dazwischen steht, wartet darauf.",
    count=("the maximum number of commands", "die größte Anzahl von Befehlen"),
)
PLANE_CHANGE_DURING_COMPENSATION = error(
    20133,
    classes=(0, 0),
    known_as=(900873,),
    en="{word} changes the plane while a contour is compensated in G{plane}",
    de="{word} wechselt die Ebene, während eine Kontur in G{plane} korrigiert wird",
    remedy_en="First leave the contour with G40 and a motion.",
    remedy_de="Vorher die Kontur mit G40 und einer Bewegung verlassen.",
    plane=("the number of the plane", "die Nummer der Ebene"),
)
TOOL_RADIUS_LOST = error(
    900874,
    en="{command} removes the tool radius while {word} is active",
    de="{command} entfernt den Werkzeugradius, während {word} aktiv ist",
    remedy_en="Write it before {word} or after G40, or select a tool with a radius.",
    remedy_de="Vor {word} oder nach G40 schreiben, oder ein Werkzeug mit Radius anwählen.",
    word=("G41 or G42", "G41 oder G42"),
)
LINE_REVERSED_BY_RADIUS = error(
    90019,
    en="with the tool radius {radius} mm this line would be traversed backwards",
    de="mit dem Werkzeugradius {radius} mm würde diese Gerade rückwärts durchfahren",
    remedy_en="Use a smaller tool, or a contour without places narrower than the tool.",
    remedy_de="Ein kleineres Werkzeug verwenden oder eine Kontur ohne Stellen, die enger sind als "
    "das Werkzeug.",
    cause_en="There is no room for the tool between the two corners of the line, so it would cut "
    "into the contour.",
    cause_de="Zwischen den beiden Ecken der Geraden ist kein Platz für das Werkzeug: es würde die "
    "Kontur verletzen.",
    classes=(2, 6),
)
ARC_REVERSED_BY_RADIUS = error(
    90038,
    en="with the tool radius {radius} mm this arc would be traversed backwards",
    de="mit dem Werkzeugradius {radius} mm würde dieser Kreisbogen rückwärts durchfahren",
    remedy_en="Use a smaller tool, or a contour without places narrower than the tool.",
    remedy_de="Ein kleineres Werkzeug verwenden oder eine Kontur ohne Stellen, die enger sind als "
    "das Werkzeug.",
    cause_en="There is no room for the tool between the two corners of the arc, so it would cut "
    "into the contour.",
    cause_de="Zwischen den beiden Ecken des Bogens ist kein Platz für das Werkzeug: es würde die "
    "Kontur verletzen.",
    classes=(2, 6),
)
TOOL_CUTS_CONTOUR = warning(
    900950,
    known_as=(90065, 90077),
    en="the tool cuts into the contour: its path crosses the path beside line {line}",
    de="das Werkzeug verletzt die Kontur: seine Bahn kreuzt die neben Zeile {line}",
    remedy_en="Use a smaller tool, or skip with G141 the parts into which it does not fit.",
    remedy_de="Ein kleineres Werkzeug verwenden oder mit G141 ausblenden, wohin es nicht passt.",
    cause_en="Each motion fits on its own, but the path beside it crosses the path beside an "
    "earlier one: the gap between them is narrower than the tool, or a closed contour begins in "
    "an inner corner.",
    cause_de="Jede Bewegung passt für sich, aber die Bahn neben ihr kreuzt die Bahn neben einer "
    "früheren: die Stelle zwischen beiden ist enger als das Werkzeug, oder eine geschlossene "
    "Kontur beginnt in einer Innenecke.",
    line=("the line of the earlier motion", "die Zeile der früheren Bewegung"),
)
TOOL_WOULD_CUT_CONTOUR = error(
    900951,
    known_as=(90066, 90074, 90088),
    en="the tool would cut into the contour: its path crosses the path beside line {line}",
    de="das Werkzeug würde die Kontur verletzen: seine Bahn kreuzt die neben Zeile {line}",
    remedy_en="Use a smaller tool, or skip with G141 the parts into which it does not fit.",
    remedy_de="Ein kleineres Werkzeug verwenden oder mit G141 ausblenden, wohin es nicht passt.",
    cause_en="Each motion fits on its own, but the path beside it crosses the path beside an "
    "earlier one: the gap between them is narrower than the tool, or a closed contour begins in "
    "an inner corner. It is an error because P-CHAN-00219 is set.",
    cause_de="Jede Bewegung passt für sich, aber die Bahn neben ihr kreuzt die Bahn neben einer "
    "früheren: die Stelle zwischen beiden ist enger als das Werkzeug, oder eine geschlossene "
    "Kontur beginnt in einer Innenecke. Es ist ein Fehler, weil P-CHAN-00219 gesetzt ist.",
    line=("the line of the earlier motion", "die Zeile der früheren Bewegung"),
)
RADIUS_CHANGE_IN_ARC = error(
    900952,
    en="the tool radius changes on an arc",
    de="der Werkzeugradius ändert sich auf einem Kreisbogen",
    remedy_en="Change it before a motion with G00 or G01.",
    remedy_de="Ihn vor einer Bewegung mit G00 oder G01 ändern.",
    cause_en="The motion after the change leads from the old distance to the new one, which only a "
    "straight line can do.",
    cause_de="Die Bewegung nach der Änderung führt vom alten Abstand zum neuen; das kann nur eine "
    "Gerade.",
)
TOOL_CUTS_INNER_CORNER = warning(
    90123,
    known_as=(900953, 90137),
    en="the closed contour begins in an inner corner: beside line {line} the tool cuts into it "
    "here",
    de="die geschlossene Kontur beginnt in einer Innenecke: neben Zeile {line} wird sie hier "
    "verletzt",
    remedy_en="Begin and end the contour in the middle of a line or at an outer corner, or use "
    "G238.",
    remedy_de="Die Kontur mitten in einer Geraden oder an einer Außenecke beginnen und beenden, "
    "oder G238 verwenden.",
    cause_en="The tool moves to a point beside the start of the first line. If the contour begins "
    "in an inner corner, the last line is closer to this point than the radius; where the two "
    "paths meet is not known until the contour is complete.",
    cause_de="Das Werkzeug fährt neben den Anfang der ersten Geraden. Beginnt die Kontur in einer "
    "Innenecke, ist die letzte Gerade näher an dieser Stelle als der Radius; wo sich beide Bahnen "
    "treffen, ist erst bekannt, wenn die Kontur vollständig ist.",
    line=("the first line of the contour", "die erste Zeile der Kontur"),
)
TOOL_WOULD_CUT_INNER_CORNER = error(
    90123,
    classes=(0, 0),
    known_as=(900954, 90137),
    en="the closed contour begins in an inner corner: beside line {line} the tool would cut into "
    "it here",
    de="die geschlossene Kontur beginnt in einer Innenecke: neben Zeile {line} würde sie hier "
    "verletzt",
    remedy_en="Begin and end the contour in the middle of a line or at an outer corner, or use "
    "G238.",
    remedy_de="Die Kontur mitten in einer Geraden oder an einer Außenecke beginnen und beenden, "
    "oder G238 verwenden.",
    cause_en="The tool moves to a point beside the start of the first line. If the contour begins "
    "in an inner corner, the last line is closer to this point than the radius; where the two "
    "paths meet is not known until the contour is complete. It is an error because P-CHAN-00219 "
    "is set.",
    cause_de="Das Werkzeug fährt neben den Anfang der ersten Geraden. Beginnt die Kontur in einer "
    "Innenecke, ist die letzte Gerade näher an dieser Stelle als der Radius; wo sich beide Bahnen "
    "treffen, ist erst bekannt, wenn die Kontur vollständig ist. Es ist ein Fehler, weil "
    "P-CHAN-00219 gesetzt ist.",
    line=("the first line of the contour", "die erste Zeile der Kontur"),
)
CONTOUR_NOT_CLOSED = error(
    90119,
    classes=(0, 0),
    known_as=(900955,),
    en="the contour does not end where it begins, as G238 requires",
    de="die Kontur endet nicht dort, wo sie beginnt, wie es G238 verlangt",
    remedy_en="Let the last motion before G40 end where the first one after G41 or G42 ends.",
    remedy_de="Die letzte Bewegung vor G40 dort enden lassen, wo die erste nach G41 oder G42 "
    "endet.",
    cause_en="With G238 the tool begins and ends the contour where the paths beside its first and "
    "last motions meet.",
    cause_de="Mit G238 beginnt und beendet das Werkzeug die Kontur dort, wo sich die Bahnen neben "
    "ihrer ersten und letzten Bewegung treffen.",
)
CLOSED_CONTOUR_TOO_LONG = error(
    90114,
    classes=(0, 0),
    known_as=(900956,),
    en="the contour has more than {count} motions; with G238 all of them wait for the last one",
    de="die Kontur hat mehr als {count} Bewegungen; mit G238 warten alle auf die letzte",
    remedy_en="Begin it in the middle of a line or at an outer corner, with G138 or G139.",
    remedy_de="Sie mitten in einer Geraden oder an einer Außenecke beginnen, mit G138 oder G139.",
    count=("the maximum number of motions", "die größte Anzahl von Bewegungen"),
)
G238_DURING_COMPENSATION = error(
    21318,
    classes=(0, 0),
    known_as=(900957,),
    cases=by_word("word", {"G238": 21317}),
    en="{word} while compensation is active: G238 can be selected and deselected only without it",
    de="{word} bei aktiver Korrektur: G238 lässt sich nur ohne sie an- und abwählen",
    remedy_en="Write it before G41 or G42, or after G40 and the motion that leaves the contour.",
    remedy_de="Vor G41 oder G42 schreiben, oder nach G40 und der Bewegung, die die Kontur "
    "verlässt.",
)
TANGENTIAL_WITH_G238 = warning(
    21316,
    en="G05 has no effect with G238",
    de="G05 wirkt mit G238 nicht",
    remedy_en="Remove G05, or begin the contour with G138 or G139.",
    remedy_de="G05 entfernen oder die Kontur mit G138 oder G139 anfahren.",
)
TANGENTIAL_ALONE = error(
    901874,
    en="G05 needs G40, G41 or G42 in its block",
    de="G05 braucht G40, G41 oder G42 in seinem Satz",
    remedy_en="Write G05 in the block with the function that begins or ends the compensation.",
    remedy_de="G05 neben die Funktion schreiben, die die Korrektur beginnt oder beendet.",
)
SIDE_CHANGE_WITH_G238 = error(
    90115,
    classes=(0, 0),
    known_as=(900958,),
    en="with G238 the tool must stay on its side of the contour until G40",
    de="mit G238 muss das Werkzeug bis G40 auf seiner Seite der Kontur bleiben",
    remedy_en="Change between G41 and G42 only after G40.",
    remedy_de="Erst nach G40 zwischen G41 und G42 wechseln.",
)
RADIUS_CHANGE_WITH_G238 = error(
    90127,
    classes=(0, 0),
    en="with G238 the tool must keep its radius until G40",
    de="mit G238 muss das Werkzeug bis G40 seinen Radius behalten",
    remedy_en="Change the radius only after G40.",
    remedy_de="Den Radius erst nach G40 ändern.",
)
NEGATIVE_TOOL_LIFE = error(
    901891,
    en="{word} of #TOOL LIFE DEF is {value}, below 0",
    de="{word} von #TOOL LIFE DEF ist {value}, kleiner als 0",
    remedy_en="Give mm for DIST and seconds for TIME, 0 or more.",
    remedy_de="Für DIST mm, für TIME Sekunden angeben, ab 0.",
    classes=(2, 3),
)
LEAD_CUTS_CONTOUR = warning(
    901964,
    en="the tool cuts into the contour beside line {line} when it approaches or leaves it",
    de="das Werkzeug verletzt die Kontur neben Zeile {line}, auf dem Weg dorthin oder von dort",
    remedy_en="Approach or leave the contour where no other part of it is in the way.",
    remedy_de="Die Kontur dort anfahren oder verlassen, wo kein anderer Teil von ihr im Weg ist.",
    line=("the line of the contour", "die Zeile der Kontur"),
)
LEAD_WOULD_CUT_CONTOUR = error(
    901965,
    classes=(2, 3),
    en="the tool would cut into the contour beside line {line} when it approaches or leaves it",
    de="das Werkzeug würde die Kontur neben Zeile {line} verletzen, auf dem Weg dorthin oder von "
    "dort",
    remedy_en="Approach or leave the contour where no other part of it is in the way.",
    remedy_de="Die Kontur dort anfahren oder verlassen, wo kein anderer Teil von ihr im Weg ist.",
    line=("the line of the contour", "die Zeile der Kontur"),
)
