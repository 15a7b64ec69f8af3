# SPDX-License-Identifier: MIT
# C types of overrides.py.
cimport cython
from nctakt.kernel.memory cimport Context

cdef class Overrides:
    cdef Context context
    cdef Py_ssize_t width
    cdef double most_pct
    cdef double operator_pct
    cdef double cycle_pct
    cdef double total_pct

    cdef double none(self) noexcept nogil
    cdef double common(self) noexcept nogil
    cdef double without_operator(self) noexcept nogil
    @cython.locals(pace=Py_ssize_t, operator=double, pct=double, spindle=Py_ssize_t, speed_v=double)
    cdef double factor(self, double[::1] row, Py_ssize_t base) noexcept nogil
