# SPDX-License-Identifier: MIT
"""The numbers of the rows that the realtime part works on: kinds and columns, once and in order.

A command of the queue is a row of float64, and so is a segment of the path. ``rows.pxd`` has the
same names as constants of C; ``scripts/constants`` writes it from this file. Lengths along the path
are mm (degrees where only rotary axes move), ``/s``, ``/s²`` and ``/s³`` their derivatives in time.
"""

from __future__ import annotations

from typing import NamedTuple

from nctakt.kernel import codes

# --- commands of the queue ------------------------------------------------------------------------

#: The first columns of each command; the arguments of its kind begin at ``ARGUMENTS``.
(
    KIND,  # one of the kinds below
    SOURCE,  # where in the program's text it comes from, a number of ``base/source_ids.py``
    BLOCK_NUMBER,  # the N word of its block, 0 without one
    ARGUMENTS,
) = range(4)


#: Contents of a column of a command; ``tick/command_bounds.py`` has the bounds of each.
(
    HOLDS_NUMBER,  # without bounds
    HOLDS_CELL,  # of the memory
    HOLDS_SLOT,  # of the cycle manager
    HOLDS_TIMER,
    HOLDS_SPINDLE,  # index in the channel
    HOLDS_MEMBER,  # index of an axis in the channel
    HOLDS_AXIS,  # number in the machine
    HOLDS_AXIS_OR_NONE,  # the same, -1: none
    HOLDS_AXIS_FROM_1,  # the same plus 1, 0: none
    HOLDS_OFFSET,  # ``codes.ZERO_OFFSET`` …
    HOLDS_MAP,  # number of a map
) = range(11)


class CommandRecord(NamedTuple):
    """Properties of a kind of command, for the queue.

    ``columns``: the contents of its arguments' columns, from ``ARGUMENTS`` on. ``min_length``: that
    of its row. ``is_timed``: it takes or may take time. ``is_transparent``: the path passes it
    between two blocks without a stop.
    """

    columns: tuple[int, ...]
    min_length: int
    is_timed: bool
    is_transparent: bool


#: Properties of each kind, for the queue.
COMMANDS: dict[int, CommandRecord] = {}


def _command(
    *columns: int,
    timed: bool = False,
    transparent: bool = False,
    needs: int | None = None,
) -> list[int]:
    """Declare a kind of command; return its number, from 1 on, and the columns of its arguments.

    ``needs``: the number of arguments that each row of it has, all columns where nothing is said.
    """
    kind = len(COMMANDS) + 1
    min_length = ARGUMENTS + (len(columns) if needs is None else needs)
    COMMANDS[kind] = CommandRecord(columns, min_length, timed, transparent)
    return [kind, *range(ARGUMENTS, ARGUMENTS + len(columns))]


