# SPDX-License-Identifier: MIT
"""Messages about constructs of nctakt that the controller does not have."""

from __future__ import annotations

from nctakt.messages.catalogue import warning

EXTENSION_USED = warning(
    901000,
    en="{construct}: an extension of nctakt; {controller}",
    de="{construct}: eine Erweiterung von nctakt; {controller}",
    remedy_en="Write it in the controller's own way before the program goes to the machine.",
    remedy_de="Anders schreiben, bevor das Programm an die Maschine geht.",
    cause_en="nctakt runs it so that programs can be tried; on the machine the program is refused "
    "or behaves otherwise.",
    cause_de="nctakt führt es aus, damit man es ausprobieren kann; an der Maschine wird das "
    "Programm abgelehnt oder verhält sich anders.",
    construct=("what is an extension", "das, was eine Erweiterung ist"),
    controller=("what the controller does with it", "das, was die Steuerung damit macht"),
)
