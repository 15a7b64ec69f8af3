# SPDX-License-Identifier: MIT
# C types of record.py.
cimport cython

@cython.final
cdef class Record:
    cdef double[::1] cells
    cdef long long[::1] signals
    cdef double[::1] rows
    cdef double[::1] events
    cdef double[::1] probes
    cdef readonly Py_ssize_t signal_count
    cdef readonly Py_ssize_t row_capacity
    cdef readonly Py_ssize_t row_count
    cdef readonly Py_ssize_t event_capacity
    cdef readonly Py_ssize_t event_count
    cdef readonly Py_ssize_t probe_capacity
    cdef readonly Py_ssize_t probe_count
    cdef public long long tick
    cdef public int channel_code
    cdef public bint records_writes
    cdef public bint records_series

    @cython.locals(i=Py_ssize_t, base=Py_ssize_t)
    cdef void take_row(self) noexcept nogil
    @cython.locals(base=Py_ssize_t)
    cdef void event(self, int kind, long long source, long long subject, double a, double b) noexcept nogil
    cdef void created(self, long long source, long long serial, int scope) noexcept nogil
    cdef void started(self, long long source, long long serial) noexcept nogil
    cdef void held(self, long long source, long long serial) noexcept nogil
    cdef void continued(self, long long source, long long serial) noexcept nogil
    cdef void aborted(self, long long source, long long serial) noexcept nogil
    cdef void ended(self, long long source, long long serial, int reason) noexcept nogil
    cdef void fired(self, long long source, long long serial) noexcept nogil
    cdef void written(self, long long source, long long serial, Py_ssize_t cell, double value) noexcept nogil
    cdef void technology_rt(self, long long source, long long serial, long long function, long long sequence) noexcept nogil
    cdef void technology(self, long long source, long long function, bint has_value, long long value) noexcept nogil
    cdef void message(self, long long source, long long number) noexcept nogil
    cdef void error(self, long long source, long long serial, int message, double detail) noexcept nogil
    cdef void program_end(self, long long source, long long program) noexcept nogil
    cdef void block(self, long long source, long long number, long long decoded_tick) noexcept nogil
    cdef void wait(self, long long source, int reason, Py_ssize_t cell) noexcept nogil
    cdef void paused(self, long long source) noexcept nogil
    cdef void loop(self, long long source, int how) noexcept nogil
    cdef void fixed_stop(self, long long source, Py_ssize_t axis, double position) noexcept nogil
    cdef void probe_found(self, long long source, double delta) noexcept nogil
    cdef void retraced(self, long long source, int how) noexcept nogil
    cdef void axis_begun(self, long long source, long long serial, Py_ssize_t axis, double target) noexcept nogil
    cdef void axis_ended(self, long long source, long long serial, Py_ssize_t axis, int how) noexcept nogil
    cdef void axis_changed(self, long long source, long long serial, Py_ssize_t axis, int what) noexcept nogil
    cdef void notice(self, long long source, long long serial, int message) noexcept nogil
    cdef void frozen(self, long long source, long long serial, long long name, double value) noexcept nogil
    cdef void starved(self, long long source) noexcept nogil
    cdef void fed(self, long long source, long long ticks) noexcept nogil
    cdef void overflow(self, long long thread) noexcept nogil
    cdef void user_error(self, long long source, long long serial, double identity, double reaction) noexcept nogil
    cdef void user_value(self, long long source, long long serial, int code, double value) noexcept nogil
    cdef void user_text(self, long long source, long long serial, int code, long long text) noexcept nogil
    cdef void spindle(self, long long source, long long serial, Py_ssize_t spindle, long long function, double rpm) noexcept nogil
    cdef void spindle_reached(self, long long source, long long serial, Py_ssize_t spindle) noexcept nogil
    cdef void spindle_position(self, long long source, long long serial, Py_ssize_t spindle, double position) noexcept nogil
    @cython.locals(base=Py_ssize_t)
    cdef void probe(self, long long number, int truth, double left, double right) noexcept nogil
    @cython.locals(base=Py_ssize_t)
    cdef void series(self, long long number, int kind, long long next_tick) noexcept nogil
    cdef int has_room(self, Py_ssize_t events, Py_ssize_t probes) noexcept nogil
