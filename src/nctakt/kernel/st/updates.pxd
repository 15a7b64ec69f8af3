# SPDX-License-Identifier: MIT
# C types of updates.py.
cimport cython
from nctakt.kernel.st cimport kinds, leaves, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.steps cimport Sourced
from nctakt.kernel.st.wholes cimport ElementPlace, LoadElement, Whole

cdef long long changed(int operator, long long left, long long right) noexcept nogil

cdef class UpdateAt(Sourced):
    cdef Whole address
    cdef int kind
    cdef int operator
    cdef Whole operand
    @cython.locals(at=cython.longlong, left=cython.longlong, right=cython.longlong)
    cdef int run(self, PlcContext context) noexcept nogil

@cython.locals(left=cython.longlong)
cdef inline int change(
    UpdateAt node, long long at, long long operand, PlcContext context
) noexcept nogil

cdef class UpdateVariable(UpdateAt):
    @cython.locals(at=cython.longlong, is_inside=bint)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class UpdateElement(UpdateAt):
    @cython.locals(at=cython.longlong, is_inside=bint)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class UpdateByElement(UpdateAt):
    cdef LoadElement element
    @cython.locals(
        at=cython.longlong, origin=cython.longlong, is_inside=bint, operand=cython.longlong
    )
    cdef int run(self, PlcContext context) noexcept nogil
