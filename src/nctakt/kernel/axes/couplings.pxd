# SPDX-License-Identifier: MIT
# C types of couplings.py.
cimport cython
from libc cimport math

@cython.final
cdef class Couplings:
    cdef readonly Py_ssize_t axis_count
    cdef readonly Py_ssize_t count
    cdef readonly Py_ssize_t fixed_count
    cdef readonly Py_ssize_t watched_count
    cdef long long[::1] slave
    cdef long long[::1] master
    cdef double[::1] factor
    cdef double[::1] slave_begin
    cdef double[::1] master_begin
    cdef double[::1] allowed_d
    cdef long long[::1] closed

    @cython.locals(k=Py_ssize_t)
    cdef Py_ssize_t pair_of(self, Py_ssize_t slave) noexcept nogil
    @cython.locals(k=Py_ssize_t)
    cdef void couple(
        self, Py_ssize_t slave, Py_ssize_t master, double factor, double allowed_d,
        double slave_position, double master_position
    ) noexcept nogil
    @cython.locals(k=Py_ssize_t, last=Py_ssize_t)
    cdef void uncouple(self, Py_ssize_t slave) noexcept nogil
    @cython.locals(i=Py_ssize_t, k=Py_ssize_t)
    cdef void close_axes(self) noexcept nogil
    cdef double follow(self, Py_ssize_t k, double master_position) noexcept nogil
    @cython.locals(difference=double)
    cdef int is_askew(
        self, Py_ssize_t k, double slave_position, double master_position
    ) noexcept nogil
