# SPDX-License-Identifier: MIT
# C types of maps.py.
cimport cython
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.kinematics cimport map_rows, rotating_planes
from nctakt.kernel.kinematics.orientation cimport Orientation

cdef double SMALLEST_WHOLE

@cython.final
cdef class KinematicMaps:
    cdef readonly Py_ssize_t axis_count
    cdef Py_ssize_t capacity
    cdef readonly Py_ssize_t used
    cdef double[::1] values
    cdef double[::1] columns
    cdef double[::1] linear
    cdef double[::1] between
    cdef double[::1] near_between
    cdef Orientation orientation
    cdef double x
    cdef double y
    cdef double z

    @cython.locals(row=Py_ssize_t, count=Py_ssize_t, k=Py_ssize_t, joint=Py_ssize_t)
    cdef int has_axis(self, Py_ssize_t number, Py_ssize_t axis) noexcept nogil
    @cython.locals(row=Py_ssize_t, second=Py_ssize_t)
    cpdef void forward(
        self, Py_ssize_t number, double[::1] positions, double[::1] near, double[::1] results
    ) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void forward_step(
        self, Py_ssize_t row, double[::1] positions, double[::1] near, double[::1] results
    ) noexcept nogil
    @cython.locals(row=Py_ssize_t, i=Py_ssize_t, answer=int, second=Py_ssize_t)
    cpdef int inverse(
        self, Py_ssize_t number, double[::1] positions, double[::1] near, double[::1] results
    ) noexcept nogil
    @cython.locals(i=Py_ssize_t, answer=int)
    cdef int inverse_step(
        self, Py_ssize_t row, double[::1] positions, double[::1] near, double[::1] results
    ) noexcept nogil
    @cython.locals(row=Py_ssize_t)
    cpdef int aim(
        self, Py_ssize_t number, double[::1] vector, double[::1] near, double[::1] results
    ) noexcept nogil
    @cython.locals(row=Py_ssize_t, joint=Py_ssize_t, first=Py_ssize_t, second=Py_ssize_t)
    cpdef void other_aim(self, Py_ssize_t number, double[::1] results) noexcept nogil
    cpdef void direction(
        self, Py_ssize_t number, double[::1] positions, double[::1] results
    ) noexcept nogil
    @cython.locals(
        count=Py_ssize_t, trailing=Py_ssize_t, leading=Py_ssize_t, k=Py_ssize_t, joint=Py_ssize_t,
        covered=double
    )
    cdef void place_tip(self, Py_ssize_t row, double[::1] positions) noexcept nogil
    @cython.locals(k=Py_ssize_t, joint=Py_ssize_t)
    cdef void turn_back_to(
        self, Py_ssize_t row, Py_ssize_t last, Py_ssize_t first, double[::1] positions
    ) noexcept nogil
    @cython.locals(
        a=double, b=double, c=double, cosine=double, sine=double, x=double, y=double, z=double,
        along=double
    )
    cdef void turn_point(self, Py_ssize_t joint, double angle) noexcept nogil
    @cython.locals(i=Py_ssize_t, matrix=Py_ssize_t)
    cdef void map_linear(self, Py_ssize_t row, double[::1] positions) noexcept nogil
    @cython.locals(
        k=Py_ssize_t, joint=Py_ssize_t, x=double, y=double, z=double, count=Py_ssize_t,
        trailing=Py_ssize_t
    )
    cdef void solve_split(self, Py_ssize_t row, double[::1] results) noexcept nogil
    @cython.locals(i=Py_ssize_t, matrix=Py_ssize_t)
    cdef void unmap_linear(
        self, Py_ssize_t row, double x, double y, double z, double[::1] results
    ) noexcept nogil
    @cython.locals(
        x=double, y=double, z=double, k=Py_ssize_t, joint=Py_ssize_t, axis=Py_ssize_t,
        i=Py_ssize_t, count=Py_ssize_t, column=Py_ssize_t
    )
    cdef int solve_mixed(self, Py_ssize_t row, double[::1] results) noexcept nogil
    @cython.locals(
        turned=Py_ssize_t, further=Py_ssize_t, joint=Py_ssize_t, column=Py_ssize_t,
        count=Py_ssize_t
    )
    cdef void turn_columns(self, Py_ssize_t row, Py_ssize_t k, double angle) noexcept nogil
    @cython.locals(
        a_x=double, a_y=double, a_z=double, whole=double, b_x=double, b_y=double, b_z=double,
        c_x=double, c_y=double, c_z=double, first=double, second=double, third=double
    )
    cdef int solve_columns(
        self, Py_ssize_t row, double x, double y, double z, double[::1] results
    ) noexcept nogil
    @cython.locals(k=Py_ssize_t, joint=Py_ssize_t, angle=double, count=Py_ssize_t)
    cdef void point_tool(self, Py_ssize_t row, double[::1] positions) noexcept nogil
    @cython.locals(first=Py_ssize_t, second=Py_ssize_t, answer=int)
    cdef int name_direction(
        self, Py_ssize_t row, double[::1] near, double[::1] results
    ) noexcept nogil
    @cython.locals(second=double, first=double)
    cdef int turn_axes(
        self, Py_ssize_t row, double[::1] positions, double[::1] near, double[::1] results
    ) noexcept nogil
    @cython.locals(
        first=Py_ssize_t, second=Py_ssize_t, first_axis=Py_ssize_t, second_axis=Py_ssize_t,
        answer=int
    )
    cdef int turn_onto_direction(
        self, Py_ssize_t row, double[::1] near, double[::1] results
    ) noexcept nogil

# The rows that are checked are lists.
cpdef check_map(row, axis_count)
cpdef check_column(row, column, low, high)
