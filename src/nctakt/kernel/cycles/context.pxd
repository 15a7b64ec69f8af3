# SPDX-License-Identifier: MIT
# C types of context.py.
cimport cython
from nctakt.kernel.plc.technology_slots cimport Hli
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.axes.single_axes cimport SingleAxes
from nctakt.kernel.axes.spindles cimport Spindles
from nctakt.kernel.base.timers cimport Timers

@cython.final
cdef class Context:
    cdef double[::1] cells
    cdef Record record
    cdef Hli hli
    cdef Timers timers
    cdef readonly SingleAxes single_axes
    cdef public Spindles spindles
    cdef public Py_ssize_t max_open_actions
    cdef public long long tick
    cdef public long long serial
    cdef public long long run
    cdef public long long owner
    cdef public int fault
    cdef public int user_reaction
    cdef public long long fault_source
    cdef public double fault_a
    cdef public double fault_b
    cdef public long long steps
    cdef public long long check_at
    cdef public long long max_steps
    cdef public long long cont_steps
    cdef public long long budget_steps

    cdef void begin(self, long long tick) noexcept nogil
    cdef void next_check(self) noexcept nogil
    cdef int over_limit(self, long long source) noexcept nogil
    cdef void fail(self, int message, long long source, double a, double b) noexcept nogil
