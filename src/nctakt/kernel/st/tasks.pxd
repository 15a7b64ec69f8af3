# SPDX-License-Identifier: MIT
# C types of tasks.py.
cimport cython
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.interface cimport CncSide
from nctakt.kernel.st.steps cimport Step

cdef class PlcTask:
    cdef int is_due(self, long long end) noexcept nogil
    cdef int run(self, PlcContext context, long long begin, long long end) noexcept nogil

@cython.final
cdef class TaskInfo:
    cdef long long count_at
    cdef long long first_at
    cdef long long length_at
    cdef long long exceeded_at

cdef class CyclicTask(PlcTask):
    cdef Step body
    cdef long long cycle
    cdef long long max_steps
    cdef PlcTask others
    cdef long long number
    cdef TaskInfo info
    cdef readonly long long due
    cdef readonly long long count
    cdef readonly long long overruns
    cdef int is_due(self, long long end) noexcept nogil
    cdef int run(self, PlcContext context, long long begin, long long end) noexcept nogil
    @cython.locals(length=cython.longlong, is_exceeded=cython.bint)
    cdef void note_length(self, PlcContext context, long long begin) noexcept nogil

cdef class PlcSide:
    cdef public bint has_news
    cdef Py_ssize_t event_bound(self) noexcept nogil
    cdef void latch(self) noexcept nogil
    cdef void guard(self) noexcept nogil
    cdef void run(self, long long tick) noexcept nogil

cdef class PlcPair(PlcSide):
    cdef PlcSide first
    cdef PlcSide second
    cdef Py_ssize_t event_bound(self) noexcept nogil
    cdef void latch(self) noexcept nogil
    cdef void guard(self) noexcept nogil
    cdef void run(self, long long tick) noexcept nogil

cdef class PlcTasks(PlcSide):
    cdef readonly PlcContext context
    cdef PlcTask tasks
    cdef CncSide cnc
    cdef long long tick_ns
    cdef long long first_tick
    cdef double[::1] cells
    cdef long long message_at
    cdef long long input_count
    cdef long long[::1] input_address
    cdef long long[::1] input_byte
    cdef long long output_count
    cdef long long[::1] output_address
    cdef long long[::1] output_kind
    cdef long long[::1] output_cell
    cdef Py_ssize_t event_bound(self) noexcept nogil
    cdef void latch(self) noexcept nogil
    cdef void guard(self) noexcept nogil
    @cython.locals(begin=cython.longlong)
    cdef void run(self, long long tick) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void latch_inputs(self, long long begin) noexcept nogil
    cdef void run_tasks(self, long long tick, long long begin) noexcept nogil
    @cython.locals(
        i=Py_ssize_t, address=cython.longlong, kind=int, cell=Py_ssize_t, value=cython.longlong
    )
    cdef void show_outputs(self) noexcept nogil
