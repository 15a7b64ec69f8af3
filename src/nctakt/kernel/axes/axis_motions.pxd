# SPDX-License-Identifier: MIT
# C types of axis_motions.py.
cimport cython
from nctakt.kernel cimport cells, codes, rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.axes.axes cimport Axes
from nctakt.kernel.axes.homing cimport Homing
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.axes.trajectory cimport Trajectories

cdef class AxisMotions:
    cdef Axes axes
    cdef Record record
    cdef readonly Py_ssize_t count
    cdef double cycle_time_us
    cdef double forgiven_t
    cdef Trajectories plans
    cdef Homing homing
    cdef readonly Py_ssize_t active_count
    cdef readonly Py_ssize_t fault_count
    cdef Py_ssize_t reported_count
    cdef Py_ssize_t requested_axis
    cdef bint has_exchanged
    cdef long long source
    cdef long long serial
    cdef long long[::1] enabled
    cdef double[::1] low
    cdef double[::1] high
    cdef double[::1] listed_low
    cdef double[::1] listed_high
    cdef long long[::1] is_homing
    cdef double[::1] limit_v
    cdef double[::1] limit_a
    cdef double[::1] limit_j
    cdef long long[::1] kind
    cdef long long[::1] held
    cdef long long[::1] owner
    cdef long long[::1] serials
    cdef long long[::1] sources
    cdef double[::1] goal
    cdef double[::1] end
    cdef double[::1] commanded_v
    cdef double[::1] direction
    cdef long long[::1] next_kind
    cdef long long[::1] next_owner
    cdef long long[::1] next_serial
    cdef long long[::1] next_source
    cdef double[::1] next_value
    cdef double[::1] next_v
    cdef long long[::1] next_direction
    cdef long long[::1] next_held
    cdef long long[::1] next_swings
    cdef double[::1] speed
    cdef double[::1] acceleration
    cdef double[::1] last_direction
    cdef double[::1] planned_v
    cdef double[::1] start_d
    cdef long long[::1] ticks
    cdef long long[::1] fault
    cdef long long[::1] failed
    cdef long long[::1] arrived
    cdef long long[::1] in_channel
    cdef long long[::1] closed
    cdef long long[::1] swings
    cdef long long[::1] swing_way
    cdef long long[::1] pausing
    cdef long long[::1] first_pause
    cdef long long[::1] second_pause
    cdef double[::1] first_d
    cdef double[::1] second_d
    cdef double[::1] stroke_d
    cdef Py_ssize_t failed_count
    cdef Py_ssize_t ring_size

    cdef int is_beyond(self, Py_ssize_t axis, double target) noexcept nogil
    @cython.locals(message=int)
    cdef int is_shift_beyond(self, Py_ssize_t axis, double shift) noexcept nogil
    cdef void move_origin(self, Py_ssize_t axis, double shift) noexcept nogil
    cdef int is_at_speed(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(kind=int, position=double)
    cdef void begin(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(
        kind=int, source=cython.longlong, serial=cython.longlong, first_d=double, second_d=double
    )
    cdef void record_begin(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(full_d=double, brake_d=double, turns=double)
    cdef double turn(self, Py_ssize_t axis, double distance_d) noexcept nogil
    @cython.locals(full_d=double)
    cdef double in_range(self, Py_ssize_t axis, double position) noexcept nogil
    cdef void drop(self, Py_ssize_t axis) noexcept nogil
    cdef void event(self, int kind, Py_ssize_t axis, double value) noexcept nogil
    @cython.locals(source=cython.longlong, serial=cython.longlong)
    cdef void drop_next(self, Py_ssize_t axis, int why) noexcept nogil
    @cython.locals(source=cython.longlong, serial=cython.longlong)
    cdef void drop_present(self, Py_ssize_t axis, int why) noexcept nogil
    cdef void give_up(self, Py_ssize_t axis) noexcept nogil
    cdef void brake(self, Py_ssize_t axis) noexcept nogil
    cdef void come_to_standstill(self, Py_ssize_t axis) noexcept nogil
    cdef void fail(self, Py_ssize_t axis, int message) noexcept nogil
    @cython.locals(axis=Py_ssize_t)
    cdef void step(self) noexcept nogil
    cdef void follow_masters(self) noexcept nogil
    @cython.locals(k=Py_ssize_t, axis=Py_ssize_t)
    cdef void watch_slaves(self) noexcept nogil
    cdef void stop_askew(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(top_v=double, now_t=double, over_t=double)
    cdef void step_axis(self, Py_ssize_t axis) noexcept nogil
    cdef void plan(self, Py_ssize_t axis, double top_v) noexcept nogil
    @cython.locals(position=double)
    cdef int arrive(self, Py_ssize_t axis, double top_v) noexcept nogil
    cdef int turn_round(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(is_there=cython.bint)
    cdef void finish_swing(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(message=int)
    cdef int take_fault(self, Py_ssize_t axis) noexcept nogil
