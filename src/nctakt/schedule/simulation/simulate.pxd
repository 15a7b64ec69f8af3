# SPDX-License-Identifier: MIT
# C types of simulate.py.
cimport cython
from nctakt.schedule.simulation.chance cimport Chance
from nctakt.schedule.simulation.counters cimport Counters
from nctakt.schedule.simulation.work cimport Work

cdef class SchedulerState:
    cdef readonly object model
    cdef readonly long long hyperperiod
    cdef readonly Counters counters
    cdef readonly object recorder
    cdef bint _records
    cdef readonly long long[::1] left
    cdef long long[::1] _due
    cdef long long[::1] _sequence
    cdef long long _next_sequence
    cdef list _waiting
    cdef readonly list suspendable
    cdef list _stoppable
    cdef list _cpu
    cdef Chance _chance
    cdef list _work
    cdef long long[::1] _last
    cdef long long[::1] _idle
    cdef long long _switch
    cdef long long _phase
    cdef long long _distance
    cdef long long _jitter
    cdef bint _is_regular
    cdef long long _offset
    cdef list _processors
    cdef object _placement
    cdef list _order
    cdef list _has_ties
    cdef list _due_table

    @cython.locals(moment=cython.longlong)
    cpdef long long interrupt(self, long long cycle) except? -1
    @cython.locals(
        point=cython.longlong, stop=cython.longlong, limit=cython.longlong, cpu=cython.Py_ssize_t
    )
    cpdef run_cycle(self, long long cycle, long long begin, long long end)
    @cython.locals(i=cython.Py_ssize_t, work=Work)
    cdef _release(self, long long cycle, long long begin)
    @cython.locals(
        now=cython.longlong,
        got=cython.longlong,
        limit=cython.longlong,
        overhead=cython.longlong,
        until=cython.longlong,
        i=cython.Py_ssize_t,
    )
    cdef long long _run_cpu(
        self, Py_ssize_t cpu, long long begin, long long stop, long long end
    ) except? -1
    cdef long long _point(self, long long begin) except? -1
    cdef list _by_urgency(self, Py_ssize_t cpu)
    cpdef long long switch(self, Py_ssize_t i, Py_ssize_t cpu) except? -1
    @cython.locals(left=cython.longlong)
    cpdef long long advance(
        self, Py_ssize_t i, Py_ssize_t cpu, long long now, long long until, long long overhead
    ) except? -1
    @cython.locals(response=cython.longlong, work=Work)
    cdef _finish(self, Py_ssize_t i, long long now)
    @cython.locals(i=cython.Py_ssize_t)
    cdef bint _suspend(self, long long moment) except *
