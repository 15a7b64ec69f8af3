# SPDX-License-Identifier: MIT
"""The numbers of the rows that the realtime part works on: kinds and columns, once and in order.

A command of the queue is a row of float64, and so is a segment of the path. ``rows.pxd`` has the
same names as constants of C; ``scripts/constants`` writes it from this file. Lengths along the path
are mm (degrees where only rotary axes move), ``/s``, ``/s²`` and ``/s³`` their derivatives in time.
"""

from __future__ import annotations

# --- commands of the queue ------------------------------------------------------------------------

#: The first columns of each command; what a kind needs comes from ``ARGUMENTS`` on.
(
    KIND,  # one of the kinds below
    SOURCE,  # where in the program's text it comes from, a number of ``base/source_ids.py``
    BLOCK_NUMBER,  # the N word of its block, 0 without one
    ARGUMENTS,
) = range(4)

#: Kinds of commands, in ``KIND``; 0 is none.
(
    SEGMENT,  # the path moves; its columns are below
    DWELL,  # the path is at rest
    DEFINE_CYCLE,  # a realtime cycle is defined, and started
    CONTROL_CYCLE,  # START, HOLD, CONTINUE, ABORT ACTION, DELETE
    TECHNOLOGY,  # an M, H or T function goes to the PLC
    AWAIT_ACKNOWLEDGE,  # waits until the PLC has acknowledged the function
    WRITE_VARIABLE,  # a number goes into a cell
    WRITE_TEXT,  # part of a character string goes into its cells
    MESSAGE,  # #MSG
    FLUSH,  # waits until the path is at rest
    READ,  # waits until the path is at rest, and answers with the value of a cell
    POSITIONS,  # waits until the path and some axes are at rest: a position request
    PROGRAM_END,  # M30
    GIVE_UP,  # the channel stops with an error of the decoder
    USER_ERROR,  # #ERROR; its values follow as commands of their own
    USER_VALUE,  # a number that is reported with an #ERROR
    USER_TEXT,  # a text that is reported with an #ERROR
    USER_STOP,  # the #ERROR before stops the channel
    SPINDLE,  # a job for a spindle
    AWAIT_SPINDLE,  # waits until a spindle's job is done
    BLOCK_MARK,  # a block begins
    WAIT_MARK,  # why the next command empties the channel
    TIMER,  # #TIMER … SYN
    SET_OFFSET,  # another value of an offset of an axis
    SET_ORIGIN,  # the origin of the program's coordinate system on an axis
    SET_TURN,  # the rotation of the program's coordinate system
    SET_TRANSFORMATION,  # the transformation that is active from here on
    PROGRAM_STOP,  # M00, M01
    FREEZE,  # a variable became a constant of the realtime cycle before it
    LOOP_BEGIN,  # #RT WHILE
    LOOP_PASS,  # the end of each pass
    LOOP_END,  # #RT ENDWHILE
    FIXED_STOP,  # an axis is monitored for a fixed stop from here on, or no longer
    FIXED_STOP_END,  # the block that moves to a fixed stop is over
    MEASURE,  # the next motion looks for an edge
    MEASURE_END,  # the motion that looks for an edge is over
    CLEAR_HISTORY,  # #BACKWARD STORAGE CLEAR
    EMPTY_BLOCK,  # a block whose motion or dwell takes no tick
    SIGNAL,  # #SIGNAL SYN
    AWAIT_SIGNAL,  # #WAIT SYN
    REMOVE_SIGNAL,  # #SIGNAL REMOVE SYN
    MODAL_MARK,  # other functions are in force from here on
    CUTTING_SPEED,  # G96, G97: the speed of a spindle follows an axis, or no longer
    SPINDLE_LIMITS,  # a spindle gets those of its tool when it starts from standstill
    TOUCH,  # the next motion measures with a touch probe (G100)
    TOUCH_END,  # the motion that measures is over
    HOME,  # an axis begins to move to its zero pulse (G74)
    REFER,  # the position where an axis is
    SOFTWARE_LIMITS,  # others for the independent motions of an axis (G98, G99)
    SINGLE_STEP,  # #SINGLE STEP
    COUPLE,  # an axis follows another one from here on, or no longer
    FEED_FORWARD,  # another share of the command speed bypasses a position control
    TOOL_LIFE,  # of the tool on the path: ``codes.LIFE_SENT`` …
    MOVE_ALONE,  # an axis moves beside the path (INDP_SYN, INDP_ASYN)
    OSCILLATE,  # an axis moves to and fro beside the path (OSC ON)
    END_OSCILLATION,  # OSC OFF
    SPINDLE_AXIS,  # a spindle gives its axis, or takes it again (S[PUTAX], S[CALLAX])
) = range(1, 58)

