# SPDX-License-Identifier: MIT
# C types of lookahead.py.
cimport cython
from nctakt.kernel cimport arithmetic
from nctakt.kernel cimport shape

cdef class LookAhead:
    cdef readonly Py_ssize_t count
    cdef readonly Py_ssize_t blocks
    cdef double most_factor
    cdef double tick_t
    cdef readonly Py_ssize_t width
    cdef public Py_ssize_t capacity
    cdef long long[::1] linear
    cdef double[::1] rapid_v
    cdef double[::1] most_v
    cdef double[::1] rapid_a
    cdef double[::1] feed_a
    cdef double[::1] rapid_slope_a
    cdef double[::1] feed_slope_a
    cdef double[::1] rapid_j
    cdef double[::1] feed_j
    cdef double[::1] entering
    cdef double[::1] leaving
    cdef double[::1] steps
    cdef double[::1] shares
    cdef double[::1] spare
    cdef double bend
    cdef double last_bend
    cdef double last_length
    cdef double last_deviation

    cdef void measure(self, double[::1] row, Py_ssize_t base, double feed_v) noexcept nogil
    @cython.locals(limit_a=double, limit_j=double, i=Py_ssize_t, way=double, part=double, slope_a=double, slope_j=double, tail=Py_ssize_t, first=Py_ssize_t, second=Py_ssize_t, x=double, y=double, radius=double, plane_j=double, plane_a=double, speed=double, fastest=double)
    cdef void smooth(self, double[::1] row, Py_ssize_t base, double feed_v) noexcept nogil
    @cython.locals(linear2=double, rotary2=double, i=Py_ssize_t, way=double)
    cdef double straight_way(self, double[::1] row, Py_ssize_t base) noexcept nogil
    @cython.locals(highest=double, limit_a=double, rapid=double, i=Py_ssize_t, way=double, part=double)
    cdef void bound(self, double[::1] row, Py_ssize_t base, double feed_v) noexcept nogil
    cdef double acceleration(self, Py_ssize_t index, double feed_v) noexcept nogil
    @cython.locals(tail=Py_ssize_t)
    cdef int in_plane(self, double[::1] row, Py_ssize_t base, Py_ssize_t index) noexcept nogil
    @cython.locals(tail=Py_ssize_t, first=Py_ssize_t, second=Py_ssize_t, x=double, y=double, radius=double, angle=double, way=double, length2=double, i=Py_ssize_t, rise=double, length=double, part=double, plane_a=double, highest=double, wanted=double, best_t=double, best_v=double, best_a=double, share=double, speed=double, limit_a=double, time=double, _=int)
    cdef void measure_arc(self, double[::1] row, Py_ssize_t base, double feed_v) noexcept nogil
    cdef void leave(self, double[::1] row, Py_ssize_t base, double length, double deviation) noexcept nogil
    @cython.locals(tail=Py_ssize_t, i=Py_ssize_t)
    cdef void join(self, double[::1] row, Py_ssize_t before, Py_ssize_t base) noexcept nogil
    cdef double axis_acceleration(self, Py_ssize_t index) noexcept nogil
    cdef double speed_of(self, double[::1] row, Py_ssize_t base) noexcept nogil
    @cython.locals(bend=double, reserve=double, shortest=double, limit_v=double, least_a=double, i=Py_ssize_t, step_a=double, speed=double, density=double, most=double, used=double)
    cdef void pass_corner(self, double[::1] row, Py_ssize_t before, Py_ssize_t base) noexcept nogil
    @cython.locals(tail=Py_ssize_t, way=double, bend=double, left2=double, limit_a=double, i=Py_ssize_t, part=double, left_a=double, place=Py_ssize_t)
    cdef void reserve_zone(self, double[::1] row, Py_ssize_t base, int at_end, double speed, double most) noexcept nogil
    @cython.locals(size2=double, i=Py_ssize_t, size=double, half=double, curve_v2=double, step_a=double, speed=double, share=double, curve_a=double, part=double, tail=Py_ssize_t, place=double)
    cdef int round_corner(self, double[::1] row, Py_ssize_t before, Py_ssize_t base) noexcept nogil
    @cython.locals(base=Py_ssize_t, tail=Py_ssize_t, speed=double, entry_v=double, free_v=double, passed=Py_ssize_t, back=Py_ssize_t)
    cdef int spread(self, double[::1] row, Py_ssize_t number, Py_ssize_t oldest, double promised_v, double promised_free_v) noexcept nogil
    @cython.locals(base=Py_ssize_t, before=Py_ssize_t, i=Py_ssize_t)
    cdef void connect(self, double[::1] row, Py_ssize_t number, Py_ssize_t back, Py_ssize_t oldest, double promised_v, double promised_free_v) noexcept nogil
