# SPDX-License-Identifier: MIT
# C types of loop_body.py.

cdef class LoopBody:
    cdef Py_ssize_t width
    cdef Py_ssize_t stride
    cdef double[::1] rows
    cdef readonly Py_ssize_t count
    cdef readonly bint is_open
    cdef readonly bint is_complete
    cdef readonly bint stops

    cdef void give_up(self) noexcept nogil
