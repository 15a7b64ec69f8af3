# SPDX-License-Identifier: MIT
# C types of path.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.arc_speed cimport ArcSpeed
from nctakt.kernel.axes.axes cimport Axes
from nctakt.kernel.path.trapezoid_profile cimport TrapezoidProfile
from nctakt.kernel.path.path_axes cimport PathAxes
from nctakt.kernel.path.tool_life cimport ToolLifeCounter
from nctakt.kernel.path.jerk_profile cimport JerkProfile

@cython.final
cdef class Path(PathAxes):
    cdef double cycle_time_t
    cdef double cycle_time_us
    cdef readonly Py_ssize_t width
    cdef readonly Py_ssize_t history_size
    cdef Py_ssize_t ring_size
    cdef double[::1] ends
    cdef readonly long long used
    cdef readonly long long oldest
    cdef Py_ssize_t front
    cdef readonly bint is_retracing
    cdef bint is_front_over
    cdef readonly long long serial
    cdef readonly bint is_active
    cdef bint is_dwell
    cdef long long dwell_ticks
    cdef TrapezoidProfile profile
    cdef ArcSpeed arc
    cdef Py_ssize_t pieces
    cdef JerkProfile jerk_profile
    cdef readonly ToolLifeCounter life
    cdef double[::1] positions
    cdef int stage
    cdef double stage_end_d
    cdef double factor
    cdef double common_factor
    cdef double unoverridden_factor
    cdef double planned_factor
    cdef double covered_d
    cdef double plan_d
    cdef readonly double speed_v
    cdef double limit_v
    cdef double offset_t
    cdef long long ticks
    cdef readonly double left_t
    cdef readonly bint is_single

    @cython.locals(i=Py_ssize_t, dwell_ticks=cython.longlong)
    cdef void begin(self, Py_ssize_t queue_row, double[::1] queue, double offset_t) noexcept nogil
    @cython.locals(i=Py_ssize_t, end=Py_ssize_t)
    cdef void remember(self) noexcept nogil
    cdef Py_ssize_t row_of(self, long long number) noexcept nogil
    cdef void return_to_newest(self, double covered_d) noexcept nogil
    cdef void forget(self) noexcept nogil
    cdef bint continues_block(self) noexcept nogil
    cdef void set_remaining(self, double remaining) noexcept nogil
    cdef double remaining_speed(self) noexcept nogil
    cdef long long block_serial(self) noexcept nogil
    cdef void enter_stages(self) noexcept nogil
    @cython.locals(border=Py_ssize_t, length=double)
    cdef int next_stage(self) noexcept nogil
    @cython.locals(limit_v=double)
    cdef int step(self, double factor, int is_stopping) noexcept nogil
    @cython.locals(goal=double)
    cdef int ends_moving(self) noexcept nogil
    cdef void set_single(self, bint is_single) noexcept nogil
    cdef int is_at_end(self) noexcept nogil
    cdef int step_carried(self, double factor, int is_stopping) noexcept nogil
    @cython.locals(count=Py_ssize_t)
    cpdef tuple history(self)
    cdef double highest_speed(self, double factor, int is_stopping) noexcept nogil
    @cython.locals(rest_d=double, limit_a=double, end_v=double, remaining_v=double, ahead=double)
    cdef void replan(self, double limit_v) noexcept nogil
    @cython.locals(end_v=double, limit_v=double, feed_v=double, min_v2=double)
    cdef double end_speed(self, double rest_d, double limit_a) noexcept nogil
    cdef double factor_ahead(self, int ignores_override) noexcept nogil
    @cython.locals(end_v=double, remaining_v=double, stop_v=double, brake2=double, max_end_v=double)
    cdef double block_end_speed(self, double rest_d, double limit_a) noexcept nogil
    @cython.locals(rest_d=double, speed_v=double, limit_a=double, limit_j=double, need_d=double)
    cdef int stops_in_single_block(self, double limit_v) noexcept nogil
    @cython.locals(now_t=double, is_over=int)
    cdef int advance_with_jerk(self) noexcept nogil
    @cython.locals(now_t=double, over_t=double)
    cdef int advance(self) noexcept nogil
    cdef int finish(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, k=Py_ssize_t)
    cdef void move_axes(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, axis=Py_ssize_t)
    cdef void abandon(self) noexcept nogil
    cdef int is_at_rest(self) noexcept nogil
    cdef double distance_to_go(self) noexcept nogil
    cdef double promised_speed(self, Py_ssize_t column) noexcept nogil
    cdef double block_number(self) noexcept nogil
    @cython.locals(motion=double)
    cdef int is_rapid(self) noexcept nogil
    cdef double covered_length(self) noexcept nogil
    @cython.locals(acceleration=double, length=double)
    cdef double braking_distance(self) noexcept nogil
    cdef double covered_part(self) noexcept nogil
