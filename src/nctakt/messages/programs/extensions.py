# SPDX-License-Identifier: MIT
"""Messages about constructs of nctakt that the controller does not have."""

from __future__ import annotations

from nctakt.messages.catalogue import warning

EXTENSION_USED = warning(
    901000,
    en="{construct} is an extension of nctakt; {controller}",
    de="{construct} ist eine Erweiterung von nctakt; {controller}",
    remedy_en="Write it as the controller expects before the program goes to the machine.",
    remedy_de="Es so schreiben, wie die Steuerung es erwartet, bevor das Programm an die Maschine "
    "geht.",
    cause_en="nctakt runs it so that programs can be tried out; on the machine the program is "
    "refused (a copy of a structure in a realtime cycle with 21984) or behaves differently.",
    cause_de="nctakt führt es aus, damit man es ausprobieren kann; an der Maschine wird das "
    "Programm abgelehnt (die Kopie einer Struktur im Echtzeit-Zyklus mit 21984) oder verhält "
    "sich anders.",
    construct=("the extension", "die Erweiterung"),
    controller=("the behaviour of the controller", "das Verhalten der Steuerung"),
)
