# SPDX-License-Identifier: MIT
"""Messages about lines by their angle (``#ANG``)."""

from __future__ import annotations

from nctakt.messages.catalogue import error

ANGLES_ARE_PARALLEL = error(
    21892,
    en="the lines at {first}° and {angle}° are parallel and do not meet",
    de="die Geraden unter {first}° und {angle}° sind parallel und schneiden sich nicht",
    remedy_en="Write two angles that differ by more than a multiple of 180°.",
    remedy_de="Zwei Winkel schreiben, die sich nicht nur um ein Vielfaches von 180° unterscheiden.",
    first=("angle of the first line", "Winkel der ersten Geraden"),
    angle=("angle of the second line", "Winkel der zweiten Geraden"),
)
ANGLE_WITH_BOTH_AXES = error(
    21895,
    en="#ANG with both axes of the plane",
    de="#ANG mit beiden Achsen der Ebene",
    remedy_en="Leave one of the two axes out; both belong to the second of two lines only.",
    remedy_de="Eine der beiden Achsen weglassen; beide gehören nur in die zweite von zwei Geraden.",
)
CONTOUR_LINE_INCOMPLETE = error(
    21904,
    en="the line of #ANG has no end",
    de="die Gerade von #ANG hat kein Ende",
    remedy_en="Add an axis of the plane, or #ANG and both axes in the next block.",
    remedy_de="Eine Achse der Ebene ergänzen, oder im nächsten Satz #ANG und beide Achsen.",
)
SECOND_LINE_RELATIVE = error(
    21910,
    en="the second of two lines of #ANG has a relative target",
    de="die zweite von zwei Geraden von #ANG hat ein relatives Ziel",
    remedy_en="Write G90 in its block, and its target absolutely.",
    remedy_de="G90 in den Satz schreiben und das Ziel absolut programmieren.",
)
ANGLE_DURING_ARC = error(
    901833,
    en="#ANG is a straight line, but G{function} is active",
    de="#ANG ist eine Gerade, aber G{function} ist aktiv",
    remedy_en="Write G01 in its block.",
    remedy_de="G01 in den Satz schreiben.",
    function=("the active G function", "die aktive G-Funktion"),
)
AXIS_NOT_REACHED_BY_ANGLE = error(
    901834,
    en="a line at {angle}° never reaches another position of {axis}",
    de="eine Gerade unter {angle}° erreicht keine andere Position von {axis}",
    remedy_en="Write the other axis of the plane, or another angle.",
    remedy_de="Die andere Achse der Ebene schreiben oder einen anderen Winkel.",
)
