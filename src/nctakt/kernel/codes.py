# SPDX-License-Identifier: MIT
"""The numbers that say what something is or does in the realtime part: kinds, states, actions.

``codes.pxd`` has the same names as constants of C; ``scripts/constants`` writes it from this file.
The numbers of rows and cells are in ``rows.py``.
"""

from __future__ import annotations

# --- why ``Kernel.run`` returns -------------------------------------------------------------------

(
    DONE,  # all ticks are done
    REFILL,  # the queue of a channel runs low
    ANSWER,  # the value that a decoder waits for is there
    PROGRAM_END,
    ERROR,
    FULL,  # the record has no room for another tick
    START,
    RESET,
    DEADLOCK,  # each running program waits for a signal that none of them can send
) = range(9)

# --- realtime cycles ------------------------------------------------------------------------------

#: States of a slot of the cycle manager.
(
    EMPTY,
    LOADED,  # the definition is on its way
    DEFINED,  # not started
    ARMED,  # started, waits for its block (BLOCK)
    RUNNING,
    HELD,
    ENDED,  # has ended, Python has not freed the slot yet
) = range(7)

#: Scopes.
BLOCK_SCOPE, PROG_SCOPE, GLOBAL_SCOPE = range(3)

#: Blocks of BLOCK cycles that are not on the path: already over; still waiting.
BLOCK_IS_OVER, WAITING_BLOCK = -1, -2

#: Management commands (RC-111).
CONTROL_START, CONTROL_HOLD, CONTROL_CONTINUE, CONTROL_ABORT, CONTROL_DELETE = range(1, 6)

#: Results of a condition or a branch.
(
    UNKNOWN,  # a condition that was not evaluated yet
    FALSE,
    TRUE,
    STOPS,  # the cycle must stop
) = range(-1, 3)

#: The reaction of an ``#ERROR`` that no reset takes back (RC 7).
FATAL_REACTION = 7

#: Actions of ``#TIMER``.
TIMER_START, TIMER_STOP, TIMER_READ, TIMER_CLEAR = range(1, 5)

# --- axes -----------------------------------------------------------------------------------------

#: Kinds of offsets of an axis, in the order in which ``X[INDP OFFSET=…]`` names them (RC-407).
(
    ZERO_OFFSET,
    ADD_ZERO_OFFSET,
    PSET_OFFSET,
    CLAMP_OFFSET,
    TOOL_OFFSET,
    MEASURE_OFFSET,
    MANUAL_OFFSET,
    OFFSET_KINDS,
) = range(8)

#: Which positions of the axes the place of a tool's tip belongs to; how many axes it shows at most.
TIP_OF_COMMAND, TIP_OF_ACTUAL, TIP_OF_TARGET, TIPS = range(4)
TIP_AXES = 12

#: Sets of offsets as bits: bit k means kind k.
ALL_OFFSETS = (1 << OFFSET_KINDS) - 1
OFFSETS_BUT_TOOL = ALL_OFFSETS - (1 << TOOL_OFFSET)

#: The override of independent motion (P-AXIS-00491).
CHANNEL_OVERRIDE, LOWER_OVERRIDE, OWN_OVERRIDE = range(3)

#: States of an axis in independent motion; from ``BRAKING`` on it has no target.
(
    IDLE,
    TO_POSITION,
    ENDLESS,
    BY_DISTANCE,  # only for a waiting motion: it begins as ``TO_POSITION``
    OSCILLATION,  # likewise
    BRAKING,
) = range(6)

#: Where an oscillating axis goes: to its first position from elsewhere, on to the second, back.
APPROACH, FORTH, BACK = range(3)

#: How an oscillation ends: at its second position, at once at another speed to it, at once.
FINISHES, RETURNS, HALTS = range(3)

#: How a command of independent motion begins: instead of the present motion, after it.
ABORTING, BUFFERED = range(2)

#: Directions of independent motion: as now, or on modulo axes the shorter one.
NEGATIVE, PRESENT, POSITIVE, SHORTEST = range(-1, 3)

#: PLCopen states.
(
    STANDSTILL,
    DISCRETE_MOTION,
    CONTINUOUS_MOTION,
    STOPPING,
    ERROR_STOP,
    SYNCHRONIZED_MOTION,  # the axis belongs to the path
) = range(1, 7)

#: The state of an axis for a position request (RC-409); in the last two its motion never ends.
AXIS_STOPPED, AXIS_MOVES, AXIS_MOVES_ENDLESSLY, AXIS_HELD = range(4)

#: The code of T0; those of M functions are below it, those of H functions below 0.
FIRST_T = 1_000_000_000

#: The owner of the PLC's first request; the others follow.
PLC_OWNER = 1_000_000
#: Owner of the motions of programs.
PROGRAM_OWNER = PLC_OWNER - 1

#: Requests of the PLC for an axis.
ABSOLUTE, RELATIVE, VELOCITY, HALT, CLEAR_FAULT, HOMING, POSITION, CALIBRATION = range(1, 9)
#: Who homes an axis; 0: it is not being homed.
HOMED_BY_PROGRAM, HOMED_BY_PLC = 1, 2

