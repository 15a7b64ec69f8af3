# SPDX-License-Identifier: MIT
# C types of orientation.py.
cimport cython
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.kinematics cimport map_rows

cdef double POLE
cdef double ROUNDING

@cython.final
cdef class Orientation:
    cdef double first
    cdef double second
    cdef double other_first
    cdef double other_second
    cdef double x
    cdef double y
    cdef double z

    cdef void start(self, double[::1] values, Py_ssize_t column) noexcept nogil
    @cython.locals(
        a=double, b=double, c=double, cosine=double, sine=double, x=double, y=double, z=double,
        along=double
    )
    cdef void turn(self, double[::1] values, Py_ssize_t column, double angle) noexcept nogil
    @cython.locals(size=double)
    cdef int normalise(self) noexcept nogil
    @cython.locals(
        u_x=double, u_y=double, u_z=double, n_x=double, n_y=double, n_z=double, sine2=double,
        c=double, g=double, h=double, e=double, m_x=double, m_y=double, m_z=double,
        ordinate=double, abscissa=double, rest=double, middle=double, aside=double
    )
    cdef int solve(
        self, double[::1] values, Py_ssize_t p, Py_ssize_t q, Py_ssize_t t, double near_first,
        double near_second
    ) noexcept nogil
    @cython.locals(angle=double)
    cdef void prefer_nearer(self, double near_first, double near_second) noexcept nogil
    @cython.locals(
        a=double, b=double, c=double, w_x=double, w_y=double, w_z=double, v_x=double, v_y=double,
        v_z=double, ordinate=double
    )
    cdef double turn_onto(
        self, double[::1] values, Py_ssize_t p, Py_ssize_t q, Py_ssize_t t, double angle,
        double u_x, double u_y, double u_z, double near
    ) noexcept nogil

cdef double product(double[::1] values, Py_ssize_t p, Py_ssize_t q) noexcept nogil
cdef double nearest(double angle, double near) noexcept nogil
cdef double distance(double angle, double near) noexcept nogil
