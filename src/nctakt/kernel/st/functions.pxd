# SPDX-License-Identifier: MIT
# C types of functions.py.
cimport cython
from libc cimport math
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.st cimport kinds

@cython.locals(is_positive=bint)
cdef double quotient_by_zero(double left, double right) noexcept nogil

@cython.locals(below=double, part=double, is_up=bint)
cdef double round_half_away(double value) noexcept nogil

@cython.locals(rest=double)
cdef long long low_bits(double value) noexcept nogil

cdef double of_angle(int function, double value) noexcept nogil

cdef double to_angle(int function, double value) noexcept nogil

cdef double of_real(int function, double value) noexcept nogil

@cython.locals(rest=double)
cdef double of_two(int function, double left, double right) noexcept nogil
