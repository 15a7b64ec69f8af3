# SPDX-License-Identifier: MIT
# C types of record.py.
cimport cython
from nctakt.kernel cimport rows

@cython.final
cdef class Record:
    cdef double[::1] cells
    cdef long long[::1] signals
    cdef double[::1] rows
    cdef double[::1] events
    cdef double[::1] probes
    cdef readonly Py_ssize_t signal_count
    cdef readonly Py_ssize_t row_capacity
    cdef readonly Py_ssize_t row_count
    cdef readonly Py_ssize_t event_capacity
    cdef readonly Py_ssize_t event_count
    cdef readonly Py_ssize_t probe_capacity
    cdef readonly Py_ssize_t probe_count
    cdef public long long tick
    cdef public int channel
    cdef long long kinds
    cdef public long long awaited_kinds
    cdef public bint records_writes
    cdef public bint records_series
    cdef public bint records_answers
    cdef readonly bint is_reduced

    cdef int has_awaited(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, row=Py_ssize_t)
    cdef void take_row(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, count=Py_ssize_t, value=double)
    cdef void reduce_row(self) noexcept nogil
    @cython.locals(count=Py_ssize_t)
    cdef void widen(self, Py_ssize_t i, double value) noexcept nogil
    @cython.locals(row=Py_ssize_t, bit=cython.longlong)
    cdef void event(
        self, int kind, long long source, long long subject=*, double a=*, double b=*, double c=*
    ) noexcept nogil
    cdef void written(
        self, long long source, long long serial, Py_ssize_t cell, double value
    ) noexcept nogil
    @cython.locals(kind=int)
    cdef void probe(self, long long number, int truth, double left, double right) noexcept nogil
    cdef void series(self, long long number, int kind, long long next_tick) noexcept nogil
    @cython.locals(row=Py_ssize_t)
    cdef void append_probe(
        self, int kind, long long number, double left, double right, long long next_tick
    ) noexcept nogil
    cdef int has_room(self, Py_ssize_t events, Py_ssize_t probes) noexcept nogil