#: The kinds that take or may take time.
TIMED_KINDS = frozenset(
    (
        SEGMENT,
        DWELL,
        AWAIT_ACKNOWLEDGE,
        FLUSH,
        READ,
        POSITIONS,
        PROGRAM_END,
        GIVE_UP,
        USER_STOP,
        AWAIT_SPINDLE,
        PROGRAM_STOP,
        LOOP_END,
        FIXED_STOP_END,
        MEASURE_END,
        AWAIT_SIGNAL,
    )
)


def _arguments(count: int) -> range:
    return range(ARGUMENTS, ARGUMENTS + count)


# Columns of single kinds.
(DWELL_TICKS,) = _arguments(1)
CYCLE_SLOT, CYCLE_STARTS = _arguments(2)  # slot of the cycle manager; 1: started at once
(
    CONTROL_ACTION,  # ``codes.CONTROL_START`` …
    CONTROL_IDENTITY,  # the cycle's programmed ID
) = _arguments(2)
(
    TECHNOLOGY_FUNCTION,  # its code (``hli/function_codes.py``)
    TECHNOLOGY_TICKS,  # how long the function takes
    TECHNOLOGY_HAS_VALUE,
    TECHNOLOGY_VALUE,
    TECHNOLOGY_LEAD,  # mm or s that it goes out before the path comes to it, 0: not before
    TECHNOLOGY_LEAD_KIND,  # ``codes.LEAD_DISTANCE`` …
) = _arguments(6)
(AWAITED_FUNCTION,) = _arguments(1)  # as ``TECHNOLOGY_FUNCTION``
(
    VARIABLE_CELL,
    VARIABLE_VALUE,
    VARIABLE_IS_REPORTED,  # 1: the write is an event
) = _arguments(3)
(
    TEXT_CELL,  # first cell of the string
    TEXT_FIRST,  # byte of the string where the characters go
    TEXT_COUNT,  # number of characters
    TEXT_ZEROS,  # number of zeros after them
    TEXT_CHARACTERS,  # the first character; the others follow
) = _arguments(5)
(MESSAGE_TEXT,) = _arguments(1)  # number of the text
(
    IS_ANSWERED,  # FLUSH, READ, POSITIONS, LOOP_END: 1: the decoder waits
    READ_CELL,  # READ
) = _arguments(2)
(
    POSITIONS_COUNT,  # number of the axes that have to be at rest, too
    POSITIONS_AXES,  # the first of their numbers in the machine; the others follow
) = range(READ_CELL, READ_CELL + 2)
(PROGRAM_NUMBER,) = _arguments(1)  # PROGRAM_END
(GIVE_UP_MESSAGE,) = _arguments(1)  # number of the message
(
    ERROR_IDENTITY,
    ERROR_REACTION,  # RC
) = _arguments(2)
(
    VALUE_KEYWORD,  # index of the keyword in ``nc/check/user_errors.py``
    VALUE_NUMBER,
) = _arguments(2)
(
    USER_TEXT_KEYWORD,  # as ``VALUE_KEYWORD``
    USER_TEXT_NUMBER,  # number of the text
) = _arguments(2)
(STOP_REACTION,) = _arguments(1)  # USER_STOP: RC
(
    JOB_SPINDLE,  # index of the spindle in the channel; of AWAIT_SPINDLE, too
    JOB_FUNCTION,  # 3, 4, 5 or 19
    JOB_SPEED,  # degrees/s
    JOB_POSITION,  # degrees
    JOB_DIRECTION,  # 1, -1; 0: the shorter way
    JOB_TICKS,  # how long the default PLC takes
    JOB_IGNORES_OVERRIDE,  # 1: the operator's override has no effect (G167)
) = _arguments(7)
(
    CUTTING_SPINDLE,  # index of the spindle in the channel
    CUTTING_SURFACE,  # mm/s that the surface has at the tool; 0: off
    CUTTING_AXIS,  # number of the face axis in the machine
    CUTTING_CENTRE,  # mm: where that axis has the radius 0
    CUTTING_LIMIT,  # highest speed, degrees/s; 0: none but that of the spindle
) = _arguments(5)
# SPINDLE_LIMITS: index in the channel, least and highest speed, degrees/s; degrees/s², /s³; 0: none
LIMITED_SPINDLE, LIMITED_LOW, LIMITED_HIGH, LIMITED_ACCELERATION = _arguments(4)
LIMITED_JERK, LIMITED_BY_GEAR = range(LIMITED_ACCELERATION + 1, LIMITED_ACCELERATION + 3)
GIVING_SPINDLE, GIVES_AXIS = _arguments(2)  # SPINDLE_AXIS: index in the channel; 1: gives
(
    MARK_TICK,  # BLOCK_MARK: tick in which the block was decoded
    MARK_CALLS,  # number of the open calls (``run/realtime/event_registry.py``)
    MARK_DEPTH,  # how many programs are open, from 1
) = _arguments(3)
(MODAL_NUMBER,) = _arguments(1)  # MODAL_MARK: number of what is in force
(
    WAIT_REASON,  # ``decoder/state/queued/commands.py``
    WAIT_CELL,  # the variable, 0 for none
) = _arguments(2)
STEP_IS_LOCKED, STEP_RESOLUTION = _arguments(2)  # SINGLE_STEP: 1: disabled; -1: not changed
TIMER_NUMBER, TIMER_ACTION = _arguments(2)  # ``codes.TIMER_START`` …
# TOOL_LIFE: ``codes.LIFE_SENT`` …, the tool's text and number; seconds and mm, or factors
LIFE_ACTION, LIFE_TOOL, LIFE_BASIC, LIFE_TIME, LIFE_DISTANCE = _arguments(5)
(
    OFFSET_AXIS,  # number in the machine
    OFFSET_KIND,  # ``codes.ZERO_OFFSET`` …
    OFFSET_VALUE,  # mm, degrees
) = _arguments(3)
(
    ORIGIN_AXIS,  # number in the machine
    ORIGIN_VALUE,  # mm, degrees
) = _arguments(2)
(
    TURN_FIRST,  # number of the first axis in the machine
    TURN_SECOND,  # of the second one, plus 1; 0: nothing is turned
    TURN_THIRD,  # of the third one, plus 1
    TURN_MATRIX,  # the first of nine numbers, row by row
) = _arguments(4)
(
    TRANSFORMATION_NUMBER,  # of its map; 0: none
    TRANSFORMATION_OF_SEGMENTS,  # the map of the segments after it; 0: they are those of the axes
) = _arguments(2)
(STOP_IS_OPTIONAL,) = _arguments(1)  # PROGRAM_STOP: M01
(
    FROZEN_CYCLE,  # serial of the cycle
    FROZEN_NAME,  # number of the variable's text
    FROZEN_VALUE,
) = _arguments(3)
(
    FIXED_STOP_AXIS,  # index of the axis in the channel
    FIXED_STOP_IS_ON,
    FIXED_STOP_LIMIT,  # mm, degrees between command and actual position
    FIXED_STOP_TICKS,  # how long it has to be exceeded
    FIXED_STOP_FROM,  # share of the block's length from which the axis is monitored
    FIXED_STOP_TO,  # and up to which
    FIXED_STOP_IS_NEEDED,  # 1: an axis that finds no stop is an error
) = _arguments(7)
(
    MEASURE_FUNCTION,  # as ``TECHNOLOGY_FUNCTION``
    MEASURE_TICKS,  # how long the function takes
    MEASURE_RESIDUAL,  # mm from the edge to where the function goes out
    MEASURE_HAS_VALUE,
    MEASURE_VALUE,
) = _arguments(5)
(
    TOUCH_PART,  # share of the block's length where the simulated probe touches; below 0: nowhere
    TOUCH_TICKS,  # ticks until it does, below 0: it does not
    TOUCH_LEVEL,  # value of HLI.PROBE that is the signal; or ``codes.FIXED_STOP_SIGNAL``
    TOUCH_CONTINUES,  # 1: the motion continues to its target after the signal (G106)
    TOUCH_IS_NEEDED,  # 1: a signal that does not come is an error
    TOUCH_MAY_BE_PRESSED,  # 1: a probe that is pressed at the start ends the block there
) = _arguments(6)
(
    HOMED_AXIS,  # number in the machine
    HOMING_DISTANCE,  # mm, degrees; REFER: the position
    HOMING_SPEED,
) = _arguments(3)
# MOVE_ALONE: number in the machine; mm, degrees; mm/s, degrees/s; 1: VALUE is a distance
ALONE_AXIS, ALONE_VALUE, ALONE_SPEED, ALONE_IS_RELATIVE = _arguments(4)
(
    SWUNG_AXIS,  # number in the machine
    SWING_FIRST,  # mm, degrees
    SWING_SECOND,
    SWING_STROKE,  # the way from the first position to the second, with its sign
    SWING_SPEED,  # mm/s, degrees/s
    SWING_FIRST_TICKS,  # how long the axis waits there
    SWING_SECOND_TICKS,
    SWING_COUNT,  # how often the axis comes to the second position; -1: until it is ended
) = _arguments(8)
ENDED_AXIS, ENDED_HOW, ENDED_SPEED = _arguments(3)  # ``codes.FINISHES`` …; mm/s of ``RETURNS``
LIMITED_AXIS, LIMIT_LOW, LIMIT_HIGH = _arguments(3)  # number in the machine; mm, degrees
# COUPLE: numbers in the machine, no master: -1; mm or degrees of actual positions, 0: any
COUPLED_AXIS, COUPLED_TO, COUPLED_BY, COUPLED_WITHIN = _arguments(4)
FED_AXIS, FED_SHARE = _arguments(2)  # FEED_FORWARD: number in the machine
(
    SIGNAL_NUMBER,
    SIGNAL_RECEIVERS,  # mask of channels (``tick/signals.py``), 0: all
    SIGNAL_COUNT,  # how often it is taken, ``codes.ENDLESS_SIGNAL``
    SIGNAL_MASK,  # which of its values are given
    SIGNAL_FIRST_VALUE,  # the others follow
) = _arguments(5)
(
    AWAITED_SIGNAL,
    AWAITED_SENDERS,  # mask of channels, 0: a broadcast
    AWAITED_OVERTAKES,  # 1: out of the order of its sender
) = _arguments(3)
(
    REMOVED_LOW,
    REMOVED_HIGH,
    REMOVED_RECEIVERS,  # mask of channels, 0: broadcasts
    REMOVED_IS_RANGE,  # 1: all signals with these numbers, 0: the oldest
) = _arguments(4)

