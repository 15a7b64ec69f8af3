# SPDX-License-Identifier: MIT
# C types of actions.py.
cimport cython
from libc cimport math
from nctakt.kernel cimport codes
from nctakt.kernel.cycles cimport instructions
from nctakt.kernel.cycles.expressions cimport Expression
from nctakt.kernel.cycles.instructions cimport Counted
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.axes.single_axes cimport SingleAxes

cdef class FeedMemory:
    cdef double speed_v

cdef class Speed:
    cdef double highest_v
    cdef FeedMemory memory
    cdef double value(self, Context context) noexcept nogil

cdef class Feed(Speed):
    cdef Expression expression
    cdef double unit_v
    @cython.locals(speed_v=double)
    cdef double value(self, Context context) noexcept nogil

cdef class EarlierFeed(Speed):
    cdef double value(self, Context context) noexcept nogil

cdef class AxisStatement(Counted):
    cdef Py_ssize_t axis

cdef int refuse(AxisStatement statement, Context context, int message, double value) noexcept nogil
cdef int complete(AxisStatement statement, Context context, double value) noexcept nogil
@cython.locals(open_count=cython.longlong)
cdef int has_room_for_action(
    AxisStatement statement, Context context, int is_buffered
) noexcept nogil
cdef int sign(double value) noexcept nogil
cdef int direction_of(AxisStatement statement, Context context, double value) noexcept nogil

cdef class StopAxis(AxisStatement):
    @cython.locals(message=int)
    cdef int run(self, Context context) noexcept nogil

cdef class MovingStatement(AxisStatement):
    cdef Speed speed
    cdef Expression direction
    cdef bint has_direction
    cdef bint is_buffered
    cdef void restart(self) noexcept nogil

@cython.final
cdef class AxisTarget:
    cdef Expression position
    cdef double unit_d
    cdef bint is_absolute
    cdef int offsets

cdef class MoveAxis(MovingStatement):
    cdef AxisTarget target
    @cython.locals(speed_v=double, position_d=double, direction=int)
    cdef int run(self, Context context) noexcept nogil
    @cython.locals(message=int)
    cdef int command(
        self, Context context, double position_d, double speed_v, int direction
    ) noexcept nogil

cdef class RunAxis(MovingStatement):
    @cython.locals(speed_v=double, direction=int, message=int)
    cdef int run(self, Context context) noexcept nogil
