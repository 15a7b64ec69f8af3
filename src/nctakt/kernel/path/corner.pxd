# SPDX-License-Identifier: MIT
# C types of corner.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path cimport cubic
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.segment_limits cimport SegmentLimits

@cython.final
cdef class Corner:
    cdef SegmentLimits limits
    cdef double[::1] entering
    cdef double[::1] leaving
    cdef double[::1] entering_curve
    cdef double[::1] leaving_curve
    cdef double[::1] steps
    cdef double[::1] shares
    cdef double[::1] turns
    cdef double[::1] unused
    cdef double centripetal_share
    cdef double last_centripetal_share
    cdef double last_length
    cdef double last_deviation
    cdef double last_part
    cdef double last_bend
    cdef double corner_v
    cdef double last_corner_v
    cdef bint is_rounded
    cdef bint last_is_rounded
    cdef bint is_bent
    cdef bint last_is_bent

    @cython.locals(i=Py_ssize_t)
    cdef void enter(
        self, double[::1] segments, Py_ssize_t row, double centripetal_share
    ) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void enter_curve(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void leave(self, double[::1] segments, Py_ssize_t row, double length) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void set_steps(self) noexcept nogil
    cdef double half_length(self, double size, double shorter, double spread) noexcept nogil
    @cython.locals(
        step=double, max_a=double, speed=double, more=double, root=double, slower=double,
        density=double
    )
    cdef double corner_speed(self, Py_ssize_t i, double shortest, double turn) noexcept nogil
