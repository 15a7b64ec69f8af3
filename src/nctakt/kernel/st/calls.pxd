# SPDX-License-Identifier: MIT
# C types of calls.py.
cimport cython
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.steps cimport Step
from nctakt.kernel.st.wholes cimport Whole

cdef class Callee:
    cdef int invoke(self, PlcContext context, long long frame, long long instance) noexcept nogil

cdef class Routine(Callee):
    cdef long long shared
    cdef long long size
    cdef Step body
    @cython.locals(outer_frame=cython.longlong, outer_instance=cython.longlong, end=int)
    cdef int invoke(self, PlcContext context, long long frame, long long instance) noexcept nogil

cdef class OfTypes(Callee):
    cdef long long lowest
    cdef long long highest
    cdef Callee routine
    @cython.locals(number=cython.longlong)
    cdef int invoke(self, PlcContext context, long long frame, long long instance) noexcept nogil

cdef class ByType(Callee):
    cdef long long split
    cdef Callee below
    cdef Callee others
    cdef int invoke(self, PlcContext context, long long frame, long long instance) noexcept nogil

cdef class Call(Whole):
    cdef Callee callee
    cdef Whole instance
    cdef long long shared
    cdef Step arguments
    cdef Step outputs
    cdef bint fills_instance
    cdef long long source
    @cython.locals(
        frame=cython.longlong, instance=cython.longlong, outer=cython.longlong,
        address=cython.longlong
    )
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class ResultPlace(Whole):
    cdef Call call
    cdef long long size
    cdef long long kept
    @cython.locals(frame=cython.longlong, address=cython.longlong, origin=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class NoteCaller(Step):
    cdef long long source
    cdef int run(self, PlcContext context) noexcept nogil

cdef class CallerSource(Whole):
    cdef long long value(self, PlcContext context) noexcept nogil