# Each kind of command with the columns of its arguments, 0 is none; new kinds come last. A column
# shared by several kinds has the same number in all of them.
(SEGMENT,) = _command(timed=True, transparent=True)  # the path moves; its columns are below
(
    DWELL,  # the path is at rest
    DWELL_TICKS,
) = _command(HOLDS_NUMBER, timed=True)
(
    DEFINE_CYCLE,  # a realtime cycle is defined, and started
    CYCLE_SLOT,
    CYCLE_STARTS,  # 1: started at once
) = _command(HOLDS_SLOT, HOLDS_NUMBER, transparent=True)
(
    CONTROL_CYCLE,  # START, HOLD, CONTINUE, ABORT ACTION, DELETE
    CONTROL_ACTION,  # ``codes.CONTROL_START`` …
    CONTROL_IDENTITY,  # the cycle's programmed ID
) = _command(HOLDS_NUMBER, HOLDS_NUMBER, transparent=True)
(
    TECHNOLOGY,  # an M, H or T function goes to the PLC
    TECHNOLOGY_FUNCTION,  # its code (``hli/function_codes.py``)
    TECHNOLOGY_TICKS,  # how long the function takes
    TECHNOLOGY_HAS_VALUE,
    TECHNOLOGY_VALUE,
    TECHNOLOGY_LEAD,  # mm or s that it goes out before the path comes to it, 0: not before
    TECHNOLOGY_LEAD_KIND,  # ``codes.LEAD_DISTANCE`` …
) = _command(*6 * (HOLDS_NUMBER,), transparent=True)
(
    AWAIT_ACKNOWLEDGE,  # waits until the PLC has acknowledged the function
    AWAITED_FUNCTION,  # as ``TECHNOLOGY_FUNCTION``
) = _command(HOLDS_NUMBER, timed=True)
(
    WRITE_VARIABLE,  # a number goes into a cell
    VARIABLE_CELL,
    VARIABLE_VALUE,
    VARIABLE_IS_REPORTED,  # 1: the write is an event
) = _command(HOLDS_CELL, HOLDS_NUMBER, HOLDS_NUMBER, transparent=True)
(
    WRITE_TEXT,  # part of a character string goes into its cells
    TEXT_CELL,  # first cell of the string
    TEXT_FIRST,  # byte of the string where the characters go
    TEXT_COUNT,  # number of characters
    TEXT_ZEROS,  # number of zeros after them
    TEXT_CHARACTERS,  # the first character; the others follow
) = _command(*5 * (HOLDS_NUMBER,), needs=4, transparent=True)
(
    MESSAGE,  # #MSG
    MESSAGE_TEXT,  # number of the text
) = _command(HOLDS_NUMBER, transparent=True)
(
    FLUSH,  # waits until the path is at rest
    IS_ANSWERED,  # 1: the decoder waits
) = _command(HOLDS_NUMBER, timed=True)
(
    READ,  # waits until the path is at rest, and answers with the value of a cell
    IS_ANSWERED,
    READ_CELL,
) = _command(HOLDS_NUMBER, HOLDS_CELL, timed=True)
(
    POSITIONS,  # waits until the path and some axes are at rest: a position request
    IS_ANSWERED,
    POSITIONS_COUNT,  # number of the axes that have to be at rest, too
    POSITIONS_AXES,  # the first of their numbers in the machine; the others follow
) = _command(*3 * (HOLDS_NUMBER,), needs=2, timed=True)
(
    PROGRAM_END,  # M30
    PROGRAM_NUMBER,
) = _command(HOLDS_NUMBER, timed=True)
(
    GIVE_UP,  # the channel stops with an error of the decoder
    GIVE_UP_MESSAGE,  # number of the message
) = _command(HOLDS_NUMBER, timed=True)
(
    USER_ERROR,  # #ERROR; its values follow as separate commands
    ERROR_IDENTITY,
    ERROR_REACTION,  # RC
) = _command(HOLDS_NUMBER, HOLDS_NUMBER, transparent=True)
(
    USER_VALUE,  # a number that is reported with an #ERROR
    VALUE_KEYWORD,  # index of the keyword in ``nc/check/user_errors.py``
    VALUE_NUMBER,
) = _command(HOLDS_NUMBER, HOLDS_NUMBER, transparent=True)
(
    USER_TEXT,  # a text that is reported with an #ERROR
    USER_TEXT_KEYWORD,  # as ``VALUE_KEYWORD``
    USER_TEXT_NUMBER,  # number of the text
) = _command(HOLDS_NUMBER, HOLDS_NUMBER, transparent=True)
(
    USER_STOP,  # the #ERROR before stops the channel
    STOP_REACTION,  # RC
) = _command(HOLDS_NUMBER, timed=True)
(
    SPINDLE,  # a job for a spindle
    JOB_SPINDLE,
    JOB_FUNCTION,  # 3, 4, 5 or 19
    JOB_SPEED,  # degrees/s
    JOB_POSITION,  # degrees
    JOB_DIRECTION,  # 1, -1; 0: the shorter way
    JOB_TICKS,  # how long the default PLC takes
    JOB_IGNORES_OVERRIDE,  # 1: the operator's override has no effect (G167)
) = _command(HOLDS_SPINDLE, *6 * (HOLDS_NUMBER,), transparent=True)
(
    AWAIT_SPINDLE,  # waits until a spindle's job is done
    JOB_SPINDLE,
) = _command(HOLDS_SPINDLE, timed=True)
(
    BLOCK_MARK,  # a block begins
    MARK_TICK,  # tick in which the block was decoded
    MARK_CALLS,  # number of the open calls (``run/realtime/event_registry.py``)
    MARK_DEPTH,  # how many programs are open, from 1
) = _command(*3 * (HOLDS_NUMBER,), transparent=True)
(
    WAIT_MARK,  # why the next command empties the channel
    WAIT_REASON,  # ``decoder/state/queued/commands.py``
    WAIT_CELL,  # the variable, 0 for none
) = _command(HOLDS_NUMBER, HOLDS_NUMBER, transparent=True)
(
    TIMER,  # #TIMER … SYN
    TIMER_NUMBER,
    TIMER_ACTION,  # ``codes.TIMER_START`` …
) = _command(HOLDS_TIMER, HOLDS_NUMBER, transparent=True)
(
    SET_OFFSET,  # another value of an offset of an axis
    OFFSET_AXIS,
    OFFSET_KIND,  # ``codes.ZERO_OFFSET`` …
    OFFSET_VALUE,  # mm, degrees
) = _command(HOLDS_AXIS, HOLDS_OFFSET, HOLDS_NUMBER, transparent=True)
(
    SET_ORIGIN,  # the origin of the program's coordinate system on an axis
    ORIGIN_AXIS,
    ORIGIN_VALUE,  # mm, degrees
) = _command(HOLDS_AXIS, HOLDS_NUMBER, transparent=True)
(
    SET_TURN,  # the rotation of the program's coordinate system
    TURN_FIRST,  # first axis
    TURN_SECOND,  # 0: nothing is turned
    TURN_THIRD,
    TURN_MATRIX,  # the first of nine numbers, row by row
) = _command(
    HOLDS_AXIS, HOLDS_AXIS_FROM_1, HOLDS_AXIS_FROM_1, HOLDS_NUMBER, needs=1, transparent=True
)
(
    SET_TRANSFORMATION,  # the transformation that is active from here on
    TRANSFORMATION_NUMBER,  # of its map; 0: none
    TRANSFORMATION_OF_SEGMENTS,  # the map of the segments after it; 0: they are those of the axes
) = _command(HOLDS_MAP, HOLDS_MAP)
(
    PROGRAM_STOP,  # M00, M01
    STOP_IS_OPTIONAL,  # M01
) = _command(HOLDS_NUMBER, timed=True)
(
    FREEZE,  # a variable became a constant of the realtime cycle before it
    FROZEN_CYCLE,  # serial of the cycle
    FROZEN_NAME,  # number of the variable's text
    FROZEN_VALUE,
) = _command(*3 * (HOLDS_NUMBER,), transparent=True)
(LOOP_BEGIN,) = _command()  # #RT WHILE
(LOOP_PASS,) = _command(transparent=True)  # the end of each pass
(
    LOOP_END,  # #RT ENDWHILE
    IS_ANSWERED,
) = _command(HOLDS_NUMBER, timed=True)
(
    FIXED_STOP,  # an axis is monitored for a fixed stop from here on, or no longer
    FIXED_STOP_AXIS,
    FIXED_STOP_IS_ON,
    FIXED_STOP_LIMIT,  # mm, degrees between command and actual position
    FIXED_STOP_TICKS,  # how long it has to be exceeded
    FIXED_STOP_FROM,  # share of the block's length from which the axis is monitored
    FIXED_STOP_TO,  # and up to which
    FIXED_STOP_IS_NEEDED,  # 1: an axis that finds no stop is an error
) = _command(HOLDS_MEMBER, *6 * (HOLDS_NUMBER,))
(FIXED_STOP_END,) = _command(timed=True)  # the block that moves to a fixed stop is over
(
    MEASURE,  # the next motion looks for an edge
    MEASURE_FUNCTION,  # as ``TECHNOLOGY_FUNCTION``
    MEASURE_TICKS,  # how long the function takes
    MEASURE_RESIDUAL,  # mm from the edge to where the function goes out
    MEASURE_HAS_VALUE,
    MEASURE_VALUE,
) = _command(*5 * (HOLDS_NUMBER,))
(MEASURE_END,) = _command(timed=True)  # the motion that looks for an edge is over
(CLEAR_HISTORY,) = _command(transparent=True)  # #BACKWARD STORAGE CLEAR
(EMPTY_BLOCK,) = _command(transparent=True)  # a block whose motion or dwell takes no tick
(
    SIGNAL,  # #SIGNAL SYN
    SIGNAL_NUMBER,
    SIGNAL_RECEIVERS,  # mask of channels (``tick/signals.py``), 0: all
    SIGNAL_COUNT,  # how often it is taken, ``codes.ENDLESS_SIGNAL``
    SIGNAL_MASK,  # which of its values are given
    SIGNAL_FIRST_VALUE,
    *_OTHER_VALUES,
) = _command(*(4 + codes.SIGNAL_VALUES) * (HOLDS_NUMBER,), transparent=True)
(
    AWAIT_SIGNAL,  # #WAIT SYN
    AWAITED_SIGNAL,
    AWAITED_SENDERS,  # mask of channels, 0: a broadcast
    AWAITED_OVERTAKES,  # 1: out of the order of its sender
) = _command(*3 * (HOLDS_NUMBER,), timed=True)
(
    REMOVE_SIGNAL,  # #SIGNAL REMOVE SYN
    REMOVED_LOW,
    REMOVED_HIGH,
    REMOVED_RECEIVERS,  # mask of channels, 0: broadcasts
    REMOVED_IS_RANGE,  # 1: all signals with these numbers, 0: the oldest
) = _command(*4 * (HOLDS_NUMBER,), transparent=True)
(
    MODAL_MARK,  # other functions are in force from here on
    MODAL_NUMBER,  # of the values in force
) = _command(HOLDS_NUMBER, transparent=True)
(
    CUTTING_SPEED,  # G96, G97: the speed of a spindle follows an axis, or no longer
    CUTTING_SPINDLE,
    CUTTING_SURFACE,  # mm/s that the surface has at the tool; 0: off
    CUTTING_AXIS,  # the face axis
    CUTTING_CENTRE,  # mm: where that axis has the radius 0
    CUTTING_LIMIT,  # highest speed, degrees/s; 0: only that of the spindle
) = _command(HOLDS_SPINDLE, HOLDS_NUMBER, HOLDS_AXIS, HOLDS_NUMBER, HOLDS_NUMBER, transparent=True)
(
    SPINDLE_LIMITS,  # a spindle gets those of its tool when it starts from standstill; 0: none
    LIMITED_SPINDLE,
    LIMITED_LOW,  # least speed, degrees/s
    LIMITED_HIGH,  # highest speed
    LIMITED_ACCELERATION,  # degrees/s²
    LIMITED_JERK,  # degrees/s³
    LIMITED_BY_GEAR,  # gear step whose limits they are, 0: those of the tool
) = _command(HOLDS_SPINDLE, *5 * (HOLDS_NUMBER,), transparent=True)
(
    TOUCH,  # the next motion measures with a touch probe (G100)
    TOUCH_PART,  # share of the block's length where the simulated probe touches; below 0: nowhere
    TOUCH_TICKS,  # ticks until it does, below 0: it does not
    TOUCH_LEVEL,  # value of HLI.PROBE that is the signal; or ``codes.FIXED_STOP_SIGNAL``
    TOUCH_CONTINUES,  # 1: the motion continues to its target after the signal (G106)
    TOUCH_IS_NEEDED,  # 1: a signal that does not come is an error
    TOUCH_MAY_BE_PRESSED,  # 1: a probe that is pressed at the start ends the block there
) = _command(*6 * (HOLDS_NUMBER,))
(TOUCH_END,) = _command()  # the motion that measures is over
(
    HOME,  # an axis begins to move to its zero pulse (G74)
    HOMED_AXIS,
    HOMING_DISTANCE,  # mm, degrees
    HOMING_SPEED,
) = _command(HOLDS_AXIS, HOLDS_NUMBER, HOLDS_NUMBER)
(
    REFER,  # the position where an axis is
    HOMED_AXIS,
    HOMING_DISTANCE,  # the position
) = _command(HOLDS_AXIS, HOLDS_NUMBER)
(
    SOFTWARE_LIMITS,  # others for the independent motions of an axis (G98, G99)
    LIMITED_AXIS,
    LIMIT_LOW,  # mm, degrees
    LIMIT_HIGH,
) = _command(HOLDS_AXIS, HOLDS_NUMBER, HOLDS_NUMBER, transparent=True)
(
    SINGLE_STEP,  # #SINGLE STEP
    STEP_IS_LOCKED,  # 1: disabled
    STEP_RESOLUTION,  # -1: not changed
) = _command(HOLDS_NUMBER, HOLDS_NUMBER, transparent=True)
(
    COUPLE,  # an axis follows another one from here on, or no longer
    COUPLED_AXIS,
    COUPLED_TO,
    COUPLED_BY,  # the factor
    COUPLED_WITHIN,  # mm or degrees between actual positions, 0: any
) = _command(HOLDS_AXIS, HOLDS_AXIS_OR_NONE, HOLDS_NUMBER, HOLDS_NUMBER)
(
    FEED_FORWARD,  # another share of the command speed bypasses a position control
    FED_AXIS,
    FED_SHARE,
) = _command(HOLDS_AXIS, HOLDS_NUMBER)
(
    TOOL_LIFE,  # of the tool on the path
    LIFE_ACTION,  # ``codes.LIFE_SENT`` …
    LIFE_TOOL,  # number of the text of the tool's ID
    LIFE_BASIC,  # the tool's number
    LIFE_TIME,  # seconds, or a factor
    LIFE_DISTANCE,  # mm, or a factor
) = _command(*5 * (HOLDS_NUMBER,), transparent=True)
(
    MOVE_ALONE,  # an axis moves independently of the path (INDP_SYN, INDP_ASYN)
    ALONE_AXIS,
    ALONE_VALUE,  # mm, degrees
    ALONE_SPEED,  # mm/s, degrees/s
    ALONE_IS_RELATIVE,  # 1: the value is a distance
) = _command(HOLDS_AXIS, *3 * (HOLDS_NUMBER,))
(
    OSCILLATE,  # an axis moves to and fro, independently of the path (OSC ON)
    SWUNG_AXIS,
    SWING_FIRST,  # mm, degrees
    SWING_SECOND,
    SWING_STROKE,  # the distance from the first position to the second, with its sign
    SWING_SPEED,  # mm/s, degrees/s
    SWING_FIRST_TICKS,  # how long the axis waits there
    SWING_SECOND_TICKS,
    SWING_COUNT,  # how often the axis comes to the second position; -1: until it is ended
) = _command(HOLDS_AXIS, *7 * (HOLDS_NUMBER,))
(
    END_OSCILLATION,  # OSC OFF
    ENDED_AXIS,
    ENDED_HOW,  # ``codes.FINISHES`` …
    ENDED_SPEED,  # mm/s of ``RETURNS``
) = _command(HOLDS_AXIS, HOLDS_NUMBER, HOLDS_NUMBER)
(
    SPINDLE_AXIS,  # a spindle gives its axis, or takes it again (S[PUTAX], S[CALLAX])
    GIVING_SPINDLE,
    GIVES_AXIS,  # 1: gives
) = _command(HOLDS_SPINDLE, HOLDS_NUMBER)

