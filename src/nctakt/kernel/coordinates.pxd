# SPDX-License-Identifier: MIT
# C types of coordinates.py.
cdef class Offsets:
    cdef double[::1] machine
    cdef double[::1] program
    cdef double[::1] interpolator
