# SPDX-License-Identifier: MIT
"""Messages about axes that change their channel."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

AXIS_NOT_IN_CHANNEL = error(
    901800,
    en="axis {axis} does not belong to this channel here; {holder}",
    de="die Achse {axis} gehört hier nicht zu diesem Kanal; {holder}",
    remedy_en="Fetch it first, for example #CALL AX [{axis}, 4, 3]; its channel gives it: #PUT AX.",
    remedy_de="Sie vorher holen, zum Beispiel #CALL AX [{axis}, 4, 3]; ihr Kanal gibt sie mit "
    "#PUT AX ab.",
    holder=("which channel has it", "welcher Kanal sie hat"),
    classes=(2, 3),
)
UNKNOWN_AXIS_NUMBER = error(
    901801,
    en="{value} is not the logical number of an axis of this machine: {numbers}",
    de="{value} ist keine logische Nummer einer Achse dieser Maschine: {numbers}",
    remedy_en="Choose one of these; kopf.achs_nr of each axis list has its number.",
    remedy_de="Eine davon wählen; kopf.achs_nr jeder Achsliste enthält ihre Nummer.",
    numbers=("the numbers of the axes", "die Nummern der Achsen"),
    classes=(2, 3),
)
INVALID_AXIS_PLACE = error(
    901802,
    en="{value} is not the index of an axis in this channel: 0 … {highest}",
    de="{value} ist kein Index einer Achse in diesem Kanal: 0 … {highest}",
    remedy_en="Choose a whole number in this range; 0 … 2 are the main axes.",
    remedy_de="Eine ganze Zahl in diesem Bereich wählen; 0 … 2 sind die Hauptachsen.",
    highest=("the highest index", "der höchste Index"),
    classes=(2, 3),
)
AXIS_TWICE = error(
    901803,
    en="{what} would belong to two axes of the channel: number {first} and number {second}",
    de="{what} würde zu zwei Achsen des Kanals gehören: Nummer {first} und Nummer {second}",
    remedy_en="Give each axis a different name, number and index, or release one of the axes "
    "first.",
    remedy_de="Jeder Achse einen eigenen Namen, eine eigene Nummer und einen eigenen Index geben "
    "oder vorher eine abgeben.",
    what=("the name, number or index", "Name, Nummer oder Index"),
    first=("the number of the first axis", "die Nummer der ersten Achse"),
    second=("the number of the second axis", "die Nummer der zweiten Achse"),
    classes=(2, 3),
)
UNSUITABLE_AXIS_NAME = error(
    901804,
    en="{name} cannot be the name of an axis",
    de="{name} kann kein Achsname sein",
    remedy_en="Begin the name with one of the letters A B C Q U V W X Y Z.",
    remedy_de="Den Namen mit einem der Buchstaben A B C Q U V W X Y Z beginnen.",
    classes=(2, 3),
)
AXIS_OPTION_REFUSED = error(
    901805,
    en="{option} is not simulated: offsets of a fetched axis always begin at 0",
    de="{option} wird nicht simuliert: Verschiebungen einer geholten Achse beginnen immer bei 0",
    remedy_en="Leave it out; program offsets after the command, for example with G54.",
    remedy_de="Weglassen; Verschiebungen nach dem Befehl programmieren, zum Beispiel mit G54.",
    classes=(2, 3),
)
EXCHANGE_UNDER_TRANSFORMATION = error(
    901806,
    en="{command} while a coordinate system, a transformation or a rotation or scale of the "
    "contour is active",
    de="{command}, während ein Koordinatensystem, eine Transformation, Drehung oder Skalierung "
    "aktiv ist",
    remedy_en="Switch it off first: #CS OFF ALL, #TRAFO OFF, #ROTATION OFF.",
    remedy_de="Vorher abwählen: #CS OFF ALL, #TRAFO OFF, #ROTATION OFF.",
    classes=(2, 3),
)
EXCHANGE_IN_SEARCH = error(
    901809,
    en="{command} before the start block: a block search does not exchange axes",
    de="{command} vor dem Startsatz: ein Satzvorlauf tauscht keine Achsen",
    remedy_en="Begin at a block before the command, or let the search skip it.",
    remedy_de="An einem Satz vor dem Befehl beginnen oder ihn im Vorlauf überspringen.",
    classes=(2, 3),
)
AXIS_OF_SPINDLE = error(
    901807,
    en="axis number {value} drives spindle {spindle} of channel {channel} and cannot be fetched",
    de="die Achse Nummer {value} treibt die Spindel {spindle} von Kanal {channel} an und kann "
    "nicht geholt werden",
    remedy_en="Fetch only the axis of a main spindle with 0x200 in P-AXIS-00015, after S[PUTAX].",
    remedy_de="Nur die Achse einer Hauptspindel mit 0x200 in P-AXIS-00015 holen, nach S[PUTAX].",
    value=("the logical number", "die logische Nummer"),
    channel=("its channel", "ihr Kanal"),
    classes=(2, 3),
)
AXIS_NEVER_GIVEN = warning(
    901808,
    en="no program of this run gives away axis number {number}, which belongs to channel {channel}",
    de="kein Programm dieses Laufs gibt die Achse Nummer {number} ab, die zu Kanal {channel} "
    "gehört",
    remedy_en="Program {command} in channel {channel}; without it this command waits forever.",
    remedy_de="{command} in Kanal {channel} programmieren; sonst wartet der Befehl endlos.",
    number=("the logical number", "die logische Nummer"),
    command=("the command that gives the axis away", "der Befehl, der die Achse abgibt"),
    channel=("the channel that has it", "der Kanal, der sie hat"),
)
CYCLE_AXIS_NOT_IN_CHANNEL = error(
    50899,
    en="axis {axis} does not belong to the channel of this realtime cycle (any more)",
    de="die Achse {axis} gehört nicht (mehr) zum Kanal dieses Echtzeit-Zyklus",
    remedy_en="End the cycle before the axis is released, or let the channel fetch it back.",
    remedy_de="Den Zyklus beenden, bevor die Achse abgegeben wird, oder die Achse zurückholen.",
    cause_en="The axis was exchanged: a cycle keeps the axis that its name stood for when the "
    "cycle was defined.",
    cause_de="Die Achse wurde getauscht: ein Zyklus behält die Achse, für die der Name stand, als "
    "der Zyklus definiert wurde.",
    classes=(6, 6),
)
