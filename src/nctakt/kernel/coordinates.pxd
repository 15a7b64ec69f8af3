# SPDX-License-Identifier: MIT
# C types of coordinates.py.
cimport cython

cdef class Offsets:
    cdef double[::1] values
    cdef double[::1] program

    cdef void set(self, Py_ssize_t axis, int kind, double value) noexcept nogil
    @cython.locals(kind=int, total=double)
    cdef double sum_of(self, Py_ssize_t axis, int kinds) noexcept nogil
