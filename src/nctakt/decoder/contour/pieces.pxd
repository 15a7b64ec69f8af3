# SPDX-License-Identifier: MIT
# C types of pieces.py.
cimport cython
from nctakt.decoder.contour cimport rows
from nctakt.kernel.base cimport arithmetic

cdef void put_line(
    double[::1] table, Py_ssize_t row, int shape, double x, double y, double x_2, double y_2
) noexcept nogil
@cython.locals(x=double, y=double)
cdef void put_arc(
    double[::1] table, Py_ssize_t row, double centre_x, double centre_y, double angle
) noexcept nogil
cdef double turn(double x, double y, double x_2, double y_2) noexcept nogil
@cython.locals(angle=double, x=double, y=double)
cdef double length(double[::1] table, Py_ssize_t row) noexcept nogil
@cython.locals(more=double, angle=double)
cdef void bound(double[::1] table, Py_ssize_t row) noexcept nogil
@cython.locals(min_x=double, max_x=double, min_y=double, max_y=double, begin=Py_ssize_t)
cdef Py_ssize_t overlapping(
    double[::1] table, Py_ssize_t piece, Py_ssize_t first, double oldest, Py_ssize_t row
) noexcept nogil
cdef void cut_end(double[::1] table, Py_ssize_t row, double x, double y) noexcept nogil
cdef void cut_start(double[::1] table, Py_ssize_t row, double x, double y) noexcept nogil
@cython.locals(angle=double)
cdef double swept(double x, double y, double x_2, double y_2, double sense) noexcept nogil
@cython.locals(
    centre_x=double, centre_y=double, start_x=double, start_y=double, angle=double, turn_=double,
    before=double
)
cdef double angle_to(double[::1] table, Py_ssize_t row, double x, double y) noexcept nogil

@cython.locals(
    angle=double, whole=double, off_x=double, off_y=double, off=double, chord_x=double,
    chord_y=double, along=double, size2=double, start2=double
)
cdef double distance(double[::1] table, Py_ssize_t row, double x, double y) noexcept nogil
@cython.locals(sense=double)
cdef double direction_x(double[::1] table, Py_ssize_t row, double y) noexcept nogil
@cython.locals(sense=double)
cdef double direction_y(double[::1] table, Py_ssize_t row, double x) noexcept nogil

cdef class Crossing:
    cdef double x
    cdef double y
    cdef double along
    cdef double sense
    cdef double required_sense

    cdef int find(self, double[::1] table, Py_ssize_t first, Py_ssize_t second) noexcept nogil
    @cython.locals(
        x=double, y=double, x_2=double, y_2=double, size=double, size_2=double, sine=double,
        off_x=double, off_y=double, along=double, along_2=double
    )
    cdef int of_lines(self, double[::1] table, Py_ssize_t first, Py_ssize_t second) noexcept nogil
    @cython.locals(
        x=double, y=double, size=double, off_x=double, off_y=double, across=double, middle=double,
        radius=double, half=double, count=int, side=int, along=double, at_x=double, at_y=double
    )
    cdef int of_both(
        self, double[::1] table, Py_ssize_t line, Py_ssize_t arc, Py_ssize_t first,
        Py_ssize_t second
    ) noexcept nogil
    @cython.locals(
        x=double, y=double, apart=double, radius=double, radius_2=double, less=double, along=double,
        half=double, count=int, side=int, off=double, at_x=double, at_y=double
    )
    cdef int of_arcs(self, double[::1] table, Py_ssize_t first, Py_ssize_t second) noexcept nogil
    @cython.locals(along=double, sense=double)
    cdef int consider(
        self, double[::1] table, Py_ssize_t first, Py_ssize_t second, double x, double y, int count
    ) noexcept nogil
    @cython.locals(
        x_2=double, y_2=double, size=double, off_x=double, off_y=double, length_to=double
    )
    cdef double distance_along(
        self, double[::1] table, Py_ssize_t row, double x, double y
    ) noexcept nogil
    @cython.locals(x_1=double, y_1=double)
    cdef double sine(
        self, double[::1] table, Py_ssize_t first, Py_ssize_t second, double x, double y
    ) noexcept nogil
