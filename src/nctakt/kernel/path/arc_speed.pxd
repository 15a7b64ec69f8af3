# SPDX-License-Identifier: MIT
# C types of arc_speed.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path.arc_limits cimport ArcLimits
from nctakt.kernel.path.trapezoid_profile cimport TrapezoidProfile

@cython.final
cdef class ArcSpeed(ArcLimits):
    cdef TrapezoidProfile profile
    cdef double[::1] highs
    cdef double[::1] lows
    cdef double prepared_v
    cdef double next_feed_v
    cdef double max_end_v
    cdef double surveyed_v
    cdef double surveyed_target_v

    cdef void begin(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(end_v=double, feed_v=double)
    cdef void look_ahead(
        self, Py_ssize_t stage, double rest_d, double start_v, double factor, double factor_ahead,
        double remaining_v
    ) noexcept nogil
    cdef void survey(self, double max_v, double target_v) noexcept nogil
    @cython.locals(k=Py_ssize_t, before=Py_ssize_t, speed2=double)
    cdef void fill(self, double[::1] borders, double end_v) noexcept nogil
    @cython.locals(width=double, border=Py_ssize_t, speed2=double)
    cdef int is_met(self, Py_ssize_t stage, double rest_d, double start_v) noexcept nogil
    @cython.locals(border=Py_ssize_t, start2=double, limit2=double, end2=double)
    cdef void plan(
        self, Py_ssize_t stage, double rest_d, double start_v, double limit_v
    ) noexcept nogil
    @cython.locals(max_a=double, longer=double)
    cdef double change(
        self, Py_ssize_t stage, double from2, double to2, double width, double direction
    ) noexcept nogil
    @cython.locals(
        border=Py_ssize_t, start2=double, rate=double, first_d=double, end2=double, last_d=double,
        last=double
    )
    cdef void slow_down(
        self, Py_ssize_t stage, double rest_d, double start_v, double limit2
    ) noexcept nogil
    @cython.locals(border=Py_ssize_t, start2=double, width=double, rate=double, end2=double)
    cdef void brake(
        self, Py_ssize_t stage, double rest_d, double start_v, double target2
    ) noexcept nogil
    @cython.locals(
        border=Py_ssize_t, start2=double, width=double, end2=double, last=double, first=double,
        top2=double, first_d=double, last_d=double
    )
    cdef void speed_up(
        self, Py_ssize_t stage, double rest_d, double start_v, double limit2
    ) noexcept nogil
    @cython.locals(top_v=double, end_v=double)
    cdef void follow(
        self, double rest_d, double start_v, double first_d, double top2, double last_d, double end2
    ) noexcept nogil
