# SPDX-License-Identifier: MIT
# C types of counting.py.
cimport cython
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.reals cimport Real
from nctakt.kernel.st.steps cimport Step
from nctakt.kernel.st.wholes cimport Whole

cdef class CountedTruth(Whole):
    cdef Whole operand
    cdef long long number
    @cython.locals(value=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class SeenWhole(Whole):
    cdef Whole operand
    cdef bint is_left
    cdef bint is_unsigned
    @cython.locals(value=cython.longlong, seen=cython.double)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class SeenReal(Real):
    cdef Real operand
    cdef bint is_left
    @cython.locals(seen=cython.double)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class ComparedTruth(CountedTruth):
    @cython.locals(value=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class SeenSelector(Whole):
    cdef Whole operand
    cdef bint is_unsigned
    cdef long long count
    cdef double[::1] lowest
    cdef double[::1] highest
    cdef long long[::1] numbers
    @cython.locals(value=cython.longlong, seen=cython.double, i=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class CountedStep(Step):
    cdef Step body
    cdef long long number
    cdef int run(self, PlcContext context) noexcept nogil
