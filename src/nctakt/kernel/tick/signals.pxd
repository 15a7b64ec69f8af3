# SPDX-License-Identifier: MIT
# C types of signals.py.
cimport cython
from nctakt.kernel cimport codes

cdef int names_channel(long long mask, int channel) noexcept nogil

@cython.final
cdef class SignalBoard:
    cdef readonly Py_ssize_t count
    cdef long long[::1] number
    cdef long long[::1] sender
    cdef long long[::1] receiver
    cdef long long[::1] remaining
    cdef long long[::1] level
    cdef long long[::1] tick
    cdef long long[::1] mask
    cdef double[::1] values
    cdef double[::1] received
    cdef readonly long long received_mask
    cdef readonly long long taken_sender
    cdef readonly long long taken_tick
    cdef readonly long long blocking
    cdef public bint has_waited

    @cython.locals(channel=int)
    cdef int send(
        self, long long number, long long sender, long long receivers, long long remaining,
        int level, long long tick, long long mask, double[::1] values, Py_ssize_t first
    ) noexcept nogil
    @cython.locals(slot=Py_ssize_t, i=Py_ssize_t)
    cdef int add(
        self, long long number, long long sender, long long receiver, long long remaining,
        int level, long long tick, long long mask, double[::1] values, Py_ssize_t first
    ) noexcept nogil
    @cython.locals(channel=int, slot=Py_ssize_t, result=int, is_there=bint)
    cdef int state(
        self, long long number, long long receiver, long long senders, int may_overtake
    ) noexcept nogil
    @cython.locals(slot=Py_ssize_t)
    cdef Py_ssize_t find(
        self, long long number, long long receiver, long long sender
    ) noexcept nogil
    @cython.locals(other=Py_ssize_t)
    cdef int is_overtaking(self, Py_ssize_t slot) noexcept nogil
    @cython.locals(channel=int, is_asked=bint, slot=Py_ssize_t)
    cdef void take(self, long long number, long long receiver, long long senders) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void use(self, Py_ssize_t slot) noexcept nogil
    @cython.locals(i=Py_ssize_t, k=Py_ssize_t, first=Py_ssize_t, following=Py_ssize_t)
    cdef void drop(self, Py_ssize_t slot) noexcept nogil
    @cython.locals(channel=int, is_asked=bint, slot=Py_ssize_t, is_numbered=bint)
    cdef void remove(
        self, long long low, long long high, long long receivers, int is_range
    ) noexcept nogil
    @cython.locals(slot=Py_ssize_t)
    cdef void clear(self, long long receiver) noexcept nogil
