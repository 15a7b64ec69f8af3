# SPDX-License-Identifier: MIT
# C types of spindle_overrides.py.
from nctakt.kernel cimport cells
cimport cython

@cython.final
cdef class SpindleOverrides:
    cdef double[::1] cells
    cdef Py_ssize_t first_cell
    cdef Py_ssize_t count
    cdef double[::1] programmed_v
    cdef double[::1] acted_pct
    cdef double[::1] highest_pct
    cdef long long[::1] is_ignored

    cdef Py_ssize_t cell(self, Py_ssize_t spindle) noexcept nogil
    cdef void begin(self, Py_ssize_t spindle, double speed_v, int is_ignored) noexcept nogil
    cdef double commanded(self, Py_ssize_t spindle) noexcept nogil
    @cython.locals(other=Py_ssize_t)
    cdef Py_ssize_t next_changed(self, Py_ssize_t spindle) noexcept nogil
    cdef int apply(self, Py_ssize_t spindle) noexcept nogil
    cdef double factor(self, Py_ssize_t spindle) noexcept nogil
