# SPDX-License-Identifier: MIT
# C types of block_scope.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.cycles.cycles cimport CycleManager
from nctakt.kernel.tick.command_queue cimport CommandQueue

@cython.final
cdef class BlockScope:
    cdef CycleManager manager
    cdef Record record
    cdef long long serial
    cdef Py_ssize_t position
    cdef long long source
    cdef bint has_moved
    cdef bint lingers
    cdef long long passed_source

    @cython.locals(serial=cython.longlong)
    cdef void leave(self, CommandQueue commands) noexcept nogil
    @cython.locals(row=Py_ssize_t, source=cython.longlong, kind=int)
    cdef int holds_next(self, CommandQueue commands) noexcept nogil
    @cython.locals(row=Py_ssize_t)
    cdef void wait(self, CommandQueue commands) noexcept nogil
    cdef int is_wait(self, int kind) noexcept nogil
    cdef void move(self, CommandQueue commands, Py_ssize_t row, long long serial) noexcept nogil
    cdef void enter(self, CommandQueue commands, Py_ssize_t row, long long serial) noexcept nogil
    cdef void pass_over(self, int kind, long long source) noexcept nogil
    cdef void report_passed(self, long long source) noexcept nogil
    cdef int is_content(self, int kind) noexcept nogil
