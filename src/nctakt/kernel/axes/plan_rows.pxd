# SPDX-License-Identifier: MIT
# The numbers of plan_rows.py as constants of C; written by `scripts/constants`.
cdef enum:
    PLAN_LAST = 0
    PLAN_DURATION = 1
    PLAN_PHASE = 2
    PLAN_PHASES = 3
    PHASE_TIME = 0
    PHASE_DISTANCE = 1
    PHASE_SPEED = 2
    PHASE_ACCELERATION = 3
    PHASE_JERK = 4
    PHASE_WIDTH = 5
    MAX_PHASES = 9
    PLAN_WIDTH = 48
