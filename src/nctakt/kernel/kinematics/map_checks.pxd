# SPDX-License-Identifier: MIT
# C types of map_checks.py: its rows are lists.
from nctakt.kernel.kinematics cimport map_rows

cpdef check_map(row, axis_count)
cpdef check_column(row, column, low, high)