# --- segments of the path -------------------------------------------------------------------------

#: Columns of a segment. A queue and a path have rows of this width; those of a dwell are 0 there.
(
    LENGTH,  # from start to target
    # what was programmed
    MOTION,  # ``FEED_MOTION`` or ``RAPID_MOTION``
    SHAPE,  # ``LINE``, ``ARC``, ``ROUNDING`` or ``CUBIC``
    EXACT_STOP,  # 1: the path stops at its end
    CONTINUES,  # 1: its block continues with the next segment
    HAS_JERK_LIMIT,  # 1: the speed changes along an S-curve, 0: along a trapezoid
    DEVIATION,  # mm that the path may pass its target at
    TRANSFORMATION,  # number of the map from its positions to those of the axes; 0: they are these
    SHOWN_TRANSFORMATION,  # in the history: the map that MCS was shown by, 0: none
    SPEED,  # /s; of a rapid motion what its axes can do
    SPEED_OVERRIDE,  # programmed override as a factor, 0: no pace is given
    IGNORES_OVERRIDE,  # 1: the operator's override has no effect (G166)
    FEED_SPINDLE,  # index of the spindle that the feed follows (G95), plus 1; 0: none
    FEED_SPINDLE_SPEED,  # degrees/s at which ``SPEED`` counts
    THREAD,  # ``CUTTING`` or ``TAPPING``: coupled to the angle of that spindle; 0: not
    THREAD_TURN,  # degrees of the spindle for each mm, negative of a tapping left-hand thread
    THREAD_ANGLE,  # degrees: start angle of a cut thread; in the path: the spindle's at its start
    ARC_FIRST_AXIS,  # indices in the channel of the two axes of the plane
    ARC_SECOND_AXIS,
    ARC_FIRST_CENTRE,  # mm
    ARC_SECOND_CENTRE,
    ARC_ANGLE,  # degrees, negative clockwise
    CUBIC_LINEAR,  # parameter of a cubic by the part of its length: coefficients of a polynomial
    CUBIC_SQUARE,
    CUBIC_CUBE,
    CUBIC_FOURTH,
    CUBIC_FIFTH,
    # limits
    MAX_SPEED,  # /s
    ACCELERATION,  # /s²
    JERK,  # /s³, 0 without a limit of the jerk
    # from one segment to the next
    PREDECESSOR,  # how many commands back the segment is that it continues; 0: none
    CORNER_SPEED,  # /s, at which its end may be passed
    END_SPEED,  # /s at its end
    MAX_END_SPEED,  # /s at its end without regard to feeds
    NEXT_SPEED,  # ``SPEED`` of the next segment, 0: none; before it is known that at its end (E)
    NEXT_IGNORES_OVERRIDE,  # ``IGNORES_OVERRIDE`` of the next segment
    REMAINING_LENGTH,  # in the path: of its block after it, with a limit of the jerk
    REMAINING_SPEED,  # in the path: highest speed from which its block ends at a standstill
    # zones beside corners, where part of the acceleration is kept in reserve
    ENTRY_LENGTH,
    EXIT_LENGTH,
    ENTRY_ACCELERATION,
    EXIT_ACCELERATION,
    # a curve over the corner at the target
    CURVE_HALF,  # half its length, 0: none
    CURVE_SPEED,
    CURVE_ACCELERATION,
    # an arc whose limits go by its angle
    ARC_PIECES,  # number of pieces, 0: one acceleration for all of it
    ARC_ENTRY_SHARE,  # share of the acceleration that the corner at its begin uses
    ARC_EXIT_SHARE,  # that at its end
    ARC_SHARE,  # those that use it all along
    BACKWARD_SPEED,  # with which it is walked backward
    # the goal that the path slows down for, with a limit of the jerk
    GOAL_LENGTH,  # from its end
    GOAL_SPEED,
    GOAL_ACCELERATION,  # on this length
    GOAL_JERK,
    GOAL_KIND,  # ``LIMIT_GOAL`` …
    CARRIED_ACCELERATION,  # that the segments after it allow on it
    CARRIED_JERK,
    # the rounding that follows, with a limit of the jerk
    ROUNDING_LENGTH,  # 0: none
    ROUNDING_ACCELERATION,
    ROUNDING_JERK,
    # positions of the axes in mm or degrees, four columns for each axis: all starts, then all …
    START,  # … targets, then where the curve ends, then the corner that a rounding rounds; the …
    # … last two of a cubic: its inner control points
) = range(ARGUMENTS, ARGUMENTS + 61)

