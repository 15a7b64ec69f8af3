# SPDX-License-Identifier: MIT
# C types of fixed_stops.py.
cimport cython
from nctakt.kernel cimport cells, rows
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.base.record cimport Record

@cython.final
cdef class FixedStops:
    cdef Path path
    cdef Record record
    cdef long long[::1] active
    cdef long long[::1] detected
    cdef long long[::1] needed
    cdef long long[::1] ticks
    cdef long long[::1] sources
    cdef double[::1] limit_d
    cdef long long[::1] min_ticks
    cdef double[::1] from_part
    cdef double[::1] to_part
    cdef readonly long long count
    cdef readonly long long detected_count

    @cython.locals(i=Py_ssize_t)
    cdef void execute(self, double[::1] queue, Py_ssize_t row) noexcept nogil
    cdef void disarm(self, Py_ssize_t i) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void clear(self) noexcept nogil
    @cython.locals(cell=Py_ssize_t)
    cdef void show(self, Py_ssize_t i, double position) noexcept nogil
    @cython.locals(before=cython.longlong, part=double, i=Py_ssize_t)
    cdef int watch(self) noexcept nogil
    @cython.locals(axis=Py_ssize_t, actual=double, lag_d=double, is_off=bint)
    cdef void watch_axis(self, Py_ssize_t i, double part) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef Py_ssize_t missing(self) noexcept nogil
