# SPDX-License-Identifier: MIT
"""Messages about ``#CAX``: the main spindle as an axis of the path."""

from __future__ import annotations

from nctakt.messages.catalogue import error

NOT_THE_MAIN_SPINDLE = error(
    21175,
    en="{spindle} is not the main spindle of the channel: {main}",
    de="{spindle} ist nicht die Hauptspindel des Kanals: {main}",
    remedy_en="Name the main spindle, or leave it out (P-CHAN-00051, P-CHAN-00053).",
    remedy_de="Die Hauptspindel nennen oder weglassen (P-CHAN-00051, P-CHAN-00053).",
    spindle=("what the command names", "was der Befehl nennt"),
    main=("the name of the main spindle", "der Name der Hauptspindel"),
)
C_AXIS_IN_PLANE = error(
    20893,
    en="#CAX OFF while {command} is active",
    de="#CAX OFF, solange {command} aktiv ist",
    remedy_en="Program {command} OFF before it.",
    remedy_de="Davor {command} OFF programmieren.",
    command=("the command of the plane", "der Befehl der Ebene"),
)
NO_NAME_OF_C_AXIS = error(
    901817,
    en="#CAX without a name, and the channel list has no name of the C axis",
    de="#CAX ohne Namen, und die Kanalliste hat keinen Namen der C-Achse",
    remedy_en="Program #CAX [C], or set default_ax_name_of_spindle (P-CHAN-00010).",
    remedy_de="#CAX [C] programmieren oder default_ax_name_of_spindle setzen (P-CHAN-00010).",
    classes=(2, 3),
)
SPINDLE_IS_C_AXIS = error(
    901818,
    en="spindle {spindle} is the C axis {axis} of the path here",
    de="die Spindel {spindle} ist hier die C-Achse {axis} der Bahn",
    remedy_en="Program #CAX OFF before it, or #PUT AX if #CALL AX has fetched the axis.",
    remedy_de="Davor #CAX OFF programmieren, oder #PUT AX, wenn #CALL AX die Achse geholt hat.",
    axis=("name of the C axis", "Name der C-Achse"),
    classes=(2, 3),
)
C_AXIS_OF_OTHER_SPINDLE = error(
    901872,
    en="#CAX: another spindle than that of the channel list is the main spindle",
    de="#CAX: eine andere Spindel als die der Kanalliste ist die Hauptspindel",
    remedy_en="Program #MAIN SPINDLE before it: only the spindle of main_spindle_ax_nr can be an "
    "axis here.",
    remedy_de="Davor #MAIN SPINDLE programmieren: nur die Spindel von main_spindle_ax_nr kann hier "
    "eine Achse sein.",
    cause_en="nctakt makes the C axis of one spindle of a channel.",
    cause_de="nctakt bildet die C-Achse aus einer Spindel des Kanals.",
    classes=(2, 3),
)
