# SPDX-License-Identifier: MIT
# C types of reals.py.
cimport cython
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.st cimport functions, kinds, leaves, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.wholes cimport Whole

cdef class Real:
    cdef readonly int leaf
    cdef readonly int kind
    cdef readonly long long offset
    cdef readonly double constant
    cdef double number(self, PlcContext context) noexcept nogil

cdef class RealConstant(Real):
    cdef double number(self, PlcContext context) noexcept nogil

cdef class LoadRealFixed(Real):
    cdef double number(self, PlcContext context) noexcept nogil

cdef class LoadRealFrame(Real):
    cdef double number(self, PlcContext context) noexcept nogil

cdef class LoadRealInstance(Real):
    cdef double number(self, PlcContext context) noexcept nogil

cdef class LoadRealAt(Real):
    cdef Whole address
    @cython.locals(at=cython.longlong)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class UnaryReal(Real):
    cdef readonly Real operand

cdef class BinaryReal(Real):
    cdef readonly Real left
    cdef readonly Real right

cdef class AddReal(BinaryReal):
    @cython.locals(left=double)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class SubtractReal(BinaryReal):
    @cython.locals(left=double)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class MultiplyReal(BinaryReal):
    @cython.locals(left=double)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class DivideReal(BinaryReal):
    @cython.locals(left=double, right=double)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class NegateReal(UnaryReal):
    cdef double number(self, PlcContext context) noexcept nogil

cdef class RoundToSingle(UnaryReal):
    cdef double number(self, PlcContext context) noexcept nogil

cdef class FunctionOfReal(Real):
    cdef int function
    cdef Real operand
    @cython.locals(operand=double)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class FunctionOfTwo(Real):
    cdef int function
    cdef Real left
    cdef Real right
    @cython.locals(left=double, right=double)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class ExtremeReal(Real):
    cdef Real left
    cdef Real right
    cdef bint is_maximum
    @cython.locals(left=double, right=double)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class SelectReal(Real):
    cdef Whole condition
    cdef Real otherwise
    cdef Real chosen
    cdef double number(self, PlcContext context) noexcept nogil

cdef class RealOfWhole(Real):
    cdef Whole operand
    cdef bint is_unsigned
    @cython.locals(value=cython.longlong)
    cdef double number(self, PlcContext context) noexcept nogil

cdef class CompareReal(Whole):
    cdef Real left
    cdef Real right
    cdef int relation
    @cython.locals(left=double, right=double)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class WholeOfReal(Whole):
    cdef Real operand
    cdef int kind
    cdef int rounding
    cdef double lowest
    cdef double limit
    @cython.locals(number=double)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class TruthOfReal(Whole):
    cdef Real operand
    cdef long long value(self, PlcContext context) noexcept nogil

# Last, since real_leaves.pxd needs the classes above.
from nctakt.kernel.st cimport real_leaves
