# SPDX-License-Identifier: MIT
# C types of path_axes.py.
cimport cython
from nctakt.kernel cimport cells, codes, rows
from nctakt.kernel.path cimport geometry
from nctakt.kernel.axes.axes cimport Axes
from nctakt.kernel.kinematics.maps cimport KinematicMaps

cdef class PathAxes:
    cdef Axes axes
    cdef double shown_pct
    cdef int shown_hold
    cdef long long shown_version
    cdef readonly Py_ssize_t count
    cdef readonly Py_ssize_t room
    cdef long long[::1] members
    cdef long long[::1] moved
    cdef Py_ssize_t moved_count
    cdef readonly Py_ssize_t refused_axis
    cdef double[::1] history_rows
    cdef Py_ssize_t row
    cdef readonly int direction
    cdef KinematicMaps maps
    cdef Py_ssize_t slot
    cdef double[::1] unmapped
    cdef double[::1] near
    cdef double[::1] mapped

    cdef int is_place_free(self, Py_ssize_t i) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef Py_ssize_t locked_axis(self) noexcept nogil
    @cython.locals(number=Py_ssize_t)
    cdef void transform(self, double[::1] queue, Py_ssize_t row) noexcept nogil
    cdef long long shown_map(self) noexcept nogil
    @cython.locals(first=Py_ssize_t, i=Py_ssize_t)
    cdef void publish_direction(self, double[::1] memory, Py_ssize_t cell) noexcept nogil
    cdef void show_map(self, long long number) noexcept nogil
    @cython.locals(i=Py_ssize_t, message=int)
    cdef int refusal(self, Py_ssize_t queue_row, double[::1] queue) noexcept nogil
    cdef int obstacle(self, Py_ssize_t queue_row, double[::1] queue, Py_ssize_t i) noexcept nogil
    cdef int moves_axis(self, double[::1] segments, Py_ssize_t row, Py_ssize_t i) noexcept nogil
    @cython.locals(i=Py_ssize_t, number=Py_ssize_t)
    cdef void map_to_axes(
        self, Py_ssize_t row, double[::1] segments, Py_ssize_t column
    ) noexcept nogil
    @cython.locals(command=double, distance=double)
    cdef int is_there(
        self, double[::1] segments, Py_ssize_t row, Py_ssize_t column, Py_ssize_t i
    ) noexcept nogil
    cdef void put_transformed(self, double[::1] positions) noexcept nogil
    @cython.locals(i=Py_ssize_t, number=Py_ssize_t)
    cdef void map_positions(self, double[::1] positions) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void to_axes(self, double[::1] positions) noexcept nogil
    @cython.locals(continues=int, i=Py_ssize_t, distance=double)
    cdef int continues_from(self, double[::1] ends) noexcept nogil
    @cython.locals(k=Py_ssize_t, i=Py_ssize_t)
    cdef void put_mapped(self) noexcept nogil
    @cython.locals(k=Py_ssize_t, i=Py_ssize_t, end=Py_ssize_t)
    cdef void aim(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void claim(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void claim_again(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void claim_free(self, Py_ssize_t column) noexcept nogil
    @cython.locals(axis=Py_ssize_t, end=Py_ssize_t)
    cdef void claim_axis(self, Py_ssize_t i) noexcept nogil
    @cython.locals(k=Py_ssize_t)
    cdef void release(self) noexcept nogil
    @cython.locals(k=Py_ssize_t, axis=Py_ssize_t)
    cdef void show_standstill(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, axis=Py_ssize_t, cell=Py_ssize_t, cycle_pct=double)
    cdef int has_no_cycle_override(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, is_shown=bint)
    cdef void publish_overrides(self, double operator_pct, int is_held) noexcept nogil
    @cython.locals(i=Py_ssize_t, k=Py_ssize_t)
    cdef void put_axes(self, Py_ssize_t column) noexcept nogil
