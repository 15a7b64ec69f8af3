# SPDX-License-Identifier: MIT
# C types of transformed_travel.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.axes.transformations cimport Transformations
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.kinematics cimport map_rows

cdef double STEP
cdef double JUMP
cdef int MAX_SAMPLES
cdef double BEGIN
cdef double BEGIN_JUMP

@cython.final
cdef class TransformedTravel:
    cdef Py_ssize_t count
    cdef Transformations transformations
    cdef public Py_ssize_t number
    cdef readonly double position
    cdef readonly int obstacle
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
    cdef double[::1] begin

    cpdef limit(self, Py_ssize_t axis, double low, double high)
    @cython.locals(i=Py_ssize_t)
    cpdef start_at(self, list axes)
    cpdef list axes_at_end(self)
    @cython.locals(i=Py_ssize_t)
    cpdef int first_outside(self, list start, list target, list arc)
    @cython.locals(i=Py_ssize_t)
    cdef int first_outside_of_line(self, double[::1] start, double[::1] target) noexcept nogil
    @cython.locals(steps=int, i=Py_ssize_t, axis=int)
    cdef int find(self, bint is_arc) noexcept nogil
    @cython.locals(i=Py_ssize_t, turn=double)
    cdef int jump_at_begin(self, bint is_arc) noexcept nogil
    @cython.locals(sample=int, i=Py_ssize_t, turn=double, widest=double, found=int)
    cdef int widest_turn(self, bint is_arc, int steps) noexcept nogil
    @cython.locals(turn=double, angle=double, steps=int)
    cdef int steps_of_turn(self, bint is_arc) noexcept nogil
    @cython.locals(sample=int, i=Py_ssize_t)
    cdef int check(self, bint is_arc, int steps) noexcept nogil
    cdef int is_inside(self, Py_ssize_t i, double position) noexcept nogil
    @cython.locals(rise=double, bend=double)
    cdef double vertex(self, Py_ssize_t i) noexcept nogil
    @cython.locals(
        i=Py_ssize_t, first=Py_ssize_t, second=Py_ssize_t, cosine=double, sine=double, x=double,
        y=double
    )
    cdef int sample(self, double part, bint is_arc) noexcept nogil