#: Pieces of an arc of 3° or more, of which the first and the last one are divided further:
#: ``MORE_PIECES`` more for that, and at most ``MAX_PIECES`` in all.
MORE_PIECES = 6
MAX_PIECES = 126

#: How many columns each axis has from ``START`` on.
POSITIONS_OF_AXIS = 4

#: An arc by itself: the columns of a segment from ``ARC_FIRST_AXIS`` on.
(
    PLANE_FIRST,
    PLANE_SECOND,
    CENTRE_FIRST,
    CENTRE_SECOND,
    ANGLE,
    ARC_WIDTH,
) = range(6)

#: A pace by itself: how many columns of a segment it has, from ``SPEED_OVERRIDE`` on.
FEED_MODIFIER_WIDTH = 7

#: Limits of ``#VECTOR LIMIT``, of feed blocks and of rapid ones each.
(
    VECTOR_SPEED,
    VECTOR_ACCELERATION,
    VECTOR_JERK,
    RADIAL_ACCELERATION,
    RADIAL_JERK,
    VECTOR_WIDTH,
) = range(6)

#: Values of ``MOTION``.
FEED_MOTION, RAPID_MOTION = range(2)

#: Values of ``THREAD``: the path follows the spindle (G33), or the spindle the path (G63, G331).
NO_THREAD, CUTTING, TAPPING = range(3)

