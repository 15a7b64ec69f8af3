# SPDX-License-Identifier: MIT
# C types of spindle_limits.py.
cimport cython
from nctakt.kernel cimport rows

@cython.final
cdef class SpindleLimits:
    cdef Py_ssize_t count
    cdef double[::1] speed_v
    cdef double[::1] acceleration_a
    cdef double[::1] jerk_j
    cdef double[::1] low_v
    cdef double[::1] step
    cdef double[::1] own_v
    cdef double[::1] own_a
    cdef double[::1] tool_low_v
    cdef double[::1] tool_v
    cdef double[::1] tool_a
    cdef double[::1] bound_v
    cdef double[::1] bound_a
    cdef double[::1] bound_j

    @cython.locals(spindle=Py_ssize_t)
    cdef void execute(self, double[::1] queue, Py_ssize_t row) noexcept nogil
    cpdef void take_over(self, Py_ssize_t spindle) noexcept nogil
    cdef void bind(
        self, Py_ssize_t spindle, double speed_v, double acceleration_a, double jerk_j
    ) noexcept nogil
    cdef double endless_v(self, Py_ssize_t spindle, double speed_v) noexcept nogil
    cdef double bounded_v(self, Py_ssize_t spindle, double speed_v) noexcept nogil
    cdef double bounded_a(self, Py_ssize_t spindle) noexcept nogil
    @cython.locals(limit_j=double, is_bound=bint)
    cdef double bounded_j(self, Py_ssize_t spindle) noexcept nogil

cdef double lower(double limit, double other) noexcept nogil
