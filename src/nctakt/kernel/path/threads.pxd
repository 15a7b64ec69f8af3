# SPDX-License-Identifier: MIT
# C types of threads.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.axes cimport spindles
from nctakt.kernel.axes.spindles cimport Spindles
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.path cimport Path

@cython.final
cdef class Threads:
    cdef Path path
    cdef Context context
    cdef Spindles spindles
    cdef int state
    cdef bint is_cutting
    cdef bint was_cut
    cdef Py_ssize_t spindle
    cdef double angle
    cdef double turn
    cdef double length_d
    cdef double delay_t
    cdef long long source
    cdef int fault

    @cython.locals(spindle=Py_ssize_t)
    cdef int may_begin(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(
        spindle_v=double, sign=double, path_v=double, lead=double, begin=double,
        missing=double, angle=double, offset=double
    )
    cdef int is_due(
        self, double[::1] segments, Py_ssize_t row, Py_ssize_t spindle
    ) noexcept nogil
    @cython.locals(limit_a=double, limit_j=double)
    cdef double lead_t(self, double[::1] segments, Py_ssize_t row, double path_v) noexcept nogil
    @cython.locals(row=Py_ssize_t, angle=double)
    cdef void begin(self) noexcept nogil
    @cython.locals(row=Py_ssize_t, turn=double)
    cdef void measure(self) noexcept nogil
    @cython.locals(
        row=Py_ssize_t, before_v=double, after_v=double, step_v=double
    )
    cdef void chain(self) noexcept nogil
    cdef int step(self, double factor, int is_stopping) noexcept nogil
    cdef int has_speed(self) noexcept nogil
    @cython.locals(
        tick=cython.longlong, angle=double, off_d=double, size=double, allowed_d=double,
        limit_a=double
    )
    cdef void lock(self) noexcept nogil
    @cython.locals(
        angle=double, covered_d=double, path_v=double, need_d=double
    )
    cdef int follow_spindle(self) noexcept nogil
    @cython.locals(row=Py_ssize_t, limit_a=double, limit_j=double)
    cdef double braking_d(self, double path_v) noexcept nogil
    cdef void settle(self) noexcept nogil
    @cython.locals(
        row=Py_ssize_t, is_tap=bint, spindle=Py_ssize_t, turn=double,
        angle=double, spindle_v=double
    )
    cdef void turn_spindle(self) noexcept nogil
    @cython.locals(angle=double)
    cdef void leave_tap(self) noexcept nogil
    @cython.locals(off=double)
    cdef void couple(self, double angle, double turn) noexcept nogil
    cdef void uncouple(self) noexcept nogil
    cdef int is_at_rest_before(self, double thread) noexcept nogil
    @cython.locals(fault=int)
    cdef int take_fault(self) noexcept nogil
    cdef Py_ssize_t spindle_number(self) noexcept nogil
    cdef void clear(self) noexcept nogil
