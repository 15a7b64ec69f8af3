# SPDX-License-Identifier: MIT
# C types of kept.py.
cimport cython
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.reals cimport Real
from nctakt.kernel.st.steps cimport Step
from nctakt.kernel.st.wholes cimport Whole

cdef class KeptWhole(Whole):
    cdef Whole operand
    @cython.locals(value=cython.longlong, at=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class WholeAfter(Whole):
    cdef Step before
    cdef Whole operand
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class RealAfter(Real):
    cdef Step before
    cdef Real operand
    cdef double number(self, PlcContext context) noexcept nogil
