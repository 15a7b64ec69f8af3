# SPDX-License-Identifier: MIT
# C types of cycles.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.cycles.instructions cimport Statement
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.axes.single_axes cimport SingleAxes
from nctakt.kernel.axes.spindles cimport Spindles

cdef class RunThrough:
    cdef int run_through(self, CycleManager manager, Context context) noexcept nogil

cdef class Group(RunThrough):
    cdef RunThrough first
    cdef RunThrough second
    cdef RunThrough third
    cdef RunThrough fourth
    cdef int run_through(self, CycleManager manager, Context context) noexcept nogil

cdef class RealtimeCycle(RunThrough):
    cdef readonly Statement body
    cdef public Py_ssize_t slot
    cdef readonly long long next_tick
    cdef readonly long long runs
    cdef readonly long long serial
    cdef public long long probe
    cdef readonly Py_ssize_t events
    cdef readonly Py_ssize_t probes
    cdef readonly long long size
    cdef int run_through(self, CycleManager manager, Context context) noexcept nogil

@cython.final
cdef class CycleManager:
    cdef public Spindles spindles
    cdef Record record
    cdef SingleAxes single_axes
    cdef readonly long long first_owner
    cdef readonly Py_ssize_t capacity
    cdef long long[::1] state
    cdef long long[::1] identity
    cdef long long[::1] scope
    cdef long long[::1] source
    cdef long long[::1] serial
    cdef long long[::1] reusable
    cdef long long[::1] restarts
    cdef long long[::1] started_tick
    cdef long long[::1] block
    cdef long long[::1] size
    cdef long long[::1] moves_on
    cdef public long long memory_limit
    cdef readonly long long memory_used
    cdef readonly list loaded
    cdef long long[::1] order
    cdef readonly Py_ssize_t loaded_count
    cdef RunThrough root
    cdef readonly long long latest_start
    cdef readonly long long running_count
    cdef readonly long long armed_count
    cdef readonly long long in_block_count
    cdef readonly long long ended_count
    cdef readonly Py_ssize_t events_bound
    cdef readonly Py_ssize_t probes_bound

    @cython.locals(slot=Py_ssize_t, index=Py_ssize_t)
    cdef Py_ssize_t find(self, long long identity) noexcept nogil
    cdef int is_alive(self, Py_ssize_t slot) noexcept nogil
    @cython.locals(before=cython.longlong)
    cdef void enter(self, Py_ssize_t slot, int state) noexcept nogil
    cdef int awaits_block(self, Py_ssize_t slot) noexcept nogil
    cdef int define(self, Py_ssize_t slot, int starts, long long tick) noexcept nogil
    cdef long long refused_value(self, Py_ssize_t slot, int message) noexcept nogil
    @cython.locals(is_armed=cython.bint)
    cdef void start(self, Py_ssize_t slot, long long tick, long long source) noexcept nogil
    @cython.locals(slot=Py_ssize_t, index=Py_ssize_t)
    cdef int started_this_tick(self, long long identity, long long tick) noexcept nogil
    @cython.locals(slot=Py_ssize_t, index=Py_ssize_t)
    cdef int has_started_this_tick(self, long long tick) noexcept nogil
    @cython.locals(slot=Py_ssize_t, index=Py_ssize_t)
    cdef int control(
        self, int action, long long identity, long long tick, long long source
    ) noexcept nogil
    cdef void hold(self, Py_ssize_t slot, long long source) noexcept nogil
    @cython.locals(is_armed=cython.bint)
    cdef void resume(self, Py_ssize_t slot, long long source) noexcept nogil
    @cython.locals(slot=Py_ssize_t, index=Py_ssize_t)
    cdef void enter_block(self, long long serial) noexcept nogil
    @cython.locals(slot=Py_ssize_t, index=Py_ssize_t)
    cdef void change_block(self, long long before, long long serial) noexcept nogil
    @cython.locals(slot=Py_ssize_t, index=Py_ssize_t)
    cdef void leave_blocks(self, long long serial) noexcept nogil
    @cython.locals(again=cython.bint)
    cdef void end(self, Py_ssize_t slot, int reason) noexcept nogil
    cdef void end_actions(self, Py_ssize_t slot) noexcept nogil
    cdef void abort_actions(self, Py_ssize_t slot) noexcept nogil
    cdef void end_program(self) noexcept nogil
    cdef void reset(self) noexcept nogil
    @cython.locals(
        slot=Py_ssize_t, index=Py_ssize_t, source=cython.longlong, serial=cython.longlong
    )
    cdef void delete_local(self, int reason) noexcept nogil
    cdef int run_cycles(self, Context context) noexcept nogil
    @cython.locals(source=cython.longlong, serial=cython.longlong)
    cdef void fail(self, Py_ssize_t slot, Context context) noexcept nogil
