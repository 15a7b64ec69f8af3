# SPDX-License-Identifier: MIT
# C types of kernel.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.axes.axes cimport Axes
from nctakt.kernel.plc.axis_requests cimport AxisRequests
from nctakt.kernel.tick.channel cimport Channel
from nctakt.kernel.tick.plc_calls cimport PlcCalls
from nctakt.kernel.st.tasks cimport PlcSide
from nctakt.kernel.tick.signals cimport SignalBoard
from nctakt.kernel.tick.stops cimport Stops
from nctakt.kernel.posted_values cimport PostedValues
from nctakt.kernel.plc.interface_image cimport InterfaceImage
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.axes.single_axes cimport SingleAxes

cdef class Lane:
    cdef int needs_python(self) noexcept nogil
    cdef int activity(self) noexcept nogil
    cdef Py_ssize_t event_bound(self) noexcept nogil
    cdef Py_ssize_t probe_bound(self) noexcept nogil
    cdef void begin_tick(self, long long tick) noexcept nogil
    cdef void end_tick(self) noexcept nogil

cdef class ChannelLane(Lane):
    cdef Channel channel
    cdef Record record
    cdef int number
    cdef Lane others
    @cython.locals(reason=int)
    cdef int needs_python(self) noexcept nogil
    @cython.locals(own=int)
    cdef int activity(self) noexcept nogil
    cdef Py_ssize_t event_bound(self) noexcept nogil
    cdef Py_ssize_t probe_bound(self) noexcept nogil
    cdef void begin_tick(self, long long tick) noexcept nogil
    cdef void end_tick(self) noexcept nogil

@cython.final
cdef class Kernel:
    cdef double[::1] cells
    cdef readonly PostedValues posted
    cdef Axes axes
    cdef Record record
    cdef SingleAxes single_axes
    cdef readonly AxisRequests requests
    cdef readonly InterfaceImage image
    cdef Lane lane
    cdef readonly Stops stops
    cdef readonly SignalBoard signals
    cdef public bint ends_deadlock
    cdef readonly PlcCalls calls
    cdef readonly PlcSide plc
    cdef readonly bint is_stopped
    cdef readonly bint is_plc_due
    cdef readonly long long tick

    @cython.locals(reason=int)
    cpdef int run(self, long long ticks)
    @cython.locals(end=cython.longlong, before=cython.longlong, reason=int)
    cpdef run_calling(self, long long ticks, call, view)
    cdef int calls_plc(self) noexcept nogil
    @cython.locals(end=cython.longlong, reason=int)
    cdef int loop(self, long long ticks) noexcept nogil
    @cython.locals(posted=Py_ssize_t)
    cdef Py_ssize_t event_bound(self) noexcept nogil
    cdef void run_tick(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void latch_inputs(self) noexcept nogil
    cdef void record_row(self) noexcept nogil
