# SPDX-License-Identifier: MIT
# C types of instructions.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.cycles.expressions cimport Expression
from nctakt.kernel.cycles.context cimport Context

cdef class Statement:
    cdef int run(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil

cdef class Pair(Statement):
    cdef Statement first
    cdef Statement second
    cdef int run(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil

cdef class Triple(Statement):
    cdef Statement first
    cdef Statement second
    cdef Statement third
    cdef int run(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil

cdef class Block(Statement):
    cdef Statement first
    cdef Statement second
    cdef Statement third
    cdef Statement fourth
    cdef int run(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil

cdef class Watch:
    cdef void look(self, Context context) noexcept nogil

cdef class Watched(Statement):
    cdef Statement statement
    cdef readonly Watch watch
    cpdef void put(self, Watch watch)
    cdef int run(self, Context context) noexcept nogil
    cdef void restart(self) noexcept nogil

cdef class Counted(Statement):
    cdef readonly long long source
    cdef readonly long long cost

cdef int begin(Counted statement, Context context) noexcept nogil
cdef int stop(Counted statement, Context context) noexcept nogil
cdef int reject(Counted statement, Context context, double value) noexcept nogil
cdef void write(Counted statement, Context context, Py_ssize_t cell, double value) noexcept nogil
@cython.locals(value=double)
cdef double evaluate(Counted statement, Expression expression, Context context) noexcept nogil

cdef class Assignment(Counted):
    cdef Py_ssize_t cell
    cdef readonly Py_ssize_t room
    cdef Expression expression
    cdef int store(self, Context context, Py_ssize_t cell, double value) noexcept nogil

cdef class BoundedAssignment(Assignment):
    cdef double lowest
    cdef double highest

cdef double round_into_range(
    BoundedAssignment statement, Context context, Py_ssize_t cell, double value
) noexcept nogil

cdef class AddToReal(Assignment):
    @cython.locals(value=double)
    cdef int run(self, Context context) noexcept nogil

cdef class AssignReal(Assignment):
    @cython.locals(value=double)
    cdef int run(self, Context context) noexcept nogil
    cdef int store(self, Context context, Py_ssize_t cell, double value) noexcept nogil

cdef class AssignInteger(BoundedAssignment):
    @cython.locals(value=double)
    cdef int run(self, Context context) noexcept nogil
    cdef int store(self, Context context, Py_ssize_t cell, double value) noexcept nogil

cdef class AssignBoolean(Assignment):
    @cython.locals(value=double)
    cdef int run(self, Context context) noexcept nogil
    cdef int store(self, Context context, Py_ssize_t cell, double value) noexcept nogil

cdef class AssignOverride(BoundedAssignment):
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
    @cython.locals(value=double, latched_ms=double)
    cdef int run(self, Context context) noexcept nogil
