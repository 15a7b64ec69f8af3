# SPDX-License-Identifier: MIT
# C types of wholes.py.
cimport cython
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext

cdef class Whole:
    cdef int leaf
    cdef int kind
    cdef long long offset
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class WholeConstant(Whole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class LoadFixed(Whole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class LoadFrame(Whole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class LoadInstance(Whole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class LoadAt(Whole):
    cdef Whole address
    @cython.locals(at=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class FramePlace(Whole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class InstancePlace(Whole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class PassingPlace(Whole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class MemberPlace(Whole):
    cdef Whole address
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class PointedPlace(Whole):
    cdef Whole pointer
    cdef long long size
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class ElementPlace(Whole):
    cdef Whole address
    cdef Whole index
    cdef long long lowest
    cdef long long count
    cdef long long stride
    cdef readonly bint is_near
    @cython.locals(address=cython.longlong, index=cython.longlong, number=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class LoadElement(ElementPlace):
    @cython.locals(at=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil
    @cython.locals(at=cython.longlong, index=cython.longlong, number=cython.longlong)
    cdef long long far_value(self, PlcContext context) noexcept nogil

cdef class OpenElementPlace(Whole):
    cdef Whole address
    cdef Whole bounds
    cdef Whole index
    cdef Whole stride
    @cython.locals(
        address=cython.longlong, bounds=cython.longlong, index=cython.longlong,
        lowest=cython.longlong, highest=cython.longlong
    )
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class UnaryWhole(Whole):
    cdef Whole operand

cdef class BinaryWhole(Whole):
    cdef Whole left
    cdef readonly Whole right

cdef class AddWhole(BinaryWhole):
    @cython.locals(left=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class SubtractWhole(BinaryWhole):
    @cython.locals(left=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class MultiplyWhole(BinaryWhole):
    @cython.locals(left=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class DivideWhole(Whole):
    cdef Whole left
    cdef Whole right
    cdef bint is_unsigned
    cdef bint is_modulo
    @cython.locals(left=cython.longlong, right=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class NegateWhole(UnaryWhole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class AbsoluteWhole(UnaryWhole):
    @cython.locals(value=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class AndBits(BinaryWhole):
    @cython.locals(left=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class OrBits(BinaryWhole):
    @cython.locals(left=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class XorBits(BinaryWhole):
    @cython.locals(left=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class NotBits(Whole):
    cdef Whole operand
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class NotTruth(UnaryWhole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class AndThen(BinaryWhole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class OrElse(BinaryWhole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef long long holds(int relation, long long left, long long right) noexcept nogil

cdef class CompareWhole(Whole):
    cdef Whole left
    cdef Whole right
    cdef int relation
    @cython.locals(left=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class CompareUnsigned(Whole):
    cdef Whole left
    cdef Whole right
    cdef int relation
    cdef bint is_left
    cdef bint is_right
    @cython.locals(
        left=cython.longlong, right=cython.longlong, left_part=cython.longlong,
        right_part=cython.longlong
    )
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class WrapWhole(Whole):
    cdef Whole operand
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class SelectWhole(Whole):
    cdef Whole condition
    cdef Whole otherwise
    cdef Whole chosen
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class ExtremeWhole(Whole):
    cdef Whole left
    cdef Whole right
    cdef bint is_unsigned
    cdef bint is_maximum
    @cython.locals(left=cython.longlong, right=cython.longlong, is_less=bint)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class MoveBits(Whole):
    cdef Whole operand
    cdef Whole count
    cdef long long operation
    cdef long long bits
    cdef long long mask
    @cython.locals(value=cython.longlong, count=cython.longlong, low=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class CycleTime(Whole):
    cdef long long unit
    cdef long long value(self, PlcContext context) noexcept nogil

# Last, since leaves.pxd needs the classes above.
from nctakt.kernel.st cimport leaves
