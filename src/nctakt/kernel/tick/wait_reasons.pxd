# SPDX-License-Identifier: MIT
# C types of wait_reasons.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.path.override cimport Overrides
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.tick.axis_exchange cimport AxisExchange
from nctakt.kernel.tick.command_execution cimport CommandExecutor
from nctakt.kernel.tick.command_queue cimport CommandQueue

@cython.final
cdef class WaitReasons:
    cdef CommandExecutor executor
    cdef CommandQueue queue
    cdef Path path
    cdef Overrides overrides
    cdef AxisExchange exchange
    cdef bint has_warned_of_wait
    cdef bint has_warned_of_spindle

    @cython.locals(spindle=Py_ssize_t)
    cdef Py_ssize_t resting_spindle(self) noexcept nogil
