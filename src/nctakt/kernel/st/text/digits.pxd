# SPDX-License-Identifier: MIT
# C types of digits.py.
cimport cython
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.st.text cimport characters
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext

cdef long long put(PlcContext context, long long at, long long character) noexcept nogil

@cython.locals(
    count=cython.longlong, rest=cython.longlong, i=cython.longlong, digit=cython.longlong
)
cdef long long put_unsigned(
    PlcContext context, long long at, long long value, long long base, long long width
) noexcept nogil

cdef long long put_signed(PlcContext context, long long at, long long value) noexcept nogil

cdef long long put_special(PlcContext context, long long at, double value) noexcept nogil

@cython.locals(
    spelled=cython.longlong, count=cython.longlong, mark=cython.longlong,
    exponent=cython.longlong, i=cython.longlong, digits=cython.longlong
)
cdef long long put_real(
    PlcContext context, long long at, double value, bint is_single
) noexcept nogil

cdef long long put_scientific(
    PlcContext context, long long at, long long spelled, long long digits, long long exponent
) noexcept nogil

@cython.locals(taken=cython.longlong, _=cython.longlong)
cdef long long put_plain(
    PlcContext context, long long at, long long spelled, long long digits, long long exponent
) noexcept nogil

@cython.locals(character=cython.longlong, digit=cython.longlong)
cdef long long digit_of(PlcContext context, long long at, long long base) noexcept nogil

cdef long long skip_blanks(PlcContext context, long long at, long long end) noexcept nogil

@cython.locals(i=cython.longlong)
cdef long long skip_prefix(PlcContext context, long long at, long long end) noexcept nogil

@cython.locals(value=cython.longlong, digit=cython.longlong)
cdef long long read_digits(
    PlcContext context, long long at, long long end, long long base
) noexcept nogil

cdef long long skip_digits(PlcContext context, long long at, long long end) noexcept nogil

@cython.locals(is_negative=bint, after=cython.longlong, value=cython.longlong)
cdef long long read_whole(PlcContext context, long long at, long long end) noexcept nogil

@cython.locals(i=cython.longlong, first=cython.longlong, exponent=cython.longlong)
cdef double read_real(PlcContext context, long long at, long long end) noexcept nogil
