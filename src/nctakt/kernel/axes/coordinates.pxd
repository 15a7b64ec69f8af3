# SPDX-License-Identifier: MIT
# C types of coordinates.py.
cimport cython
from nctakt.kernel cimport codes, rows

@cython.final
cdef class Offsets:
    cdef Py_ssize_t count
    cdef double[::1] values
    cdef double[::1] program
    cdef double[::1] origin

    cdef void set(self, Py_ssize_t axis, int kind, double value) noexcept nogil
    @cython.locals(kind=int, total=double)
    cdef double sum_of(self, Py_ssize_t axis, int kinds) noexcept nogil
    cdef void set_origin(self, Py_ssize_t axis, double value) noexcept nogil
    cdef double outer(self, Py_ssize_t axis) noexcept nogil
    cdef double inner(self, Py_ssize_t axis) noexcept nogil

@cython.final
cdef class Turns:
    cdef int active
    cdef long long[::1] second
    cdef long long[::1] third
    cdef double[::1] matrix

    @cython.locals(first=Py_ssize_t, before=int, i=int)
    cdef void set(self, double[::1] queue, Py_ssize_t row) noexcept nogil
