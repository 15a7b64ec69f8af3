# SPDX-License-Identifier: MIT
"""The keywords of ``#SLOPE``, ``#CONTOUR MODE``, ``#VECTOR LIMIT`` and ``#HSC``."""

from __future__ import annotations

#: The slopes in the order of their numbers (P-CHAN-00071).
SLOPES = ("STEP", "TRAPEZ", "SIN2", "HSC")

#: The modes of ``#CONTOUR MODE`` that are simulated, each with the keywords of its size.
CONTOUR_MODES = {
    "DEV": ("PATH_DEV",),
    "AUTO_DEV": ("PATH_DEV",),
    "DIST": ("PRE_DIST", "POST_DIST"),
    "DIST_SOFT": ("PATH_DIST",),
    "DIST_MASTER": ("SYM_DIST",),
    "POS": ("PRE_DIST", "POST_DIST"),
    "PTP": ("PATH_DEV", "PATH_DIST"),
}
#: Modes whose curve depends on speeds by rules that are not public.
REFUSED_MODES = ("AUTO_VEL",)
#: When M and H functions of a rounded corner act.
PRE_ACTION, INTER_ACTION, POST_ACTION = ACTIONS = (
    "PRE_ACTION",
    "INTER_ACTION",
    "POST_ACTION",
)
#: Keywords of ``#CONTOUR MODE`` from 0 up to a highest value, in per cent and degrees.
CONTOUR_SHARES = {"REMAIN_PART": 100.0, "MAX_ANGLE": 180.0}
#: Further keywords of ``#CONTOUR MODE`` with a number.
CONTOUR_NUMBERS = (
    "REMAIN_PART",
    "MAX_ANGLE",
    "RELEVANT_PATH",
    "RELEVANT_TRACK",
    "TRACK_DEV",
    "TRACK_DIST",
    "ACC_MAX",
    "ACC_MIN",
    "RAMP_TIME",
    "DIST_WEIGHT",
    "MERGE",
    "CHECK_JERK",
    "CONST_VEL",
)

#: The limits of ``#VECTOR LIMIT``, and the blocks that they may be for.
VECTOR_LIMITS = ("VEL", "ACC", "DEC", "JERK", "RADIAL_ACC", "RADIAL_JERK", "TRANS_ACC")
VECTOR_BLOCKS = ("FEED", "RAPID")

#: The named curves of ``#HSC``, and the keywords of the unnamed one (OPMODE), all with a number.
HSC_CURVES = ("BSPLINE", "SURFACE")
HSC_MODES = ("OPMODE", "CONTERROR")
HSC_NUMBERS = (
    "PATH_DEV",
    "TRACK_DEV",
    "MERGE",
    "AUTO_OFF_PATH",
    "AUTO_OFF_TRACK",
    "AUTO_OFF_G00",
    "AUTO_OFF_G60",
    "MAX_PATH_LENGTH",
    "MAX_ANGLE",
    *HSC_MODES,
)
