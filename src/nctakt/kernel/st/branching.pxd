# SPDX-License-Identifier: MIT
# C types of branching.py.
cimport cython
from nctakt.kernel.st cimport kinds, leaves, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.steps cimport Sourced, Step
from nctakt.kernel.st.wholes cimport Whole

cdef class Alternative(Sourced):
    cdef Whole condition
    cdef Step body
    @cython.locals(truth=cython.longlong)
    cdef int attempt(self, PlcContext context) noexcept nogil
    @cython.locals(truth=cython.longlong)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class EitherOr(Alternative):
    cdef Step otherwise
    @cython.locals(truth=cython.longlong)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class AlternativePair(Alternative):
    cdef Alternative first
    cdef Alternative second
    @cython.locals(end=int)
    cdef int attempt(self, PlcContext context) noexcept nogil
    @cython.locals(end=int)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class Alternatives(Step):
    cdef Alternative branches
    cdef Step otherwise
    @cython.locals(end=int)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class Choices:
    cdef int choose(self, PlcContext context, long long selector) noexcept nogil

cdef class Choice(Choices):
    cdef long long lowest
    cdef long long highest
    cdef Step body
    cdef Choices less
    cdef Choices greater
    cdef int choose(self, PlcContext context, long long selector) noexcept nogil

cdef class Case(Sourced):
    cdef Whole selector
    cdef Choices labels
    cdef Step otherwise
    @cython.locals(selector=cython.longlong, end=int)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class For(Sourced):
    cdef Whole address
    cdef int kind
    cdef Whole start
    cdef Whole end
    cdef Whole step
    cdef Step body
    cdef long long bias
    @cython.locals(
        at=cython.longlong, value=cython.longlong, limit=cython.longlong, step=cython.longlong,
        end=int
    )
    cdef int run(self, PlcContext context) noexcept nogil

cdef class While(Sourced):
    cdef Whole condition
    cdef Step body
    @cython.locals(truth=cython.longlong, end=int)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class Repeat(Sourced):
    cdef Whole condition
    cdef Step body
    @cython.locals(end=int, truth=cython.longlong)
    cdef int run(self, PlcContext context) noexcept nogil