#: Values of ``SHAPE``: an arc is a helix with further axes, a rounding rounds a corner with a limit
#: of the jerk, a cubic is a piece of a spline.
LINE, ARC, ROUNDING, CUBIC = range(4)

#: Values of ``GOAL_KIND``: how the override changes the goal's speed.
(
    LIMIT_GOAL,  # not at all: a corner, an axis or a standstill limits it
    FEED_GOAL,  # it is a feed
    EXEMPT_FEED_GOAL,  # it is a feed that the operator's override has no effect on
) = range(3)

# --- what a tick records --------------------------------------------------------------------------

#: Columns of an event.
(
    EVENT_TICK,
    EVENT_KIND,  # one of the kinds below
    EVENT_CHANNEL,  # number of the channel where the machine has several, else 0
    EVENT_SOURCE,  # where in the program's text it comes from; 0: nowhere
    EVENT_SUBJECT,  # serial of the realtime cycle, 0: none; or what is said at the kind
    EVENT_A,  # what is said at the kind
    EVENT_B,
    EVENT_C,
    EVENT_WIDTH,
) = range(9)

#: Kinds of events: what each has from ``EVENT_A`` on, and as its subject where that is no cycle.
(
    EVENT_CREATED,  # scope (``codes.BLOCK_SCOPE`` …)
    EVENT_STARTED,
    EVENT_HELD,
    EVENT_CONTINUED,
    EVENT_ABORTED,
    EVENT_ENDED,  # ``ENDED_BY_SCOPE`` …
    EVENT_FIRED,  # the source is the branch
    EVENT_WRITTEN,  # cell, new value; without a cycle the decoder has written
    EVENT_TECHNOLOGY_RT,  # function as in ``TECHNOLOGY_FUNCTION``, number within the tick
    EVENT_TECHNOLOGY,  # subject: whether it has a value; function, value
    EVENT_MESSAGE,  # subject: number of the text
    EVENT_ERROR,  # number of the message, detail; the source is the statement
    EVENT_PROGRAM_END,  # subject: number of the program
    EVENT_NOTICE,  # number of the message: diagnosis level 2
    EVENT_USER_ERROR,  # ID, RC
    EVENT_USER_VALUE,  # keyword as in ``VALUE_KEYWORD``, value
    EVENT_USER_TEXT,  # keyword, number of the text
    EVENT_AXIS_BEGUN,  # axis, target; without a cycle the PLC moves it
    EVENT_AXIS_ENDLESS,  # axis, direction
    EVENT_AXIS_ENDED,  # axis, ``MOTION_DONE`` …, of an aborted one ``WITH_CYCLE_…``
    EVENT_AXIS_CHANGED,  # axis, ``MOTION_HELD`` …, of a stopped one what is left to its target
    EVENT_SPINDLE,  # spindle, M function, revolutions per minute
    EVENT_SPINDLE_REACHED,  # spindle
    EVENT_SPINDLE_POSITION,  # spindle, degrees
    EVENT_FROZEN,  # number of the variable's text, value; the source is the access
    EVENT_BLOCK,  # subject: number of the block; tick in which it was decoded, open calls, depth
    EVENT_WAIT,  # subject: reason; cell; the source is what waits
    EVENT_LOOP,  # subject: ``LOOP_BEGUN`` …; the source is the loop
    EVENT_PROBED,  # length that is left of the block after the joint
    EVENT_FIXED_STOP,  # axis, position; the source is its command
    EVENT_RETRACED,  # subject: ``RETRACE_BACKWARD`` …; the source is the block
    EVENT_PAUSED,  # the source is what waits
    EVENT_STARVED,  # the source is the last command that was taken
    EVENT_FED,  # subject: ticks for which the queue was empty
    EVENT_OVERFLOW,  # subject: number of the thread
    EVENT_TIMER,  # timer, ``codes.TIMER_START`` …, the value in ms that READ latches
    EVENT_ACKNOWLEDGED,  # function, number within the tick of its output (0: program), that tick
    EVENT_DROPPED,  # the same, of a function that a reset ends
    EVENT_WRITTEN_TEXT,  # cell and part of a text, its characters as below
    EVENT_SIGNAL_SENT,  # subject: number; receivers as in ``SIGNAL_RECEIVERS``, count, 1: with SYN
    EVENT_SIGNAL_AWAITED,  # subject: number; senders, 0, 1: with SYN
    EVENT_SIGNAL_TAKEN,  # subject: number; its sender, tick in which it was sent, 1: with SYN
    EVENT_TOUCHED,  # length from the block's start to where the probe touches
    EVENT_AXIS_EXCHANGED,  # subject: axis; ``codes.AXIS_AWAITED`` …, who has it, spindle from 1
    EVENT_TOOL_LIFE,  # subject: text of the tool's ID; its number, seconds, mm
    EVENT_AXIS_OSCILLATES,  # axis, first position, second position
) = range(1, 47)

