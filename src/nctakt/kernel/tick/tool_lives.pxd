# SPDX-License-Identifier: MIT
# C types of tool_lives.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.path.tool_life cimport ToolLifeCounter
from nctakt.kernel.plc.panel cimport Panel
from nctakt.kernel.tick.command_queue cimport CommandQueue

@cython.final
cdef class ToolLifeReporter:
    cdef CommandQueue queue
    cdef ToolLifeCounter life
    cdef Panel panel
    cdef Record record
    cdef long long sent
    cdef bint omits_zero

    cdef void end_tick(self) noexcept nogil
    @cython.locals(
        action=int, tool=cython.longlong, basic=cython.longlong, time=double, distance=double,
        is_ahead=int, before_d=double, time_t=double
    )
    cdef void execute(self, Py_ssize_t row) noexcept nogil
    @cython.locals(source=cython.longlong, time_t=double)
    cdef void send(
        self, Py_ssize_t row, long long tool, long long basic, double distance_d
    ) noexcept nogil
