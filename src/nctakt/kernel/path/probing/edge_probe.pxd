# SPDX-License-Identifier: MIT
# C types of edge_probe.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.plc.technology_slots cimport Hli
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.base.record cimport Record

@cython.final
cdef class EdgeProbe:
    cdef Path path
    cdef Hli hli
    cdef Record record
    cdef double[::1] cells
    cdef Py_ssize_t cell
    cdef readonly int phase
    cdef long long source
    cdef long long function
    cdef long long ticks
    cdef bint has_value
    cdef long long value
    cdef double residual_d
    cdef double joint_d

    cdef void arm(self, long long source, double[::1] queue, Py_ssize_t row) noexcept nogil
    cdef void clear(self) noexcept nogil
    @cython.locals(rest_d=double)
    cdef int watch(self, long long tick) noexcept nogil
    cdef void put_out(self, long long tick) noexcept nogil
    cdef int finish(self, long long tick) noexcept nogil
