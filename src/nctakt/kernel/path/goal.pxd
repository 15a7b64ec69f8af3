# SPDX-License-Identifier: MIT
# C types of goal.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic

@cython.final
cdef class Goal:
    cdef readonly double distance_d
    cdef readonly double speed_v
    cdef readonly double acceleration_a
    cdef readonly double jerk_j
    cdef readonly int kind
    cdef double carried_a
    cdef double carried_j

    @cython.locals(goal_a=double)
    cdef void load(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    cdef void load_end(
        self, double[::1] segments, Py_ssize_t row, double carried_a, double carried_j
    ) noexcept nogil
    cdef void move(self, double speed_v, int kind) noexcept nogil
    @cython.locals(is_new=int)
    cdef int store(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(
        change=double, ramp_t=double, ramp_v=double, time=double, distance=double, from_v=double
    )
    cdef double braking_distance(self, double speed) noexcept nogil
    @cython.locals(ramp_t=double, time=double, distance=double, change=double)
    cdef double slowing_distance(self, double speed) noexcept nogil
    @cython.locals(low=double, high=double, middle=double, _=int)
    cdef double safe_speed(self, double top_v) noexcept nogil
