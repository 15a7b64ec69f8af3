# SPDX-License-Identifier: MIT
"""Messages about mirroring, rotation and scaling of the programmed contour."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

INVALID_MIRROR_VALUE = error(
    20860,
    en="G351 with {axis}{value}: only -1 and 1 are possible",
    de="G351 mit {axis}{value}: nur -1 und 1 sind möglich",
    remedy_en="Write -1 to mirror the axis, 1 to end it.",
    remedy_de="Mit -1 die Achse spiegeln, mit 1 das Spiegeln beenden.",
)
NOT_AN_AXIS_OF_THE_PLANE = error(
    22156,
    en="G68: {axis} is not an axis of the plane G{plane}",
    de="G68: {axis} ist keine Achse der Ebene G{plane}",
    remedy_en="Name the centre of rotation by the two axes of the active plane.",
    remedy_de="Den Drehpunkt mit den beiden Achsen der aktiven Ebene angeben.",
)
ROTATION_ENDED_BY_PLANE = warning(
    901729,
    en="G{plane} ends the rotation of the contour",
    de="G{plane} beendet die Konturdrehung",
    remedy_en="Switch the rotation off before selecting another plane, and on again there.",
    remedy_de="Die Drehung vor dem Wechsel der Ebene abwählen und danach neu anwählen.",
    plane=("the plane that was selected", "die angewählte Ebene"),
)
SCALE_IS_ON = error(
    901725,
    en="#SCALE while the contour is already scaled",
    de="#SCALE, während die Kontur schon skaliert ist",
    remedy_en="Write #SCALE OFF before other factors.",
    remedy_de="Vor anderen Faktoren #SCALE OFF schreiben.",
    classes=(2, 3),
)
INVALID_SCALE_FACTOR = error(
    901726,
    en="#SCALE {axis}{value}: factors are greater than 0",
    de="#SCALE {axis}{value}: Faktoren sind größer als 0",
    remedy_en="Write a factor above 0; G21 … G23 or G351 mirror.",
    remedy_de="Einen Faktor über 0 schreiben; G21 … G23 oder G351 spiegeln.",
    value=("its factor", "ihr Faktor"),
    classes=(2, 3),
)
ARC_SCALED_UNEQUALLY = error(
    901727,
    en="an arc in the plane G{plane}, whose axes #SCALE gives different factors",
    de="ein Kreisbogen in der Ebene G{plane}, deren Achsen #SCALE verschiedene Faktoren gibt",
    remedy_en="Give both axes of the plane the same factor, or write the curve as lines.",
    remedy_de="Beiden Achsen der Ebene denselben Faktor geben oder die Kurve mit Geraden annähern.",
    cause_en="The arc would become part of an ellipse.",
    cause_de="Der Kreisbogen würde zum Teil einer Ellipse.",
    classes=(2, 3),
)
FRAME_DURING_COMPENSATION = error(
    901728,
    en="{word} while {compensation} is active",
    de="{word}, während {compensation} aktiv ist",
    remedy_en="End tool radius compensation with G40 first.",
    remedy_de="Vorher die Werkzeugradiuskorrektur mit G40 beenden.",
    word=("what changes the contour", "was die Kontur ändert"),
    compensation=("`G41` or `G42`", "`G41` oder `G42`"),
    classes=(2, 3),
)
