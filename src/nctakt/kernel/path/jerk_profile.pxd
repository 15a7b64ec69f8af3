# SPDX-License-Identifier: MIT
# C types of jerk_profile.py.
cimport cython
from libc cimport math
from nctakt.kernel cimport rows
from nctakt.kernel.axes.trajectory cimport Trajectories

@cython.final
cdef class JerkProfile:
    cdef Trajectories course
    cdef double tick_t
    cdef double acceleration_a
    cdef double distance_d
    cdef double speed_v
    cdef double left_t
    cdef double rest_d
    cdef bint ends_in_time
    cdef bint stops_at_end
    cdef double own_j

    cdef void begin(self) noexcept nogil
    @cython.locals(
        limit_a=double, limit_j=double, goal_d=double, goal_v=double, goal_a=double, goal_j=double,
        is_met=int, settles=bint
    )
    cdef void plan(
        self, double[::1] segments, Py_ssize_t row, double rest_d, double speed_v, double limit_v,
        double factor, int is_single
    ) noexcept nogil
    @cython.locals(stop_d=double)
    cdef int can_stop(self, double speed_v, double limit_a, double limit_j) noexcept nogil
    @cython.locals(is_met=int)
    cdef void stop_at_end(
        self, double speed_v, double limit_v, double limit_a, double limit_j
    ) noexcept nogil
    @cython.locals(low_v=double, high_v=double, sign=double, _attempt=int)
    cdef void fade_by_end(
        self, double goal_v, double speed_v, double limit_a, double limit_j
    ) noexcept nogil
    @cython.locals(start_a=double, change_v=double, fading_j=double, is_met=int)
    cdef int head_for(
        self, double distance_d, double goal_v, double speed_v, double limit_v, double limit_a,
        double limit_j
    ) noexcept nogil
    @cython.locals(end_t=double, begin_t=double)
    cdef int advance(self, double now_t) noexcept nogil
    @cython.locals(time_t=double, off_d=double, speed_v=double, _attempt=int)
    cdef double time_at_end(self, double low_t, double high_t) noexcept nogil
    cdef void settle(self) noexcept nogil
