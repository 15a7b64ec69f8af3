# SPDX-License-Identifier: MIT
# C types of lines.py.
cimport cython
from nctakt.decoder.fast.compensated_lines cimport CompensatedLines
from nctakt.decoder.kinematics.transformed_travel cimport TransformedTravel
from nctakt.kernel cimport rows
from nctakt.kernel.tick.command_queue cimport CommandQueue
from nctakt.nc.fast.plain_lines cimport PlainScanner

cdef class PlainLines:
    cdef readonly PlainScanner scanner
    cdef readonly CompensatedLines compensated
    cdef readonly TransformedTravel axis_check
    cdef public bint is_transformed
    cdef public bint leaves_last
    cdef public bint leaves_functions
    cdef public bint marks
    cdef public long long tick
    cdef public long long calls
    cdef public long long depth
    cdef bint is_block
    cdef readonly Py_ssize_t count
    cdef double[::1] positions
    cdef double[::1] start
    cdef double[::1] target
    cdef double[::1] offsets
    cdef double[::1] factors
    cdef double[::1] lows
    cdef double[::1] highs
    cdef public int motion
    cdef readonly int rapid
    cdef public double feed_v
    cdef public double feed_factor
    cdef public bint is_absolute
    cdef public bint stops_exactly
    cdef public bint rapid_stops_exactly
    cdef public double deviation
    cdef public bint limits_jerk
    cdef public long long source_base
    cdef public Py_ssize_t blocks
    cdef public Py_ssize_t max_blocks
    cdef readonly long long source
    cdef public long long block_number

    @cython.locals(end=Py_ssize_t, what=int, is_rapid=bint, motion=int, feed_v=double, stops=bint)
    cpdef Py_ssize_t fill(
        self, CommandQueue queue, Py_ssize_t timed, list lines, Py_ssize_t index, long long number
    ) except -1
    cpdef bint is_left(self, list lines, Py_ssize_t index) except -1
    @cython.locals(begins=int, is_function=int, character=Py_UCS4)
    cdef int may_output(self, str line)
    @cython.locals(
        scanner=PlainScanner,
        end=Py_ssize_t,
        what=int,
        i=Py_ssize_t,
        position=double,
        begin=double,
    )
    cpdef int is_followed(self, list lines, Py_ssize_t index) except -1
    cpdef bint resume(self, CommandQueue queue, Py_ssize_t timed)
    @cython.locals(
        scanner=PlainScanner, what=int, motion=int, feed_v=double, moves=int, i=Py_ssize_t
    )
    cpdef int decode(self, str line, long long number) except -1
    cdef int try_join(self, int motion)
    @cython.locals(
        scanner=PlainScanner, moves=int, i=Py_ssize_t, position=double, begin=double, target=double
    )
    cdef int set_target(self)
