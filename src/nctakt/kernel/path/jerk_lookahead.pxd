# SPDX-License-Identifier: MIT
# C types of jerk_lookahead.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.segment_limits cimport SegmentLimits

cdef class JerkLookAhead(SegmentLimits):
    cdef void leave_with_jerk(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(shortest=double, speed=double, i=Py_ssize_t, turn=double, passed=double, max_j=double, step=double)
    cdef void join_with_jerk(self, double[::1] segments, Py_ssize_t before, Py_ssize_t row) noexcept nogil
    @cython.locals(step=double, max_a=double, speed=double, more=double, root=double, slower=double, density=double)
    cdef double corner_speed(self, Py_ssize_t i, double shortest, double turn) noexcept nogil
    cdef double axis_jerk(self, Py_ssize_t index) noexcept nogil
    cdef double min_jerk(self, double[::1] segments, Py_ssize_t before, Py_ssize_t row) noexcept nogil
    @cython.locals(i=Py_ssize_t, part=double, min_a=double, left_a=double, left_j=double)
    cdef void use_up(self, double[::1] segments, Py_ssize_t row, double[::1] parts) noexcept nogil
    cdef double speed_of(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(row=Py_ssize_t, before=Py_ssize_t, is_less=int, passed=Py_ssize_t, change=int, goal_a=double, back=Py_ssize_t)
    cdef int spread_with_jerk(self, double[::1] segments, Py_ssize_t number, Py_ssize_t oldest, int is_promised) noexcept nogil
    @cython.locals(goal_a=double, goal_j=double, distance=double)
    cdef int is_far(self, double[::1] segments, Py_ssize_t row, double speed) noexcept nogil
    @cython.locals(is_new=int)
    cdef int store_goal(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    cdef void slow_before(self, double[::1] segments, Py_ssize_t before, Py_ssize_t row) noexcept nogil
    @cython.locals(goal_kind=int, is_exempt=bint, is_other=bint, feed_v=double, is_rounding=bint)
    cdef void stop_at(self, double[::1] segments, Py_ssize_t before, Py_ssize_t row, double top_v) noexcept nogil
    @cython.locals(change=double, ramp_t=double, ramp_v=double, time=double, distance=double, from_v=double)
    cdef double braking_distance(self, double speed) noexcept nogil
    @cython.locals(ramp_t=double, time=double, distance=double, change=double)
    cdef double slowing_distance(self, double speed, double goal_v, double limit_a, double limit_j) noexcept nogil
    @cython.locals(low=double, high=double, middle=double, _=int)
    cdef double safe_speed(self, double top_v) noexcept nogil
    cdef void carry_back(self, double[::1] segments, Py_ssize_t before, Py_ssize_t row) noexcept nogil
    @cython.locals(old_a=double, old_j=double)
    cdef int take_over(self, double[::1] segments, Py_ssize_t before) noexcept nogil
