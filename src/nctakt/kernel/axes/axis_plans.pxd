# SPDX-License-Identifier: MIT
# C types of axis_plans.py.
cimport cython
from nctakt.kernel.axes.trajectory cimport Trajectories

@cython.final
cdef class MotionLimits:
    cdef long long[::1] is_enabled
    cdef double[::1] low
    cdef double[::1] high
    cdef double[::1] listed_low
    cdef double[::1] listed_high
    cdef double[::1] max_v
    cdef double[::1] max_a
    cdef double[::1] max_j

    cdef void put_back(self, Py_ssize_t axis) noexcept nogil

@cython.final
cdef class AxisPlans:
    cdef MotionLimits limits
    cdef double cycle_time_us
    cdef double forgiven_t
    cdef Trajectories trajectories
    cdef double[::1] speed
    cdef double[::1] acceleration
    cdef double[::1] last_direction
    cdef double[::1] planned_v
    cdef double[::1] start_d
    cdef long long[::1] ticks

    cdef void come_to_rest(self, Py_ssize_t axis) noexcept nogil
    cdef double brake_d(self, Py_ssize_t axis) noexcept nogil
    cdef void begin(self, Py_ssize_t axis, double position, double top_v) noexcept nogil
    cdef void plan_speed(self, Py_ssize_t axis, double end_v) noexcept nogil
    cdef void plan_distance(self, Py_ssize_t axis, double goal) noexcept nogil
    @cython.locals(over_t=double)
    cdef int count_tick(self, Py_ssize_t axis) noexcept nogil
    cdef double time_t(self, Py_ssize_t axis) noexcept nogil
    cdef double advance(self, Py_ssize_t axis) noexcept nogil
    cdef double end_position(self, Py_ssize_t axis) noexcept nogil
