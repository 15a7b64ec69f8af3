# SPDX-License-Identifier: MIT
# C types of posted_values.py.
cimport cython

@cython.final
cdef class PostedValues:
    cdef long long[::1] memory
    cdef double[::1] present_cells
    cdef Py_ssize_t count
    cdef Py_ssize_t capacity
    cdef long long[::1] cells
    cdef long long[::1] words
    cdef double[::1] values
    cdef long long[::1] slots

    cpdef check_cell(self, cell)
    cpdef post(self, cell, double value)
    @cython.locals(slot=Py_ssize_t)
    cdef put(self, Py_ssize_t cell, double value)
    @cython.locals(slot=Py_ssize_t)
    cdef Py_ssize_t slot_of(self, Py_ssize_t cell) noexcept nogil
    @cython.locals(slot=Py_ssize_t)
    cdef Py_ssize_t slot_for(self, Py_ssize_t cell) except -1
    @cython.locals(slot=Py_ssize_t)
    cdef double present(self, Py_ssize_t cell) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cpdef void latch(self) noexcept nogil
