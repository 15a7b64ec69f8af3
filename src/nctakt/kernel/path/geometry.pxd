# SPDX-License-Identifier: MIT
# C types of geometry.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path cimport cubic

cdef double total_length(double[::1] segments, Py_ssize_t row) noexcept nogil
cdef double length_with_rounding(double[::1] segments, Py_ssize_t row) noexcept nogil
@cython.locals(target=Py_ssize_t)
cdef Py_ssize_t end_column(double[::1] segments, Py_ssize_t row, Py_ssize_t count) noexcept nogil
cdef Py_ssize_t pieces(double[::1] segments, Py_ssize_t row) noexcept nogil
@cython.locals(start=Py_ssize_t, target=Py_ssize_t, curve_end=Py_ssize_t)
cdef int moves_axis(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, Py_ssize_t i
) noexcept nogil
@cython.locals(length=double)
cdef double stage_length(double[::1] segments, Py_ssize_t row, int stage) noexcept nogil
cdef double stage_acceleration(double[::1] segments, Py_ssize_t row, int stage) noexcept nogil
@cython.locals(speed2=double, curve_v=double, gained2=double)
cdef double entry_speed(
    double[::1] segments, Py_ssize_t row, int stage, double end_v, double limit_v
) noexcept nogil
@cython.locals(
    start=Py_ssize_t, target=Py_ssize_t, part=double, i=Py_ssize_t, begin=double, end=Py_ssize_t,
    first=Py_ssize_t, second=Py_ssize_t, angle=double, cosine=double, sine=double, x=double,
    y=double
)
cdef void locate(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, double distance, double[::1] positions
) noexcept nogil
@cython.locals(
    start=Py_ssize_t, target=Py_ssize_t, curve_end=Py_ssize_t, half=double, length=double,
    part=double, i=Py_ssize_t, corner=double, before=double, after=double
)
cdef void locate_on_curve(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, double distance, double[::1] positions
) noexcept nogil
@cython.locals(
    start=Py_ssize_t, target=Py_ssize_t, corners=Py_ssize_t, part=double, is_far_half=bint,
    off=double, i=Py_ssize_t, near=double, far=double, corner=double
)
cdef void locate_on_rounding(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, double distance, double[::1] positions
) noexcept nogil
@cython.locals(
    start=Py_ssize_t, target=Py_ssize_t, length=double, i=Py_ssize_t, first=Py_ssize_t,
    second=Py_ssize_t, end=Py_ssize_t, turn=double
)
cdef void tangent(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, int at_end, double[::1] directions
) noexcept nogil
@cython.locals(i=Py_ssize_t, first=Py_ssize_t, second=Py_ssize_t, end=Py_ssize_t, turn=double)
cdef void curvature(
    double[::1] segments, Py_ssize_t row, Py_ssize_t count, int at_end, double[::1] curvatures
) noexcept nogil
