# SPDX-License-Identifier: MIT
# C types of jerk_lookahead.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.segment_limits cimport SegmentLimits

cdef class JerkAhead(SegmentLimits):
    cdef void leave_smoothly(self, double[::1] row, Py_ssize_t base) noexcept nogil
    @cython.locals(shortest=double, speed=double, i=Py_ssize_t, turn=double, passed=double, most_j=double, step=double)
    cdef void join_smoothly(self, double[::1] row, Py_ssize_t before, Py_ssize_t base) noexcept nogil
    @cython.locals(step=double, most_a=double, speed=double, more=double, root=double, slower=double, density=double)
    cdef double corner_speed(self, Py_ssize_t i, double shortest, double turn) noexcept nogil
    cdef double axis_jerk(self, Py_ssize_t index) noexcept nogil
    cdef double least_jerk(self, double[::1] row, Py_ssize_t before, Py_ssize_t base) noexcept nogil
    @cython.locals(i=Py_ssize_t, part=double, least_a=double, left_a=double, left_j=double)
    cdef void use(self, double[::1] row, Py_ssize_t base, double[::1] parts) noexcept nogil
    cdef double speed_of(self, double[::1] row, Py_ssize_t base) noexcept nogil
    @cython.locals(base=Py_ssize_t, before=Py_ssize_t, is_less=int, passed=Py_ssize_t, lent=int, goal_a=double, back=Py_ssize_t)
    cdef int spread_smoothly(self, double[::1] row, Py_ssize_t number, Py_ssize_t oldest, int is_promised) noexcept nogil
    @cython.locals(goal_a=double, goal_j=double, way=double)
    cdef int is_far(self, double[::1] row, Py_ssize_t base, double speed) noexcept nogil
    @cython.locals(is_new=int)
    cdef int keep(self, double[::1] row, Py_ssize_t base) noexcept nogil
    cdef void stop_before(self, double[::1] row, Py_ssize_t before, Py_ssize_t base) noexcept nogil
    @cython.locals(goal_kind=int, is_exempt=bint, is_other=bint, feed_v=double, is_rounding=bint)
    cdef void stop_at(self, double[::1] row, Py_ssize_t before, Py_ssize_t base, double top_v) noexcept nogil
    @cython.locals(change=double, ramp_t=double, ramp_v=double, time=double, way=double, from_v=double)
    cdef double reach(self, double speed) noexcept nogil
    @cython.locals(ramp_t=double, time=double, way=double, change=double)
    cdef double slowing_way(self, double speed, double goal_v, double limit_a, double limit_j) noexcept nogil
    @cython.locals(low=double, high=double, middle=double, _=int)
    cdef double safe_speed(self, double top_v) noexcept nogil
    cdef void lend(self, double[::1] row, Py_ssize_t before, Py_ssize_t base) noexcept nogil
    @cython.locals(old_a=double, old_j=double)
    cdef int borrow(self, double[::1] row, Py_ssize_t before) noexcept nogil
