# SPDX-License-Identifier: MIT
# C types of homing.py.
cimport cython
from nctakt.kernel.axes.axes cimport Axes

@cython.final
cdef class Homing:
    cdef Axes axes
    cdef long long[::1] running
    cdef long long[::1] is_allowed
    cdef double[::1] distance
    cdef double[::1] speed
    cdef double[::1] overrun
    cdef double[::1] position
    cdef double[::1] ordered
    cdef long long[::1] is_homed
    cdef double[::1] reference

    cdef void keep(self, Py_ssize_t axis, double reference) noexcept nogil
    cdef void finish(self, Py_ssize_t axis) noexcept nogil
