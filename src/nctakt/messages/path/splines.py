# SPDX-License-Identifier: MIT
"""Messages about splines."""

from __future__ import annotations

from nctakt.messages.cases import by_beginning
from nctakt.messages.catalogue import error

SPLINE_AT_LOOP = error(
    22128,
    classes=(0, 0),
    cases=by_beginning("command", {"#RT ENDWHILE": 22129}),
    en="{command} while a spline is active",
    de="{command}, während ein Spline aktiv ist",
    remedy_en="Program #SPLINE OFF before it; #SPLINE ON is allowed inside the loop.",
    remedy_de="Davor #SPLINE OFF programmieren; #SPLINE ON darf in der Schleife stehen.",
    command=("#RT WHILE or #RT ENDWHILE", "#RT WHILE oder #RT ENDWHILE"),
)
INVALID_TRANSITION = error(
    120097,
    en="{value} is not a transition of Akima splines",
    de="{value} ist kein Übergang von Akima-Splines",
    remedy_en="Write 1 (AUTO), 2 (TANGENTIAL) or 3 (USER).",
    remedy_de="1 (AUTO), 2 (TANGENTIAL) oder 3 (USER) schreiben.",
    classes=(2, 6),
)
INVALID_SPLINE_VECTOR = error(
    120100,
    en="{command} needs {axes}, and not 0 in all of them",
    de="{command} braucht {axes}, und nicht in allen 0",
    remedy_en="Write the direction with all main axes: {command} {example}",
    remedy_de="Die Richtung mit allen Hauptachsen schreiben: {command} {example}",
    axes=("the names of the main axes", "die Namen der Hauptachsen"),
    example=("a direction", "eine Richtung"),
    classes=(2, 6),
)
NO_MOTION_BEFORE_SPLINE = error(
    120112,
    en="no motion comes before a spline that begins tangentially",
    de="vor einem tangential beginnenden Spline fehlt eine Bewegung",
    remedy_en="Program a motion before it, after #SPLINE TYPE, or #AKIMA TRANS [START=AUTO].",
    remedy_de="Davor und nach #SPLINE TYPE eine Bewegung oder #AKIMA TRANS [START=AUTO] "
    "programmieren.",
    classes=(2, 6),
)
SPLINE_WITHOUT_MAIN_AXES = error(
    120180,
    en="a block of a spline does not move the main axes",
    de="ein Satz eines Splines bewegt die Hauptachsen nicht",
    remedy_en="Move tracking axes together with a main axis, or program #SPLINE OFF first.",
    remedy_de="Mitschleppachsen mit einer Hauptachse bewegen oder davor #SPLINE OFF programmieren.",
    classes=(2, 6),
)
ARC_IN_BSPLINE = error(
    120254,
    en="G02 and G03 are not possible in a B-spline",
    de="G02 und G03 sind in einem B-Spline nicht möglich",
    remedy_en="Use an Akima spline (#SPLINE TYPE AKIMA), or #SPLINE OFF before the arc.",
    remedy_de="Einen Akima-Spline verwenden (#SPLINE TYPE AKIMA) oder vor dem Kreisbogen #SPLINE "
    "OFF programmieren.",
    classes=(2, 6),
)
SPLINE_WITH_CONTOURING = error(
    120255,
    en="corners are rounded while a spline is active",
    de="Ecken werden verschliffen, während ein Spline aktiv ist",
    remedy_en="Program G260 or #HSC OFF before the spline.",
    remedy_de="Vor dem Spline G260 oder #HSC OFF programmieren.",
    classes=(2, 6),
)
NO_MOTION_AFTER_SPLINE = error(
    901620,
    en="no motion follows a spline that ends tangentially",
    de="nach einem tangential endenden Spline fehlt eine Bewegung",
    remedy_en="Program a motion directly after it, without a wait in between, or #AKIMA TRANS "
    "[END=AUTO].",
    remedy_de="Direkt danach, ohne Warten, eine Bewegung programmieren oder #AKIMA TRANS "
    "[END=AUTO].",
)
SPLINE_TOO_SHORT = error(
    901621,
    en="the spline has {count} points, but needs {fewest}",
    de="der Spline hat {count} Punkte, braucht aber {fewest}",
    remedy_en="Program more motions, or both directions (#AKIMA TRANS): then 2 points suffice.",
    remedy_de="Mehr Bewegungen programmieren oder beide Richtungen (#AKIMA TRANS): dann genügen 2 "
    "Punkte.",
    cause_en="The last point before the spline is its first one.",
    cause_de="Der letzte Punkt vor dem Spline ist sein erster.",
    count=("its points", "seine Punkte"),
    fewest=("points that it needs", "Punkte, die er braucht"),
)
SPLINE_DURING_COMPENSATION = error(
    901622,
    en="tool radius compensation is not possible in a spline",
    de="in einem Spline ist keine Werkzeugradiuskorrektur möglich",
    remedy_en="Program #SPLINE OFF before G41 or G42, or leave the contour with G40 and a motion.",
    remedy_de="Vor G41 oder G42 #SPLINE OFF programmieren oder die Kontur mit G40 und einer "
    "Bewegung verlassen.",
)
SPLINE_OUTSIDE_LIMITS = error(
    901623,
    en="the spline takes axis {axis} to {position}, outside its limits {low} … {high}",
    de="der Spline führt die Achse {axis} auf {position}, außerhalb ihrer Grenzen {low} … {high}",
    remedy_en="Move its points away from the limit (P-AXIS-00177, -00178).",
    remedy_de="Seine Punkte von der Grenze weg verlegen (P-AXIS-00177, -00178).",
    position=(
        "a position on the curve in mm or degrees",
        "eine Position der Kurve in mm oder Grad",
    ),
)
CORNER_IN_SPLINE = error(
    901624,
    en="{word}: a spline has no corner",
    de="{word}: ein Spline hat keine Ecke",
    remedy_en="Program #SPLINE OFF before the corner.",
    remedy_de="Vor der Ecke #SPLINE OFF programmieren.",
    word=("G301, G302 or a word with a size", "G301, G302 oder ein Wort mit einer Größe"),
)
