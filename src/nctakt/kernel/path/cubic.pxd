# SPDX-License-Identifier: MIT
# C types of cubic.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic

cdef double MIN_SLOPE
cdef double MAX_SLOPE

cdef int is_cubic(double[::1] segments, Py_ssize_t row) noexcept nogil
@cython.locals(first=Py_ssize_t, begin=double, _=int)
cdef int moves_axis(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, Py_ssize_t i
) noexcept nogil
@cython.locals(value=double)
cdef double parameter(double[::1] segments, Py_ssize_t row, double part) noexcept nogil
@cython.locals(
    t=double, rest=double, first=Py_ssize_t, i=Py_ssize_t, column=Py_ssize_t, begin=double,
    end=double, leaving=double, entering=double
)
cdef void locate(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, double part, double[::1] positions
) noexcept nogil
@cython.locals(
    length=double, t=double, linear=double, square=double, cube=double, fourth=double,
    fifth=double, half=double, slope=double, curve=double, bend=double, start=Py_ssize_t,
    i=Py_ssize_t, column=Py_ssize_t, begin=double, end=double, leaving=double, entering=double,
    b1=double, b2=double, b3=double, one=double, two=double
)
cdef void differentiate(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, double part, double[::1] first,
    double[::1] second, double[::1] third
) noexcept nogil
@cython.locals(
    start=Py_ssize_t, rate2=double, i=Py_ssize_t, column=Py_ssize_t, begin=double, end=double,
    leaving=double, entering=double, b2=double, b3=double, one=double
)
cdef double rate(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, double t, long long[::1] linear,
    int kind
) noexcept nogil
@cython.locals(before=double)
cdef double rates(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, double offset, long long[::1] linear,
    int kind
) noexcept nogil
@cython.locals(
    kind=int, i=Py_ssize_t, length=double, step=double, start_rate=double, end_rate=double,
    shortest=double, longest=double, start_slope=double, end_slope=double, change=double,
    start_curve=double, end_curve=double, slopes=double
)
cdef void measure(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, long long[::1] linear
) noexcept nogil
