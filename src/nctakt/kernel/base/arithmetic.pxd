# SPDX-License-Identifier: MIT
# C types of arithmetic.py; cpdef, because the decoder and the tests call the same functions.
cimport cython
from libc cimport math

cdef double NAN
cdef double INFINITY

cpdef bint is_finite(double value) noexcept nogil
cpdef double divide(double left, double right) noexcept nogil
cpdef double modulo(double left, double right) noexcept nogil
@cython.locals(size=double)
cpdef double power(double base, double exponent) noexcept nogil
@cython.locals(whole=cython.longlong, below=double)
cpdef double floor(double value) noexcept nogil
cpdef double ceiling(double value) noexcept nogil
cpdef double truncate(double value) noexcept nogil
cpdef double fraction(double value) noexcept nogil
@cython.locals(below=double, fraction=double)
cpdef double round_half_even(double value) noexcept nogil
@cython.locals(inside=double)
cpdef double within(double value, double low, double full) noexcept nogil
cpdef double square_root(double value) noexcept nogil
cpdef double exponential(double value) noexcept nogil
cpdef double decimal_exponential(double value) noexcept nogil
cpdef double natural_logarithm(double value) noexcept nogil
cpdef double decimal_logarithm(double value) noexcept nogil
@cython.locals(x=double, y=double, s=double)
cdef double _small_sine(double degrees) noexcept nogil
@cython.locals(x=double, y=double, c=double)
cdef double _small_cosine(double degrees) noexcept nogil
@cython.locals(angle=double, sign=double)
cpdef double sine(double degrees) noexcept nogil
@cython.locals(angle=double)
cpdef double cosine(double degrees) noexcept nogil
cpdef double tangent(double degrees) noexcept nogil
cpdef double cotangent(double degrees) noexcept nogil
cpdef double arc_sine(double value) noexcept nogil
cpdef double arc_cosine(double value) noexcept nogil
cpdef double arc_tangent(double value) noexcept nogil
cpdef double arc_tangent_2(double ordinate, double abscissa) noexcept nogil
cpdef double arc_cotangent(double value) noexcept nogil
cpdef bint is_bit_pattern(double value) noexcept nogil
@cython.locals(a=cython.longlong, b=cython.longlong)
cpdef double bit_and(double left, double right) noexcept nogil
@cython.locals(a=cython.longlong, b=cython.longlong)
cpdef double bit_or(double left, double right) noexcept nogil
@cython.locals(a=cython.longlong, b=cython.longlong)
cpdef double bit_xor(double left, double right) noexcept nogil
@cython.locals(a=cython.longlong)
cpdef double bit_invert(double value) noexcept nogil
cpdef bint is_true(double value) noexcept nogil
