# SPDX-License-Identifier: MIT
# C types of corner_rounding.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path.corner cimport Corner
from nctakt.kernel.path.segment_limits cimport SegmentLimits

@cython.final
cdef class CornerRounding:
    cdef SegmentLimits limits
    cdef Corner corner
    cdef Py_ssize_t width
    cdef double[::1] row
    cdef double[::1] spare

    @cython.locals(half=double, speed=double, i=Py_ssize_t)
    cdef int round(
        self, double[::1] segments, Py_ssize_t before, Py_ssize_t row, Py_ssize_t back
    ) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void restore(self, double[::1] segments, Py_ssize_t before, Py_ssize_t row) noexcept nogil
    @cython.locals(
        size2=double, i=Py_ssize_t, step=double, size=double, shorter=double, half=double
    )
    cdef double rounding_half(
        self, double[::1] segments, Py_ssize_t before, Py_ssize_t row
    ) noexcept nogil
    @cython.locals(
        shortest=double, speed=double, corner_v=double, i=Py_ssize_t, step=double, max_v2=double,
        max_v3=double
    )
    cdef double rounding_speed(
        self, double[::1] segments, Py_ssize_t before, Py_ssize_t row, double half
    ) noexcept nogil
    @cython.locals(
        limit_a=double, limit_j=double, top_v=double, room=double, time=double, stop_t=double,
        rounding_t=double
    )
    cdef int saves_time(
        self, double[::1] segments, Py_ssize_t before, Py_ssize_t row, double half, double speed
    ) noexcept nogil
    cdef double ramp_time(self, double change, double limit_a, double limit_j) noexcept nogil
    @cython.locals(
        limit_a=double, limit_j=double, i=Py_ssize_t, step=double, part=double, left_a=double,
        left_j=double
    )
    cdef void limit_rounding(
        self, double[::1] segments, Py_ssize_t before, Py_ssize_t row, double half, double speed
    ) noexcept nogil
    @cython.locals(
        rounding=double[::1], start=Py_ssize_t, target=Py_ssize_t, corners=Py_ssize_t, i=Py_ssize_t,
        corner=double
    )
    cdef void put_rounding(
        self, double[::1] segments, Py_ssize_t before, Py_ssize_t row, double half
    ) noexcept nogil
