# SPDX-License-Identifier: MIT
# C types of conversions.py.
cimport cython
from nctakt.kernel.st.text cimport characters, dates, digits
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.reals cimport Real
from nctakt.kernel.st.text.texts cimport StringPart
from nctakt.kernel.st.wholes cimport Whole

cdef class StringOfWhole(Whole):
    cdef Whole operand
    cdef long long form
    cdef long long width
    cdef long long kept
    @cython.locals(kept=cython.longlong, value=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil
    cdef long long write(self, PlcContext context, long long at, long long value) noexcept nogil

cdef long long put_truth(PlcContext context, long long at, long long value) noexcept nogil

cdef class StringOfReal(Whole):
    cdef Real operand
    cdef bint is_single
    cdef long long kept
    @cython.locals(kept=cython.longlong, number=double, end=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class WholeOfString(Whole):
    cdef StringPart text
    cdef bint is_length
    cdef long long scale
    @cython.locals(begin=cython.longlong, end=cython.longlong, first=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

@cython.locals(scaled=double)
cdef long long whole_length(double length, long long scale) noexcept nogil

@cython.locals(spelled=cython.longlong)
cdef long long truth_at(PlcContext context, long long at, long long end) noexcept nogil

cdef class RealOfString(Real):
    cdef StringPart text
    @cython.locals(begin=cython.longlong)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class MomentOfString(Whole):
    cdef StringPart text
    cdef int shown
    @cython.locals(begin=cython.longlong, end=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil
