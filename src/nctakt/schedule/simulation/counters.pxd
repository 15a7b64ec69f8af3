# SPDX-License-Identifier: MIT
# C types of counters.py.
cimport cython

cdef class Counters:
    cdef long long _guarantee
    cdef tuple _cpus
    cdef Py_ssize_t _sum
    cdef readonly long long[::1] due
    cdef readonly long long[::1] completed
    cdef readonly long long[::1] overflows
    cdef readonly long long[::1] lost
    cdef readonly long long[::1] suspensions
    cdef readonly long long[::1] busy
    cdef long long[::1] _response_sum
    cdef long long[::1] _response_min
    cdef long long[::1] _response_max
    cdef long long[::1] _first_overflow
    cdef long long[::1] _total
    cdef long long[::1] _min
    cdef long long[::1] _max
    cdef long long[::1] _violated
    cdef long long[::1] _late
    cdef list _culprits
    cdef list _runners
    cdef bint _has_runners
    cdef long long[::1] _cycles
    cdef list _responses
    cdef long long[::1] _shifts

    cpdef overflow(self, Py_ssize_t i, long long now)
    @cython.locals(counts=dict, step=cython.longlong)
    cpdef finish(self, Py_ssize_t i, long long response)
    cpdef runs_late(self, Py_ssize_t cpu, Py_ssize_t i)
    @cython.locals(total=cython.longlong, share=cython.longlong, column=cython.Py_ssize_t)
    cpdef end_cycle(
        self, long long[::1] idle, long long point, long long end, bint is_missed, bint suspended
    )
    cdef _violate(self, Py_ssize_t column, bint is_late)
    cdef _share(self, Py_ssize_t column, long long share)
