# SPDX-License-Identifier: MIT
# C types of hli.py.
cimport cython

cdef class Hli:
    cdef readonly Py_ssize_t slot_count
    cdef long long[::1] slot_state
    cdef long long[::1] slot_function
    cdef long long[::1] slot_sequence
    cdef long long[::1] slot_tick
    cdef readonly long long issued_in_tick
    cdef readonly int program_state
    cdef readonly long long program_function
    cdef long long waiting_count
    cdef public bint acknowledges_itself
    cdef public double operator_override_pct
    cdef public bint feed_hold

    @cython.locals(i=Py_ssize_t)
    cdef void latch(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, slot=Py_ssize_t)
    cdef long long issue(self, long long function, long long tick) noexcept nogil
    cdef int issue_program(self, long long function) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void run_default_plc(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void clear(self) noexcept nogil
