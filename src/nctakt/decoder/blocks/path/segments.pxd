# SPDX-License-Identifier: MIT
# C types of segments.py.
from nctakt.nc.fast cimport raw_nodes

cpdef object segment(
    object source, object number, list start, list target, object motion, object feed,
    object exact_stop, object deviation, object limits_jerk, object arc, object modifiers,
    object tilt
)
