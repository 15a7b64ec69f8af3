# SPDX-License-Identifier: MIT
# C types of spindle_exchange.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.tick.channel_signals cimport ChannelSignals
from nctakt.kernel.tick.command_queue cimport CommandQueue

@cython.final
cdef class SpindleExchange:
    cdef Context context
    cdef CommandQueue queue
    cdef ChannelSignals signals
    cdef Record record
    cdef readonly long long blocked_since

    @cython.locals(spindle=Py_ssize_t, axis=Py_ssize_t, position=double)
    cdef int execute(self, long long tick, Py_ssize_t row) noexcept nogil
    @cython.locals(axis=Py_ssize_t)
    cdef int take(self, long long tick, Py_ssize_t row, Py_ssize_t spindle) noexcept nogil
    @cython.locals(holder=cython.longlong)
    cdef int has_other(self, Py_ssize_t axis) noexcept nogil
    @cython.locals(row=Py_ssize_t, spindle=Py_ssize_t)
    cdef int is_stuck(self) noexcept nogil
    @cython.locals(source=cython.longlong, holder=cython.longlong, number=cython.longlong)
    cdef void record_exchange(
        self, Py_ssize_t row, Py_ssize_t spindle, Py_ssize_t axis, int what
    ) noexcept nogil
    cdef void reset(self) noexcept nogil
