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

    @cython.locals(before=int)
    cdef void activate(self, Py_ssize_t slot, long long number) noexcept nogil
    cpdef bint has_axis(self, Py_ssize_t number, Py_ssize_t axis) except *
    cdef Py_ssize_t joint(self, Py_ssize_t number, Py_ssize_t k) noexcept nogil
    cdef Py_ssize_t joints(self, Py_ssize_t number) noexcept nogil
    cdef Py_ssize_t axis_of(self, Py_ssize_t number, Py_ssize_t k) noexcept nogil
    cdef Py_ssize_t member(self, Py_ssize_t number, Py_ssize_t k) noexcept nogil
    @cython.locals(k=Py_ssize_t, axis=Py_ssize_t)
    cdef void map_forward(
        self, Py_ssize_t number, double[::1] machine, Py_ssize_t tip
    ) noexcept nogil
    @cython.locals(k=Py_ssize_t)
    cdef void copy_tip(self, Py_ssize_t tip, Py_ssize_t to) noexcept nogil
    cdef double tip(self, Py_ssize_t tip, Py_ssize_t k) noexcept nogil
    @cython.locals(row=Py_ssize_t)
    cdef int is_mapped(self, Py_ssize_t number, Py_ssize_t k) noexcept nogil
    @cython.locals(k=Py_ssize_t, axis=Py_ssize_t, total=double, angle=double)
    cdef double rotation(
        self, Py_ssize_t number, double[::1] start, double[::1] target
    ) noexcept nogil
