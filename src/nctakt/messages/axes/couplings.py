# SPDX-License-Identifier: MIT
"""Messages about axes and spindles that follow others: ``#AX LINK``, gantries."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

_GROUP = ("number of the coupling group", "Nummer der Kopplungsgruppe")
_SLAVE = ("the slave", "der Slave")
_MASTER = ("the master", "der Master")
_AXIS = ("the axis or spindle", "die Achse oder Spindel")
_COMMAND = ("the command", "der Befehl")

HOMING_WHILE_COUPLED = error(
    20137,
    en="G74 while the coupling group {group} is active",
    de="G74, während die Kopplungsgruppe {group} aktiv ist",
    remedy_en="Program #AX LINK OFF ALL before it, and couple the axes again afterwards.",
    remedy_de="Davor #AX LINK OFF ALL programmieren und die Achsen danach wieder koppeln.",
    group=_GROUP,
)
COUPLING_DURING_COMPENSATION = error(
    20457,
    en="{command} during tool radius compensation",
    de="{command} während der Werkzeugradiuskorrektur",
    remedy_en="Couple the axes before G41 or G42, and release them after G40.",
    remedy_de="Die Achsen vor G41 oder G42 koppeln und nach G40 lösen.",
    command=_COMMAND,
)
COUPLING_GROUP_OUT_OF_RANGE = error(
    20461,
    en="{group} is not a valid number of a coupling group",
    de="{group} ist keine gültige Nummer einer Kopplungsgruppe",
    remedy_en="Give a whole number from {low} to {high}; 0 is the group of the channel list.",
    remedy_de="Eine ganze Zahl von {low} bis {high} angeben; 0 ist die Gruppe der Kanalliste.",
    group=_GROUP,
)
MAIN_AXIS_AS_SLAVE = error(
    20467,
    en="{slave} cannot follow {master}: it is a main axis",
    de="{slave} kann {master} nicht folgen: sie ist eine Hauptachse",
    remedy_en="Slaves have the index 3 or above: exchange the two, or move the axis first (#SET "
    "AX).",
    remedy_de="Slaves haben den Index 3 oder höher: die beiden tauschen oder die Achse vorher "
    "umsetzen (#SET AX).",
    slave=_SLAVE,
    master=_MASTER,
)
COUPLED_TYPES_DIFFER = error(
    20468,
    en="{slave} cannot follow {master}: they are of different types",
    de="{slave} kann {master} nicht folgen: sie sind von verschiedenem Typ",
    remedy_en="Couple linear axes with linear axes, rotary axes with rotary axes (P-AXIS-00018), "
    "and spindles with spindles.",
    remedy_de="Linearachsen mit Linearachsen koppeln, Rundachsen mit Rundachsen (P-AXIS-00018) und "
    "Spindeln mit Spindeln.",
    slave=_SLAVE,
    master=_MASTER,
)
COUPLED_MODES_DIFFER = error(
    20469,
    en="{slave} cannot follow {master}: their modes differ (P-AXIS-00015)",
    de="{slave} kann {master} nicht folgen: ihre Betriebsarten sind verschieden (P-AXIS-00015)",
    remedy_en="Give both the same kenngr.achs_mode: make both modulo axes, for example.",
    remedy_de="Beiden dasselbe kenngr.achs_mode geben, etwa beide zu Moduloachsen machen.",
    slave=_SLAVE,
    master=_MASTER,
)
ACTIVE_GROUP_DEFINED_AGAIN = error(
    20472,
    en="the coupling group {group} cannot be defined: it is active",
    de="die Kopplungsgruppe {group} kann nicht definiert werden: sie ist aktiv",
    remedy_en="Program #DISABLE AX LINK [{group}] before it.",
    remedy_de="Davor #DISABLE AX LINK [{group}] programmieren.",
    group=_GROUP,
)
AXIS_FOLLOWS_ITSELF = error(
    20475,
    en="{slave} cannot follow itself",
    de="{slave} kann sich nicht selbst folgen",
    remedy_en="Name two different axes.",
    remedy_de="Zwei verschiedene Achsen nennen.",
    slave=_SLAVE,
)
SLAVE_TWICE_IN_GROUP = error(
    20476,
    en="{slave} has two masters in the group",
    de="{slave} hat in der Gruppe zwei Master",
    remedy_en="Let it follow one of them only.",
    remedy_de="Sie nur einem von ihnen folgen lassen.",
    slave=_SLAVE,
)
SLAVE_IS_MASTER_IN_GROUP = error(
    20477,
    en="{axis} is a slave and a master in the group",
    de="{axis} ist in der Gruppe Slave und Master",
    remedy_en="Let all slaves follow the first master; chains are not possible.",
    remedy_de="Alle Slaves dem ersten Master folgen lassen; Ketten sind nicht möglich.",
    axis=_AXIS,
)
COUPLED_AXIS_GIVEN = error(
    20545,
    en="{command}: {axis} cannot be given away, it is coupled in group {group}",
    de="{command}: {axis} kann nicht abgegeben werden, sie ist in Gruppe {group} gekoppelt",
    remedy_en="Program #DISABLE AX LINK [{group}] before it.",
    remedy_de="Davor #DISABLE AX LINK [{group}] programmieren.",
    command=_COMMAND,
    axis=_AXIS,
    group=_GROUP,
)
FACTOR_IS_ZERO = error(
    21077,
    en="the coupling factor is 0",
    de="der Koppelfaktor ist 0",
    remedy_en="Program a numerator and a denominator that are not 0; -1, 1 mirrors.",
    remedy_de="Zähler und Nenner ungleich 0 programmieren; -1, 1 spiegelt.",
)
DENOMINATOR_MISSING = error(
    21110,
    en="the coupling factor has no denominator",
    de="dem Koppelfaktor fehlt der Nenner",
    remedy_en="Program both: with [C=A, 1, 2] C moves half as far as A.",
    remedy_de="Beide programmieren: mit [C=A, 1, 2] fährt C den halben Weg von A.",
)
SLAVE_IN_TWO_GROUPS = error(
    21283,
    en="{axis} is already a slave in the active group {group}",
    de="{axis} ist schon Slave in der aktiven Gruppe {group}",
    remedy_en="Program #DISABLE AX LINK [{group}] before it.",
    remedy_de="Davor #DISABLE AX LINK [{group}] programmieren.",
    axis=_AXIS,
    group=_GROUP,
)
SLAVE_IS_MASTER_OF_GROUP = error(
    21284,
    en="{axis} cannot become a slave: it is a master in the active group {group}",
    de="{axis} kann kein Slave werden: sie ist Master in der aktiven Gruppe {group}",
    remedy_en="Program #DISABLE AX LINK [{group}] before it.",
    remedy_de="Davor #DISABLE AX LINK [{group}] programmieren.",
    axis=_AXIS,
    group=_GROUP,
)
MASTER_IS_SLAVE_OF_GROUP = error(
    21285,
    en="{axis} cannot become a master: it is a slave in the active group {group}",
    de="{axis} kann kein Master werden: sie ist Slave in der aktiven Gruppe {group}",
    remedy_en="Program #DISABLE AX LINK [{group}] before it.",
    remedy_de="Davor #DISABLE AX LINK [{group}] programmieren.",
    axis=_AXIS,
    group=_GROUP,
)
COUPLED_AXIS_MOVED_TO_INDEX = error(
    21312,
    en="{command}: {axis} cannot change its index, it is coupled in group {group}",
    de="{command}: {axis} kann ihren Index nicht ändern, sie ist in Gruppe {group} gekoppelt",
    remedy_en="Program #DISABLE AX LINK [{group}] before it.",
    remedy_de="Davor #DISABLE AX LINK [{group}] programmieren.",
    command=_COMMAND,
    axis=_AXIS,
    group=_GROUP,
)
MAIN_SPINDLE_AS_SLAVE = error(
    21347,
    en="{slave} cannot follow {master}: it is the main spindle",
    de="{slave} kann {master} nicht folgen: sie ist die Hauptspindel",
    remedy_en="Let {master} be the slave, or make it the main spindle first (#MAIN SPINDLE).",
    remedy_de="{master} zum Slave machen oder vorher zur Hauptspindel (#MAIN SPINDLE).",
    slave=_SLAVE,
    master=_MASTER,
)
COUPLED_AXIS_MOVES_ALONE = error(
    21481,
    en="axis {axis} is coupled and takes no separate command",
    de="Achse {axis} ist gekoppelt und nimmt keinen eigenen Auftrag an",
    remedy_en="Move the master with the path, or release the coupling (#DISABLE AX LINK).",
    remedy_de="Den Master mit der Bahn bewegen oder die Kopplung lösen (#DISABLE AX LINK).",
)
GANTRY_ASKEW = error(
    901879,
    en="the drives that follow axis {axis} are too far away from it",
    de="die Antriebe, die der Achse {axis} folgen, sind zu weit von ihr entfernt",
    remedy_en="Find out what holds one of them back; the limit is P-AXIS-00072 or the first value "
    "after G.",
    remedy_de="Nachsehen, was einen von ihnen aufhält; die Grenze ist P-AXIS-00072 oder der erste "
    "Wert nach G.",
    cause_en="The actual positions of master and slave differ by more than is allowed.",
    cause_de="Die Istpositionen von Master und Slave weichen mehr als erlaubt voneinander ab.",
    axis=("the master", "der Master"),
    classes=(6, 6),
)
UNKNOWN_COUPLING_GROUP = error(
    901880,
    en="{command}: the coupling group {group} is not defined",
    de="{command}: die Kopplungsgruppe {group} ist nicht definiert",
    remedy_en="Define it first with #SET AX LINK (group 0: in the channel list). Defined: {known}",
    remedy_de="Sie vorher mit #SET AX LINK definieren (Gruppe 0: in der Kanalliste). Definiert: "
    "{known}",
    command=_COMMAND,
    group=_GROUP,
    known=("the groups that are defined", "die Gruppen, die definiert sind"),
    classes=(2, 3),
)
UNKNOWN_COUPLED_AXIS = error(
    901881,
    en="{axis} is not an axis or spindle of the channel",
    de="{axis} ist keine Achse oder Spindel des Kanals",
    remedy_en="Name one of these: {known}",
    remedy_de="Eine von diesen nennen: {known}",
    axis=("the name or logical number", "der Name oder die logische Nummer"),
    known=("the axes and spindles", "die Achsen und Spindeln"),
    classes=(2, 3),
)
TOO_MANY_PAIRS = error(
    901882,
    en="a coupling group has at most {limit} pairs",
    de="eine Kopplungsgruppe hat höchstens {limit} Paare",
    remedy_en="Put the others into another group.",
    remedy_de="Die übrigen in eine eigene Gruppe legen.",
    limit=("the highest number of pairs", "die höchste Anzahl von Paaren"),
    classes=(2, 3),
)
SLAVE_PROGRAMMED = error(
    901883,
    en="{axis} cannot be programmed: it follows {master}",
    de="{axis} kann nicht programmiert werden: sie folgt {master}",
    remedy_en="Program {master}, or release the coupling before (#DISABLE AX LINK).",
    remedy_de="{master} programmieren oder vorher die Kopplung lösen (#DISABLE AX LINK).",
    axis=_SLAVE,
    master=_MASTER,
    classes=(2, 3),
)
NOT_WHILE_COUPLED = error(
    901884,
    en="{command} cannot be combined with {other}",
    de="{command} und {other} sind nicht gleichzeitig möglich",
    remedy_en="Release the coupling first, or switch off the other: transformation, G96, block "
    "search.",
    remedy_de="Vorher die Kopplung lösen oder das andere beenden: Transformation, G96, "
    "Satzvorlauf.",
    command=_COMMAND,
    other=("what excludes it", "was ihn ausschließt"),
    classes=(2, 3),
)
SLAVE_OUTSIDE_LIMITS = error(
    901885,
    en="{slave}, which follows {master}, is outside its software limits {low} … {high} at "
    "{position}",
    de="{slave}, die {master} folgt, liegt bei {position} außerhalb ihrer Software-Endschalter "
    "{low} … {high}",
    remedy_en="Move the master less far, or couple the axes at other positions.",
    remedy_de="Den Master weniger weit fahren oder die Achsen an anderen Positionen koppeln.",
    slave=_SLAVE,
    master=_MASTER,
    position=("position of the slave in mm or degrees", "Position des Slaves in mm oder Grad"),
    classes=(2, 3),
)
GROUP_NOT_RESTORED = warning(
    901888,
    en="the coupling group {group} is not active any more: {reason}",
    de="die Kopplungsgruppe {group} ist nicht mehr aktiv: {reason}",
    remedy_en="Fetch its axes or choose its main spindle, then write #AX LINK ON [{group}].",
    remedy_de="Ihre Achsen holen oder ihre Hauptspindel wählen, dann #AX LINK ON [{group}].",
    cause_en="P-CHAN-00104 and P-CHAN-00105 couple it at the start of the program, with the axes "
    "and the main spindle of the channel list.",
    cause_de="P-CHAN-00104 und P-CHAN-00105 koppeln sie am Programmanfang, mit den Achsen und der "
    "Hauptspindel der Kanalliste.",
    group=_GROUP,
    reason=("why it cannot be coupled", "warum sie nicht gekoppelt werden kann"),
)
SPINDLES_FOLLOW_JOBS = error(
    901889,
    en="spindle {slave} takes over the jobs of its master: a factor or a limit is not possible",
    de="die Spindel {slave} übernimmt die Aufträge ihres Masters: Faktor und Grenze sind nicht "
    "möglich",
    remedy_en="Write the pair without them: S2=S.",
    remedy_de="Das Paar ohne sie schreiben: S2=S.",
    slave=_SLAVE,
    classes=(2, 3),
)
