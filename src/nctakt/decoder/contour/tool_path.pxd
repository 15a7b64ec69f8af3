# SPDX-License-Identifier: MIT
# C types of tool_path.py.
cimport cython
from nctakt.decoder.contour cimport rows
from nctakt.decoder.contour cimport pieces
from nctakt.decoder.contour.chain cimport Chain
from nctakt.decoder.contour.corners cimport Corners

cdef double NOTHING_MM

cdef class ToolPath(Chain):
    cdef readonly Corners corners
    cdef double[::1] cut_off
    cdef long long cut_off_number
    cdef readonly bint is_open
    cdef Py_ssize_t last_motion
    cdef public bint parts
    cdef readonly double at_x
    cdef readonly double at_y
    cdef readonly long long first
    cdef long long contour_start
    cdef double contour_start_x
    cdef double contour_start_y
    cdef long long closed
    cdef bint is_begun
    cdef double begin_x
    cdef double begin_y

    cpdef void set_corners(self, bint by_arc, bint is_direct) noexcept
    @cython.locals(at=Py_ssize_t)
    cpdef void line(
        self, double x, double y, double x_2, double y_2, double begin_d, double end_d,
        int compared
    ) noexcept
    @cython.locals(at=Py_ssize_t, motions=double[::1])
    cpdef bint arc(
        self, double x, double y, double x_2, double y_2, double distance, double centre_x,
        double centre_y, double angle
    ) noexcept
    @cython.locals(at=Py_ssize_t)
    cpdef void begin(self, double x, double y, bint is_perpendicular) noexcept
    @cython.locals(
        number=cython.longlong, first=Py_ssize_t, distance=double, meets=int, x=double, y=double,
        piece=Py_ssize_t, row=Py_ssize_t
    )
    cpdef long long enclose(self) noexcept
    @cython.locals(at=Py_ssize_t, meets=int, i=Py_ssize_t)
    cpdef bint add(self) noexcept
    @cython.locals(
        at=Py_ssize_t, count=Py_ssize_t, barrier=Py_ssize_t, leading=cython.longlong, x=double,
        y=double
    )
    cdef bint try_add(self, double low_x, double high_x, double low_y, double high_y) noexcept
    @cython.locals(end_x=double, end_y=double)
    cpdef bint close(self, bint is_perpendicular) noexcept
    cpdef bint last_motion_fits(self) noexcept
    cdef void open(self, Py_ssize_t at) noexcept
    @cython.locals(
        corners=Corners, at=Py_ssize_t, compared=double, is_contour=int, row=Py_ssize_t, fits=int,
        k=int, i=Py_ssize_t, is_lead=bint
    )
    cdef int put_motion(self, int meets, Py_ssize_t other) noexcept
    cdef void compare_lead(self, bint leads) noexcept
    @cython.locals(row=Py_ssize_t)
    cdef void put_end(self, double end_x, double end_y) noexcept
    cdef void put_if_long(self, Py_ssize_t row, int is_contour) noexcept
    @cython.locals(
        corners=Corners, row=Py_ssize_t, i=Py_ssize_t, x=double, y=double, next_x=double,
        next_y=double, motions=double[::1], radius=double
    )
    cdef void part(self, Py_ssize_t at, Py_ssize_t other, int is_contour) noexcept
    @cython.locals(motions=double[::1], off=double)
    cdef void note_ends(self, Py_ssize_t at, int is_contour) noexcept
    cpdef bint closes_contour(self) noexcept
    cdef void keep_cut_off(self, Py_ssize_t at, Py_ssize_t other) noexcept
