# SPDX-License-Identifier: MIT
# C types of corners.py.
cimport cython
from nctakt.decoder.contour cimport rows
from nctakt.decoder.contour cimport pieces
from nctakt.kernel.base cimport arithmetic

cdef class Corners:
    cdef double[::1] motions
    cdef double[::1] joint
    cdef int joint_count
    cdef public bint by_arc
    cdef public bint is_direct
    cdef double end_x
    cdef double end_y
    cdef double next_x
    cdef double next_y

    @cython.locals(motions=double[::1], size=double)
    cdef void enter(
        self, Py_ssize_t at, double x, double y, double x_2, double y_2, double begin_d,
        double end_d
    ) noexcept
    @cython.locals(
        motions=double[::1], sense=double, x=double, y=double, radius=double, is_too_small=bint
    )
    cdef void bend(self, Py_ssize_t at, double centre_x, double centre_y, double angle) noexcept
    @cython.locals(motions=double[::1], distance=double)
    cdef void place_end(self, Py_ssize_t at) noexcept
    @cython.locals(motions=double[::1], distance=double)
    cdef void place_start(self, Py_ssize_t at) noexcept
    cdef void add_line(self, int shape, double x, double y, double x_2, double y_2) noexcept
    @cython.locals(motions=double[::1], distance=double)
    cdef int join(self, Py_ssize_t first, Py_ssize_t second) noexcept
    @cython.locals(motions=double[::1], x=double, y=double)
    cdef int join_contour(self, Py_ssize_t first, Py_ssize_t second, double distance) noexcept
    @cython.locals(x=double, y=double)
    cdef void part(self, Py_ssize_t first, Py_ssize_t second) noexcept
    @cython.locals(distance=double)
    cdef int meets_inside(self, Py_ssize_t first, Py_ssize_t second) noexcept
    @cython.locals(
        motions=double[::1], x=double, y=double, distance=double, end_x=double, end_y=double,
        centre_x=double, centre_y=double, angle=double
    )
    cdef void put_cut_off(self, Py_ssize_t first, double[::1] table, Py_ssize_t row) noexcept
    cdef void meet(self, double x, double y) noexcept
    @cython.locals(motions=double[::1], share=double, off_x=double, off_y=double)
    cdef void meet_between(self, Py_ssize_t first, Py_ssize_t second, double distance) noexcept
    @cython.locals(motions=double[::1], along=double)
    cdef double cosine(self, Py_ssize_t first, Py_ssize_t second) noexcept
    @cython.locals(motions=double[::1], across=double)
    cdef double sine(self, Py_ssize_t first, Py_ssize_t second) noexcept
    cdef int is_straight(self, Py_ssize_t first, Py_ssize_t second) noexcept
    @cython.locals(sine=double)
    cdef int is_outer(self, Py_ssize_t first, Py_ssize_t second, double distance) noexcept
    @cython.locals(x=double, y=double, extent=double)
    cdef int is_within(
        self, Py_ssize_t first, double low_x, double high_x, double low_y, double high_y
    ) noexcept
    @cython.locals(
        motions=double[::1], corner_x=double, corner_y=double, x=double, y=double, x_2=double,
        y_2=double, cosine=double, share=double, extent=double
    )
    cdef void go_around(self, Py_ssize_t first, Py_ssize_t second, double distance) noexcept
    @cython.locals(motions=double[::1], angle=double)
    cdef void add_arc(self, Py_ssize_t first, Py_ssize_t second, double distance) noexcept
    @cython.locals(
        motions=double[::1], arc=Py_ssize_t, x=double, y=double, off_x=double, off_y=double,
        across=double, middle=double, radius=double, half2=double, half=double, along=double,
        at_x=double
    )
    cdef int meet_nearest(self, Py_ssize_t first, Py_ssize_t second, double distance) noexcept
    @cython.locals(
        motions=double[::1], x=double, y=double, apart=double, radius=double, radius_2=double,
        along=double, half2=double, half=double, off_x=double, off_y=double
    )
    cdef int meet_of_arcs(self, Py_ssize_t first, Py_ssize_t second, double distance) noexcept
    @cython.locals(sense=double)
    cdef double shifted_radius(self, Py_ssize_t at, double distance) noexcept
    @cython.locals(motions=double[::1], x=double, y=double, length=double)
    cdef int put_own(self, Py_ssize_t at, double[::1] table, Py_ssize_t row) noexcept
    @cython.locals(
        motions=double[::1], centre_x=double, centre_y=double, sense=double, whole=double,
        distance=double, angle=double, length=double
    )
    cdef int put_own_arc(self, Py_ssize_t at, double[::1] table, Py_ssize_t row) noexcept
