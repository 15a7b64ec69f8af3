# SPDX-License-Identifier: MIT
# C types of updates.py.
cimport cython
from nctakt.kernel.st cimport kinds, leaves, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.steps cimport Sourced
from nctakt.kernel.st.wholes cimport ElementPlace, Whole

cdef long long changed(int operator, long long left, long long right) noexcept nogil

cdef class UpdateAt(Sourced):
    cdef Whole address
    cdef int kind
    cdef int operator
    cdef Whole operand
    @cython.locals(at=cython.longlong, left=cython.longlong, right=cython.longlong)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class UpdateElement(UpdateAt):
    cdef ElementPlace element
    cdef bint is_near
    @cython.locals(
        number=cython.longlong, at=cython.longlong, steps=cython.longlong, left=cython.longlong,
        right=cython.longlong
    )
    cdef int run(self, PlcContext context) noexcept nogil
