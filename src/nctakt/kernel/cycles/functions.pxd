# SPDX-License-Identifier: MIT
# C types of functions.py.
cimport cython
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.cycles.expressions cimport Binary, Unary

cdef class Truncate(Unary):
    cdef double value(self, Context context) noexcept nogil

cdef class Fraction(Unary):
    cdef double value(self, Context context) noexcept nogil

cdef class Round(Unary):
    cdef double value(self, Context context) noexcept nogil

cdef class Floor(Unary):
    cdef double value(self, Context context) noexcept nogil

cdef class Ceiling(Unary):
    cdef double value(self, Context context) noexcept nogil

cdef class ArcTangent(Unary):
    cdef double value(self, Context context) noexcept nogil

cdef class ArcCotangent(Unary):
    cdef double value(self, Context context) noexcept nogil

cdef class Absolute(Unary):
    @cython.locals(operand=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Square(Unary):
    @cython.locals(operand=double)
    cdef double value(self, Context context) noexcept nogil

cdef class SquareRoot(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Exponential(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class DecimalExponential(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class NaturalLogarithm(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class DecimalLogarithm(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Sine(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Cosine(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Tangent(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Cotangent(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class ArcSine(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class ArcCosine(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Invert(Unary):
    @cython.locals(operand=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class ArcTangent2(Binary):
    @cython.locals(left=double, result=double)
    cdef double value(self, Context context) noexcept nogil
