# SPDX-License-Identifier: MIT
# C types of tasks.py.
cimport cython
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.steps cimport Step

cdef class PlcTask:
    cdef int run(self, PlcContext context, long long begin, long long end) noexcept nogil

cdef class CyclicTask(PlcTask):
    cdef Step body
    cdef long long cycle
    cdef long long max_steps
    cdef PlcTask others
    cdef readonly long long due
    cdef readonly long long count
    cdef int run(self, PlcContext context, long long begin, long long end) noexcept nogil

cdef class PlcSide:
    cdef public bint has_news
    cdef void run(self, long long tick) noexcept nogil

cdef class PlcTasks(PlcSide):
    cdef readonly PlcContext context
    cdef PlcTask tasks
    cdef long long tick_ns
    cdef long long first_tick
    cdef double[::1] cells
    cdef long long input_count
    cdef long long[::1] input_address
    cdef long long[::1] input_byte
    cdef long long output_count
    cdef long long[::1] output_address
    cdef long long[::1] output_kind
    cdef long long[::1] output_cell
    @cython.locals(begin=cython.longlong, i=Py_ssize_t)
    cdef void run(self, long long tick) noexcept nogil
    @cython.locals(
        i=Py_ssize_t, address=cython.longlong, kind=int, cell=Py_ssize_t, value=cython.longlong
    )
    cdef void show_outputs(self) noexcept nogil
