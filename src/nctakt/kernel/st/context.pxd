# SPDX-License-Identifier: MIT
# C types of context.py.
cimport cython
from nctakt.kernel.st cimport kinds
from nctakt.kernel.st.observing cimport notes
from nctakt.kernel.st.observing.notes cimport Notes
from nctakt.kernel.st.outside cimport Outside

@cython.final
cdef class PlcContext:
    cdef readonly unsigned char[::1] memory
    cdef readonly long long stack
    cdef readonly long long stack_end
    cdef readonly long long end
    cdef readonly long long interface
    cdef readonly long long plain_end
    cdef public Outside outside
    cdef readonly Notes notes
    cdef readonly bint is_noting
    cdef long long[::1] writers
    cdef public long long task
    cdef public long long frame
    cdef public long long top
    cdef public long long instance
    cdef public long long passing
    cdef public long long depth
    cdef public long long caller
    cdef public long long now
    cdef public long long steps
    cdef public long long max_steps
    cdef public long long instruction_ns
    cdef public long long source_base
    cdef public long long overrun_task
    cdef public long long overrun_ns
    cdef public int fault
    cdef public long long fault_source
    cdef public long long fault_a
    cdef public long long fault_b
    cdef public long long fault_frame
    cdef public long long fault_instance
    cdef readonly long long[::1] trail
    cdef public long long trail_length
    cdef readonly long long[::1] counts
    cdef readonly double[::1] near_left
    cdef readonly double[::1] near_right
    cdef readonly double[::1] distances
    cdef public double seen_left
    cdef public double seen_right
    cdef long long count_end
    cdef public bint stops_at_invalid
    cdef public bint wraps_conversions

    cdef void wrote(self, long long at, int kind, long long source) noexcept nogil
    cdef void wrote_target(self, long long at, int kind, long long source) noexcept nogil
    cdef void wrote_bytes(self, long long at, long long size, long long source) noexcept nogil
    cdef void count(self, long long number) noexcept nogil
    cdef void approach(self, long long number, long long truth) noexcept nogil
    @cython.locals(distance=cython.double, known=cython.double)
    cdef void note_near(self, long long missed, double left, double right) noexcept nogil
    cpdef void begin(self, long long now) noexcept nogil
    cdef void fail(self, int message, long long a, long long b) noexcept nogil
    cdef int stop_at(self, long long source) noexcept nogil
    cdef int over_budget(self, long long source) noexcept nogil
    cdef void note_call(self, long long source) noexcept nogil
    cdef void note_writer(self, long long address, long long source) noexcept nogil
    @cython.locals(source=cython.longlong)
    cpdef long long writer_of(self, long long address) noexcept nogil
    cdef long long checked(self, long long address, long long size) noexcept nogil
    cdef long long checked_target(self, long long address, long long size) noexcept nogil
