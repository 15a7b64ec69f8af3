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
    spindle=("the spindle that the command names", "die Spindel, die der Befehl nennt"),
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
    en="#CAX names no C axis, and neither does the channel list",
    de="#CAX nennt keine C-Achse, die Kanalliste auch nicht",
    remedy_en="Program #CAX [C], or set default_ax_name_of_spindle (P-CHAN-00010).",
    remedy_de="#CAX [C] programmieren oder default_ax_name_of_spindle setzen (P-CHAN-00010).",
    classes=(2, 3),
)
SPINDLE_IS_C_AXIS = error(
    901818,
    en="spindle {spindle} is in use as C axis {axis} of the path",
    de="die Spindel {spindle} wird als C-Achse {axis} der Bahn verwendet",
    remedy_en="Program #CAX OFF before it, or #PUT AX if #CALL AX has fetched the axis.",
    remedy_de="Davor #CAX OFF programmieren, oder #PUT AX, wenn #CALL AX die Achse geholt hat.",
    axis=("name of the C axis", "Name der C-Achse"),
    classes=(2, 3),
)
C_AXIS_OF_OTHER_SPINDLE = error(
    901872,
    en="#CAX: the main spindle is not the one of the channel list",
    de="#CAX: die Hauptspindel ist nicht die der Kanalliste",
    remedy_en="Select it first (#MAIN SPINDLE): only the spindle of main_spindle_ax_nr can become "
    "an axis.",
    remedy_de="Sie vorher wählen (#MAIN SPINDLE): nur die Spindel von main_spindle_ax_nr kann "
    "Achse werden.",
    cause_en="Only one spindle of a channel can be a C axis in nctakt.",
    cause_de="In nctakt kann nur eine Spindel eines Kanals C-Achse sein.",
    classes=(2, 3),
)
