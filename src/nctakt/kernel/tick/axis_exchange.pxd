# SPDX-License-Identifier: MIT
# C types of axis_exchange.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.axes.c_axis cimport CAxis
from nctakt.kernel.axes.single_axes cimport SingleAxes
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.path.segment_limits cimport SegmentLimits
from nctakt.kernel.tick.channel_signals cimport ChannelSignals
from nctakt.kernel.tick.spindle_exchange cimport SpindleExchange

@cython.final
cdef class AxisExchange:
    cdef Path path
    cdef SegmentLimits limits
    cdef SingleAxes single_axes
    cdef ChannelSignals signals
    cdef readonly CAxis c_axis
    cdef list c_axes
    cdef SpindleExchange spindles
    cdef long long[::1] awaited
    cdef readonly bint is_waiting
    cdef readonly long long source
    cdef readonly long long since

    @cython.locals(axis=Py_ssize_t)
    cdef int can_exchange(self) noexcept nogil
    @cython.locals(axis=Py_ssize_t)
    cdef int is_stuck(self) noexcept nogil
    cdef void reset(self) noexcept nogil
