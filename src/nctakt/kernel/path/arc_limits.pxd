# SPDX-License-Identifier: MIT
# C types of arc_limits.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic

@cython.locals(ramp=double, half=double, peak=double)
cdef double rest_to_rest_time(
    double distance, double speed, double limit_a, double limit_j
) noexcept nogil

cdef class ArcLimits:
    cdef readonly Py_ssize_t count
    cdef Py_ssize_t room
    cdef double[::1] max_v
    cdef double[::1] max_a
    cdef double[::1] first_parts
    cdef double[::1] second_parts
    cdef double[::1] first_curvatures
    cdef double[::1] second_curvatures
    cdef double[::1] caps
    cdef double[::1] keeps
    cdef double[::1] ends
    cdef Py_ssize_t pieces
    cdef double first_a
    cdef double second_a
    cdef double outer_a
    cdef double outer_v

    @cython.locals(
        first=Py_ssize_t, second=Py_ssize_t, angle=double, x=double, y=double, radius=double,
        turn=double, part=double, curvature=double, share=double, cosine=double, sine=double,
        j=Py_ssize_t, even=double, keep=double, k=Py_ssize_t, cap=double, outer_v=double
    )
    cdef void open(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(rest=Py_ssize_t, even=double)
    cdef double border(self, Py_ssize_t j) noexcept nogil
    @cython.locals(start=Py_ssize_t, target=Py_ssize_t, i=Py_ssize_t, distance=double, part=double)
    cdef void open_outer(
        self, double[::1] segments, Py_ssize_t row, Py_ssize_t first, Py_ssize_t second
    ) noexcept nogil
    @cython.locals(end=Py_ssize_t, used=double)
    cdef double used_share(self, double[::1] segments, Py_ssize_t row, Py_ssize_t k) noexcept nogil
    @cython.locals(cap=double, part=double, speed=double)
    cdef double cap_at(
        self, Py_ssize_t j, Py_ssize_t first, Py_ssize_t second, double keep
    ) noexcept nogil
    @cython.locals(first=double, second=double, cap=double)
    cdef double centre_cap(self, Py_ssize_t k, Py_ssize_t j) noexcept nogil
    @cython.locals(max_a=double)
    cdef double rate(
        self, Py_ssize_t k, double speed2, double growth, double direction
    ) noexcept nogil
    @cython.locals(part=double, curvature=double, max_a=double)
    cdef double border_rate(
        self, Py_ssize_t j, double keep, double speed2, double growth, double direction
    ) noexcept nogil
    @cython.locals(left_a=double, later=double)
    cdef double axis_rate(
        self, double part, double curvature, double limit_a, double speed2, double growth
    ) noexcept nogil
    @cython.locals(k=Py_ssize_t)
    cdef double entry_v2(self, double speed2) noexcept nogil
    @cython.locals(end=Py_ssize_t, width=double)
    cdef double before(self, Py_ssize_t k, double speed2) noexcept nogil
    cdef double entry_speed(self, double end_v, double limit_v) noexcept nogil
    @cython.locals(cap=double, k=Py_ssize_t)
    cdef double highest_speed(self) noexcept nogil
    @cython.locals(last=Py_ssize_t)
    cdef double end_cap(self, int at_end) noexcept nogil
