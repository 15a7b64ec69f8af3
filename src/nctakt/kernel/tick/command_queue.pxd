# SPDX-License-Identifier: MIT
# C types of command_queue.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport bounds
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.lookahead cimport LookAhead
from nctakt.kernel.tick.loop_body cimport LoopBody
from nctakt.kernel.path.path cimport Path

@cython.final
cdef class CommandQueue:
    cdef readonly Path path
    cdef readonly LookAhead look_ahead
    cdef readonly Py_ssize_t width
    cdef Py_ssize_t capacity
    cdef double[::1] rows
    cdef Py_ssize_t head
    cdef Py_ssize_t tail
    cdef readonly Py_ssize_t timed_count
    cdef Py_ssize_t started
    cdef Py_ssize_t last_segment
    cdef long long transformation
    cdef readonly LoopBody loop_body
    cdef bint has_early
    cdef double[::1] end_row

    @cython.locals(row=Py_ssize_t, i=Py_ssize_t, kind=int)
    cpdef put(self, list command)
    @cython.locals(row=Py_ssize_t, first=Py_ssize_t, i=Py_ssize_t)
    cpdef put_segment(
        self, double source, double number, start, target, int motion, double feed_v,
        int exact_stop, double deviation, int limits_jerk, arc, feed_modifiers=*, curve=*
    )
    cdef void note_early(self, Py_ssize_t row) noexcept nogil
    @cython.locals(length=double, oldest=Py_ssize_t)
    cdef void prepare(self, Py_ssize_t row) noexcept nogil
    @cython.locals(before=Py_ssize_t, back=Py_ssize_t)
    cdef Py_ssize_t pass_into(self, Py_ssize_t row, Py_ssize_t oldest) noexcept nogil
    @cython.locals(promised_v=double, promised_max_v=double)
    cdef void connect(self, Py_ssize_t back, Py_ssize_t oldest) noexcept nogil
    @cython.locals(
        number=Py_ssize_t, rounding=Py_ssize_t, row=Py_ssize_t, i=Py_ssize_t, before=Py_ssize_t
    )
    cdef Py_ssize_t insert_rounding(self, Py_ssize_t oldest) noexcept nogil
    @cython.locals(row=Py_ssize_t, target=Py_ssize_t, i=Py_ssize_t)
    cdef void copy_row(self, Py_ssize_t number, Py_ssize_t to) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void begin_segment(
        self, Py_ssize_t row, double source, double number, int motion, int exact_stop,
        int limits_jerk
    ) noexcept nogil
    @cython.locals(first=Py_ssize_t, i=Py_ssize_t)
    cdef void put_ends(self, Py_ssize_t row, double[::1] start, double[::1] target) noexcept nogil
    @cython.locals(exact_stop=bint)
    cdef void end_segment(self, Py_ssize_t row) noexcept nogil
    @cython.locals(row=Py_ssize_t, i=Py_ssize_t)
    cdef int put_mark(
        self, double source, double number, double decoded_tick, double calls, double depth
    ) except -1
    @cython.locals(row=Py_ssize_t)
    cdef void put_line(
        self, double source, double number, double[::1] start, double[::1] target, int motion,
        double feed_v, int exact_stop, double deviation, int limits_jerk
    ) noexcept nogil
    @cython.locals(row=Py_ssize_t, i=Py_ssize_t)
    cdef void put_arc(
        self, double source, double number, double[::1] start, double[::1] target, double[::1] arc,
        int motion, double feed_v, int exact_stop, double deviation, int limits_jerk
    ) noexcept nogil
    @cython.locals(row=Py_ssize_t)
    cpdef void continue_block(self) noexcept
    cdef int has_thread(self, Py_ssize_t row) noexcept nogil
    @cython.locals(before=Py_ssize_t, thread=double, limits_jerk=bint)
    cdef int has_same_slope(self, Py_ssize_t number, Py_ssize_t row) noexcept nogil
    cdef Py_ssize_t next_row(self) except -1
    @cython.locals(
        count=Py_ssize_t, length=double, needed=double, position=Py_ssize_t, row=Py_ssize_t
    )
    cdef int needs_pass(self) noexcept nogil
    @cython.locals(fastest_v=double, speed=double, acceleration=double, length=double)
    cdef double braking_distance_in(self, Py_ssize_t row) noexcept nogil
    @cython.locals(end=Py_ssize_t, i=Py_ssize_t, k=Py_ssize_t, row=Py_ssize_t, kept=Py_ssize_t)
    cdef void repeat_body(self) noexcept nogil
    @cython.locals(kind=int)
    cdef int time_units(self, Py_ssize_t row) noexcept nogil
    @cython.locals(last=cython.longlong, row=Py_ssize_t, remaining=double, limit_v=double)
    cdef double remaining_of_block(self, long long position) noexcept nogil
    @cython.locals(row=Py_ssize_t)
    cdef int block_continues(self, long long position) noexcept nogil
    cdef Py_ssize_t head_row(self) noexcept nogil
