# SPDX-License-Identifier: MIT
# C types of courses.py.
cimport cython

@cython.locals(i=Py_ssize_t)
cpdef Py_ssize_t first(
    double[::1] values, Py_ssize_t begin, double limit, bint below, bint equal, bint above,
    bint unordered
) except -2
@cython.locals(i=Py_ssize_t, is_met=bint, was_met=bint)
cpdef list begins(
    double[::1] values, double limit, bint below, bint equal, bint above, bint unordered
)
cdef bint meets(
    double value, double limit, bint below, bint equal, bint above, bint unordered
) noexcept
