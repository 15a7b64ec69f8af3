# SPDX-License-Identifier: MIT
# C types of conditions.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.cycles.expressions cimport Expression
from nctakt.kernel.cycles.context cimport Context

cdef class Combination

cdef class Condition:
    cdef public long long probe
    cdef readonly int truth
    cdef readonly long long next_tick
    cdef readonly double seen_left
    cdef readonly double seen_right
    cdef readonly bint was_ever_true
    cdef readonly bint was_ever_false
    cdef readonly double distance
    cdef readonly double nearest
    cdef readonly double nearest_left
    cdef readonly double nearest_right
    cdef readonly long long nearest_tick
    cdef int decide(self, Context context) noexcept nogil
    cdef void forget(self) noexcept nogil

@cython.locals(distance=double)
cdef inline void note(
    Condition condition, Context context, int truth, double left, double right
) noexcept nogil
cdef void note_combination(
    Combination condition, Context context, int truth, double distance
) noexcept nogil
@cython.locals(distance=double)
cdef double share(Condition condition) noexcept nogil
cdef void record_change(
    Condition condition, Context context, int truth, double left, double right
) noexcept nogil
@cython.locals(distance=double)
cdef void approach(Condition condition, Context context, double left, double right) noexcept nogil

cdef class Comparison(Condition):
    cdef Expression left
    cdef Expression right

cdef class CellComparison(Condition):
    cdef Expression load
    cdef Py_ssize_t cell
    cdef double number

cdef class IsTrue(Condition):
    cdef Expression operand
    @cython.locals(value=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsTruePart(IsTrue):
    @cython.locals(value=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsTextTrue(IsTrue):
    pass

cdef class Combination(Condition):
    cdef readonly Condition first
    cdef readonly Condition second
    cdef readonly double beside_first
    cdef readonly double beside_second
    cdef void forget(self) noexcept nogil

@cython.locals(first=double, second=double)
cdef double far(Combination combination, bint first_holds, bint second_holds) noexcept nogil

cdef class Both(Combination):
    @cython.locals(first=int, second=int, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class Either(Combination):
    @cython.locals(first=int, second=int, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsLess(Comparison):
    @cython.locals(left=double, right=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsLessCellConstant(CellComparison):
    @cython.locals(left=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsLessEqual(Comparison):
    @cython.locals(left=double, right=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsLessEqualCellConstant(CellComparison):
    @cython.locals(left=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsGreater(Comparison):
    @cython.locals(left=double, right=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsGreaterCellConstant(CellComparison):
    @cython.locals(left=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsGreaterEqual(Comparison):
    @cython.locals(left=double, right=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsGreaterEqualCellConstant(CellComparison):
    @cython.locals(left=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsEqual(Comparison):
    @cython.locals(left=double, right=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsEqualCellConstant(CellComparison):
    @cython.locals(left=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsNotEqual(Comparison):
    @cython.locals(left=double, right=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil

cdef class IsNotEqualCellConstant(CellComparison):
    @cython.locals(left=double, truth=int)
    cdef int decide(self, Context context) noexcept nogil
