# SPDX-License-Identifier: MIT
# C types of command_execution.py.
cimport cython
from nctakt.kernel cimport cells, codes, rows
from nctakt.kernel.cycles.cycles cimport CycleManager
from nctakt.kernel.path.probing.fixed_stops cimport FixedStops
from nctakt.kernel.path.probing.measuring cimport Measuring
from nctakt.kernel.path.threads cimport Threads
from nctakt.kernel.plc.technology_slots cimport Hli
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.plc.panel cimport Panel
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.tick.block_scope cimport BlockScope
from nctakt.kernel.tick.channel_signals cimport ChannelSignals
from nctakt.kernel.tick.command_queue cimport CommandQueue
from nctakt.kernel.tick.early_outputs cimport EarlyOutputs
from nctakt.kernel.tick.single_block cimport SingleBlock
from nctakt.kernel.tick.spindle_exchange cimport SpindleExchange
from nctakt.kernel.tick.tool_lives cimport ToolLifeReporter
from nctakt.kernel.axes.single_axes cimport SingleAxes
from nctakt.kernel.base.timers cimport Timers

@cython.final
cdef class CommandExecutor:
    cdef readonly CommandQueue queue
    cdef readonly Path path
    cdef double[::1] cells
    cdef unsigned char[::1] characters
    cdef readonly Py_ssize_t first_cell
    cdef Record record
    cdef readonly Hli hli
    cdef readonly Panel panel
    cdef readonly SingleBlock single_block
    cdef EarlyOutputs early_outputs
    cdef readonly ToolLifeReporter tool_lives
    cdef readonly CycleManager manager
    cdef BlockScope block_scope
    cdef readonly FixedStops fixed_stops
    cdef readonly Measuring measuring
    cdef readonly Context context
    cdef Threads threads
    cdef public Timers program_timers
    cdef readonly ChannelSignals signals
    cdef readonly SpindleExchange spindle_exchange
    cdef readonly int modal
    cdef int waiting
    cdef public long long taken_source
    cdef readonly bint program_ended
    cdef readonly bint error_pending
    cdef readonly double error_detail
    cdef readonly int axis_state
    cdef readonly int error_message
    cdef readonly bint is_looping
    cdef bint is_skipping
    cdef bint is_between
    cdef readonly bint is_stopped
    cdef readonly bint is_fatal
    cdef readonly bint is_resetting

    cdef void run_commands(self, long long tick) noexcept nogil
    @cython.locals(row=Py_ssize_t, kind=int)
    cdef void run_due_commands(self, long long tick) noexcept nogil
    @cython.locals(moves=bint)
    cdef int is_at_rest(self) noexcept nogil
    cdef int is_reversing(self) noexcept nogil
    @cython.locals(source=cython.longlong, how=int)
    cdef void execute_loop(self, Py_ssize_t row) noexcept nogil
    @cython.locals(source=cython.longlong, member=Py_ssize_t)
    cdef void execute_fixed_stop_end(self, Py_ssize_t row) noexcept nogil
    @cython.locals(source=cython.longlong, message=int)
    cdef void execute_part(self, Py_ssize_t row, int kind) noexcept nogil
    @cython.locals(outcome=int)
    cdef int execute_measure_end(self, long long tick, Py_ssize_t row) noexcept nogil
    @cython.locals(is_enabled=bint)
    cdef int loop_repeats(self) noexcept nogil
    cdef void prolong_loop(self) noexcept nogil
    cdef void leave_loop(self, long long source) noexcept nogil
    cdef void give_up_loop(self) noexcept nogil
    cdef int enter_block(self, Py_ssize_t row) noexcept nogil
    cdef int execute(self, long long tick, Py_ssize_t row, int kind) noexcept nogil
    cdef int moves_alone(self, int kind) noexcept nogil
    @cython.locals(timer=int)
    cdef int execute_at_once(self, long long tick, Py_ssize_t row, int kind) noexcept nogil
    @cython.locals(
        source=cython.longlong, number=cython.longlong, serial=cython.longlong, name=double,
        value=double, decoded_tick=double, reason=cython.longlong, cell=double
    )
    cdef void record_event(self, Py_ssize_t row, int kind) noexcept nogil
    @cython.locals(
        has_thread=bint, is_current=bint, serial=cython.longlong, message=int
    )
    cdef int execute_block(self, Py_ssize_t row) noexcept nogil
    @cython.locals(slot=Py_ssize_t, message=int, source=cython.longlong)
    cdef int execute_definition(self, long long tick, Py_ssize_t row) noexcept nogil
    @cython.locals(source=cython.longlong, identity=cython.longlong, action=int, message=int)
    cdef int execute_control(self, long long tick, Py_ssize_t row) noexcept nogil
    @cython.locals(result=int, spindle=Py_ssize_t, number=Py_ssize_t)
    cdef int execute_spindle_axis(self, long long tick, Py_ssize_t row) noexcept nogil
    @cython.locals(spindle=Py_ssize_t, ticks=cython.longlong)
    cdef int execute_spindle(self, long long tick, Py_ssize_t row) noexcept nogil
    @cython.locals(spindle=Py_ssize_t, number=Py_ssize_t)
    cdef int execute_spindle_wait(self, Py_ssize_t row) noexcept nogil
    @cython.locals(cell=Py_ssize_t)
    cdef void execute_write(self, Py_ssize_t row) noexcept nogil
    @cython.locals(
        cell=Py_ssize_t, first=Py_ssize_t, count=Py_ssize_t, zeros=Py_ssize_t, i=Py_ssize_t
    )
    cdef void execute_characters(self, Py_ssize_t row) noexcept nogil
    @cython.locals(program=cython.longlong, source=cython.longlong)
    cdef int execute_program_end(self, long long tick, Py_ssize_t row) noexcept nogil
    @cython.locals(outcome=int, source=cython.longlong)
    cdef int execute_signal(self, long long tick, Py_ssize_t row, int kind) noexcept nogil
    @cython.locals(
        source=cython.longlong, identity=double, reaction=double, keyword=double, text=double,
        value=double
    )
    cdef void execute_user_error(self, Py_ssize_t row, int kind) noexcept nogil
    cdef void stop_for_user(self, int reaction) noexcept nogil
    cdef void enter_error(self, int message) noexcept nogil
    cdef void report(self, long long source, int message, double detail) noexcept nogil
