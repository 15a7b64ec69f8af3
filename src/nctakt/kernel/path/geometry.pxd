# SPDX-License-Identifier: MIT
# C types of geometry.py.
cimport cython
from nctakt.kernel.base cimport arithmetic

cdef double whole_way(double[::1] row, Py_ssize_t base, Py_ssize_t count) noexcept nogil
@cython.locals(way=double)
cdef double way_with_bend(double[::1] row, Py_ssize_t base, Py_ssize_t count) noexcept nogil
@cython.locals(place=Py_ssize_t)
cdef Py_ssize_t end_place(double[::1] row, Py_ssize_t base, Py_ssize_t count) noexcept nogil
cdef Py_ssize_t pieces(double[::1] row, Py_ssize_t base, Py_ssize_t count) noexcept nogil
cdef int leaves_operator(double[::1] row, Py_ssize_t base, Py_ssize_t count) noexcept nogil
@cython.locals(tail=Py_ssize_t, target=double, has_curve=bint)
cdef int moves(double[::1] row, Py_ssize_t base, Py_ssize_t count, Py_ssize_t i) noexcept nogil
@cython.locals(tail=Py_ssize_t)
cdef double stage_way(double[::1] row, Py_ssize_t base, Py_ssize_t count, int stage) noexcept nogil
@cython.locals(tail=Py_ssize_t)
cdef double stage_acceleration(double[::1] row, Py_ssize_t base, Py_ssize_t count, int stage) noexcept nogil
@cython.locals(tail=Py_ssize_t, speed2=double, curve_v=double, way=double)
cdef double entry_speed(double[::1] row, Py_ssize_t base, Py_ssize_t count, int stage, double end_v, double limit_v) noexcept nogil
@cython.locals(tail=Py_ssize_t, part=double, i=Py_ssize_t, start=double, end=Py_ssize_t, first=Py_ssize_t, second=Py_ssize_t, angle=double, cosine=double, sine=double, x=double, y=double)
cdef void locate(double[::1] row, Py_ssize_t base, Py_ssize_t count, double way, double[::1] places) noexcept nogil
@cython.locals(tail=Py_ssize_t, half=double, length=double, part=double, i=Py_ssize_t, corner=double, before=double, behind=double)
cdef void locate_on_curve(double[::1] row, Py_ssize_t base, Py_ssize_t count, double way, double[::1] places) noexcept nogil
@cython.locals(part=double, is_behind=bint, off=double, i=Py_ssize_t, near=double, far=double, corner=double)
cdef void locate_on_bend(double[::1] row, Py_ssize_t base, Py_ssize_t count, double way, double[::1] places) noexcept nogil
@cython.locals(length=double, i=Py_ssize_t, tail=Py_ssize_t, first=Py_ssize_t, second=Py_ssize_t, place=Py_ssize_t, turn=double)
cdef void direct(double[::1] row, Py_ssize_t base, Py_ssize_t count, int at_end, double[::1] ways) noexcept nogil
@cython.locals(i=Py_ssize_t, tail=Py_ssize_t, first=Py_ssize_t, second=Py_ssize_t, place=Py_ssize_t, turn=double)
cdef void curve(double[::1] row, Py_ssize_t base, Py_ssize_t count, int at_end, double[::1] turns) noexcept nogil
