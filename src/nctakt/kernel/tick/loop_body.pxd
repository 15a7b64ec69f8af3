# SPDX-License-Identifier: MIT
# C types of loop_body.py.
from nctakt.kernel cimport rows

cdef class LoopBody:
    cdef Py_ssize_t width
    cdef double[::1] rows
    cdef readonly Py_ssize_t count
    cdef readonly bint is_open
    cdef readonly bint is_complete
    cdef readonly bint ends_at_standstill

    cdef void give_up(self) noexcept nogil
