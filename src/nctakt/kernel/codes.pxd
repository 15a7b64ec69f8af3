# SPDX-License-Identifier: MIT
# The numbers of codes.py as constants of C; written by `scripts/constants`.
cdef enum:
    BEFORE_STAGES = -1
    ENTRY_ZONE = 0
    MIDDLE = 1
    EXIT_ZONE = 2
    CURVE = 3
    BEHIND_STAGES = 4
