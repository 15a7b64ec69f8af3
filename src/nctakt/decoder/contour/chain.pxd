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
    cdef Py_ssize_t left_out_count
    cdef Py_ssize_t count
    cdef Py_ssize_t taken_count
    cdef Py_ssize_t barrier
    cdef readonly long long number
    cdef public double side
    cdef public bint masks
    cdef public long long crossed
    cdef readonly long long crossing
    cdef readonly bint crosses_lead
    cdef long long leading
    cdef Py_ssize_t leading_count
    cdef double radius

    cdef void count_motion(self) noexcept
    cdef void separate(self) noexcept
    cdef void import_from(self, Py_ssize_t count, Py_ssize_t barrier) noexcept
    cdef void put_line(
        self, int shape, double x, double y, double x_2, double y_2, int is_contour
    ) noexcept
    @cython.locals(row=Py_ssize_t, is_gap=bint)
    cdef void put(self, int is_contour) noexcept
    @cython.locals(first=Py_ssize_t, i=Py_ssize_t)
    cdef void make_room(self) noexcept
    @cython.locals(first=Py_ssize_t, before=Py_ssize_t)
    cdef Py_ssize_t oldest(self, Py_ssize_t last) noexcept
    @cython.locals(motion=double)
    cdef int is_near(self, Py_ssize_t piece) noexcept
    @cython.locals(last=Py_ssize_t, crossed_piece=Py_ssize_t)
    cdef void compare(self) noexcept
    @cython.locals(piece=Py_ssize_t)
    cdef void lead(self) noexcept
    @cython.locals(row=Py_ssize_t, k=Py_ssize_t, at=Py_ssize_t)
    cdef void compare_with_leading(self, Py_ssize_t last) noexcept
    @cython.locals(
        row=Py_ssize_t, oldest=double, piece=Py_ssize_t, at=Py_ssize_t, is_neighbour=bint
    )
    cdef void compare_leaving(self, Py_ssize_t last) noexcept
    @cython.locals(x=double, y=double, along=double, rest=double)
    cdef int enters(self, Py_ssize_t first, Py_ssize_t second, Py_ssize_t contour) noexcept
    @cython.locals(room=int, last=Py_ssize_t, crossed_piece=Py_ssize_t)
    cdef void mask(self) noexcept
    @cython.locals(crossed_piece=Py_ssize_t)
    cdef void note(self, Py_ssize_t last) noexcept
    @cython.locals(motion=double)
    cdef void cross(self, Py_ssize_t last, Py_ssize_t crossed_piece) noexcept
    @cython.locals(row=Py_ssize_t, piece=Py_ssize_t, oldest=double)
    cdef Py_ssize_t search(self, Py_ssize_t last, double required_sense) noexcept
    @cython.locals(row=Py_ssize_t, piece=Py_ssize_t, oldest=double)
    cdef Py_ssize_t search_loops(self, Py_ssize_t last) noexcept
    @cython.locals(table=double[::1], x=double, y=double)
    cdef void leave_out(self, Py_ssize_t first, Py_ssize_t last) noexcept
    @cython.locals(at=Py_ssize_t, piece=Py_ssize_t)
    cdef void keep_loop(self, Py_ssize_t first, Py_ssize_t last) noexcept
    @cython.locals(after=Py_ssize_t, piece=Py_ssize_t)
    cdef void forget_loop(self, Py_ssize_t first) noexcept
    cdef Py_ssize_t end_of_loop(self, Py_ssize_t piece) noexcept
    @cython.locals(
        table=double[::1], end=Py_ssize_t, first=Py_ssize_t, before=Py_ssize_t, after=Py_ssize_t,
        x=double, y=double, begin=Py_ssize_t, at=Py_ssize_t, piece=Py_ssize_t
    )
    cdef int restore_loop(self, Py_ssize_t crossed_piece, Py_ssize_t last) noexcept
    @cython.locals(i=Py_ssize_t)
    cdef void copy(self, Py_ssize_t source, Py_ssize_t target) noexcept
    @cython.locals(row=Py_ssize_t, noted=double, piece=Py_ssize_t)
    cpdef int take(self, long long number) noexcept
    @cython.locals(at=Py_ssize_t)
    cdef void hide(self, double x, double y, double radius) noexcept
    @cython.locals(
        row=Py_ssize_t, number=double, piece=Py_ssize_t, at=Py_ssize_t, motion=double, x=double,
        y=double, off=double
    )
    cdef void find_hidden(self) noexcept
    cdef Py_ssize_t taken_row(self) noexcept
    cpdef bint has_next(self, long long number) noexcept
