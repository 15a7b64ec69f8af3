# SPDX-License-Identifier: MIT
"""Messages about coupled axes in lists."""

from __future__ import annotations

from nctakt.messages.catalogue import warning

_INDEX = ("index of the pair", "Index des Paars")
_SLAVE = ("logical number of the slave", "logische Nummer des Slaves")
_MASTER = ("logical number of the master", "logische Nummer des Masters")

LISTED_PAIR_WITHOUT_AXIS = warning(
    20438,
    en="paar[{index}] is left out: master {master}, slave {slave}",
    de="paar[{index}] entfällt: Master {master}, Slave {slave}",
    remedy_en="Give both logical numbers; 0 means none.",
    remedy_de="Beide logischen Nummern angeben; 0 heißt keine.",
    index=_INDEX,
    slave=_SLAVE,
    master=_MASTER,
)
LISTED_PAIR_OF_ONE_AXIS = warning(
    20440,
    en="paar[{index}] is left out: slave {slave} and master {master} are the same axis",
    de="paar[{index}] entfällt: Slave {slave} und Master {master} sind dieselbe Achse",
    remedy_en="Give two different logical numbers.",
    remedy_de="Zwei verschiedene logische Nummern angeben.",
    index=_INDEX,
    slave=_SLAVE,
    master=_MASTER,
)
LISTED_SLAVE_TWICE = warning(
    20441,
    en="paar[{index}] is left out: axis {slave} already follows another axis than {master}",
    de="paar[{index}] entfällt: Achse {slave} folgt schon einer anderen als {master}",
    remedy_en="Let a slave follow one master only.",
    remedy_de="Einen Slave nur einem Master folgen lassen.",
    index=_INDEX,
    slave=_SLAVE,
    master=_MASTER,
)
LISTED_SLAVE_IS_MASTER = warning(
    20442,
    en="paar[{index}] is left out: an axis is both a slave and a master ({slave} follows {master})",
    de="paar[{index}] entfällt: eine Achse ist Slave und Master ({slave} folgt {master})",
    remedy_en="Let all slaves follow the first master; chains are not possible.",
    remedy_de="Alle Slaves dem ersten Master folgen lassen; Ketten sind nicht möglich.",
    index=_INDEX,
    slave=_SLAVE,
    master=_MASTER,
)
GANTRY_MASTER_MISSING = warning(
    70124,
    en="gantry_ax_nr {master}: axis {slave} follows no axis",
    de="gantry_ax_nr {master}: Achse {slave} folgt keiner Achse",
    remedy_en="Name another axis of the machine that does not itself follow an axis.",
    remedy_de="Eine andere Achse der Maschine nennen, die selbst keiner folgt.",
    slave=_SLAVE,
    master=_MASTER,
)
GANTRY_SLAVE_IN_CHANNEL = warning(
    901886,
    en="axis {slave} follows axis {master} (gantry_ax_nr) and must not be in a channel",
    de="Achse {slave} folgt Achse {master} (gantry_ax_nr) und gehört in keinen Kanal",
    remedy_en="Remove one of the two: the entry of the channel list, or gantry_ax_nr.",
    remedy_de="Eines von beiden entfernen: den Eintrag der Kanalliste oder gantry_ax_nr.",
    cause_en="The slave of a fixed gantry is moved by its master only. It moves with its channel "
    "here, as if gantry_ax_nr were 0.",
    cause_de="Den Slave eines festen Gantryverbunds bewegt nur sein Master. Hier fährt er mit "
    "seinem Kanal, als wäre gantry_ax_nr 0.",
    slave=_SLAVE,
    master=_MASTER,
)
GANTRY_MODULO_DIFFERS = warning(
    70202,
    en="slave {slave} has another modulo mode or range than its master {master}",
    de="Slave {slave} hat eine andere Modulo-Betriebsart oder -Grenze als Master {master}",
    remedy_en="Give both the same P-AXIS-00015, P-AXIS-00126 and P-AXIS-00127; those of the "
    "master count.",
    remedy_de="Beiden dieselben P-AXIS-00015, P-AXIS-00126 und P-AXIS-00127 geben; die des "
    "Masters gelten.",
    slave=_SLAVE,
    master=_MASTER,
)
GANTRY_ACCELERATION_DIFFERS = warning(
    70205,
    en="slave {slave} has another a_max than its master {master}: {value} instead of {other}",
    de="Slave {slave} hat ein anderes a_max als sein Master {master}: {value} statt {other}",
    remedy_en="Give both the same P-AXIS-00008; that of the master counts.",
    remedy_de="Beiden dasselbe P-AXIS-00008 geben; das des Masters gilt.",
    slave=_SLAVE,
    master=_MASTER,
    value=("a_max of the slave", "a_max des Slaves"),
    other=("a_max of the master", "a_max des Masters"),
)
GANTRY_SLAVE_HAS_NARROWER_LIMIT = warning(
    901890,
    en="{key} of slave {slave} is narrower than that of its master {master}, and has no effect",
    de="{key} von Slave {slave} ist enger als bei Master {master} und wirkt nicht",
    remedy_en="Give the master limits that its slave can keep, too.",
    remedy_de="Dem Master Grenzen geben, die auch der Slave einhält.",
    cause_en="No channel knows the slave of a fixed gantry: it follows wherever its master goes.",
    cause_de="Kein Kanal kennt den Slave eines festen Gantryverbunds: er folgt dem Master überall.",
    slave=_SLAVE,
    master=_MASTER,
)
