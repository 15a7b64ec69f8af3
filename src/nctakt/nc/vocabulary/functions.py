# SPDX-License-Identifier: MIT
"""The table of the G functions and of the controller's M functions.

A row holds number, support, meaning in English and German, the form in which the function is
written (``Form``), its modal group, and whether the fast paths know it (``plain``). They do not
unless the row says so: a new function is decoded from its tree. Checker, decoder and fast paths
take numbers and groups from this module; no other module of ``nc`` and ``decoder`` holds them
(``tests/test_tidy.py``).
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from nctakt.base.diagnostics import Text
from nctakt.nc.vocabulary.entries import SIMULATED
from nctakt.nc.vocabulary.function_rows import (
    Form,
    GFunction,
    Group,
    MFunction,
    Role,
    accepted,
    axis_values,
    axis_weights,
    by_number,
    group,
    m_function,
    plain,
    refused,
    simplified,
    simulated,
    subprograms,
    weight,
)
from nctakt.nc.vocabulary.simplifications import (
    AKIMA_CURVE,
    AS_G900,
    CORNER_FEED,
    FEED_RAMP,
    TANGENTIAL_ARC,
)

# --- numbers of the functions that are simulated -------------------------------------------------

RAPID, LINE, ARC_CLOCKWISE, ARC_COUNTERCLOCKWISE, ARC_IN_SPACE = 0, 1, 2, 3, 303
ARCS = (ARC_CLOCKWISE, ARC_COUNTERCLOCKWISE)
ANY_ARCS = (*ARCS, ARC_IN_SPACE)
DWELL = 4
THREAD_CUTTING = 33
TAPPING_BY_FEED, TAPPING, TAP_RETRACTION = 63, 331, 332
TAPPING_FUNCTIONS = (TAPPING_BY_FEED, TAPPING, TAP_RETRACTION)
THREADS = (THREAD_CUTTING, *TAPPING_FUNCTIONS)
CENTRE_FEED, CONTOUR_FEED = 10, 11
PLANE_XY, PLANE_ZX, PLANE_YZ = 17, 18, 19
MIRRORING_OF_AXES = 351
MIRRORED_BY_PLANE = {20: (), 21: (0,), 22: (1,), 23: (0, 1)}
LINEAR_TRANSITIONS, CIRCULAR_TRANSITIONS = 25, 26
COMPENSATION_OFF, COMPENSATION_LEFT, COMPENSATION_RIGHT = 40, 41, 42
COMPENSATIONS = (COMPENSATION_LEFT, COMPENSATION_RIGHT)
DIAMETER_ON = 51
#: Indexed by the zero offset that they select; G53 selects none (P-ZERO-00003).
ZERO_OFFSETS = (53, 54, 55, 56, 57, 58, 59)
NUMBERED_ZERO_OFFSET = 159
EXACT_STOP_ONCE, CONTOURING_ONCE = 60, 61
FEED_STEPS, FEED_RAMPS = (8, 9), (193, 293)
CORNER_DECELERATION = 13
INCH, MILLIMETRES = 70, 71
ROTATION_ON, ROTATION_OFF = 68, 69
#: Functions that end mirroring and rotation, and functions that take axis words for them.
MAPS_OFF = (20, ROTATION_OFF)
MAPS_BY_AXES = frozenset((MIRRORING_OF_AXES, ROTATION_ON))
MAP_FUNCTIONS = MAPS_BY_AXES.union(MAPS_OFF, MIRRORED_BY_PLANE)
ABSOLUTE, RELATIVE = 90, 91
REFERENCE_OFFSET = 92
CUTTING_SPEED, CONSTANT_SPEED, SPINDLE_LIMIT = 96, 97, 196
GEAR_STEP, GEAR_FUNCTIONS = 112, range(40, 46)
INVERSE_TIME_FEED, FEED_PER_MINUTE, FEED_PER_REVOLUTION, FEED_SHARE = 93, 94, 95, 194
HOMING, NEGATIVE_LIMIT, POSITIVE_LIMIT = 74, 98, 99
MEASURING, MEASURING_CONTINUES, INTERRUPTIBLE = 100, 106, 310
MEASURING_OFFSET_ON, MEASURING_OFFSET_OFF = 101, 102
EDGE_BANDING_OFF, EDGE_BANDING = 107, 108
APPROACH_DIRECT, APPROACH_INDIRECT = 138, 139
TANGENTIAL_APPROACH = 5
APPROACH_PERPENDICULAR, APPROACH_INNER_CORNER, DEPART_WITHOUT_MOTION = 237, 238, 239
MASKING_OFF, MASKING_ON = 140, 141
ABSOLUTE_CENTRE, RELATIVE_CENTRE = 161, 162
ARC_RADIUS, NO_OVERRIDE, NO_SPINDLE_OVERRIDE = 163, 166, 167
SPLINE_OFF, SPLINE_ON = (150, 151)
CHAMFER, ROUNDING = INSERTIONS = (301, 302)
CONTOURING_OFF, CONTOURING_ON = 260, 261
EXACT_STOP_OFF, EXACT_STOP_ON = 359, 360
#: Weights in per cent: of named axes, of all axes.
SPEED_WEIGHTS, SPEED_WEIGHT = 127, 128
FEED_FORWARD_ON, FEED_FORWARD_WEIGHTS, FEED_FORWARD_OFF = 135, 136, 137
RAPID_SPEED_WEIGHT = 129
FEED_ACCELERATION_WEIGHTS, FEED_ACCELERATION_WEIGHT = 130, 131
FEED_RAMP_WEIGHTS, FEED_RAMP_WEIGHT = 132, 133
RAPID_ACCELERATION_WEIGHTS, RAPID_ACCELERATION_WEIGHT = 230, 231
RAPID_RAMP_WEIGHTS, RAPID_RAMP_WEIGHT = 232, 233

#: M functions of spindles.
CLOCKWISE, COUNTERCLOCKWISE, SPINDLE_STOP, SPINDLE_POSITION = 3, 4, 5, 19
#: The M function that a program of the channel list may replace (P-CHAN-00118).
TOOL_CHANGE = 6

#: All known G functions by number.
G_FUNCTIONS: Mapping[int, GFunction] = by_number(
    group(
        Group.MOTION,
        plain(RAPID, "rapid traverse", "Eilgang"),
        plain(LINE, "straight line with feed", "Gerade mit Vorschub"),
        simulated(ARC_CLOCKWISE, "arc, clockwise", "Kreis im Uhrzeigersinn"),
        simulated(ARC_COUNTERCLOCKWISE, "arc, counter-clockwise", "Kreis gegen den Uhrzeigersinn"),
        simulated(THREAD_CUTTING, "thread cutting", "Gewindeschneiden"),
        simulated(TAPPING_BY_FEED, "tapping, pitch F / S", "Gewindebohren, Steigung F / S"),
        simulated(ARC_IN_SPACE, "arc in space", "Kreis im Raum"),
        simulated(TAPPING, "tapping with pitch", "Gewindebohren mit Steigung"),
        simulated(TAP_RETRACTION, "retraction from tapping", "Rückzug beim Gewindebohren"),
    ),
    group(
        None,
        simulated(DWELL, "dwell", "Verweilzeit", Form.TIME),
        simulated(8, "acceleration at the block's start", "Beschleunigen am Satzanfang"),
        simulated(9, "deceleration at the block's end", "Bremsen am Satzende"),
    ),
    group(
        Group.CORNER_DECELERATION,
        plain(12, "corner deceleration off", "Eckenverzögerung aus"),
        simplified(13, "corner deceleration on", "Eckenverzögerung ein", CORNER_FEED, plain=False),
    ),
    group(
        Group.FEED_ADAPTATION,
        plain(CENTRE_FEED, "feed of the tool's centre", "Vorschub des Werkzeugmittelpunkts"),
        plain(CONTOUR_FEED, "feed of the contour", "Vorschub an der Kontur"),
    ),
    group(
        Group.PLANE,
        plain(PLANE_XY, "plane X Y", "Ebene X Y"),
        plain(PLANE_ZX, "plane Z X", "Ebene Z X"),
        plain(PLANE_YZ, "plane Y Z", "Ebene Y Z"),
    ),
    group(
        Group.MIRROR,
        plain(20, "mirroring off", "Spiegeln aus"),
        simulated(21, "mirroring of the plane's first axis", "erste Achse der Ebene spiegeln"),
        simulated(22, "mirroring of the plane's second axis", "zweite Achse der Ebene spiegeln"),
        simulated(23, "mirroring of both axes of the plane", "beide Achsen der Ebene spiegeln"),
        simulated(MIRRORING_OF_AXES, "mirroring of axes", "Achsen spiegeln", Form.MIRRORED_AXES),
    ),
    group(
        Group.TRANSITION,
        plain(
            LINEAR_TRANSITIONS,
            "linear transitions of tool radius compensation",
            "lineare Übergänge der WRK",
        ),
        plain(
            CIRCULAR_TRANSITIONS,
            "circular transitions of tool radius compensation",
            "Bogenübergänge der WRK",
        ),
    ),
    group(
        Group.COMPENSATION,
        plain(COMPENSATION_OFF, "tool radius compensation off", "Werkzeugradiuskorrektur aus"),
        plain(COMPENSATION_LEFT, "tool radius compensation left", "Werkzeugradiuskorrektur links"),
        plain(
            COMPENSATION_RIGHT, "tool radius compensation right", "Werkzeugradiuskorrektur rechts"
        ),
    ),
    group(
        Group.DIAMETER,
        simulated(
            DIAMETER_ON,
            "positions of the face axis as diameters",
            "Positionen der Planachse als Durchmesser",
        ),
        accepted(
            52,
            "positions of the face axis as radii",
            "Positionen der Planachse als Radien",
            plain=True,
            neutral=0.0,
        ),
    ),
    group(
        Group.ZERO_OFFSET,
        plain(ZERO_OFFSETS[0], "zero offsets off", "Nullpunktverschiebungen aus"),
        plain(ZERO_OFFSETS[1], "zero offset", "Nullpunktverschiebung"),
        plain(ZERO_OFFSETS[2], "zero offset", "Nullpunktverschiebung"),
        plain(ZERO_OFFSETS[3], "zero offset", "Nullpunktverschiebung"),
        plain(ZERO_OFFSETS[4], "zero offset", "Nullpunktverschiebung"),
        plain(ZERO_OFFSETS[5], "zero offset", "Nullpunktverschiebung"),
        plain(ZERO_OFFSETS[6], "zero offset", "Nullpunktverschiebung"),
        plain(
            NUMBERED_ZERO_OFFSET,
            "further zero offset",
            "weitere Nullpunktverschiebung",
            Form.ZERO_OFFSET,
        ),
    ),
    group(
        None,
        simulated(
            EXACT_STOP_ONCE, "exact stop for this block", "Genauhalt für diesen Satz", Form.MOTION
        ),
        simulated(CONTOURING_ONCE, "contouring for this block", "Überschleifen für diesen Satz"),
        refused(66, "synchronising at the block's end", "Synchronisation am Satzende"),
    ),
    group(
        Group.UNIT,
        plain(INCH, "lengths in inch", "Längen in Zoll"),
        plain(MILLIMETRES, "lengths in mm", "Längen in mm"),
    ),
    group(
        Group.ROTATION,
        simulated(ROTATION_ON, "rotation of the contour", "Konturdrehung"),
        plain(ROTATION_OFF, "rotation of the contour off", "Konturdrehung aus"),
    ),
    group(
        None,
        axis_values(HOMING, "homing", "Referenzpunktfahrt"),
    ),
    subprograms(80, 89),
    group(
        Group.DIMENSION,
        plain(ABSOLUTE, "absolute dimensions", "Absolutmaße"),
        plain(RELATIVE, "relative dimensions", "Relativmaße"),
    ),
    group(
        None,
        simulated(
            REFERENCE_OFFSET, "reference point offset", "Bezugspunktverschiebung", Form.OFFSETS
        ),
    ),
    group(
        Group.FEED,
        simulated(INVERSE_TIME_FEED, "F is the time of the block", "F ist die Zeit des Satzes"),
        plain(FEED_PER_MINUTE, "F is feed per minute", "F ist Vorschub je Minute"),
        simulated(FEED_PER_REVOLUTION, "F is feed per revolution", "F ist Vorschub je Umdrehung"),
        simulated(
            FEED_SHARE, "F is a share of the highest feed", "F ist Anteil des höchsten Vorschubs"
        ),
    ),
    group(
        Group.CUTTING,
        simulated(CUTTING_SPEED, "constant cutting speed", "konstante Schnittgeschwindigkeit"),
        plain(CONSTANT_SPEED, "constant spindle speed", "konstante Spindeldrehzahl"),
    ),
    group(
        None,
        axis_values(NEGATIVE_LIMIT, "negative software limit", "negativer Software-Endschalter"),
        axis_values(POSITIVE_LIMIT, "positive software limit", "positiver Software-Endschalter"),
        simulated(MEASURING, "measuring", "Messen", Form.MEASURING),
        axis_values(MEASURING_OFFSET_ON, "measuring offset on", "Messversatz einrechnen"),
        axis_values(MEASURING_OFFSET_OFF, "measuring offset off", "Messversatz herausrechnen"),
        simulated(MEASURING_CONTINUES, "on after measuring", "Weiterfahrt nach dem Messen"),
    ),
    group(
        Group.EDGE_BANDING,
        plain(EDGE_BANDING_OFF, "edge banding off", "Kantenanleimen aus"),
        plain(EDGE_BANDING, "edge banding", "Kantenanleimen"),
    ),
    group(
        None,
        simulated(GEAR_STEP, "gear step of a spindle", "Getriebestufe einer Spindel"),
        refused(115, "influence on look-ahead", "Einfluss auf Look-ahead"),
        refused(116, "influence on look-ahead", "Einfluss auf Look-ahead"),
        accepted(117, "look-ahead on", "Look-ahead ein"),
        axis_weights(SPEED_WEIGHTS, "weight of an axis' speed", "Gewicht der Achsgeschwindigkeit"),
        weight(SPEED_WEIGHT, "weight of the highest speed", "Gewichtung der Höchstgeschwindigkeit"),
        weight(
            RAPID_SPEED_WEIGHT, "weight of the rapid speed", "Gewichtung der Eilganggeschwindigkeit"
        ),
        axis_weights(
            FEED_ACCELERATION_WEIGHTS,
            "weight of an axis' acceleration",
            "Gewichtung der Achsbeschleunigung",
        ),
        weight(FEED_ACCELERATION_WEIGHT, "weight of acceleration", "Gewichtung der Beschleunigung"),
        axis_weights(
            FEED_RAMP_WEIGHTS, "weight of an axis' ramp time", "Gewichtung der Rampenzeit"
        ),
        weight(FEED_RAMP_WEIGHT, "weight of ramp times", "Gewichtung der Rampenzeiten"),
        weight(134, "weight of geometrical ramps", "geometrische Rampenzeiten", accepted=True),
        axis_weights(FEED_FORWARD_WEIGHTS, "weight of feed-forward", "Gewichtung der Vorsteuerung"),
    ),
    group(
        Group.FEED_FORWARD,
        plain(FEED_FORWARD_ON, "feed-forward on", "Vorsteuerung ein"),
        plain(FEED_FORWARD_OFF, "feed-forward off", "Vorsteuerung aus"),
    ),
    group(
        Group.APPROACH,
        plain(
            APPROACH_DIRECT, "direct begin of tool radius compensation", "direkte Anwahl der WRK"
        ),
        plain(
            APPROACH_INDIRECT,
            "indirect begin of tool radius compensation",
            "indirekte Anwahl der WRK",
        ),
        refused(
            236,
            "begin of compensation on the path",
            "Anwahl der WRK auf der Bahn",
            Text(
                "G138 leads to the contour directly, G139 around its corner, G237 across.",
                "G138 führt direkt an die Kontur, G139 um ihre Ecke, G237 quer.",
            ),
        ),
        plain(
            APPROACH_PERPENDICULAR,
            "perpendicular begin of compensation",
            "senkrechte Anwahl der WRK",
        ),
        plain(
            APPROACH_INNER_CORNER,
            "begin of compensation in an inner corner",
            "Anwahl der WRK in einer Innenecke",
        ),
        plain(
            DEPART_WITHOUT_MOTION,
            "end of compensation without motion",
            "Abwahl der WRK ohne Bewegung",
        ),
    ),
    group(
        Group.MASKING,
        plain(MASKING_OFF, "contour masking off", "Konturausblendung aus"),
        plain(MASKING_ON, "contour masking on", "Konturausblendung ein"),
    ),
    group(
        Group.SPLINE,
        plain(SPLINE_OFF, "spline off", "Spline aus"),
        simplified(SPLINE_ON, "spline on", "Spline ein", AKIMA_CURVE, plain=False),
    ),
    group(
        None,
        refused(160, "zero offset of named axes", "Nullpunktverschiebung genannter Achsen"),
    ),
    group(
        Group.ARC_CENTRE,
        plain(ABSOLUTE_CENTRE, "absolute centres of arcs", "Kreismittelpunkte absolut"),
        plain(RELATIVE_CENTRE, "relative centres of arcs", "Kreismittelpunkte relativ"),
    ),
    group(
        Group.CENTRE_CORRECTION,
        accepted(
            164, "correction of arc centres off", "Korrektur der Kreismittelpunkte aus", plain=True
        ),
        accepted(
            165, "correction of arc centres on", "Korrektur der Kreismittelpunkte ein", plain=True
        ),
    ),
    group(
        None,
        simplified(
            TANGENTIAL_APPROACH,
            "tangential begin and end of compensation",
            "tangentiale An- und Abwahl der WRK",
            TANGENTIAL_ARC,
        ),
        simulated(ARC_RADIUS, "radius of arcs, as R", "Radius von Kreisen, wie R", Form.RADIUS),
        simulated(NO_OVERRIDE, "override 100 % for this block", "Override 100 % für diesen Satz"),
        simulated(NO_SPINDLE_OVERRIDE, "spindle override 100 %", "Spindel-Override 100 %"),
        simplified(193, "feed linear over the way", "Vorschub linear über dem Weg", FEED_RAMP),
        simulated(SPINDLE_LIMIT, "highest spindle speed of G96", "höchste Drehzahl zu G96"),
        refused(200, "manual mode", "Handbetrieb"),
        refused(201, "manual mode beside the path", "Handbetrieb neben der Bahn"),
        accepted(202, "manual mode beside the path off", "Handbetrieb neben der Bahn aus"),
        axis_weights(
            RAPID_ACCELERATION_WEIGHTS,
            "weight of an axis' acceleration, rapid",
            "Achsbeschleunigung im Eilgang",
        ),
        weight(
            RAPID_ACCELERATION_WEIGHT,
            "weight of acceleration, rapid",
            "Gewichtung der Eilgangbeschleunigung",
        ),
        axis_weights(
            RAPID_RAMP_WEIGHTS,
            "weight of an axis' ramp time, rapid",
            "Rampenzeit einer Achse im Eilgang",
        ),
        weight(
            RAPID_RAMP_WEIGHT, "weight of ramp times, rapid", "Gewichtung der Eilgang-Rampenzeiten"
        ),
        simplified(293, "feed linear over time", "Vorschub linear über der Zeit", FEED_RAMP),
        simulated(CHAMFER, "chamfer", "Fase", Form.CORNER),
        simulated(ROUNDING, "rounding", "Rundung", Form.CORNER),
        simulated(INTERRUPTIBLE, "interruptible block", "unterbrechbarer Satz", Form.MEASURING),
        axis_weights(333, "weight of an axis' feed hold", "Achse bei Vorschubhalt", accepted=True),
        weight(334, "weight of feed hold", "Bremsen bei Vorschubhalt", accepted=True),
        axis_weights(338, "weight of an axis' hold ramp", "Achsrampe, Vorschubhalt", accepted=True),
        weight(339, "weight of hold ramps", "Rampen bei Vorschubhalt", accepted=True),
    ),
    group(
        Group.CONTOURING,
        plain(CONTOURING_OFF, "contouring off", "Überschleifen aus"),
        plain(CONTOURING_ON, "contouring on", "Überschleifen ein"),
    ),
    group(
        Group.EXACT_STOP,
        plain(EXACT_STOP_OFF, "exact stop off", "Genauhalt aus"),
        plain(EXACT_STOP_ON, "exact stop on", "Genauhalt ein"),
    ),
    subprograms(800, 839),
    group(
        Group.DECELERATION,
        plain(900, "deceleration before the block's end", "Bremsen vor dem Satzende"),
        simplified(
            901, "deceleration after the block's end", "Bremsen hinter dem Satzende", AS_G900
        ),
    ),
)

_M_ROWS = (
    m_function(0, "stop until START", "Halt bis START", Role.PROGRAM_STOP),
    m_function(1, "stop if HLI.OPTIONAL_STOP", "Halt bei HLI.OPTIONAL_STOP", Role.OPTIONAL_STOP),
    m_function(2, "program end", "Programmende", Role.PROGRAM_END),
    m_function(CLOCKWISE, "spindle clockwise", "Spindel im Uhrzeigersinn", Role.SPINDLE),
    m_function(
        COUNTERCLOCKWISE,
        "spindle counter-clockwise",
        "Spindel gegen den Uhrzeigersinn",
        Role.SPINDLE,
    ),
    m_function(SPINDLE_STOP, "spindle stop", "Spindel halt", Role.SPINDLE),
    m_function(17, "end of a subprogram", "Ende eines Unterprogramms", Role.SUBPROGRAM_END),
    m_function(SPINDLE_POSITION, "spindle to a position", "Spindel positionieren", Role.SPINDLE),
    m_function(29, "end of a subprogram", "Ende eines Unterprogramms", Role.SUBPROGRAM_END),
    m_function(30, "program end", "Programmende", Role.PROGRAM_END),
)

#: M functions of the controller itself by number; all others are defined by the channel list.
M_FUNCTIONS: Mapping[int, MFunction] = MappingProxyType({row.number: row for row in _M_ROWS})


# --- derived from the table ----------------------------------------------------------------------


def group_of(number: int) -> Group | None:
    """Return the modal group of a G function; ``None`` for an unknown one or one without a
    group.
    """
    row = G_FUNCTIONS.get(number)
    return None if row is None else row.group


def members(of: Group) -> tuple[int, ...]:
    """Return the numbers of the simulated functions of a group."""
    rows = (row for row in G_FUNCTIONS.values() if row.group is of)
    return tuple(row.number for row in rows if row.support is SIMULATED)


def _of_role(*roles: Role) -> tuple[int, ...]:
    return tuple(row.number for row in M_FUNCTIONS.values() if row.role in roles)


#: G functions whose axis words are weights, not targets.
AXIS_WEIGHTS = frozenset(
    row.number for row in G_FUNCTIONS.values() if row.form is Form.AXIS_WEIGHTS
)
#: Other functions whose axis words are not targets.
AXIS_VALUES = frozenset(row.number for row in G_FUNCTIONS.values() if row.form is Form.AXIS_VALUES)
#: G functions whose value is a weight of all axes.
WEIGHTS = frozenset(row.number for row in G_FUNCTIONS.values() if row.form is Form.WEIGHT)

#: Functions of the transition to the next block: one of them in a block (20117).
BLOCK_TRANSITIONS = (
    EXACT_STOP_ONCE,
    CONTOURING_ONCE,
    *members(Group.CONTOURING),
    *members(Group.EXACT_STOP),
)

#: All motions, and those that may appear in a plain line.
MOTIONS = members(Group.MOTION)
PLAIN_MOTIONS = tuple(number for number in MOTIONS if G_FUNCTIONS[number].plain)

#: M functions that end the main program, a subprogram, or either of them.
PROGRAM_ENDS = _of_role(Role.PROGRAM_END)
SUBPROGRAM_ENDS = _of_role(Role.SUBPROGRAM_END)
ENDS = _of_role(Role.PROGRAM_END, Role.SUBPROGRAM_END)
#: Ends of subprograms as commands with options, ``M17 [MAIN]``.
RETURN_COMMANDS = tuple(M_FUNCTIONS[number].name for number in SUBPROGRAM_ENDS)

#: M functions that stop the program until START; those that do so only with HLI.OPTIONAL_STOP.
PROGRAM_STOPS = _of_role(Role.PROGRAM_STOP, Role.OPTIONAL_STOP)
OPTIONAL_STOPS = _of_role(Role.OPTIONAL_STOP)
#: M functions that control programs, not allowed in realtime cycles (RC-403).
FLOW_FUNCTIONS = _of_role(
    Role.PROGRAM_STOP, Role.OPTIONAL_STOP, Role.PROGRAM_END, Role.SUBPROGRAM_END
)
SPINDLE_FUNCTIONS = _of_role(Role.SPINDLE)
