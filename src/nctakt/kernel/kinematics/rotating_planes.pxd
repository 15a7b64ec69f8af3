# SPDX-License-Identifier: MIT
# C types of rotating_planes.py.
cimport cython
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.kinematics cimport map_rows

@cython.locals(
    rotary=Py_ssize_t, radial=Py_ssize_t, angle=double, along=double, beside=double, cosine=double,
    sine=double
)
cdef void to_plane(
    double[::1] values, Py_ssize_t row, double[::1] positions, double[::1] results
) noexcept nogil
@cython.locals(
    rotary=Py_ssize_t, radial=Py_ssize_t, angle=double, along=double, along2=double, beside=double,
    x=double, y=double, turns=double
)
cdef int to_axes(
    double[::1] values, Py_ssize_t row, double[::1] positions, double[::1] near,
    double[::1] results
) noexcept nogil
