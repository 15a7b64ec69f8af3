# SPDX-License-Identifier: MIT
# C types of tool_path.py.
cimport cython
from nctakt.decoder cimport pieces
from nctakt.decoder.corners cimport Corners
from nctakt.decoder.pieces cimport Crossing

cdef class ToolPath:
    cdef readonly Corners corners
    cdef Crossing crossings
    cdef double[::1] rows
    cdef double[::1] rest
    cdef long long rest_number
    cdef Py_ssize_t left
    cdef Py_ssize_t count
    cdef Py_ssize_t out
    cdef Py_ssize_t barrier
    cdef readonly long long number
    cdef readonly bint is_open
    cdef Py_ssize_t latest
    cdef public double side
    cdef public bint masks
    cdef public bint parts
    cdef readonly double at_x
    cdef readonly double at_y
    cdef public long long crossed
    cdef readonly long long crossing

    cpdef void set_corners(self, bint by_arc, bint is_direct) noexcept
    @cython.locals(at=Py_ssize_t)
    cpdef void line(self, double x, double y, double x_2, double y_2, double begin_d, double end_d, bint is_contour) noexcept
    @cython.locals(at=Py_ssize_t, motions=double[::1])
    cpdef bint arc(self, double x, double y, double x_2, double y_2, double distance, double centre_x, double centre_y, double angle) noexcept
    @cython.locals(at=Py_ssize_t)
    cpdef void begin(self, double x, double y, bint is_perpendicular) noexcept
    @cython.locals(at=Py_ssize_t, meets=int)
    cpdef bint add(self) noexcept
    @cython.locals(at=Py_ssize_t, count=Py_ssize_t, barrier=Py_ssize_t, x=double, y=double)
    cdef bint try_add(self, double low_x, double high_x, double low_y, double high_y) noexcept
    @cython.locals(end_x=double, end_y=double)
    cpdef bint close(self, bint is_perpendicular) noexcept
    cpdef bint latest_fits(self) noexcept
    cdef void open(self, Py_ssize_t at) noexcept
    @cython.locals(corners=Corners, at=Py_ssize_t, is_contour=int, base=Py_ssize_t, fits=int, k=int, i=Py_ssize_t)
    cdef int put_motion(self, int meets, Py_ssize_t other) noexcept
    @cython.locals(corners=Corners, base=Py_ssize_t, i=Py_ssize_t, x=double, y=double, next_x=double, next_y=double)
    cdef void part(self, Py_ssize_t at, Py_ssize_t other, int is_contour) noexcept
    cdef void keep_rest(self, Py_ssize_t at, Py_ssize_t other) noexcept
    cdef void put_line(self, int kind, double x, double y, double x_2, double y_2, int is_contour) noexcept
    @cython.locals(base=Py_ssize_t, is_gap=bint)
    cdef void put(self, int is_contour) noexcept
    @cython.locals(first=Py_ssize_t, i=Py_ssize_t)
    cdef void make_room(self) noexcept
    @cython.locals(first=Py_ssize_t)
    cdef Py_ssize_t oldest(self, Py_ssize_t last) noexcept
    @cython.locals(last=Py_ssize_t, found=Py_ssize_t)
    cdef void compare(self) noexcept
    @cython.locals(room=int, last=Py_ssize_t, found=Py_ssize_t)
    cdef void mask(self) noexcept
    @cython.locals(found=Py_ssize_t)
    cdef void note(self, Py_ssize_t last) noexcept
    @cython.locals(rows=double[::1], base=Py_ssize_t, one=Py_ssize_t)
    cdef Py_ssize_t search(self, Py_ssize_t last, double wanted) noexcept
    @cython.locals(rows=double[::1], base=Py_ssize_t, one=Py_ssize_t)
    cdef Py_ssize_t search_loops(self, Py_ssize_t last) noexcept
    @cython.locals(rows=double[::1], x=double, y=double)
    cdef void leave_out(self, Py_ssize_t first, Py_ssize_t last) noexcept
    @cython.locals(at=Py_ssize_t, one=Py_ssize_t)
    cdef void keep_loop(self, Py_ssize_t first, Py_ssize_t last) noexcept
    @cython.locals(behind=Py_ssize_t, one=Py_ssize_t)
    cdef void forget_loop(self, Py_ssize_t first) noexcept
    cdef Py_ssize_t end_of_loop(self, Py_ssize_t one) noexcept
    @cython.locals(rows=double[::1], end=Py_ssize_t, first=Py_ssize_t, rest=Py_ssize_t, x=double, y=double, begin=Py_ssize_t, at=Py_ssize_t, one=Py_ssize_t)
    cdef int take_in(self, Py_ssize_t found, Py_ssize_t last) noexcept
    @cython.locals(i=Py_ssize_t)
    cdef void copy(self, Py_ssize_t one, Py_ssize_t other) noexcept
    @cython.locals(kind=int, noted=double, one=Py_ssize_t)
    cpdef int take(self, long long number) noexcept
    cdef Py_ssize_t taken_place(self) noexcept
    cpdef bint goes_on(self, long long number) noexcept