#: The kinds that take or may take time.
TIMED_KINDS = frozenset(kind for kind, record in COMMANDS.items() if record.is_timed)

#: The kinds that the path passes without a stop.
TRANSPARENT_KINDS = frozenset(kind for kind, record in COMMANDS.items() if record.is_transparent)


def is_timed(kind: int) -> bool:
    """Return whether a command of this kind takes or may take time; compiled: C in line."""
    return kind in TIMED_KINDS


def is_transparent(kind: int) -> bool:
    """Return whether the path passes a command of this kind; compiled: C in line."""
    return kind in TRANSPARENT_KINDS


# --- segments of the path -------------------------------------------------------------------------

#: Columns of a segment. A queue and a path have rows of this width; those of a dwell are 0 there.
(
    LENGTH,  # from start to target
    # the programmed values
    MOTION,  # ``FEED_MOTION`` or ``RAPID_MOTION``
    SHAPE,  # ``LINE``, ``ARC``, ``ROUNDING`` or ``CUBIC``
    EXACT_STOP,  # 1: the path stops at its end
    CONTINUES,  # 1: its block continues with the next segment
    HAS_JERK_LIMIT,  # 1: the speed changes along an S-curve, 0: along a trapezoid
    DEVIATION,  # mm that the path may pass its target at
    TRANSFORMATION,  # number of the map from its positions to those of the axes; 0: they are these
    SHOWN_TRANSFORMATION,  # in the history: the map that MCS was shown by, 0: none
    SPEED,  # /s; of a rapid motion the highest its axes can do
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
    # zones next to corners, where part of the acceleration is kept in reserve
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

# --- the record of a tick -------------------------------------------------------------------------

#: Columns of an event.
(
    EVENT_TICK,
    EVENT_KIND,  # one of the kinds below
    EVENT_CHANNEL,  # number of the channel where the machine has several, else 0
    EVENT_SOURCE,  # where in the program's text it comes from; 0: nowhere
    EVENT_SUBJECT,  # serial of the realtime cycle, 0: none; or as given at the kind
    EVENT_A,  # as given at the kind
    EVENT_B,
    EVENT_C,
    EVENT_WIDTH,
) = range(9)

#: Kinds of events: the values of each from ``EVENT_A`` on, and its subject if that is not a cycle.
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
    EVENT_AXIS_CHANGED,  # axis, ``MOTION_HELD`` …, of a stopped one the distance left to its target
    EVENT_SPINDLE,  # spindle, M function, revolutions per minute
    EVENT_SPINDLE_REACHED,  # spindle
    EVENT_SPINDLE_POSITION,  # spindle, degrees
    EVENT_FROZEN,  # number of the variable's text, value; the source is the access
    EVENT_BLOCK,  # subject: number of the block; tick in which it was decoded, open calls, depth
    EVENT_WAIT,  # subject: reason; cell; the source is the waiting statement
    EVENT_LOOP,  # subject: ``LOOP_BEGUN`` …; the source is the loop
    EVENT_PROBED,  # length that is left of the block after the joint
    EVENT_FIXED_STOP,  # axis, position; the source is its command
    EVENT_RETRACED,  # subject: ``RETRACE_BACKWARD`` …; the source is the block
    EVENT_PAUSED,  # the source is the waiting statement
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

#: Motions that END_ACTION = MOVE_ABORT aborts with their cycle: one to a target, an endless one, a
#: waiting one.
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
