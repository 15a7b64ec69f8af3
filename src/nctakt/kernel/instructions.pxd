# SPDX-License-Identifier: MIT
# C types of instructions.py.
cimport cython
from nctakt.kernel cimport arithmetic
from nctakt.kernel.conditions cimport Condition
from nctakt.kernel.expressions cimport Expression
from nctakt.kernel.memory cimport Context

cdef class Statement:
    cdef int run(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil

cdef class Pair(Statement):
    cdef Statement first
    cdef Statement second
    cdef int run(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil

cdef class Block(Statement):
    cdef Statement first
    cdef Statement second
    cdef Statement third
    cdef Statement fourth
    cdef int run(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil

cdef class Counted(Statement):
    cdef readonly long long source
    cdef readonly long long cost

cdef int begin(Counted statement, Context context) noexcept nogil
cdef int stop(Counted statement, Context context) noexcept nogil
cdef void write(Counted statement, Context context, Py_ssize_t cell, double value) noexcept nogil
@cython.locals(value=double)
cdef double evaluate(Counted statement, Expression expression, Context context) noexcept nogil

cdef class Assignment(Counted):
    cdef Py_ssize_t cell
    cdef Expression expression
    cdef double lowest
    cdef double highest
    cdef int store(self, Context context, Py_ssize_t cell, double value) noexcept nogil

cdef double round_into_range(Assignment statement, Context context, Py_ssize_t cell, double value) noexcept nogil

cdef class AssignReal(Assignment):
    @cython.locals(value=double)
    cdef int run(self, Context context) noexcept nogil
    cdef int store(self, Context context, Py_ssize_t cell, double value) noexcept nogil

cdef class AssignInteger(Assignment):
    @cython.locals(value=double)
    cdef int run(self, Context context) noexcept nogil
    cdef int store(self, Context context, Py_ssize_t cell, double value) noexcept nogil

cdef class AssignBoolean(Assignment):
    @cython.locals(value=double)
    cdef int run(self, Context context) noexcept nogil
    cdef int store(self, Context context, Py_ssize_t cell, double value) noexcept nogil

cdef class AssignOverride(Assignment):
    @cython.locals(value=double)
    cdef int run(self, Context context) noexcept nogil

cdef class AssignElement(Counted):
    cdef Expression index
    cdef Assignment scalar
    @cython.locals(value=double, offset=Py_ssize_t)
    cdef int run(self, Context context) noexcept nogil

cdef class Read(Counted):
    cdef Expression expression
    cdef int run(self, Context context) noexcept nogil

cdef class IssueTechnology(Counted):
    cdef long long function
    cdef long long ticks
    @cython.locals(sequence=cython.longlong, number=int)
    cdef int run(self, Context context) noexcept nogil

cdef class CommandTimer(Counted):
    cdef int action
    cdef Expression timer
    @cython.locals(value=double)
    cdef int run(self, Context context) noexcept nogil

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
