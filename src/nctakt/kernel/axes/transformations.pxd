# SPDX-License-Identifier: MIT
# C types of transformations.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel.kinematics cimport map_rows
from nctakt.kernel.kinematics.maps cimport KinematicMaps

@cython.final
cdef class Transformations:
    cdef readonly KinematicMaps maps
    cdef int active_count
    cdef long long[::1] active
    cdef double[::1] gathered
    cdef double[::1] mapped
    cdef double[::1] near
    cdef double[::1] tips
    cdef double[::1] directions
    cdef long long named
    cdef Py_ssize_t joint_count
    cdef long long[::1] joint_axes
    cdef long long[::1] joint_members
    cdef long long[::1] joint_mapped
    cdef long long target_number
    cdef double[::1] mapped_targets

    @cython.locals(before=int, first=Py_ssize_t, i=Py_ssize_t)
    cdef void activate(self, Py_ssize_t slot, long long number) noexcept nogil
    cpdef bint has_axis(self, Py_ssize_t number, Py_ssize_t axis) except *
    @cython.locals(second=Py_ssize_t)
    cdef Py_ssize_t second_step(self, Py_ssize_t row) noexcept nogil
    @cython.locals(row=Py_ssize_t, count=Py_ssize_t)
    cdef Py_ssize_t joint(self, Py_ssize_t number, Py_ssize_t k) noexcept nogil
    @cython.locals(row=Py_ssize_t, count=Py_ssize_t, further=Py_ssize_t)
    cdef Py_ssize_t joints(self, Py_ssize_t number) noexcept nogil
    cdef Py_ssize_t axis_of(self, Py_ssize_t number, Py_ssize_t k) noexcept nogil
    @cython.locals(k=Py_ssize_t)
    cdef void map_forward(
        self, Py_ssize_t number, double[::1] machine, Py_ssize_t tip
    ) noexcept nogil
    @cython.locals(row=Py_ssize_t, first=Py_ssize_t)
    cdef void keep_direction(self, Py_ssize_t number, Py_ssize_t slot) noexcept nogil
    @cython.locals(k=Py_ssize_t, is_kept=bint, target=double)
    cdef void map_targets(self, Py_ssize_t number, double[::1] machine) noexcept nogil
    @cython.locals(k=Py_ssize_t)
    cdef void name_joints(self, Py_ssize_t number) noexcept nogil
    @cython.locals(k=Py_ssize_t)
    cdef void copy_tip(self, Py_ssize_t tip, Py_ssize_t to) noexcept nogil
    cdef double tip(self, Py_ssize_t tip, Py_ssize_t k) noexcept nogil
    @cython.locals(row=Py_ssize_t)
    cdef int is_mapped(self, Py_ssize_t number, Py_ssize_t k) noexcept nogil
    @cython.locals(row=Py_ssize_t)
    cdef int is_lateral(self, Py_ssize_t number) noexcept nogil
    @cython.locals(row=Py_ssize_t)
    cdef Py_ssize_t plane_axis(self, Py_ssize_t number) noexcept nogil
    @cython.locals(k=Py_ssize_t)
    cdef int is_rotary(self, Py_ssize_t number, Py_ssize_t axis) noexcept nogil
    @cython.locals(row=Py_ssize_t)
    cdef int turns_otherwise(self, Py_ssize_t number) noexcept nogil
    @cython.locals(k=Py_ssize_t, axis=Py_ssize_t, total=double, angle=double)
    cdef double rotation(
        self, Py_ssize_t number, double[::1] start, double[::1] target
    ) noexcept nogil
