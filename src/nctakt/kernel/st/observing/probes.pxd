# SPDX-License-Identifier: MIT
# C types of probes.py.
cimport cython
from nctakt.kernel.st cimport kinds
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.steps cimport Step
from nctakt.kernel.st.wholes cimport Whole

@cython.final
cdef class StatementCounter:
    cdef readonly long long passed
    cdef long long halt_at
    cdef long long room
    cdef Sought each
    cdef readonly long long[::1] sources
    cdef readonly long long[::1] depths
    cdef void count(self, long long source, long long depth) noexcept nogil

cdef class Sought:
    cdef readonly long long held
    cdef long long after
    cdef long long before
    cdef readonly long long first
    cdef readonly long long last
    cdef void look(self, PlcContext context, long long number) noexcept nogil
    cdef void note(self, long long number) noexcept nogil

cdef class SoughtStatement(Sought):
    cdef Whole guard
    cdef long long max_depth
    cdef Sought others
    @cython.locals(truth=cython.longlong)
    cdef void look(self, PlcContext context, long long number) noexcept nogil

cdef class Probe(Step):
    cdef Step body
    cdef long long source
    cdef StatementCounter counter
    cdef Sought sought
    cdef int run(self, PlcContext context) noexcept nogil
