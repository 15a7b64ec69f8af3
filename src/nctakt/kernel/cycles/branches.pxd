# SPDX-License-Identifier: MIT
# C types of branches.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.cycles cimport instructions
from nctakt.kernel.cycles.conditions cimport Condition
from nctakt.kernel.cycles.instructions cimport Counted, Statement
from nctakt.kernel.cycles.context cimport Context

cdef class Reaction(Counted):
    cdef readonly Condition condition
    cdef Statement body
    cdef readonly long long count
    cdef readonly long long first_tick
    cdef readonly long long next_tick
    cdef readonly long long last_run
    cdef void restart(self) noexcept nogil

@cython.locals(truth=int)
cdef int judge(Reaction reaction, Context context) noexcept nogil
cdef int react(Reaction reaction, Context context) noexcept nogil

cdef class Branch(Reaction):
    @cython.locals(result=int)
    cdef int attempt(self, Context context) noexcept nogil
    @cython.locals(truth=int)
    cdef int run(self, Context context) noexcept nogil

cdef class Branches(Branch):
    cdef Branch first
    cdef Branch second
    cdef Branch third
    cdef Branch fourth
    cdef int run(self, Context context) noexcept nogil
    @cython.locals(result=int)
    cdef int attempt(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil

cdef class NoBranch(Branch):
    cdef int attempt(self, Context context) noexcept nogil

cdef class IfOnce(Reaction):
    cdef bint is_done
    @cython.locals(truth=int)
    cdef int run(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil

cdef class IfEdge(Reaction):
    cdef int was_true
    @cython.locals(truth=int, rises=bint)
    cdef int run(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil

cdef class IfAlways(Reaction):
    cdef bint is_latched
    @cython.locals(truth=int)
    cdef int run(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil
