# SPDX-License-Identifier: MIT
# C types of jerk_lookahead.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.path.corner cimport Corner
from nctakt.kernel.path.goal cimport Goal
from nctakt.kernel.path.segment_limits cimport SegmentLimits

@cython.final
cdef class JerkLookAhead:
    cdef SegmentLimits limits
    cdef Corner corner
    cdef Goal goal
    cdef Goal stored
    cdef Py_ssize_t width
    cdef Py_ssize_t capacity
    cdef Py_ssize_t blocks

    @cython.locals(
        shortest=double, speed=double, i=Py_ssize_t, turn=double, passed=double, max_j=double,
        step=double
    )
    cdef void join(self, double[::1] segments, Py_ssize_t before, Py_ssize_t row) noexcept nogil
    cdef double min_jerk(
        self, double[::1] segments, Py_ssize_t before, Py_ssize_t row
    ) noexcept nogil
    @cython.locals(
        i=Py_ssize_t, part=double, left_a=double, left_j=double, free_a=double, free_j=double
    )
    cdef void use_up(
        self, double[::1] segments, Py_ssize_t row, double[::1] parts, bint is_bent
    ) noexcept nogil
    @cython.locals(
        row=Py_ssize_t, before=Py_ssize_t, is_less=int, passed=Py_ssize_t, change=int,
        corner_v=double, back=Py_ssize_t
    )
    cdef int spread(
        self, double[::1] segments, Py_ssize_t number, Py_ssize_t oldest, int is_promised
    ) noexcept nogil
    cdef int is_far(self, double[::1] segments, Py_ssize_t row, double speed) noexcept nogil
    @cython.locals(goal_kind=int, is_exempt=bint, is_other=bint, feed_v=double, is_rounding=bint)
    cdef void slow_before(
        self, Goal goal, double[::1] segments, Py_ssize_t before, Py_ssize_t row, double top_v
    ) noexcept nogil
    cdef void carry_back(
        self, double[::1] segments, Py_ssize_t before, Py_ssize_t row
    ) noexcept nogil
    @cython.locals(old_a=double, old_j=double)
    cdef int take_over(self, double[::1] segments, Py_ssize_t before) noexcept nogil
