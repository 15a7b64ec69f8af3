# SPDX-License-Identifier: MIT
# C types of plc_calls.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel.axes.spindles cimport Spindles
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.cycles.expressions cimport Expression
from nctakt.kernel.plc.technology_slots cimport Hli, Section
from nctakt.kernel.tick cimport stops

cdef class Whens:
    cdef int look(self, long long tick) noexcept nogil

cdef class When(Whens):
    cdef Expression expression
    cdef Context context
    cdef readonly int was_true
    cdef int rises
    cdef long long tick
    cdef Whens others
    cdef int look(self, long long tick) noexcept nogil
    @cython.locals(is_now=int)
    cdef void look_alone(self, long long tick) noexcept nogil

@cython.final
cdef class Delays:
    cdef long long others
    cdef Py_ssize_t count
    cdef long long[::1] functions
    cdef long long[::1] delays
    @cython.locals(i=Py_ssize_t)
    cpdef long long delay_of(self, long long function) noexcept nogil

@cython.final
cdef class PlcCalls:
    cdef readonly bint is_watching
    cdef public bint is_noting
    cdef public long long next_tick
    cdef Hli hli
    cdef Spindles spindles
    cdef long long issued_program
    cdef long long issued_realtime
    cdef long long issued_jobs
    cdef Whens whens
    cdef Delays delays
    cdef public Py_ssize_t answer_count
    @cython.locals(is_new=bint, is_risen=int)
    cdef int is_due(self, long long tick) noexcept nogil
    cpdef void answer(self, long long tick) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void answer_section(self, Section section, long long tick) noexcept nogil
