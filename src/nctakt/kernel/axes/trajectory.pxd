# SPDX-License-Identifier: MIT
# C types of trajectory.py.
cimport cython
from libc cimport math
from nctakt.kernel cimport codes
from nctakt.kernel.axes cimport plan_rows

@cython.final
cdef class Trajectories:
    cdef double[::1] rows
    cdef readonly double distance_d
    cdef readonly double speed_v
    cdef readonly double acceleration_a
    cdef double top_v
    cdef double limit_a
    cdef double limit_j
    cdef double from_v
    cdef double from_a
    cdef double middle_v
    cdef double middle_a
    cdef double slowest_v
    cdef double slowest_peak2
    cdef double first_peak2
    cdef double sign
    cdef double cruise_t
    cdef double first_t
    cdef double hold_t
    cdef double last_t
    cdef double peak_a
    cdef double first_j
    cdef Py_ssize_t row
    cdef Py_ssize_t count
    cdef double end_t
    cdef double end_d
    cdef double end_v
    cdef double goal_v
    cdef double side

    @cython.locals(beyond_d=double)
    cdef void plan_distance(
        self, Py_ssize_t axis, double distance_d, double start_v, double start_a, double top_v,
        double limit_a, double limit_j
    ) noexcept nogil
    @cython.locals(direct_d=double)
    cdef int plan_passing(
        self, Py_ssize_t axis, double distance_d, double start_v, double start_a, double top_v,
        double goal_v, double limit_a, double limit_j, double fading_j
    ) noexcept nogil
    @cython.locals(rise=double)
    cdef void plan_speed(
        self, Py_ssize_t axis, double end_v, double start_v, double start_a, double limit_a,
        double limit_j
    ) noexcept nogil
    @cython.locals(
        row=Py_ssize_t, phase=Py_ssize_t, last=Py_ssize_t, begin=Py_ssize_t, next_begin=Py_ssize_t,
        since=double, speed_v=double, rise_a=double, jerk=double, half=double
    )
    cdef void evaluate(self, Py_ssize_t axis, double time_t) noexcept nogil
    cdef void rewind(self, Py_ssize_t axis) noexcept nogil
    cdef double duration_t(self, Py_ssize_t axis) noexcept nogil
    cdef double stopping_d(
        self, double start_v, double start_a, double limit_a, double limit_j
    ) noexcept nogil
    @cython.locals(rise=double, highest_v=double, peak2=double, first_t=double, rest_d=double)
    cdef void trapezoid(self, double distance_d) noexcept nogil
    cdef double settled(self) noexcept nogil
    cdef double peak2(
        self, double start_v, double start_a, double end_v, double end_a, double sign
    ) noexcept nogil
    @cython.locals(
        peak_a=double, is_held=bint, ramps_v=double, time=double, distance_d=double, speed_v=double
    )
    cdef double change(
        self, double start_v, double start_a, double end_v, double end_a, double sign, double peak2
    ) noexcept nogil
    @cython.locals(peak2=double)
    cdef double brake(self, double start_v, double start_a, double sign) noexcept nogil
    @cython.locals(missing_v=double, size_v=double, sign=double)
    cdef double direct(self, double start_v, double start_a) noexcept nogil
    @cython.locals(settled_v=double, longest_d=double, rising_a=double, above=double)
    cdef void solve(self, double distance_d) noexcept nogil
    @cython.locals(ramp_v=double, min_v=double, left_d=double, middle2=double, highest_v=double)
    cdef int guess(self, double distance_d, double longest_d) noexcept nogil
    @cython.locals(rising=double, peak2=double, falling=double)
    cdef double crossing(self) noexcept nogil
    @cython.locals(turned=double)
    cdef double measure(self, int unknown, double value) noexcept nogil
    @cython.locals(distance_d=double)
    cdef double distance(self) noexcept nogil
    @cython.locals(
        other=double, before=double, value=double, other_d=double, before_d=double, value_d=double,
        allowed_d=double, allowed=double, part=double, estimate=double, estimate_d=double,
        ratio=double, ratio_d=double, _attempt=int
    )
    cdef void search(self, int unknown, double low, double high, double distance_d) noexcept nogil
    cdef void begin(
        self, Py_ssize_t axis, double top_v, double limit_a, double limit_j
    ) noexcept nogil
    @cython.locals(begin=Py_ssize_t)
    cdef void put_phase(self, double start_a, double jerk_j) noexcept nogil
    cdef void append(self, double time_t, double start_a, double jerk_j) noexcept nogil
    @cython.locals(jerk=double)
    cdef double fade(self, double fading_j) noexcept nogil
    cdef void append_both(self) noexcept nogil
    @cython.locals(fading_j=double)
    cdef void append_change(self, double end_v) noexcept nogil
    cdef void finish(self) noexcept nogil
