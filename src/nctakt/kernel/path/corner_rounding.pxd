# SPDX-License-Identifier: MIT
# C types of corner_rounding.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path.jerk_lookahead cimport JerkAhead

cdef class Bends(JerkAhead):
    @cython.locals(half=double, speed=double, i=Py_ssize_t)
    cdef int round_smoothly(self, double[::1] row, Py_ssize_t before, Py_ssize_t base, Py_ssize_t back) noexcept nogil
    @cython.locals(size2=double, i=Py_ssize_t, step=double, size=double, shorter=double, half=double)
    cdef double half_bend(self, double[::1] row, Py_ssize_t before, Py_ssize_t base) noexcept nogil
    @cython.locals(shortest=double, speed=double, corner_v=double, i=Py_ssize_t, step=double, most_v2=double, most_v3=double)
    cdef double bend_speed(self, double[::1] row, Py_ssize_t before, Py_ssize_t base, double half) noexcept nogil
    @cython.locals(limit_a=double, limit_j=double, top_v=double, room=double, time=double, stand_t=double, bend_t=double)
    cdef int saves_time(self, double[::1] row, Py_ssize_t before, Py_ssize_t base, double half, double speed) noexcept nogil
    cdef double ramp_time(self, double change, double limit_a, double limit_j) noexcept nogil
    cdef double least_acceleration(self, Py_ssize_t index) noexcept nogil
    @cython.locals(limit_a=double, limit_j=double, i=Py_ssize_t, step=double, part=double, left_a=double, left_j=double)
    cdef void limit_bend(self, double[::1] row, Py_ssize_t before, Py_ssize_t base, double half, double speed) noexcept nogil
    @cython.locals(bend=double[::1], start=Py_ssize_t, target=Py_ssize_t, corners=Py_ssize_t, i=Py_ssize_t, corner=double)
    cdef void put_bend(self, double[::1] row, Py_ssize_t before, Py_ssize_t base, double half) noexcept nogil
