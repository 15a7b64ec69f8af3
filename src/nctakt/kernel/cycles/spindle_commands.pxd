# SPDX-License-Identifier: MIT
# C types of spindle_commands.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel.cycles cimport instructions
from nctakt.kernel.cycles.expressions cimport Expression
from nctakt.kernel.cycles.instructions cimport Counted
from nctakt.kernel.cycles.context cimport Context

cdef class CommandSpindle(Counted):
    cdef Py_ssize_t spindle
    cdef int function
    cdef Expression speed
    cdef Expression position
    cdef int direction
    cdef long long ticks
    @cython.locals(speed=double, position=double)
    cdef int run(self, Context context) noexcept nogil
    @cython.locals(number=Py_ssize_t, open_count=cython.longlong)
    cdef int command_spindle(self, Context context, double speed_v, double position) noexcept nogil
