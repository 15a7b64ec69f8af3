# SPDX-License-Identifier: MIT
# C types of early_outputs.py.
cimport cython
from libc cimport math
from nctakt.kernel cimport codes, rows
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.plc.technology_slots cimport Hli
from nctakt.kernel.tick.command_queue cimport CommandQueue

@cython.final
cdef class EarlyOutputs:
    cdef CommandQueue queue
    cdef Path path
    cdef Hli hli
    cdef Record record
    cdef double travel_d
    cdef double travel_t
    cdef double last_v
    cdef double last_a
    cdef double end_v

    @cython.locals(
        is_open=int, closed_d=double, has_more=int, position=Py_ssize_t, row=Py_ssize_t, kind=int,
        length_d=double
    )
    cdef void put_out(self, long long tick) noexcept nogil
    @cython.locals(row=Py_ssize_t, rest_d=double)
    cdef void begin_travel(self) noexcept nogil
    @cython.locals(factor=double)
    cdef void go_on(self, double[::1] segments, Py_ssize_t row, double length_d) noexcept nogil
    @cython.locals(lead=double, kind=int, end_v=double)
    cdef int is_due(self, Py_ssize_t row) noexcept nogil
    @cython.locals(change_v=double, ramp_d=double, start_v=double)
    cdef double time_to(self, double end_v) noexcept nogil
    @cython.locals(function=cython.longlong)
    cdef int issue(self, long long tick, Py_ssize_t row) noexcept nogil
    @cython.locals(
        function=cython.longlong, ticks=cython.longlong, value=cython.longlong, has_value=bint,
        source=cython.longlong
    )
    cdef int issue_at_its_place(self, long long tick, Py_ssize_t row) noexcept nogil
