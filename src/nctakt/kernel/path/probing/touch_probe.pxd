# SPDX-License-Identifier: MIT
# C types of touch_probe.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.probing.fixed_stops cimport FixedStops
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.plc.panel cimport Panel

@cython.final
cdef class TouchProbe:
    cdef Path path
    cdef Panel panel
    cdef Record record
    cdef FixedStops fixed_stops
    cdef readonly double[::1] values
    cdef bint is_seeking
    cdef bint is_braking
    cdef readonly bint has_touched
    cdef long long source
    cdef double touch_part
    cdef long long ticks
    cdef int touch_level
    cdef bint continues
    cdef bint is_needed

    cdef int arm(self, long long source, double[::1] queue, Py_ssize_t row) noexcept nogil
    cdef void clear(self) noexcept nogil
    cdef int is_pressed(self) noexcept nogil
    cdef int watch(self) noexcept nogil
    cdef void seek(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void latch_actual(self, double covered_d) noexcept nogil
    @cython.locals(length_d=double, covered_d=double)
    cdef void latch_simulated(self) noexcept nogil
    cdef void touch(self, double covered_d) noexcept nogil
    cdef int finish(self) noexcept nogil
