# SPDX-License-Identifier: MIT
# C types of bound_values.py.
cimport cython
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.kernel cimport Kernel

@cython.final
cdef class InputNotes:
    cdef Kernel kernel
    cdef public bint is_listening
    cdef public list cells
    cpdef add(self, source, kind, values, value)

@cython.final
cdef class BoundValue:
    cdef object access
    cdef Kernel kernel
    cdef InputNotes notes
    cdef readonly str name
    cdef readonly str source
    cdef Py_ssize_t cell
    cdef readonly str type
    cdef bint is_truth
    cdef bint is_text
    cdef bint is_whole
    cdef double low
    cdef double high
    @cython.locals(given=double, number=double)
    cpdef write(self, value, source)

cdef class BoundValues:
    cdef Kernel kernel
    cdef Py_ssize_t count
    cdef long long[::1] numbers

@cython.final
cdef class BoundAttribute:
    cdef Py_ssize_t index

cpdef value_at(BoundValues values, Py_ssize_t index)
