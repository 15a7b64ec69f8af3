# SPDX-License-Identifier: MIT
# C types of counting.py.
cimport cython
from nctakt.kernel.st cimport kinds
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.steps cimport Step
from nctakt.kernel.st.wholes cimport Whole

cdef class CountedTruth(Whole):
    cdef Whole operand
    cdef long long number
    @cython.locals(value=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class CountedStep(Step):
    cdef Step body
    cdef long long number
    cdef int run(self, PlcContext context) noexcept nogil
