# SPDX-License-Identifier: MIT
# C types of axes.py.
cimport cython
from nctakt.kernel cimport cells, codes, rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.axes.coordinates cimport Offsets, Turns
from nctakt.kernel.axes.couplings cimport Couplings
from nctakt.kernel.axes.transformations cimport Transformations

@cython.final
cdef class Axes:
    cdef double[::1] cells
    cdef readonly Py_ssize_t first_cell
    cdef readonly Py_ssize_t count
    cdef double[::1] command
    cdef bint has_lag
    cdef bint is_late
    cdef double[::1] lag_d
    cdef double[::1] lag_kept
    cdef double[::1] lag_alone
    cdef double[::1] lag_gained
    cdef double[::1] followed
    cdef double[::1] drive_d
    cdef double[::1] unsent
    cdef double[::1] target
    cdef double[::1] modulo_low
    cdef double[::1] modulo_range
    cdef long long[::1] on_path
    cdef long long[::1] independent
    cdef long long[::1] override_mode
    cdef double[::1] override_pct
    cdef double[::1] max_override_pct
    cdef double[::1] independent_pct
    cdef double[::1] plc_factor
    cdef long long[::1] locked
    cdef readonly long long locked_count
    cdef long long override_version
    cdef long long[::1] ignores_hold
    cdef bint has_stops
    cdef double[::1] stop_low
    cdef double[::1] stop_high
    cdef readonly Offsets offsets
    cdef Turns turns
    cdef readonly Transformations transformations
    cdef readonly Couplings couplings
    cdef double[::1] actual
    cdef bint has_moved
    cdef bint is_shifted
    cdef double[::1] shown_command
    cdef double[::1] shown_actual
    cdef double[::1] shown_target

    @cython.locals(k=Py_ssize_t, i=Py_ssize_t, master=Py_ssize_t, command=double, state=int)
    cdef void follow_masters(self) noexcept nogil
    @cython.locals(actual=double)
    cdef int is_askew(self, Py_ssize_t k) noexcept nogil
    @cython.locals(slave=Py_ssize_t, master=Py_ssize_t)
    cdef void couple(self, double[::1] queue, Py_ssize_t row) noexcept nogil
    cpdef void feed_forward(self, Py_ssize_t index, double share) noexcept nogil
    cdef Py_ssize_t cell_of(self, Py_ssize_t i) noexcept nogil
    @cython.locals(i=Py_ssize_t, step=double, sent=double, lag=double)
    cdef void follow(self) noexcept nogil
    @cython.locals(shift=double, k=Py_ssize_t)
    cdef void refer(self, Py_ssize_t axis, double position) noexcept nogil
    @cython.locals(half=double)
    cdef double distance(self, Py_ssize_t i, double begin, double end) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void begin_tick(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, command=double, actual=double, is_shown=bint)
    cdef void publish(self) noexcept nogil
    @cython.locals(cell=Py_ssize_t, distance_to_go=double, shift=double)
    cdef void publish_axis(
        self, Py_ssize_t i, double command, double actual, double target
    ) noexcept nogil
    @cython.locals(cell=Py_ssize_t, pct=double, cycle_pct=double)
    cdef void publish_override(
        self, Py_ssize_t i, double operator_pct, int is_held
    ) noexcept nogil
    @cython.locals(actual=double)
    cdef double actual_position(self, Py_ssize_t i) noexcept nogil
    cdef void show_state(self, Py_ssize_t i, int state) noexcept nogil
    @cython.locals(k=Py_ssize_t)
    cdef void put_at(self, Py_ssize_t index, double position) noexcept nogil
    cdef void set_offset(self, Py_ssize_t axis, int kind, double value) noexcept nogil
    @cython.locals(
        i=Py_ssize_t, k=Py_ssize_t, command=double, actual=double, target=double,
        cell=Py_ssize_t, rest=double, shift=double
    )
    cdef void publish_tip(self, Py_ssize_t number, Py_ssize_t slot) noexcept nogil
    cdef void transform(self, Py_ssize_t slot, long long number) noexcept nogil
    @cython.locals(j=Py_ssize_t, k=Py_ssize_t, cell=int, x=double, y=double, z=double)
    cdef void publish_turned(self, Py_ssize_t i) noexcept nogil
    @cython.locals(first=Py_ssize_t, second=Py_ssize_t, third=Py_ssize_t, value=double)
    cdef void publish_inside(
        self, Py_ssize_t i, Py_ssize_t axis, int column, int cell, double x, double y, double z
    ) noexcept nogil
    cdef void set_origin(self, Py_ssize_t axis, double value) noexcept nogil
    @cython.locals(axis=Py_ssize_t, offset=int)
    cdef void execute(self, double[::1] queue, Py_ssize_t row, int kind) noexcept nogil
    cdef void turn(self, double[::1] queue, Py_ssize_t row) noexcept nogil
    cdef void publish_system(
        self, Py_ssize_t cell, double command, double actual, double target, double distance_to_go
    ) noexcept nogil