#: Why a cycle's command for an axis is refused in the tick: numbers of ``REFUSALS`` in
#: ``nc/vocabulary/single_axes/axis_commands.py``.
DIRECTION_UNKNOWN, FEED_UNKNOWN, FEED_ZERO = range(6, 9)
FEED_NEGATIVE = 12

#: The unknown of a trajectory: how far its highest speed lies above the slowest that makes sense,
#: as the root of the difference; the acceleration with which ``top_v`` is passed while braking;
#: that up to which a braking is taken back.
HIGHEST_SPEED, CROSSING, MIN_BRAKING = range(3)

# --- spindles -------------------------------------------------------------------------------------

#: Jobs: the M functions.
SPINDLE_FORWARD, SPINDLE_BACKWARD, SPINDLE_STOP = range(3, 6)
SPINDLE_POSITION = 19

#: States of a spindle.
(
    SPINDLE_STOPPED,
    TURNING,
    POSITIONING,
    COUPLED,  # tapping: its angle is that of the path
) = range(4)

#: States of the threads of a path.
(
    WITHOUT_THREAD,
    WITH_TAP,  # the spindle follows the path
    THREAD_ENTRY,  # the path accelerates, from an angle of the spindle on
    THREAD_CUT,  # the path is where the angle of the spindle says
    THREAD_EXIT,  # the path brakes, or continues into the next thread
) = range(5)

# --- signals between channels ---------------------------------------------------------------------

#: Number of signals that can be open at once in all channels together.
SIGNAL_CAPACITY = 256
#: Number of values that a signal can carry.
SIGNAL_VALUES = 12
#: Highest number of a channel that signals can name.
MAX_SIGNAL_CHANNEL = 30
#: Numbers of owners for the cycles of a channel, one for each slot; those of channel 1 from 1 on.
CYCLE_OWNERS = 1024
#: Kinds of events of the axis exchange.
AXIS_AWAITED, AXIS_TAKEN, AXIS_GIVEN = range(3)
#: A signal that is never used up.
ENDLESS_SIGNAL = -1

#: Whether the signals that a channel waits for are there.
(
    SIGNAL_ABSENT,
    SIGNAL_THERE,
    SIGNAL_OVERTAKES,  # another one of the same sender must be taken first
) = range(3)

#: States of a channel.
(
    AT_REST,  # no program runs
    STUCK,  # its program waits for a signal, and nothing else moves it on
    AT_WORK,
) = range(3)

# --- PLC ------------------------------------------------------------------------------------------

#: States of a slot for a technology function, and of the job of a spindle under the PLC.
FREE, WAITING, ACKNOWLEDGED = range(3)

#: States of a channel on its panel.
CHANNEL_READY, CHANNEL_RUNNING, CHANNEL_ERROR, CHANNEL_RESET = range(4)

#: How the path walks over its history.
AT_FRONT, WALKS_BACKWARD, WALKS_FORWARD = range(3)

#: Phases of measuring an edge joint.
(
    NOT_MEASURING,
    SEEKS_EDGE,
    FOUND_EDGE,
    BRAKES_FOR_JOINT,
    AWAITS_FUNCTION,
) = range(5)

#: Types of variables in the image of the HLI.
(
    IMAGE_BOOLEAN,
    IMAGE_SGN08,
    IMAGE_UNS08,
    IMAGE_SGN16,
    IMAGE_UNS16,
    IMAGE_SGN32,
    IMAGE_UNS32,
    IMAGE_REAL64,
    IMAGE_STRING,
) = range(9)

# --- measuring ------------------------------------------------------------------------------------

#: ``TOUCH_LEVEL`` of a measuring motion to a fixed stop: the signal is not HLI.PROBE.
FIXED_STOP_SIGNAL = 2

#: The error of a PLC that does not show in time that it lives (``messages/plcs/plc.py``).
PLC_SILENT = 902320

# --- tool life ------------------------------------------------------------------------------------

#: Changes of the tool life, in ``LIFE_ACTION``.
(
    LIFE_SENT,  # it is sent, and that of another tool begins
    LIFE_BEGUN,  # that of another tool begins
    LIFE_READ,  # it is sent for a tool, and counting continues
    LIFE_REMOVED,  # it begins at 0
    LIFE_DEFINED,  # it continues from other values, below 0: from its present ones
    LIFE_FACTORS,  # other factors count from here on
) = range(6)

#: How much a function goes out before the path comes to it, in ``TECHNOLOGY_LEAD_KIND``.
(
    LEAD_DISTANCE,  # mm
    LEAD_TIME,  # s with the speed at which the path passes
    LEAD_TIME_TO_REST,  # s with a ramp to standstill
) = range(1, 4)
#: ``TECHNOLOGY_LEAD`` of a function that has gone out.
LEAD_IS_OVER = -1

# --- path -----------------------------------------------------------------------------------------

#: After every eighth segment the look-ahead with a limit of the jerk checks whether it may end: the
#: last bits of their number then.
FAR_CHECK = 7

#: Stages of a segment (``path/geometry.py``), in the order in which the path passes them forward.
(
    BEFORE_STAGES,
    ENTRY_ZONE,
    MIDDLE,
    EXIT_ZONE,
    CURVE,
    AFTER_STAGES,
) = range(-1, 5)

#: Instead of the number of the segment that comes next (``tick/command_queue.py``).
END_OF_QUEUE, STOPS_BETWEEN = -1, -2
