# SPDX-License-Identifier: MIT
# C types of technology_slots.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.plc.panel cimport Panel

@cython.final
cdef class FunctionTable:
    cdef long long[::1] m
    cdef long long[::1] h
    cdef Py_ssize_t m_count
    cdef Py_ssize_t h_count
    cdef long long tool

    @cython.locals(number=cython.longlong)
    cdef long long of(self, long long function) noexcept nogil

@cython.final
cdef class Section:
    cdef readonly Py_ssize_t slot_count
    cdef long long[::1] state
    cdef long long[::1] function
    cdef long long[::1] sequence
    cdef long long[::1] tick
    cdef long long[::1] serial
    cdef long long[::1] value
    cdef long long[::1] is_answered
    cdef long long[::1] area
    cdef long long[::1] unit
    cdef FunctionTable areas
    cdef long long[::1] answer_source
    cdef Py_ssize_t last_slot
    cdef long long[::1] done
    cdef readonly long long issued_in_tick
    cdef readonly long long taken_count
    cdef long long issued
    cdef long long version

    @cython.locals(i=Py_ssize_t)
    cdef void latch(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef long long issue(self, long long function, long long tick, long long ticks) noexcept nogil
    @cython.locals(unit=cython.longlong)
    cdef long long free_unit(self, Py_ssize_t slot) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef int is_unit_taken(self, Py_ssize_t slot, long long unit) noexcept nogil
    cdef void give_value(self, long long value) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef int is_waiting(self, long long function) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void acknowledge_done(self, long long tick) noexcept nogil
    @cython.locals(i=Py_ssize_t, number=cython.longlong, source=cython.longlong)
    cdef void record_answers(
        self, Record record, int state, int kind, int is_realtime
    ) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void clear(self) noexcept nogil

@cython.final
cdef class Hli:
    cdef readonly Panel panel
    cdef readonly Section realtime
    cdef readonly Section program
    cdef public bint acknowledges_itself
    cdef public bint is_divided

    cdef void latch(self) noexcept nogil
    cdef int has_default_plc(self) noexcept nogil
    cdef void run_default_plc(self, long long tick) noexcept nogil
    cpdef long long waiting_count(self) noexcept nogil
    cdef void record_answers(self, Record record, int state, int kind) noexcept nogil
    cdef void clear(self) noexcept nogil
