# SPDX-License-Identifier: MIT
# C types of override.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.cycles.context cimport Context

@cython.final
cdef class Overrides:
    cdef Context context
    cdef double max_pct
    cdef double operator_pct
    cdef double cycle_pct
    cdef bint is_settled
    cdef double total_pct

    cdef int have_changed(self, double operator_pct, double cycle_pct) noexcept nogil
    @cython.locals(operator=double)
    cdef double parts(self, int ignores_override) noexcept nogil
    cdef double none(self) noexcept nogil
    @cython.locals(pct=double, spindle=Py_ssize_t, speed_v=double)
    cdef double factor(self, double[::1] segments, Py_ssize_t row) noexcept nogil
