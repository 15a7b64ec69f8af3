# SPDX-License-Identifier: MIT
# C types of history.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.goal cimport Goal
from nctakt.kernel.path.lookahead cimport LookAhead
from nctakt.kernel.path.path cimport Path

cdef class History:
    cdef Path path
    cdef LookAhead look_ahead
    cdef Goal goal
    cdef long long[::1] foreign
    cdef long long number
    cdef long long front_number
    cdef long long front_map
    cdef long long[::1] stretch
    cdef Py_ssize_t max_stretch
    cdef long long stretch_end
    cdef double[::1] goal_row
    cdef double limit_a
    cdef double limit_j
    cdef double rounding_a
    cdef double rounding_j

    cdef long long neighbour(self, long long number, int direction) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef int is_shut(self, Py_ssize_t row) noexcept nogil
    @cython.locals(has_changed=int, i=Py_ssize_t)
    cdef int note_foreign(self) noexcept nogil
    @cython.locals(first=Py_ssize_t, second=Py_ssize_t)
    cdef double passing_speed(self, long long number, long long other) noexcept nogil
    @cython.locals(count=Py_ssize_t, number=cython.longlong, other=cython.longlong)
    cdef void survey(self, int is_new) noexcept nogil
    @cython.locals(
        last=Py_ssize_t, row=Py_ssize_t, before=Py_ssize_t, first=Py_ssize_t, corner_v=double
    )
    cdef void find_goal(self, Py_ssize_t count) noexcept nogil
    @cython.locals(own_a=double, own_j=double, speed=double, max_speed=double, fades_d=double)
    cdef void take_over(self, Py_ssize_t before, Py_ssize_t row) noexcept nogil
