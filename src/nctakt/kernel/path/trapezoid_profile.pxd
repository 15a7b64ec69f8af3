# SPDX-License-Identifier: MIT
# C types of trapezoid_profile.py.
cimport cython
from libc cimport math

@cython.final
cdef class TrapezoidProfile:
    cdef double first_t
    cdef double first_a
    cdef double first_d
    cdef double start_v
    cdef double cruise_t
    cdef double cruise_v
    cdef double cruise_d
    cdef double last_a
    cdef readonly double duration_t
    cdef readonly double length_d
    cdef readonly double end_v
    cdef readonly bint is_endless

    @cython.locals(
        brake_d=double, peak2=double, last_t=double, start2=double, end_v2=double, highest_v=double
    )
    cdef void plan(
        self, double length_d, double start_v, double end_v, double limit_v, double limit_a
    ) noexcept nogil
    @cython.locals(last_t=double)
    cdef void plan_ramps(
        self, double length_d, double start_v, double first_d, double cruise_v, double last_d,
        double end_v
    ) noexcept nogil
    cdef void pass_at_once(self) noexcept nogil
    @cython.locals(middle_v=double)
    cdef void brake_only(self) noexcept nogil
    @cython.locals(since=double)
    cdef double position(self, double time_t) noexcept nogil
    @cython.locals(since=double)
    cdef double speed(self, double time_t) noexcept nogil
