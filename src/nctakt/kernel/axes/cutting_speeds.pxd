# SPDX-License-Identifier: MIT
# C types of cutting_speeds.py.
cimport cython
from libc cimport math
from nctakt.kernel cimport rows
from nctakt.kernel.axes.axes cimport Axes

cdef double DEGREES_PER_RADIAN

@cython.final
cdef class CuttingSpeeds:
    cdef double[::1] surface_v
    cdef long long[::1] face_axis
    cdef double[::1] centre_d
    cdef double[::1] limit_v
    cdef Py_ssize_t active_count
    cdef public Axes axes
    cdef public Py_ssize_t rapid_cell

    @cython.locals(spindle=Py_ssize_t, was_on=bint, is_on=bint)
    cdef void execute(self, double[::1] queue, Py_ssize_t row) noexcept nogil
    @cython.locals(radius=double, asked_v=double)
    cdef double speed(self, Py_ssize_t spindle, double highest_v, double factor) noexcept nogil
