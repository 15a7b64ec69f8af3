# SPDX-License-Identifier: MIT
# C types of compensated_lines.py.
cimport cython
from nctakt.decoder.contour cimport rows as contour_rows
from nctakt.decoder.contour.tool_path cimport ToolPath
from nctakt.kernel cimport rows
from nctakt.kernel.tick.command_queue cimport CommandQueue

cdef class CompensatedLines:
    cdef readonly ToolPath tool
    cdef readonly Py_ssize_t count
    cdef public bint is_on
    cdef public Py_ssize_t first
    cdef public Py_ssize_t second
    cdef public double distance
    cdef double[::1] start
    cdef double[::1] target
    cdef double[::1] begin
    cdef double[::1] end
    cdef double[::1] arc
    cdef double[::1] sources
    cdef public long long source
    cdef public long long number
    cdef public int motion
    cdef public double feed_v
    cdef public bint stops
    cdef public double deviation
    cdef public bint limits_jerk
    cdef bint has_first_piece
    cdef readonly bint has_next
    cdef double[::1] next_target
    cdef long long next_source
    cdef long long next_number
    cdef int next_motion
    cdef double next_feed_v
    cdef bint next_stops

    @cython.locals(x=double, y=double, x_2=double, y_2=double)
    cdef int try_join(
        self, double[::1] start, double[::1] target, double[::1] lows, double[::1] highs,
        bint is_contour
    ) noexcept
    @cython.locals(before=cython.longlong, shape=int)
    cdef int emit(self, CommandQueue queue, Py_ssize_t timed) noexcept
    @cython.locals(i=Py_ssize_t)
    cdef void advance(self, long long before) noexcept
    @cython.locals(row=Py_ssize_t, i=Py_ssize_t, is_continued=bint, stops=bint, deviation=double)
    cdef void emit_piece(self, CommandQueue queue, int shape, long long before) noexcept
    @cython.locals(i=Py_ssize_t)
    cdef void set_next(
        self, long long source, long long number, double[::1] target, int motion, double feed_v,
        int stops
    ) noexcept
