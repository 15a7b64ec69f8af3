# SPDX-License-Identifier: MIT
# C types of axis.py.
cimport cython
from nctakt.kernel.coordinates cimport Offsets

cdef class Axes:
    cdef double[::1] cells
    cdef readonly Py_ssize_t first_cell
    cdef readonly Py_ssize_t count
    cdef double[::1] command
    cdef double[::1] actual
    cdef double[::1] target
    cdef readonly Offsets offsets
    cdef bint has_moved

    @cython.locals(i=Py_ssize_t)
    cdef void begin_tick(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, base=Py_ssize_t)
    cdef void publish(self) noexcept nogil
    cdef void set_offset(self, Py_ssize_t axis, int kind, double value) noexcept nogil
    cdef void publish_system(self, Py_ssize_t i, Py_ssize_t base, double offset) noexcept nogil
