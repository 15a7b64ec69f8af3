# SPDX-License-Identifier: MIT
# C types of spindles.py.
cimport cython
from libc cimport math
from nctakt.kernel cimport cells, codes, rows
from nctakt.kernel.axes.cutting_speeds cimport CuttingSpeeds
from nctakt.kernel.axes.spindle_limits cimport SpindleLimits
from nctakt.kernel.axes.spindle_overrides cimport SpindleOverrides
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.axes.trajectory cimport Trajectories

@cython.final
cdef class Spindles:
    cdef double[::1] cells
    cdef readonly Py_ssize_t first_cell
    cdef readonly Py_ssize_t count
    cdef public Py_ssize_t first_number
    cdef Record record
    cdef double cycle_t
    cdef Trajectories plans
    cdef readonly SpindleLimits limits
    cdef SpindleOverrides overrides
    cdef readonly CuttingSpeeds cutting
    cdef long long[::1] is_plc
    cdef double[::1] position
    cdef double[::1] speed_v
    cdef double[::1] acceleration
    cdef long long[::1] mode
    cdef double[::1] begin_position
    cdef long long[::1] begin_tick
    cdef double[::1] commanded_v
    cdef double[::1] commanded_position
    cdef long long[::1] direction
    cdef long long[::1] function
    cdef long long[::1] is_open
    cdef long long[::1] is_held
    cdef long long[::1] owner
    cdef long long[::1] source
    cdef long long[::1] serial
    cdef long long[::1] taken_tick
    cdef long long[::1] has_no_axis
    cdef readonly long long[::1] axis
    cdef long long[::1] plc_state
    cdef long long[::1] done_tick
    cdef long long[::1] job
    cdef double[::1] reached_v
    cdef double[::1] laps
    cdef long long issued
    cdef long long version
    cdef readonly Py_ssize_t active_count

    cdef int is_ready(self, Py_ssize_t spindle, long long tick) noexcept nogil
    cdef void command(
        self, Py_ssize_t spindle, int function, double speed_v, double position, int direction,
        long long owner, long long tick, int ignores_override=*
    ) noexcept nogil
    @cython.locals(speed_v=double)
    cdef double goal_v(self, Py_ssize_t spindle) noexcept nogil
    @cython.locals(is_stop=bint)
    cdef int rests(self, Py_ssize_t spindle) noexcept nogil
    @cython.locals(goes_on=bint)
    cdef void follow_override(self, Py_ssize_t spindle, long long tick) noexcept nogil
    @cython.locals(spindle=Py_ssize_t)
    cpdef bint has_jobs(self) noexcept
    @cython.locals(number=Py_ssize_t, function=cython.longlong, speed=double, position=double)
    cdef void record_job(
        self, Py_ssize_t spindle, long long source, long long serial
    ) noexcept nogil
    cdef void hand_over(self, Py_ssize_t spindle, long long done_tick) noexcept nogil
    @cython.locals(end_v=double, limit_a=double, limit_j=double, waits=bint)
    cdef void plan(self, Py_ssize_t spindle, long long tick) noexcept nogil
    @cython.locals(direction=int, braking=double, remaining=double)
    cdef double remaining_angle(self, Py_ssize_t spindle) noexcept nogil
    @cython.locals(turned=double)
    cdef void count_laps(self, Py_ssize_t spindle, long long tick) noexcept nogil
    @cython.locals(begin=double)
    cdef double turned_by(self, Py_ssize_t spindle, long long tick) noexcept nogil
    cdef int is_at_speed(self, Py_ssize_t spindle) noexcept nogil
    cdef void follow(self, Py_ssize_t spindle, double angle, double speed_v) noexcept nogil
    cdef void uncouple(self, Py_ssize_t spindle) noexcept nogil
    cdef int give_axis(self, Py_ssize_t spindle) noexcept nogil
    cdef void take_axis(self, Py_ssize_t spindle) noexcept nogil
    cdef void turn_to(self, Py_ssize_t spindle, double angle) noexcept nogil
    cdef void execute(self, double[::1] queue, Py_ssize_t row, int kind) noexcept nogil
    @cython.locals(spindle=Py_ssize_t, limit_v=double, factor=double, speed_v=double)
    cdef void follow_axes(self, long long tick) noexcept nogil
    @cython.locals(is_bound=bint)
    cdef int turns_freely(self, Py_ssize_t spindle) noexcept nogil
    @cython.locals(count=Py_ssize_t, spindle=Py_ssize_t)
    cdef Py_ssize_t open_count(self, long long owner) noexcept nogil
    cdef int is_busy(self, Py_ssize_t spindle) noexcept nogil
    cdef int is_resting(self, Py_ssize_t spindle) noexcept nogil
    cdef int has_job(self, Py_ssize_t spindle, long long owner) noexcept nogil
    cdef int is_endless(self, Py_ssize_t spindle) noexcept nogil
    @cython.locals(spindle=Py_ssize_t)
    cdef void hold(self, long long owner, long long tick) noexcept nogil
    @cython.locals(spindle=Py_ssize_t)
    cdef void resume(self, long long owner, long long tick) noexcept nogil
    @cython.locals(spindle=Py_ssize_t)
    cdef void abort(self, long long owner, long long tick) noexcept nogil
    @cython.locals(spindle=Py_ssize_t)
    cdef void leave(self, long long owner) noexcept nogil
    @cython.locals(spindle=Py_ssize_t)
    cdef void latch(self) noexcept nogil
    cdef double plc_speed(self, Py_ssize_t spindle) noexcept nogil
    @cython.locals(spindle=Py_ssize_t, is_free=bint)
    cdef void step(self, long long tick, int acknowledges_itself) noexcept nogil
    @cython.locals(time_t=double)
    cdef void advance(self, Py_ssize_t spindle, long long tick) noexcept nogil
    @cython.locals(cell=Py_ssize_t)
    cdef void publish(self, Py_ssize_t spindle) noexcept nogil
    @cython.locals(is_there=bint, is_at_rest=bint, waits=bint)
    cdef void arrive(self, Py_ssize_t spindle) noexcept nogil
    @cython.locals(number=Py_ssize_t, source=cython.longlong, serial=cython.longlong)
    cdef void finish(self, Py_ssize_t spindle) noexcept nogil

@cython.locals(turned=double)
cdef double wrapped(double degrees) noexcept nogil
