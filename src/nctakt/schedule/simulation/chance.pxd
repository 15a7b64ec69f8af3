# SPDX-License-Identifier: MIT
# C types of chance.py.
cimport cython

cdef class Chance:
    cdef object _seed
    cdef object _source
    cdef unsigned long long[::1] _words
    cdef Py_ssize_t _next
    cdef Py_ssize_t _count

    cdef _refill(self)
    cdef unsigned long long _word(self) except? 1
    @cython.locals(drawn=cython.longlong)
    cpdef long long below(self, long long limit, int bits) except? -1
    cpdef randint(self, low, high)
