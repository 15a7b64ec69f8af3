# SPDX-License-Identifier: MIT
"""The columns of the rows that the path of the tool's centre is made of (``pieces.py`` …).

A motion of the contour and a piece of the tool's path are rows of float64: lengths in mm, angles in
degrees. ``rows.pxd`` has the same names as constants of C; ``scripts/constants`` writes it from
this file.
"""

from __future__ import annotations

#: Columns of both.
(
    START_X,
    START_Y,
    END_X,
    END_Y,
    SHAPE,  # ``LINE``, ``ARC``, ``GAP`` or ``LOOP_END``
    CENTRE_X,  # of an arc
    CENTRE_Y,
    ANGLE,  # of an arc, negative clockwise; else 0
    RADIUS,  # of an arc
    FURTHER,  # the columns below begin
) = range(10)

#: Values of ``SHAPE``; ``NOTHING`` means that there is no piece.
(
    NOTHING,
    LINE,
    ARC,
    GAP,  # between two pieces that do not meet
    LOOP_END,  # the row after a loop that was left out
) = range(-1, 4)

#: Further columns of a piece.
(
    MOTION,  # running number of the motion that it belongs to
    IS_CONTOUR,  # 1: part of a contour; 0: it leads there or comes from there
    MIN_X,  # its bounds
    MAX_X,
    MIN_Y,
    MAX_Y,
    CROSSED,  # the motion whose path it crosses, 0 none
    PIECE_WIDTH,
) = range(FURTHER, FURTHER + 8)

#: Further columns of a motion.
(
    START_DISTANCE,  # of the tool, to the left; both 0: it leads to a contour or from it
    END_DISTANCE,
    START_COSINE,  # its direction at the start and at the end
    START_SINE,
    END_COSINE,
    END_SINE,
    TOOL_X,  # where the tool begins it
    TOOL_Y,
    IS_TOO_SMALL,  # 1: an arc that is too small for the tool
    IS_OF_CONTOUR,  # 1: part of a contour
    MOTION_WIDTH,
) = range(FURTHER, FURTHER + 11)

#: The rows of the motions: two known ones in turn, then the first one of the contour.
SECOND_MOTION = MOTION_WIDTH
FIRST_OF_CONTOUR = 2 * MOTION_WIDTH
MOTIONS = 3

#: Columns of the end of an arc that the tool does not fit into.
(
    HIDDEN_X,
    HIDDEN_Y,
    HIDDEN_RADIUS,
    HIDDEN_MOTION,  # running number of its motion
    HIDDEN_WIDTH,
) = range(5)

#: How many of them are known at most.
MAX_HIDDEN = 64

#: Number of earlier motions that a new path is compared with; with ``Chain.masks`` the path of as
#: many motions is held back.
REACH = 50

#: Capacity in pieces: two reaches, with everything that can join two motions; after them as many
#: pieces of loops that were left out, each loop followed by a row.
ROOM = 1024

#: Pieces from which on those are forgotten that are neither compared nor waited for; up to how many
#: the path may be led around a loop again.
MANY = 500
FULL = 1000

#: Values of ``IS_OF_CONTOUR``: not compared, part of the contour, leads to it or from it.
NO_CONTOUR, OF_CONTOUR, LEADS = range(3)

#: Pieces of the motion to a contour that are kept.
MAX_LEADING = 4
