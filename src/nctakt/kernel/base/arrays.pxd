# SPDX-License-Identifier: MIT
# C types of arrays.py: Python's side calls it, between ticks.

cpdef doubles(count)
cpdef integers(count)
