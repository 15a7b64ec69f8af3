# SPDX-License-Identifier: MIT
# C types of channel_signals.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.tick.command_queue cimport CommandQueue
from nctakt.kernel.tick.signals cimport SignalBoard

@cython.final
cdef class ChannelSignals:
    cdef readonly SignalBoard board
    cdef readonly long long number
    cdef public int named
    cdef CommandQueue queue
    cdef Record record
    cdef readonly bint is_decoder_waiting
    cdef readonly long long awaited_number
    cdef readonly long long awaited_senders
    cdef readonly bint may_overtake
    cdef readonly long long awaited_source
    cdef readonly long long waiting_since
    cdef readonly long long blocked_since
    cdef public bint awaits_tick

    cdef int decoder_state(self) noexcept nogil
    @cython.locals(
        row=Py_ssize_t, number=cython.longlong, senders=cython.longlong, may_overtake=int, state=int
    )
    cdef int is_stuck(self) noexcept nogil
    cdef int execute(self, long long tick, Py_ssize_t row, int kind) noexcept nogil
    @cython.locals(
        number=cython.longlong, receivers=cython.longlong, remaining=cython.longlong,
        mask=cython.longlong, source=cython.longlong
    )
    cdef int execute_send(self, long long tick, Py_ssize_t row) noexcept nogil
    @cython.locals(
        number=cython.longlong, senders=cython.longlong, may_overtake=int, source=cython.longlong,
        state=int, sender=cython.longlong, sent=cython.longlong
    )
    cdef int execute_wait(self, long long tick, Py_ssize_t row) noexcept nogil
    cdef void reset(self) noexcept nogil
