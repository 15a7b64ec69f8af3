# SPDX-License-Identifier: MIT
# C types of c_axis.py.
cimport cython
from nctakt.kernel.axes.axes cimport Axes
from nctakt.kernel.axes.spindles cimport Spindles

@cython.final
cdef class CAxis:
    cdef Axes axes
    cdef readonly Spindles spindles
    cdef readonly Py_ssize_t axis
    cdef readonly Py_ssize_t spindle
    cdef double last
    cdef readonly long long channel
    cdef readonly bint is_active

    cdef int can_take(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(command=double, covered=double)
    cdef void follow(self) noexcept nogil
