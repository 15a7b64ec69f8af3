# SPDX-License-Identifier: MIT
# C types of single_axes.py.
cimport cython
from nctakt.kernel cimport cells, codes, rows
from nctakt.kernel.base cimport bounds
from nctakt.kernel.axes.axes cimport Axes
from nctakt.kernel.axes.axis_motions cimport AxisMotions
from nctakt.kernel.base.record cimport Record

@cython.final
cdef class SingleAxes(AxisMotions):
    cdef long long source
    cdef long long serial
    cdef Py_ssize_t requested_axis
    cdef bint has_exchanged
    cdef long long[::1] closed

    cdef bint is_command(
        self, Py_ssize_t axis, double value, double speed_v, long long mode, long long direction,
        long long owner
    ) noexcept nogil
    @cython.locals(is_right=cython.bint)
    cdef int check_command(self, axis, value, speed_v, mode, direction, owner) except -1
    cdef void order(self, long long source, long long serial) noexcept nogil
    @cython.locals(message=int)
    cdef int move_to(
        self, Py_ssize_t axis, double target, double speed_v, int mode, int direction,
        long long owner
    ) noexcept nogil
    @cython.locals(message=int, start=double)
    cdef int move_by(
        self, Py_ssize_t axis, double distance, double speed_v, int mode, long long owner
    ) noexcept nogil
    @cython.locals(message=int)
    cdef int run_endless(
        self, Py_ssize_t axis, double speed_v, int direction, int mode, long long owner
    ) noexcept nogil
    @cython.locals(message=int)
    cdef int stop(self, Py_ssize_t axis, long long owner) noexcept nogil
    cdef int refusal(self, Py_ssize_t axis, int mode, long long owner) noexcept nogil
    @cython.locals(before=cython.longlong)
    cdef int is_foreign(self, Py_ssize_t axis, long long owner) noexcept nogil
    cdef void put(
        self, Py_ssize_t axis, int kind, double value, double speed_v, int direction, int mode,
        long long owner
    ) noexcept nogil
    @cython.locals(axis=Py_ssize_t, distance=double, speed_v=double)
    cdef int execute(self, double[::1] queue, Py_ssize_t row, int kind) noexcept nogil
    @cython.locals(message=int, distance=double, speed_v=double)
    cdef int home(
        self, Py_ssize_t axis, double position, int is_listed, long long owner
    ) noexcept nogil
    @cython.locals(message=int, shift=double)
    cdef int give_position(
        self, Py_ssize_t axis, double value, int is_relative, long long owner
    ) noexcept nogil
    @cython.locals(message=int)
    cdef int calibrate(
        self, Py_ssize_t axis, double position, int keeps_position, long long owner
    ) noexcept nogil
    @cython.locals(value=double, speed_v=double, direction=int)
    cdef int move_alone(self, Py_ssize_t axis, double[::1] queue, Py_ssize_t row) noexcept nogil
    @cython.locals(message=int, kind=int, owner=cython.longlong, speed_v=double, first_d=double)
    cdef int oscillate(self, Py_ssize_t axis, double[::1] queue, Py_ssize_t row) noexcept nogil
    @cython.locals(how=int, direction=int, speed_v=double, target_d=double)
    cdef int end_oscillation(
        self, Py_ssize_t axis, double[::1] queue, Py_ssize_t row
    ) noexcept nogil
    @cython.locals(axis=Py_ssize_t)
    cdef void hold(self, long long owner) noexcept nogil
    @cython.locals(axis=Py_ssize_t, is_endless=cython.bint)
    cdef void resume(self, long long owner) noexcept nogil
    @cython.locals(axis=Py_ssize_t, why=int, is_endless=cython.bint)
    cdef void abort(self, long long owner, int with_cycle) noexcept nogil
    @cython.locals(axis=Py_ssize_t)
    cdef void end_owner(self, long long owner, int continues) noexcept nogil
    @cython.locals(axis=Py_ssize_t, count=int)
    cdef int open_count(self, long long owner) noexcept nogil
    @cython.locals(count=int)
    cdef int open_on(self, Py_ssize_t axis, long long owner) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void finish_swings(self, long long[::1] members, Py_ssize_t count) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void finish_requested(self, double[::1] queue, Py_ssize_t row) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef int all_free(self, long long[::1] members, Py_ssize_t count) noexcept nogil
    @cython.locals(i=Py_ssize_t, message=int, last_message=int)
    cdef int take_faults(self, long long[::1] members, Py_ssize_t count) noexcept nogil
    @cython.locals(i=Py_ssize_t, state=int)
    cdef int request_state(self, double[::1] queue, Py_ssize_t row) noexcept nogil
    cdef int state_for_request(self, Py_ssize_t axis) noexcept nogil
    cdef void reset(self, Py_ssize_t axis) noexcept nogil
    cdef void reopen(self, Py_ssize_t axis) noexcept nogil
    cdef int clear_fault(self, Py_ssize_t axis) noexcept nogil
    cdef int is_free(self, Py_ssize_t axis) noexcept nogil
    cdef int is_held(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(shown=int)
    cdef int state(self, Py_ssize_t axis) noexcept nogil
    cdef int is_ending(self, Py_ssize_t axis) noexcept nogil
    cdef Py_ssize_t event_bound(self, Py_ssize_t commands) noexcept nogil
