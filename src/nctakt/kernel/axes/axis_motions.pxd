# SPDX-License-Identifier: MIT
# C types of axis_motions.py.
cimport cython
from nctakt.kernel cimport cells, codes, rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.axes.axes cimport Axes
from nctakt.kernel.axes.axis_plans cimport AxisPlans, MotionLimits
from nctakt.kernel.axes.homing cimport Homing
from nctakt.kernel.base.record cimport Record

@cython.final
cdef class WaitingMotions:
    cdef long long[::1] kind
    cdef long long[::1] owner
    cdef long long[::1] serial
    cdef long long[::1] source
    cdef double[::1] value
    cdef double[::1] speed_v
    cdef long long[::1] direction
    cdef long long[::1] held
    cdef long long[::1] swings

@cython.final
cdef class Oscillations:
    cdef long long[::1] left
    cdef long long[::1] stage
    cdef long long[::1] pausing
    cdef long long[::1] first_pause
    cdef long long[::1] second_pause
    cdef double[::1] first_d
    cdef double[::1] second_d
    cdef double[::1] stroke_d

    cdef void end(self, Py_ssize_t axis) noexcept nogil

@cython.final
cdef class AxisFaults:
    cdef readonly Py_ssize_t open_count
    cdef Py_ssize_t reported_count
    cdef Py_ssize_t failed_count
    cdef Py_ssize_t ring_size
    cdef long long[::1] message
    cdef long long[::1] failed

    cdef void enter(self, Py_ssize_t axis, int message, long long channel) noexcept nogil
    cdef void note(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(message=int)
    cdef int take(self, Py_ssize_t axis) noexcept nogil

cdef class AxisMotions:
    cdef Axes axes
    cdef Record record
    cdef MotionLimits limits
    cdef AxisPlans plans
    cdef Homing homing
    cdef WaitingMotions waiting
    cdef Oscillations oscillations
    cdef readonly AxisFaults faults
    cdef readonly Py_ssize_t active_count
    cdef long long[::1] kind
    cdef long long[::1] held
    cdef long long[::1] owner
    cdef long long[::1] serials
    cdef long long[::1] sources
    cdef double[::1] goal
    cdef double[::1] end
    cdef double[::1] commanded_v
    cdef double[::1] direction
    cdef long long[::1] arrived
    cdef long long[::1] in_channel

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
    @cython.locals(full_d=double, turns=double)
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
    @cython.locals(top_v=double)
    cdef void step_axis(self, Py_ssize_t axis) noexcept nogil
    cdef void plan(self, Py_ssize_t axis, double top_v) noexcept nogil
    @cython.locals(position=double)
    cdef int arrive(self, Py_ssize_t axis, double top_v) noexcept nogil
    cdef int turn_round(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(is_there=cython.bint)
    cdef void finish_swing(self, Py_ssize_t axis) noexcept nogil
