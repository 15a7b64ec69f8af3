# SPDX-License-Identifier: MIT
# C types of single_block.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.plc.panel cimport Panel
from nctakt.kernel.tick.command_queue cimport CommandQueue

@cython.final
cdef class SingleBlock:
    cdef CommandQueue queue
    cdef Path path
    cdef Panel panel
    cdef bint only_motions

    @cython.locals(resolution=cython.longlong)
    cdef void execute(self, Py_ssize_t row) noexcept nogil
    @cython.locals(head=cython.longlong, row=Py_ssize_t, kind=int, is_started=bint)
    cdef int permits(self) noexcept nogil
    @cython.locals(number=cython.longlong, row=Py_ssize_t, continues=bint)
    cdef int stops_ahead(self) noexcept nogil
    @cython.locals(row=Py_ssize_t, block=double, line=cython.longlong, kind=int)
    cdef int is_block(self, long long number) noexcept nogil
    @cython.locals(row=Py_ssize_t, kind=int)
    cdef bint leads_to_motion(self, long long number) noexcept nogil
    @cython.locals(source=cython.longlong)
    cdef long long line(self, Py_ssize_t row) noexcept nogil
    cdef bint is_mark(self, int kind) noexcept nogil
    cdef bint is_motion(self, int kind) noexcept nogil
