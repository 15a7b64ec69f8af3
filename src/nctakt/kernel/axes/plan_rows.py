# SPDX-License-Identifier: MIT
"""Columns of the plans of single axes and spindles (``trajectory.py``); constants of C."""

from __future__ import annotations

#: Columns of a plan; the phases follow from ``PLAN_PHASES`` on.
(
    PLAN_LAST,  # number of the last phase, counted from 0
    PLAN_DURATION,  # s
    PLAN_PHASE,  # the phase of the last evaluation
    PLAN_PHASES,
) = range(4)

#: Columns of a phase of constant jerk: its start.
(
    PHASE_TIME,  # s
    PHASE_DISTANCE,  # mm, degrees
    PHASE_SPEED,  # /s
    PHASE_ACCELERATION,  # /s²
    PHASE_JERK,  # /s³
    PHASE_WIDTH,
) = range(6)

#: The most phases of a plan, and its columns.
MAX_PHASES = 9
PLAN_WIDTH = PLAN_PHASES + MAX_PHASES * PHASE_WIDTH
