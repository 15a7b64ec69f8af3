# SPDX-License-Identifier: MIT
# C types of chain.py.
cimport cython
from nctakt.decoder.contour cimport rows
from nctakt.decoder.contour cimport pieces
from nctakt.decoder.contour.pieces cimport Crossing

cdef class Chain:
    cdef Crossing crossings
    cdef double[::1] rows
    cdef double[::1] hidden
    cdef Py_ssize_t hidden_count
    cdef Py_ssize_t left
    cdef Py_ssize_t count
    cdef Py_ssize_t out
    cdef Py_ssize_t barrier
    cdef readonly long long number
    cdef public double side
    cdef public bint masks
    cdef public long long crossed
    cdef readonly long long crossing

    cdef void count_motion(self) noexcept
    cdef void separate(self) noexcept
    cdef void import_from(self, Py_ssize_t count, Py_ssize_t barrier) noexcept
    cdef void put_line(self, int shape, double x, double y, double x_2, double y_2, int is_contour) noexcept
    @cython.locals(base=Py_ssize_t, is_gap=bint)
    cdef void put(self, int is_contour) noexcept
    @cython.locals(first=Py_ssize_t, i=Py_ssize_t)
    cdef void make_room(self) noexcept
    @cython.locals(first=Py_ssize_t, before=Py_ssize_t)
    cdef Py_ssize_t oldest(self, Py_ssize_t last) noexcept
    @cython.locals(motion=double)
    cdef int is_in_reach(self, Py_ssize_t one) noexcept
    @cython.locals(last=Py_ssize_t, found=Py_ssize_t)
    cdef void compare(self) noexcept
    @cython.locals(room=int, last=Py_ssize_t, found=Py_ssize_t)
    cdef void mask(self) noexcept
    @cython.locals(found=Py_ssize_t)
    cdef void note(self, Py_ssize_t last) noexcept
    @cython.locals(motion=double)
    cdef void cross(self, Py_ssize_t last, Py_ssize_t found) noexcept
    @cython.locals(base=Py_ssize_t, one=Py_ssize_t)
    cdef Py_ssize_t search(self, Py_ssize_t last, double wanted) noexcept
    @cython.locals(base=Py_ssize_t, one=Py_ssize_t)
    cdef Py_ssize_t search_loops(self, Py_ssize_t last) noexcept
    @cython.locals(begin=Py_ssize_t)
    cdef int is_crossed(self, Py_ssize_t one, Py_ssize_t base) noexcept
    @cython.locals(row=double[::1], x=double, y=double)
    cdef void leave_out(self, Py_ssize_t first, Py_ssize_t last) noexcept
    @cython.locals(at=Py_ssize_t, one=Py_ssize_t)
    cdef void keep_loop(self, Py_ssize_t first, Py_ssize_t last) noexcept
    @cython.locals(behind=Py_ssize_t, one=Py_ssize_t)
    cdef void forget_loop(self, Py_ssize_t first) noexcept
    cdef Py_ssize_t end_of_loop(self, Py_ssize_t one) noexcept
    @cython.locals(row=double[::1], end=Py_ssize_t, first=Py_ssize_t, before=Py_ssize_t, rest=Py_ssize_t, x=double, y=double, begin=Py_ssize_t, at=Py_ssize_t, one=Py_ssize_t)
    cdef int take_in(self, Py_ssize_t found, Py_ssize_t last) noexcept
    @cython.locals(i=Py_ssize_t)
    cdef void copy(self, Py_ssize_t one, Py_ssize_t other) noexcept
    @cython.locals(base=Py_ssize_t, noted=double, one=Py_ssize_t)
    cpdef int take(self, long long number) noexcept
    @cython.locals(at=Py_ssize_t)
    cdef void hide(self, double x, double y, double radius) noexcept
    @cython.locals(base=Py_ssize_t, number=double, one=Py_ssize_t, at=Py_ssize_t, motion=double, x=double, y=double, off=double)
    cdef void find_hidden(self) noexcept
    cdef Py_ssize_t taken_place(self) noexcept
    cpdef bint goes_on(self, long long number) noexcept
