# SPDX-License-Identifier: MIT
# C types of steps.py.
cimport cython
from nctakt.kernel.st cimport kinds, leaves, real_leaves, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.reals cimport Real
from nctakt.kernel.st.wholes cimport Whole

cdef class Step:
    cdef int run(self, PlcContext context) noexcept nogil

cdef class StepPair(Step):
    cdef Step first
    cdef Step second
    @cython.locals(end=int)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class Uncounted(Step):
    cdef Step body
    @cython.locals(steps=cython.longlong, end=int)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class StepBlock(Step):
    cdef Step first
    cdef Step second
    cdef Step third
    cdef Step fourth
    @cython.locals(end=int)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class Sourced(Step):
    cdef long long source
    cdef long long cost

cdef class Store(Sourced):
    cdef long long target
    cdef int kind
    cdef Whole operand

cdef class StoreFixed(Store):
    @cython.locals(value=cython.longlong)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class StoreFrame(Store):
    @cython.locals(value=cython.longlong)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class StoreInstance(Store):
    @cython.locals(value=cython.longlong)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class StoreAt(Sourced):
    cdef Whole address
    cdef int kind
    cdef Whole operand
    @cython.locals(at=cython.longlong, value=cython.longlong)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class StoreReal(Sourced):
    cdef long long target
    cdef int kind
    cdef Real operand
    cdef long long[::1] links

cdef class StoreRealFixed(StoreReal):
    @cython.locals(number=double)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class StoreRealFrame(StoreReal):
    @cython.locals(number=double)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class StoreRealInstance(StoreReal):
    @cython.locals(number=double)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class StoreRealAt(Sourced):
    cdef Whole address
    cdef int kind
    cdef Real operand
    @cython.locals(at=cython.longlong, number=double)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class StoreBit(Sourced):
    cdef Whole address
    cdef int kind
    cdef long long bit
    cdef Whole operand
    @cython.locals(
        at=cython.longlong, value=cython.longlong, mask=cython.longlong, old=cython.longlong,
        new=cython.longlong
    )
    cdef int run(self, PlcContext context) noexcept nogil

cdef class CopyBytes(Sourced):
    cdef Whole address
    cdef Whole origin
    cdef long long size
    @cython.locals(to=cython.longlong, origin=cython.longlong)
    cdef int run(self, PlcContext context) noexcept nogil

cdef class Evaluate(Sourced):
    cdef Whole operand
    cdef int run(self, PlcContext context) noexcept nogil

cdef class EvaluateReal(Sourced):
    cdef Real operand
    cdef int run(self, PlcContext context) noexcept nogil

cdef class Leave(Sourced):
    cdef long long end
    cdef int run(self, PlcContext context) noexcept nogil

cdef class Fail(Sourced):
    cdef int message
    cdef Whole operand
    cdef int run(self, PlcContext context) noexcept nogil
