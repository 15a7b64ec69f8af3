# SPDX-License-Identifier: MIT
# C types of axis_calls.py.
cimport cython
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.reals cimport Real
from nctakt.kernel.st.wholes cimport Whole

cdef class OpenInterface(Whole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class TaskNumber(Whole):
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class CommandAxis(Whole):
    cdef Whole kind
    cdef Whole axis
    cdef Real target
    cdef Real speed
    cdef Whole mode
    cdef Whole direction
    @cython.locals(
        kind=cython.longlong, axis=cython.longlong, target=double, speed_v=double,
        mode=cython.longlong, direction=cython.longlong
    )
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class SwitchAxis(Whole):
    cdef Whole axis
    cdef Whole is_on
    cdef bint is_lock
    @cython.locals(axis=cython.longlong, is_on=int)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class OverrideAxis(Whole):
    cdef Whole axis
    cdef Real factor
    @cython.locals(axis=cython.longlong, factor=double)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class LookAtAxis(Whole):
    cdef Whole what
    cdef Whole axis
    cdef Whole owner
    @cython.locals(what=cython.longlong, axis=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class MeasureAxis(Real):
    cdef Whole what
    cdef Whole axis
    @cython.locals(what=cython.longlong)
    cdef double number(self, PlcContext context) noexcept nogil
