# SPDX-License-Identifier: MIT
"""Layout of values in memory, endings of statements, numbers of relations and functions."""

#: A value in memory: its width, and whether it is signed, a truth or a real number (ST-301).
BOOL, I8, I16, I32, I64, U8, U16, U32, U64, F32, F64 = range(11)

#: How a statement ends: the next one follows; a fault; EXIT, CONTINUE, RETURN (ST-513).
GOES_ON, STOPS, EXITS, CONTINUES, RETURNS = range(5)

#: Result of a branch that is not taken.
NOT_TAKEN = -1

#: Operands that parents evaluate in place instead of calling: constants, variables by the base of
#: their offsets, and, where an address is needed, places; all others are computed.
INSTANCE_PLACE, FRAME_PLACE, COMPUTED, CONSTANT, IN_DATA, IN_FRAME, IN_INSTANCE = range(-2, 5)

#: Operators of assignments that change a variable: ``a[i] := a[i] + x``.
ADD, SUBTRACT, AND, OR = range(4)

#: Operations of a link in a chain of real numbers; subtract the number from the operand; round the
#: number to REAL. Of operands that are REAL, the numbers are twice these and one.
LINK_ADD, LINK_SUBTRACT, LINK_SUBTRACT_FROM, LINK_MULTIPLY, LINK_ROUND = range(5)
#: Words of a link: where the offset of its operand counts from (0: it is the link's constant), the
#: offset, the operation, the constant.
LINK_SOURCE, LINK_OFFSET, LINK_OPERATION, LINK_CONSTANT = range(4)
LINK_WIDTH = 4

#: Relations of two values.
EQUAL, NOT_EQUAL, LESS, LESS_EQUAL, GREATER, GREATER_EQUAL = range(6)

#: Shifts and rotations (ST-714).
SHIFT_LEFT, SHIFT_RIGHT, ROTATE_LEFT, ROTATE_RIGHT = range(4)

#: How a real number becomes whole: nearest, half away from zero, or cut towards zero (ST-307).
NEAREST, TOWARDS_ZERO = range(2)

#: Functions of a real number (ST-712).
ABS, SQRT, LN, LOG, EXP, SIN, COS, TAN, ASIN, ACOS, ATAN, FLOOR, CEIL, FRAC, LTRUNC = range(15)

#: Functions of two real numbers.
EXPT, ATAN2, LMOD, MODABS = range(4)

#: Text functions (ST-711).
CONCAT, INSERT, DELETE, REPLACE, LEFT, RIGHT, MID = range(7)
#: Bytes of the longest text that the text functions work on, and of a kept result.
MAX_TEXT = 255
TEXT_BYTES = 256

#: How a whole number is written.
SIGNED, UNSIGNED, TRUTH, HEXADECIMAL, LENGTH, FINE_LENGTH, CLOCK, DAY, MOMENT = range(9)
#: Parts of a point in time that a text shows.
TIME_OF_DAY, DATE, DATE_AND_TIME = range(3)

#: Faults at run time (ST-560).
DIVISION = 902265
INDEX = 902266
#: A fault of an index packs the bounds of the array: the lowest index times this, plus the count.
BOUND = 1 << 32
PLACE = 902267
STACK = 902268
BUDGET = 902269
CONVERSION = 902270
INVALID = 902260
STEP = 902271
RAISED = 902360
#: No fault: a debugger has halted the tick before a statement (``probes.py``).
HALTED = 1
#: Words of a call on the way to a fault: its source, and instance and frame of its caller.
TRAIL_WIDTH = 3

#: Bytes reserved after the memory: offsets of accesses without a check are smaller.
SLACK = 65536
#: No object lies below, so that a null pointer with a small offset is found.
NULL_BYTES = 4096
#: Calls within calls (ST-407).
MAX_DEPTH = 200
#: The largest memory of a PLC, in bytes.
MAX_MEMORY = 1 << 30
#: Maximum numbers: bytes that a PLC gets from outside in one cycle, variables that are signals.
MAX_INPUTS = 4096
MAX_OUTPUTS = 256
#: Maximum number of counted conditions and bodies in one project.
MAX_COUNTS = 1 << 22
#: Notes of what led to a change (``notes.py``): rows on the stack, watched variables, words of the
#: log, changes of a variable that it keeps, words before the rows of a change, and among them the
#: number of the rows and of the change; markers that the rows from a row on belong to a finished
#: statement, or to a call that has returned.
NOTE_ROWS = 512
MAX_WATCHES = 16384
NOTE_LOG = 1 << 20
NOTES_KEPT = 50
NOTE_HEAD = 8
NOTE_ROW_COUNT = 5
NOTE_NUMBER = 7
NOTE_CLOSED = -1
NOTE_RETURNED = -2
NOTES_CUT = 1
NOTES_FIRST = 2
#: The source of writes by MEMCPY and the like.
NOT_A_STATEMENT = -1

#: Queries of code about an axis or a command.
(
    AXIS_ANSWER,
    AXIS_OPEN,
    AXIS_ACTIVE,
    AXIS_ARRIVED,
    AXIS_AT_SPEED,
    AXIS_FAULT,
    AXIS_STATE,
    AXIS_POWERED,
    AXIS_INDEX,
    AXIS_HOMES,
    AXIS_IS_HOMED,
    AXIS_SHOWN_STATE,
) = range(12)
#: Positions of an axis that code reads: command position, actual position, target.
AXIS_MEASURES = 3
#: The limits of an axis, numbers after those.
(
    AXIS_HIGH,
    AXIS_LOW,
    AXIS_SPEED_LIMIT,
    AXIS_ACCELERATION_LIMIT,
    AXIS_JERK_LIMIT,
) = range(3, 8)
#: Lag, actual and commanded speed, actual and commanded acceleration, numbers after those.
(
    AXIS_LAG,
    AXIS_ACTUAL_SPEED,
    AXIS_SET_SPEED,
    AXIS_ACTUAL_ACCELERATION,
    AXIS_SET_ACCELERATION,
) = range(8, 13)
#: Values of an axis that are noted in each tick.
(
    NOTED_ACTUAL_SPEED,
    NOTED_SET_SPEED,
    NOTED_ACTUAL_ACCELERATION,
    NOTED_SET_ACCELERATION,
    NOTED_ACTUAL,
    NOTED_COMMAND,
    AXIS_NOTES,
) = range(7)

#: How an element of the interface shows a value: scaled, where it is a number or is not, by a table
#: of numbers.
SCALED, EQUALS, DIFFERS, MAPPED = range(4)
#: Entries of a table of numbers.
MAPPED_NUMBERS = 16

#: A row for the interface of a channel apart from numbers and control units: addresses first, then
#: cells, then the area.
(
    RECORD_MODE,
    RECORD_STATE,
    RECORD_SEMAPHORE,
    RECORD_ENABLE,
    RECORD_ERROR,
    RECORD_STATE_CELL,
    RECORD_PAUSED_CELL,
    RECORD_HOLD_CELL,
    RECORD_ARMED_CELL,
    RECORD_ERROR_CELL,
    RECORD_SERIAL_CELL,
    RECORD_AREA,
    RECORD_WIDTH,
) = range(13)
#: Numbers of a row of an axis' releases.
RELEASE_WIDTH = 8

#: A command of the interface: none, taken from the PLC, in force.
NOT_COMMANDED, COMMANDED, IN_FORCE = range(3)
