# SPDX-License-Identifier: MIT
# C types of lookahead.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.corner cimport Corner
from nctakt.kernel.path.corner_rounding cimport CornerRounding
from nctakt.kernel.path.jerk_lookahead cimport JerkLookAhead
from nctakt.kernel.path.segment_limits cimport SegmentLimits

@cython.final
cdef class LookAhead:
    cdef readonly SegmentLimits limits
    cdef Corner corner
    cdef CornerRounding rounding
    cdef JerkLookAhead jerk
    cdef readonly Py_ssize_t blocks
    cdef readonly Py_ssize_t width
    cdef Py_ssize_t capacity
    cdef double[::1] spare

    cdef void measure(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(i=Py_ssize_t, speed=double)
    cdef void join(self, double[::1] segments, Py_ssize_t before, Py_ssize_t row) noexcept nogil
    @cython.locals(
        share=double, reserve=double, shortest=double, limit_v=double, min_a=double, i=Py_ssize_t,
        step_a=double, speed=double, density=double, max_share=double, used=double
    )
    cdef void pass_corner(
        self, double[::1] segments, Py_ssize_t before, Py_ssize_t row
    ) noexcept nogil
    @cython.locals(
        length=double, first_a=double, second_a=double, column=Py_ssize_t, limit_a=double,
        share=double, left2=double, i=Py_ssize_t, part=double, free=double, entry_a=double,
        exit_a=double
    )
    cdef void reserve_zone(
        self, double[::1] segments, Py_ssize_t row, int at_end, double speed, double max_share
    ) noexcept nogil
    @cython.locals(
        size2=double, i=Py_ssize_t, size=double, shorter=double, half=double, curve_v2=double,
        step_a=double, speed=double, share=double, curve_a=double, part=double, start=Py_ssize_t,
        corner=Py_ssize_t, curve_end=Py_ssize_t, position=double, radial_a=double
    )
    cdef int round_corner(
        self, double[::1] segments, Py_ssize_t before, Py_ssize_t row
    ) noexcept nogil
    cdef double arc_speed(self, double[::1] segments, Py_ssize_t row, int at_end) noexcept nogil
    @cython.locals(speed=double)
    cdef double feed_entry_speed(
        self, double[::1] segments, Py_ssize_t row, double end_v
    ) noexcept nogil
    @cython.locals(speed=double)
    cdef double max_entry_speed(
        self, double[::1] segments, Py_ssize_t row, double entry_v, double end_v, double max_end_v
    ) noexcept nogil
    cdef double entry_speed(
        self, double[::1] segments, Py_ssize_t row, double end_v, double limit_v
    ) noexcept nogil
    @cython.locals(
        row=Py_ssize_t, passed=Py_ssize_t, entry_v=double, max_entry_v=double, back=Py_ssize_t,
        end_v=double, max_end_v=double
    )
    cdef int spread(
        self, double[::1] segments, Py_ssize_t number, Py_ssize_t oldest, double promised_v,
        double promised_max_v
    ) noexcept nogil
    @cython.locals(row=Py_ssize_t, before=Py_ssize_t, i=Py_ssize_t, end_v=double)
    cdef void connect(
        self, double[::1] segments, Py_ssize_t number, Py_ssize_t back, Py_ssize_t oldest,
        double promised_v, double promised_max_v
    ) noexcept nogil
    cdef int spread_any(
        self, double[::1] segments, Py_ssize_t number, Py_ssize_t oldest, double promised_v,
        double promised_max_v
    ) noexcept nogil
