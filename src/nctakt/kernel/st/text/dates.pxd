# SPDX-License-Identifier: MIT
# C types of dates.py.
cimport cython
from nctakt.kernel.st.text cimport characters, digits
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext

@cython.locals(begin=cython.longlong, scale=cython.longlong)
cdef long long put_length(
    PlcContext context, long long at, long long value, bint is_fine
) noexcept nogil

@cython.locals(count=cython.longlong)
cdef long long put_unit(
    PlcContext context, long long at, long long value,
    long long unit, long long ring, long long first,
    long long second
) noexcept nogil

cdef long long put_clock(PlcContext context, long long at, long long seconds) noexcept nogil

@cython.locals(
    shifted=cython.longlong, cycle=cython.longlong, inside=cython.longlong,
    leaps=cython.longlong, year=cython.longlong, rest=cython.longlong, month=cython.longlong,
    number=cython.longlong
)
cdef long long put_day(PlcContext context, long long at, long long day) noexcept nogil

@cython.locals(rest=cython.longlong)
cdef long long put_moment(
    PlcContext context, long long at, long long value, long long shown
) noexcept nogil

@cython.locals(total=double, number=double, unit=double)
cdef double read_length(PlcContext context, long long at, long long end) noexcept nogil

@cython.locals(first=cython.longlong, second=cython.longlong)
cdef double unit_at(PlcContext context, long long at, long long end) noexcept nogil

cdef long long number_at(PlcContext context, long long at, long long end) noexcept nogil

@cython.locals(shifted=cython.longlong, rest=cython.longlong, leaps=cython.longlong)
cdef long long day_of(long long year, long long month, long long day) noexcept nogil

@cython.locals(
    seconds=cython.longlong, year=cython.longlong, month=cython.longlong, day=cython.longlong,
    hour=cython.longlong, minute=cython.longlong, whole=cython.longlong, part=double
)
cdef long long read_moment(
    PlcContext context, long long at, long long end, int shown
) noexcept nogil
