# SPDX-License-Identifier: MIT
# C types of texts.py.
cimport cython
from nctakt.kernel.st.text cimport characters
from nctakt.kernel.st cimport kinds, wholes, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.steps cimport Sourced
from nctakt.kernel.st.wholes cimport Whole

cdef class StringPart:
    cdef readonly Whole address
    cdef readonly long long capacity
    cdef readonly long long unit
    cdef long long begin(self, PlcContext context) noexcept nogil
    cdef long long length(self, PlcContext context, long long begin) noexcept nogil

cdef class ChosenText(StringPart):
    cdef long long begin(self, PlcContext context) noexcept nogil
    @cython.locals(count=cython.longlong)
    cdef long long length(self, PlcContext context, long long begin) noexcept nogil

cdef class AssignString(Sourced):
    cdef Whole address
    cdef long long capacity
    cdef StringPart text
    @cython.locals(
        to=cython.longlong, begin=cython.longlong, count=cython.longlong, unit=cython.longlong
    )
    cdef int run(self, PlcContext context) noexcept nogil

@cython.locals(
    left_count=cython.longlong, right_count=cython.longlong, order=cython.longlong,
    count=cython.longlong
)
cdef long long order_of(
    PlcContext context, StringPart left, long long first, StringPart right, long long second
) noexcept nogil

cdef class CompareStrings(Whole):
    cdef StringPart left
    cdef StringPart right
    cdef int relation
    @cython.locals(
        left=cython.longlong, right=cython.longlong, order=cython.longlong
    )
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class ExtremeText(Whole):
    cdef StringPart left
    cdef StringPart right
    cdef bint is_maximum
    @cython.locals(left=cython.longlong, right=cython.longlong, order=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class LengthOfString(Whole):
    cdef StringPart text
    @cython.locals(begin=cython.longlong)
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class FindString(Whole):
    cdef StringPart text
    cdef StringPart searched
    @cython.locals(
        begin=cython.longlong, searched=cython.longlong, count=cython.longlong,
        last=cython.longlong, i=cython.longlong, unit=cython.longlong
    )
    cdef long long value(self, PlcContext context) noexcept nogil

@cython.locals(count=cython.longlong, added=cython.longlong)
cdef long long join(
    PlcContext context, long long to, long long first,
    long long first_count, long long second, long long second_count, long long unit
) noexcept nogil

cdef class ChangeString(Whole):
    cdef StringPart text
    cdef StringPart inserted
    cdef Whole length
    cdef Whole position
    cdef int function
    cdef long long kept
    @cython.locals(
        kept=cython.longlong, begin=cython.longlong, inserted=cython.longlong,
        removed=cython.longlong, position=cython.longlong, count=cython.longlong,
        added=cython.longlong, total=cython.longlong, rest=cython.longlong, head=cython.longlong,
        unit=cython.longlong, origin=cython.longlong
    )
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class PartOfString(Whole):
    cdef StringPart text
    cdef Whole length
    cdef Whole position
    cdef int function
    cdef long long kept
    @cython.locals(
        kept=cython.longlong, begin=cython.longlong, taken=cython.longlong,
        position=cython.longlong, count=cython.longlong, head=cython.longlong,
        unit=cython.longlong
    )
    cdef long long value(self, PlcContext context) noexcept nogil

cdef class ResizedText(Whole):
    cdef StringPart text
    cdef long long kept
    @cython.locals(
        kept=cython.longlong, begin=cython.longlong, count=cython.longlong, unit=cython.longlong,
        resized=cython.longlong, i=cython.longlong, character=cython.longlong
    )
    cdef long long value(self, PlcContext context) noexcept nogil
