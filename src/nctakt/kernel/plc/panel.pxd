# SPDX-License-Identifier: MIT
# C types of panel.py.
cimport cython
from nctakt.kernel cimport cells, codes

@cython.final
cdef class Panel:
    cdef double[::1] cells
    cdef readonly Py_ssize_t first_cell
    cdef long long[::1] words
    cdef bint is_quiet
    cdef readonly double override_pct
    cdef readonly bint feed_hold
    cdef readonly bint single_block
    cdef readonly bint plc_present
    cdef readonly bint start_pressed
    cdef readonly bint reset_pressed
    cdef readonly bint is_armed
    cdef readonly bint is_running
    cdef public bint is_paused
    cdef bint is_released
    cdef bint is_step_locked
    cdef long long step_resolution
    cdef readonly bint backward_motion
    cdef bint turns_back
    cdef readonly bint probe
    cdef bint optional_stop
    cdef long long block_line
    cdef bint block_moves
    cdef readonly bint start_taken
    cdef readonly bint reset_taken
    cdef readonly bint is_watched
    cdef public long long silent_ticks

    @cython.locals(
        cell=Py_ssize_t, key=Py_ssize_t, pressed=cython.longlong, is_backward=bint, is_single=bint
    )
    cdef void latch(self) noexcept nogil
    @cython.locals(is_single=bint)
    cdef void lock_step(self, bint is_locked) noexcept nogil
    cdef void take_start(self, int can_start) noexcept nogil
    cdef int permits_block(self, long long line, bint moves_axis, bint is_started) noexcept nogil
    cdef int holds_back(self, long long line, bint moves_axis, bint is_started) noexcept nogil
    cdef int is_same_block(self, long long line, bint moves_axis) noexcept nogil
    cdef int stop_for_program(self, bint is_optional) noexcept nogil
    @cython.locals(cell=Py_ssize_t)
    cdef void publish(self, int state, int message) noexcept nogil
    cdef void show_loop(self, bint is_inside) noexcept nogil
    cdef void show_history(self, int state, long long blocks) noexcept nogil
    cdef void show_life(self, double time_t, double distance_d) noexcept nogil
    cdef void send_life(
        self, long long serial, long long tool, double time_t, double distance_d
    ) noexcept nogil
