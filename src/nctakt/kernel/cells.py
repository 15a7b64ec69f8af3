# SPDX-License-Identifier: MIT
"""Where the realtime part publishes its values: cells of the memory, words of the image.

The order is that of the tables that others read by, which a test compares with these names.
``cells.pxd`` has the same names as constants of C; ``scripts/constants`` writes it from this file.
"""

from __future__ import annotations

# --- cells of the memory --------------------------------------------------------------------------

#: Cells of an axis, in the order of ``AXIS_VARIABLES`` in
#: ``nc/vocabulary/variables/realtime_variables.py``.
(
    AXIS_ACS_ACT_POS,
    AXIS_ACS_CUR_POS,
    AXIS_ACS_CMD_POS,
    AXIS_MCS_ACT_POS,
    AXIS_MCS_CUR_POS,
    AXIS_MCS_CMD_POS,
    AXIS_MCS_DIST_TO_GO,
    AXIS_PCS_ACT_POS,
    AXIS_PCS_CUR_POS,
    AXIS_PCS_CMD_POS,
    AXIS_PCS_DIST_TO_GO,
    AXIS_IPO_ACT_POS,
    AXIS_IPO_CUR_POS,
    AXIS_IPO_CMD_POS,
    AXIS_IPO_DIST_TO_GO,
    AXIS_OVERRIDE_VEL_CYCLE,
    AXIS_OVERRIDE_VEL_TOTAL,
    AXIS_FIXED_STOP_ACTIVE,
    AXIS_FIXED_STOP_DETECTED,
    AXIS_FIXED_STOP_ACS_POS,
    AXIS_STATE,
    AXIS_CELLS,
) = range(22)

#: Cells of a coordinate system of an axis: MCS, PCS and IPO.
SYSTEM_ACT_POS, SYSTEM_CUR_POS, SYSTEM_CMD_POS, SYSTEM_DIST_TO_GO, SYSTEM_CELLS = range(5)

#: Cells of a channel, in the order of ``CHANNEL_VARIABLES`` in
#: ``nc/vocabulary/variables/realtime_variables.py``; the timers are at the end.
(
    CHANNEL_OVERRIDE_VEL_CYCLE,
    CHANNEL_OVERRIDE_VEL_TOTAL,
    CHANNEL_CYCLES_DIAG_LEVEL,
    CHANNEL_MEAS_DELTA,
    CHANNEL_LOOP_ENABLED,
    CHANNEL_LOOP_COUNT,
    CHANNEL_PATH_SPEED,
    CHANNEL_BLOCK,
    CHANNEL_CYCLES_ACTIVE,
    CHANNEL_PATH_DIST_TO_GO,
    CHANNEL_PATH_RAPID,
    CHANNEL_TOOL_DIRECTION_X,
    CHANNEL_TOOL_DIRECTION_Y,
    CHANNEL_TOOL_DIRECTION_Z,
    CHANNEL_TIMER,
) = range(15)

#: Timers of a channel.
TIMERS = 128

#: Cells of the operator's panel, in the order of ``PANEL``, ``LAMPS`` and ``TOOLS`` in
#: ``hli/layout.py``.
(
    PANEL_OVERRIDE,
    PANEL_FEED_HOLD,
    PANEL_SINGLE_BLOCK,
    PANEL_START,
    PANEL_RESET,
    PANEL_PLC_PRESENT,
    PANEL_BACKWARD_MOTION,
    PANEL_PROBE,
    PANEL_OPTIONAL_STOP,
    PANEL_WATCHDOG,
    PANEL_ALIVE,
    PANEL_SEARCH_TYPE,
    PANEL_SEARCH_BLOCK,
    PANEL_SEARCH_PASS,
    PANEL_STATE,  # the lamps begin
    PANEL_PAUSED,
    PANEL_ARMED,
    PANEL_ERROR,
    PANEL_RETRACE,
    PANEL_HISTORY,
    PANEL_INSIDE_RT_LOOP,
    PANEL_HISTORY_SIZE,
    PANEL_TOOL_TIME,
    PANEL_TOOL_DISTANCE,
    PANEL_LIFE_SERIAL,
    PANEL_LIFE_TOOL,
    PANEL_LIFE_TIME,
    PANEL_LIFE_DISTANCE,
    PANEL_ERROR_SERIAL,
    PANEL_TOOLS,  # the cells of ``TOOLS`` begin
) = range(30)
#: All cells of a panel, those of the tool manager included.
PANEL_CELLS = 74

#: Cells of a spindle, in the order of ``SPINDLE_VALUES`` in
#: ``nc/vocabulary/variables/realtime_variables.py``.
SPINDLE_SPEED, SPINDLE_POSITION, SPINDLE_OVERRIDE, SPINDLE_CELLS = range(4)

# --- the interface image --------------------------------------------------------------------------

#: A unit of a technology function in int32, as ``UNIT`` in ``hli/layout.py``.
(
    UNIT_SERIAL,
    UNIT_LETTER,
    UNIT_NUMBER,
    UNIT_SEQUENCE,
    UNIT_AXIS,
    UNIT_VALUE,
    UNIT_IDENTIFIER,
    UNIT_SYNCHRONISATION,
    UNIT_TIMES,  # the words below begin
) = range(9)
UNIT_WIDTH = 12

#: The identifier of a unit: who has commanded it.
IDENTIFIER_PROGRAM, POS_RT = range(1, 3)

#: The synchronisation type of functions from a realtime cycle: output, and no wait.
MOS = 1

#: The letters of a unit.
LETTER_M, LETTER_H, LETTER_T = range(1, 4)

#: The job of a spindle in int32, from ``job`` of ``SPINDLE`` in ``hli/layout.py`` on.
(
    SPINDLE_JOB,
    SPINDLE_JOB_FUNCTION,
    SPINDLE_JOB_DIRECTION,
    SPINDLE_JOB_GAP,
    SPINDLE_JOB_TIMES,  # the words below begin
) = range(5)

#: Direction of a spindle's job back to a position.
SPINDLE_JOB_BACKWARD = 2

#: Words of 8 bytes of both; the last two of a spindle's job only.
IMAGE_TIME, IMAGE_DURATION, IMAGE_SPEED, IMAGE_POSITION = range(4)

#: Words of the clock of the image: sequence and tick.
CLOCK_SEQUENCE, CLOCK_TICK = range(2)

# --- bytes of the interface by the controller's names ---------------------------------------------

#: Bytes of a technology unit: flags, kind of the function, data.
TECHNO_PLEASE, TECHNO_DONE, TECHNO_TYPE = 0, 1, 2
TECHNO_DATA, TECHNO_DATA_BYTES = 8, 40
#: Units of one area at most.
TECHNO_UNITS = 20
#: Kinds of functions.
TECHNO_M, TECHNO_H, TECHNO_S, TECHNO_T = range(1, 5)
#: Bytes of the data of M and H functions.
TECHNO_NUMBER, TECHNO_TIME, TECHNO_VALUE, TECHNO_MODE = 0, 4, 16, 24
#: Bytes of the data of a spindle's function.
TECHNO_POSITION, TECHNO_SPEED = 0, 4
#: Units of the interface: 0.0001°; 0.001°/s in a degree/s.
TECHNO_ANGLE, TECHNO_ROTATION = 10_000, 1_000
#: The mode that is simulated, and its states.
MODE_AUTOMATIC = 2
MODE_DESELECTED, MODE_SELECTED, MODE_READY, MODE_ACTIVE, MODE_HOLD, MODE_ERROR = range(1, 7)
MODE_RESETTING = 15
