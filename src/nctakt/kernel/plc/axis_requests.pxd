# SPDX-License-Identifier: MIT
# C types of axis_requests.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel.axes.single_axes cimport SingleAxes

@cython.final
cdef class AxisRequests:
    cdef SingleAxes single_axes
    cdef Py_ssize_t capacity
    cdef long long[::1] kind
    cdef long long[::1] axis
    cdef double[::1] value
    cdef double[::1] speed_v
    cdef long long[::1] mode
    cdef long long[::1] direction
    cdef long long[::1] answer
    cdef long long posted
    cdef long long latched

    @cython.locals(slot=Py_ssize_t)
    cdef long long put(
        self, long long kind, long long axis, double value, double speed_v, long long mode,
        long long direction
    ) noexcept nogil
    @cython.locals(newest=cython.longlong)
    cdef long long answer_of(self, long long owner) noexcept nogil
    cdef Py_ssize_t event_bound(self) noexcept nogil
    cdef void latch(self) noexcept nogil
    @cython.locals(
        axis=Py_ssize_t, owner=cython.longlong, mode=int, direction=int, kind=cython.longlong
    )
    cdef void give(self, Py_ssize_t slot) noexcept nogil