#: A text that a cycle writes is recorded in parts. The column of the cell is the cell plus this
#: number, twice for each earlier part and once more if another part follows.
TEXT_PART = 1073741824
#: Characters in each of the two columns after it, packed as a number to the base 256.
TEXT_HALF = 6

ENDED_BY_SCOPE, ENDED_BY_DELETE, ENDED_BY_RESET, ENDED_BY_ERROR = range(4)

LOOP_BEGUN, LOOP_SKIPPED, LOOP_LEFT = range(3)

#: Backward motion: its two directions, the start of the history, the front again.
RETRACE_BACKWARD, RETRACE_FORWARD, RETRACE_START, RETRACE_FRONT = range(4)

MOTION_DONE, MOTION_ABORTED, MOTION_FAILED = range(3)

#: What END_ACTION = MOVE_ABORT gives up with its cycle: a motion, an endless one, one that waits.
NOT_WITH_CYCLE, WITH_CYCLE, WITH_CYCLE_ENDLESS, WITH_CYCLE_WAITING = range(4)

MOTION_HELD, MOTION_CONTINUED, MOTION_STOPPED = range(3)

#: Columns of a probe row.
(
    PROBE_TICK,
    PROBE_KIND,  # one of the kinds below
    PROBE_NUMBER,  # of the condition, branch or cycle
    PROBE_LEFT,  # the two sides of a condition
    PROBE_RIGHT,
    PROBE_NEXT_TICK,  # of a series: the tick after the last one of the series before, -1: none
    PROBE_WIDTH,
) = range(7)

#: Kinds of probe rows: a condition is false or true from this tick on; after a tick without one a
#: series of evaluations begins in this tick, or one of run-throughs of a body.
PROBE_FALSE, PROBE_TRUE, PROBE_EVALUATED, PROBE_RAN = range(4)


#: The matrix of a turned coordinate system, row by row.
MATRIX_SIDE = 3
MATRIX_SIZE = 9


def segment_width(axis_count: int) -> int:
    """Return the number of columns of a queue over ``axis_count`` axes."""
    return START + POSITIONS_OF_AXIS * axis_count


def text_width(axis_count: int) -> int:
    """Number of characters that fit into one ``WRITE_TEXT``."""
    return segment_width(axis_count) - TEXT_CHARACTERS
