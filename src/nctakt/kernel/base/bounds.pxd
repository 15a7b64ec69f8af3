# SPDX-License-Identifier: MIT
# C types of bounds.py: its integers are Python's, which may have any size.

cpdef check_index(number, count, what)
cpdef check_range(number, low, high, what)
cpdef check_finite(double number, what)
cpdef check_size(number, what)
cpdef check_cells(first_cell, count, memory)
