# SPDX-License-Identifier: MIT
# C types of noted.py.
cimport cython
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.calls cimport Call, Callee
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.reals cimport Real
from nctakt.kernel.st.steps cimport Step
from nctakt.kernel.st.wholes cimport Whole

cdef class NotedWhole(Whole):
    cdef Whole operand
    cdef long long row
    @cython.locals(value=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class NotedReal(Real):
    cdef Real operand
    cdef long long row
    @cython.locals(number=double)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class NotedLoop(Whole):
    cdef Whole operand
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class NotedPass(Step):
    cdef Step body
    cdef Whole address
    cdef int kind
    cdef long long row
    @cython.locals(at=cython.longlong)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class NotedScope(Step):
    cdef Step body
    @cython.locals(begin=cython.longlong, outer=cython.longlong, end=int)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class NotedResult(Step):
    cdef Step body
    cdef long long row
    @cython.locals(end=int)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class NotedCall(Call):
    cdef long long row
    cdef Call call
    @cython.locals(begin=cython.longlong, kept=cython.longlong, address=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil
