# SPDX-License-Identifier: MIT
# C types of work.py.
cimport cython
from nctakt.schedule.simulation.chance cimport Chance

cdef class Work:
    cdef readonly bint is_random
    cdef long long _extra
    cdef Chance _chance
    cdef Py_ssize_t _count
    cdef long long[::1] _drawn
    cdef long long _constant
    cdef long long[::1] _low
    cdef long long[::1] _span
    cdef long long[::1] _bits
    cdef list _lists
    cdef long long[::1] _function
    cdef long long[::1] _positions

    @cython.locals(work=cython.longlong, time=cython.longlong, i=cython.Py_ssize_t)
    cpdef long long draw(self) except? -1
    cdef long long _next(self, Py_ssize_t i) except? -1
