# SPDX-License-Identifier: MIT
# C types of expressions.py.
cimport cython
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.cycles.context cimport Context

cdef class Expression:
    cdef double value(self, Context context) noexcept nogil

cdef class Constant(Expression):
    cdef double number
    cdef double value(self, Context context) noexcept nogil

cdef class Load(Expression):
    cdef readonly Py_ssize_t cell
    cdef readonly Py_ssize_t room
    cdef double value(self, Context context) noexcept nogil

cdef class Index(Expression):
    cdef readonly long long span
    cdef Expression index
    cdef long long stride
    cdef long long count
    cdef Expression further
    cdef long long source
    cdef int message
    @cython.locals(number=double)
    cdef double value(self, Context context) noexcept nogil

cdef class LoadElement(Expression):
    cdef Py_ssize_t first_cell
    cdef Expression index
    @cython.locals(index=Py_ssize_t)
    cdef double value(self, Context context) noexcept nogil

cdef class Binary(Expression):
    cdef Expression left
    cdef Expression right

cdef class Unary(Expression):
    cdef Expression operand

cdef class Add(Binary):
    @cython.locals(left=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Subtract(Binary):
    @cython.locals(left=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Multiply(Binary):
    @cython.locals(left=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Divide(Binary):
    @cython.locals(left=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Modulo(Binary):
    @cython.locals(left=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Power(Binary):
    @cython.locals(left=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class BitAnd(Binary):
    @cython.locals(left=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class BitOr(Binary):
    @cython.locals(left=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class BitXor(Binary):
    @cython.locals(left=double, result=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Less(Binary):
    @cython.locals(left=double)
    cdef double value(self, Context context) noexcept nogil

cdef class LessEqual(Binary):
    @cython.locals(left=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Greater(Binary):
    @cython.locals(left=double)
    cdef double value(self, Context context) noexcept nogil

cdef class GreaterEqual(Binary):
    @cython.locals(left=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Equal(Binary):
    @cython.locals(left=double)
    cdef double value(self, Context context) noexcept nogil

cdef class NotEqual(Binary):
    @cython.locals(left=double)
    cdef double value(self, Context context) noexcept nogil

cdef class And(Binary):
    @cython.locals(left=double, right=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Or(Binary):
    @cython.locals(left=double, right=double)
    cdef double value(self, Context context) noexcept nogil

cdef class ExclusiveOr(Binary):
    @cython.locals(left=double, right=double)
    cdef double value(self, Context context) noexcept nogil

cdef class Negate(Unary):
    cdef double value(self, Context context) noexcept nogil

cdef class Not(Unary):
    cdef double value(self, Context context) noexcept nogil
