# SPDX-License-Identifier: MIT
# C types of outside.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel.axes.single_axes cimport SingleAxes
from nctakt.kernel.plc.axis_requests cimport AxisRequests
from nctakt.kernel.st cimport kinds, words

cdef class Outside:
    cdef void open(self, unsigned char[::1] memory) noexcept nogil
    cdef long long command(
        self, long long kind, long long axis, double value, double speed_v, long long mode,
        long long direction
    ) noexcept nogil
    cdef int power(self, long long axis, int is_on) noexcept nogil
    cdef int lock(self, long long axis, int is_on) noexcept nogil
    cdef int override(self, long long axis, double factor) noexcept nogil
    cdef long long look(self, long long what, long long axis, long long owner) noexcept nogil
    cdef double measure(self, long long what, long long axis) noexcept nogil
    cdef void follow(self) noexcept nogil

cdef class Connection(Outside):
    cdef AxisRequests requests
    cdef SingleAxes single_axes
    cdef Py_ssize_t count
    cdef double[::1] cells
    cdef long long[::1] numbers
    cdef long long[::1] is_powered
    cdef long long[::1] is_locked
    cdef long long[::1] measures
    cdef Py_ssize_t pointer_count
    cdef long long[::1] pointer_at
    cdef long long[::1] pointer_value
    cdef long long wrong_value
    cdef long long not_released
    cdef double ticks_per_s
    cdef double[::1] notes
    @cython.locals(i=Py_ssize_t)
    cdef void open(self, unsigned char[::1] memory) noexcept nogil
    @cython.locals(is_motion=cython.bint, needs_release=cython.bint, is_right=cython.bint)
    cdef long long command(
        self, long long kind, long long axis, double value, double speed_v, long long mode,
        long long direction
    ) noexcept nogil
    cdef int power(self, long long axis, int is_on) noexcept nogil
    cdef int lock(self, long long axis, int is_on) noexcept nogil
    cdef int override(self, long long axis, double factor) noexcept nogil
    @cython.locals(i=Py_ssize_t, fault=cython.longlong)
    cdef long long look(self, long long what, long long axis, long long owner) noexcept nogil
    @cython.locals(state=int)
    cdef int shown_state(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(command=double, actual=double)
    cdef double measure(self, long long what, long long axis) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void follow(self) noexcept nogil
    @cython.locals(
        at=Py_ssize_t, command=double, actual=double, before=double, actual_v=double,
        command_v=double, limit_v=double, change_v=double
    )
    cdef void note(self, Py_ssize_t axis) noexcept nogil
    cdef double limit(self, long long what, long long axis) noexcept nogil
