# SPDX-License-Identifier: MIT
# C types of channel.py.
cimport cython
from nctakt.kernel cimport cells, codes, rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.cycles.cycles cimport CycleManager
from nctakt.kernel.path.backward cimport BackwardMotion
from nctakt.kernel.path.override cimport Overrides
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.axes.c_axis cimport CAxis
from nctakt.kernel.path.probing.fixed_stops cimport FixedStops
from nctakt.kernel.path.probing.measuring cimport Measuring
from nctakt.kernel.path.threads cimport Threads
from nctakt.kernel.plc.panel cimport Panel
from nctakt.kernel.plc.technology_slots cimport Hli
from nctakt.kernel.tick.axis_exchange cimport AxisExchange
from nctakt.kernel.tick.channel_signals cimport ChannelSignals
from nctakt.kernel.tick.command_bounds cimport check_command
from nctakt.kernel.tick.command_execution cimport CommandExecutor
from nctakt.kernel.tick.command_queue cimport CommandQueue
from nctakt.kernel.tick.wait_reasons cimport WaitReasons

@cython.final
cdef class DecoderFeed:
    cdef public Py_ssize_t low_water
    cdef public bint decoder_open
    cdef public bint wants_slot
    cdef public bint is_paced
    cdef long long starved_since
    cdef double answer
    cdef readonly bint answer_ready

@cython.final
cdef class Channel:
    cdef readonly CommandQueue queue
    cdef readonly CommandExecutor executor
    cdef readonly Path path
    cdef double[::1] cells
    cdef readonly Py_ssize_t first_cell
    cdef Record record
    cdef readonly Hli hli
    cdef readonly Panel panel
    cdef readonly CycleManager manager
    cdef readonly Context context
    cdef readonly ChannelSignals signals
    cdef readonly AxisExchange exchange
    cdef Threads threads
    cdef FixedStops fixed_stops
    cdef bint is_at_fixed_stop
    cdef Measuring measuring
    cdef CAxis c_axis
    cdef Overrides overrides
    cdef readonly DecoderFeed feed
    cdef double total_pct
    cdef readonly BackwardMotion backward
    cdef readonly WaitReasons waits
    cdef bint is_reset_due
    cdef public long long silence_ticks

    @cython.locals(commands=Py_ssize_t, single=Py_ssize_t, cycles=Py_ssize_t)
    cdef Py_ssize_t event_bound(self) noexcept nogil
    @cython.locals(has_slot=bint)
    cdef int needs_python(self) noexcept nogil
    @cython.locals(state=int)
    cdef int can_accept(self) noexcept nogil
    @cython.locals(is_stuck=bint)
    cdef int activity(self) noexcept nogil
    cdef int is_idle(self) noexcept nogil
    @cython.locals(is_empty=bint, can_go=bint)
    cdef void watch_queue(self, long long tick) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void begin_tick(self, long long tick) noexcept nogil
    cdef void run_cycles(self) noexcept nogil
    @cython.locals(
        factor=double, is_cutting=bint, was_retracing=bint, is_away=bint, fault=int,
        is_stopping=bint, is_single=bint, has_time_left=int, total_pct=double, number=Py_ssize_t
    )
    cdef void interpolate(self) noexcept nogil
    cdef void watch_plc(self) noexcept nogil
    @cython.locals(cycle_pct=double, factor=double)
    cdef double override(self) noexcept nogil
    cdef void watch_stops(self) noexcept nogil
    @cython.locals(has_time_left=int, is_held=bint)
    cdef int step_back(self, double factor, int is_stopping) noexcept nogil
    @cython.locals(waits=bint, is_held=bint, row=Py_ssize_t, source=cython.longlong)
    cdef void warn_of_wait(self) noexcept nogil
    @cython.locals(number=double, is_rapid=double)
    cdef void publish_block(self) noexcept nogil
    @cython.locals(source=cython.longlong)
    cdef void watch_spindle(self, double factor) noexcept nogil
    @cython.locals(
        position=Py_ssize_t, row=Py_ssize_t, kind=int, message=int, source=cython.longlong
    )
    cdef void pass_block_ends(self, int is_stopping) noexcept nogil
    @cython.locals(message=int)
    cdef void report_axes(self) noexcept nogil
    @cython.locals(state=int, row=Py_ssize_t, waits=bint)
    cdef void end_tick(self) noexcept nogil
    cdef void begin_reset(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void end_reset(self) noexcept nogil
    @cython.locals(state=int, row=Py_ssize_t, source=cython.longlong)
    cdef int are_axes_at_rest(self) noexcept nogil
    @cython.locals(row=Py_ssize_t, cell=Py_ssize_t)
    cdef void answer_waiting(self) noexcept nogil
