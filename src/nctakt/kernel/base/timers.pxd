# SPDX-License-Identifier: MIT
# C types of timers.py.
cimport cython
from nctakt.kernel cimport cells, codes
from nctakt.kernel.base cimport arithmetic

@cython.final
cdef class Timers:
    cdef double[::1] cells
    cdef readonly Py_ssize_t first_cell
    cdef long long cycle_time_us
    cdef long long[::1] is_running
    cdef long long[::1] started_tick
    cdef long long[::1] elapsed_ticks

    cdef void command(self, int action, Py_ssize_t timer, long long tick) noexcept nogil
    @cython.locals(running=cython.longlong)
    cdef long long elapsed(self, Py_ssize_t timer, long long tick) noexcept nogil
    cdef double latched(self, Py_ssize_t timer) noexcept nogil
    @cython.locals(time_us=cython.longlong, milliseconds=double)
    cdef void latch(self, Py_ssize_t timer, long long tick) noexcept nogil
