# SPDX-License-Identifier: MIT
# C types of fused.py.
cimport cython
from nctakt.kernel.cycles.expressions cimport Expression
from nctakt.kernel.cycles.context cimport Context

cdef class CellConstant(Expression):
    cdef Py_ssize_t cell
    cdef double number

cdef class CellCell(Expression):
    cdef Py_ssize_t cell
    cdef Py_ssize_t other

cdef class ExpressionConstant(Expression):
    cdef Expression operand
    cdef double number

cdef class ExpressionCell(Expression):
    cdef Expression operand
    cdef Py_ssize_t cell

cdef class AddCellConstant(CellConstant):
    cdef double value(self, Context context) noexcept nogil

cdef class AddCellCell(CellCell):
    cdef double value(self, Context context) noexcept nogil

cdef class AddExpressionConstant(ExpressionConstant):
    cdef double value(self, Context context) noexcept nogil

cdef class AddExpressionCell(ExpressionCell):
    cdef double value(self, Context context) noexcept nogil

cdef class SubtractCellConstant(CellConstant):
    cdef double value(self, Context context) noexcept nogil

cdef class SubtractCellCell(CellCell):
    cdef double value(self, Context context) noexcept nogil

cdef class SubtractExpressionConstant(ExpressionConstant):
    cdef double value(self, Context context) noexcept nogil

cdef class SubtractExpressionCell(ExpressionCell):
    cdef double value(self, Context context) noexcept nogil

cdef class MultiplyCellConstant(CellConstant):
    cdef double value(self, Context context) noexcept nogil

cdef class MultiplyCellCell(CellCell):
    cdef double value(self, Context context) noexcept nogil

cdef class MultiplyExpressionConstant(ExpressionConstant):
    cdef double value(self, Context context) noexcept nogil

cdef class MultiplyExpressionCell(ExpressionCell):
    cdef double value(self, Context context) noexcept nogil

cdef class DivideExpressionConstant(ExpressionConstant):
    cdef double value(self, Context context) noexcept nogil

cdef class SumOfTwo(Expression):
    cdef Py_ssize_t a
    cdef Py_ssize_t b
    cdef double factor_a
    cdef double factor_b
    cdef double scale
    @cython.locals(total=double)
    cdef double value(self, Context context) noexcept nogil

cdef class SumOfThree(Expression):
    cdef Py_ssize_t a
    cdef Py_ssize_t b
    cdef Py_ssize_t c
    cdef double factor_a
    cdef double factor_b
    cdef double factor_c
    cdef double scale
    @cython.locals(total=double)
    cdef double value(self, Context context) noexcept nogil

cdef class SumOfFour(Expression):
    cdef Py_ssize_t a
    cdef Py_ssize_t b
    cdef Py_ssize_t c
    cdef Py_ssize_t d
    cdef double factor_a
    cdef double factor_b
    cdef double factor_c
    cdef double factor_d
    cdef double scale
    @cython.locals(total=double)
    cdef double value(self, Context context) noexcept nogil
