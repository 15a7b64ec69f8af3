# SPDX-License-Identifier: MIT
# C types of transformed_way.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.axes.transformations cimport Transformations
from nctakt.kernel.base cimport arithmetic

cdef double STEP

@cython.final
cdef class TransformedWay:
    cdef Py_ssize_t count
    cdef Transformations transformations
    cdef public Py_ssize_t number
    cdef readonly double position
    cdef double[::1] lows
    cdef double[::1] highs
    cdef double[::1] start
    cdef double[::1] target
    cdef double[::1] arc
    cdef double[::1] point
    cdef double[::1] near
    cdef double[::1] newest
    cdef double[::1] middle
    cdef double[::1] before

    cpdef limit(self, Py_ssize_t axis, double low, double high)
    @cython.locals(i=Py_ssize_t)
    cpdef int first_outside(self, list start, list target, list arc)
    @cython.locals(i=Py_ssize_t)
    cdef int first_outside_of_line(self, double[::1] start, double[::1] target) noexcept nogil
    @cython.locals(turn=double, angle=double, steps=Py_ssize_t, sample=Py_ssize_t, i=Py_ssize_t)
    cdef int check(self, bint is_arc) noexcept nogil
    cdef int is_inside(self, Py_ssize_t i, double position) noexcept nogil
    @cython.locals(rise=double, bend=double)
    cdef double vertex(self, Py_ssize_t i) noexcept nogil
    @cython.locals(
        i=Py_ssize_t, first=Py_ssize_t, second=Py_ssize_t, cosine=double, sine=double, x=double,
        y=double
    )
    cdef void sample(self, double part, bint is_arc) noexcept nogil
