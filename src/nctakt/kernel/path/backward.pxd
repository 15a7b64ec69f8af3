# SPDX-License-Identifier: MIT
# C types of backward.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.history cimport History
from nctakt.kernel.path.lookahead cimport LookAhead
from nctakt.kernel.path.trapezoid_profile cimport TrapezoidProfile
from nctakt.kernel.path.override cimport Overrides
from nctakt.kernel.plc.panel cimport Panel
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.base.record cimport Record

@cython.final
cdef class BackwardMotion(History):
    cdef Panel panel
    cdef Overrides overrides
    cdef Record record
    cdef TrapezoidProfile profile
    cdef int stage
    cdef double stage_d
    cdef double plan_d
    cdef double offset_t
    cdef long long ticks
    cdef double factor
    cdef bint is_single
    cdef bint is_blocked
    cdef bint was_paused
    cdef bint was_released
    cdef int fault
    cdef bint has_failed
    cdef long long fault_source
    cdef double entered

    cdef int can_take_over(self) noexcept nogil
    cdef int state(self) noexcept nogil
    @cython.locals(number=cython.longlong)
    cdef int can_go_back(self) noexcept nogil
    @cython.locals(direction=int, halts=bint, limit_v=double, is_changed=bint)
    cdef int step(self, double factor, int is_stopping) noexcept nogil
    @cython.locals(i=Py_ssize_t, axis=Py_ssize_t)
    cdef void leave(self) noexcept nogil
    cdef void turn(self, int direction) noexcept nogil
    @cython.locals(source=cython.longlong, phase=int)
    cdef void go(self, int direction) noexcept nogil
    @cython.locals(source=cython.longlong)
    cdef void return_to_front(self, double covered_d) noexcept nogil
    @cython.locals(factor=double, speed=double)
    cdef double feed_speed(self, Py_ssize_t row, int ignores_feed) noexcept nogil
    @cython.locals(speed=double)
    cdef double stage_speed(self, Py_ssize_t row, int stage, int ignores_feed) noexcept nogil
    @cython.locals(first=Py_ssize_t, second=Py_ssize_t)
    cdef double corner_speed(
        self, long long number, long long other, int ignores_feed
    ) noexcept nogil
    @cython.locals(row=Py_ssize_t, end_v=double, limit_v=double)
    cdef double front_speed(self, int ignores_feed) noexcept nogil
    @cython.locals(
        number=cython.longlong, stage=int, row=Py_ssize_t, max_v2=double, gained2=double,
        speed=double, other=cython.longlong, limit_a=double, d=double
    )
    cdef double border_speed(self, int ignores_feed) noexcept nogil
    @cython.locals(end_v=double, feed_v=double, speed2=double, min_v2=double)
    cdef double end_speed(self, double rest_d, double limit_a) noexcept nogil
    @cython.locals(rest_d=double, speed_v=double, is_single=bint, limit_a=double, end_v=double)
    cdef void replan(self, double limit_v) noexcept nogil
    @cython.locals(is_backward=bint)
    cdef int first_stage(self, Py_ssize_t row) noexcept nogil
    @cython.locals(is_inside=bint)
    cdef int next_stage(self, Py_ssize_t row, int stage) noexcept nogil
    cdef int enter_stage(self) noexcept nogil
    @cython.locals(length=double, i=int)
    cdef double border(self, int stage) noexcept nogil
    @cython.locals(length=double, i=int)
    cdef double length(self) noexcept nogil
    @cython.locals(other=cython.longlong, refusal=int, end=Py_ssize_t)
    cdef int cross(self) noexcept nogil
    cdef int keeps_moving(self) noexcept nogil
    @cython.locals(row=Py_ssize_t, end=Py_ssize_t, i=Py_ssize_t, axis=Py_ssize_t)
    cdef int refusal_into(self, long long number) noexcept nogil
    @cython.locals(source=cython.longlong, other=cython.longlong)
    cdef void stay(self, int refusal) noexcept nogil
    cdef void fail(self, int refusal, long long number) noexcept nogil
    @cython.locals(now_t=double)
    cdef int advance(self, int is_stopping) noexcept nogil
    @cython.locals(source=cython.longlong)
    cdef void stop_between(self) noexcept nogil
    @cython.locals(first=cython.longlong)
    cdef int is_inside(self) noexcept nogil
    @cython.locals(over_t=double)
    cdef int has_ended(self, double now_t) noexcept nogil
    @cython.locals(is_over=int)
    cdef int has_ended_with_jerk(self, double now_t) noexcept nogil
    @cython.locals(covered_d=double, rest_d=double)
    cdef void follow(self, double distance) noexcept nogil
