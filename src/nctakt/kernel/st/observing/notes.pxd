# SPDX-License-Identifier: MIT
# C types of notes.py.
cimport cython
from nctakt.kernel.st cimport kinds, words

@cython.final
cdef class Notes:
    cdef readonly bint is_on
    cdef public long long top
    cdef public long long kept
    cdef public long long loop
    cdef long long[::1] numbers
    cdef long long[::1] values
    cdef double[::1] reals
    cdef int[::1] watched
    cdef readonly long long count
    cdef public long long interface_from
    cdef readonly long long[::1] address
    cdef readonly long long[::1] kind
    cdef long long[::1] whole
    cdef long long[::1] is_new
    cdef readonly long long[::1] seen
    cdef readonly long long[::1] written_at
    cdef readonly long long[::1] written_by
    cdef readonly long long[::1] missed
    cdef readonly long long[::1] logged
    cdef readonly long long log_size
    cdef readonly long long[::1] log
    cdef readonly long long log_end
    cdef readonly bint is_crowded

    cdef void begin(self) noexcept nogil
    cdef void push(self, long long number, long long value) noexcept nogil
    cdef void push_real(self, long long number, double value) noexcept nogil
    cdef void leave(self, long long begin) noexcept nogil
    @cython.locals(i=cython.longlong)
    cdef long long add(
        self, unsigned char[::1] memory, long long address, int kind
    ) noexcept nogil
    cdef long long bits(
        self, unsigned char[::1] memory, long long address, int kind
    ) noexcept nogil
    @cython.locals(i=cython.longlong, number=cython.longlong, latest=cython.longlong)
    cdef void note(
        self, unsigned char[::1] memory, long long at, long long size, long long source,
        long long now
    ) noexcept nogil
    @cython.locals(number=cython.longlong)
    cdef void discover(self, unsigned char[::1] memory, long long at, int kind) noexcept nogil
    @cython.locals(number=cython.longlong)
    cdef void refresh(self, unsigned char[::1] memory, long long now) noexcept nogil
    cdef void touch(self, unsigned char[::1] memory, long long at, long long now) noexcept nogil
    @cython.locals(
        value=cython.longlong, before=cython.longlong, count=cython.longlong,
        flags=cython.longlong, i=cython.longlong
    )
    cdef void compare(
        self, unsigned char[::1] memory, long long number, long long source, long long now
    ) noexcept nogil
    cdef void put(self, long long word) noexcept nogil
    @cython.locals(
        at=cython.longlong, kept=cython.longlong, end=cython.longlong, number=cython.longlong,
        i=cython.longlong
    )
    cpdef void drop_old(self) noexcept nogil

cdef long long width(int kind) noexcept nogil
