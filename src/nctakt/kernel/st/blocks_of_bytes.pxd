# SPDX-License-Identifier: MIT
# C types of blocks_of_bytes.py.
cimport cython
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.wholes cimport Whole

cdef class MoveBytes(Whole):
    cdef Whole to
    cdef Whole origin
    cdef Whole count
    @cython.locals(to=cython.longlong, origin=cython.longlong, count=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class FillBytes(Whole):
    cdef Whole to
    cdef Whole filling
    cdef Whole count
    @cython.locals(to=cython.longlong, filling=cython.longlong, count=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class CompareBytes(Whole):
    cdef Whole one
    cdef Whole other
    cdef Whole count
    @cython.locals(one=cython.longlong, other=cython.longlong, count=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil
