# SPDX-License-Identifier: MIT
# C types of stops.py.
cimport cython
from nctakt.kernel cimport codes, rows
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.cycles.branches cimport Reaction
from nctakt.kernel.cycles.conditions cimport Condition
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.cycles.cycles cimport RealtimeCycle
from nctakt.kernel.cycles.expressions cimport Expression
from nctakt.kernel.cycles.instructions cimport Watch
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.observing.probes cimport Sought

cdef class Stop:
    cdef Expression guard
    cdef long long hits_needed
    cdef readonly long long count
    cdef readonly long long last_tick
    cdef void begin(self, Context context) noexcept nogil
    cdef int holds(self, Context context, Record record) noexcept nogil

@cython.locals(value=double)
cdef int is_true(Expression expression, Context context) noexcept nogil

cdef class BecomesTrue(Stop):
    cdef Expression expression
    cdef int truth
    cdef int previous
    cdef void begin(self, Context context) noexcept nogil
    @cython.locals(before=int)
    cdef int holds(self, Context context, Record record) noexcept nogil

cdef class Changes(Stop):
    cdef Expression expression
    cdef double previous
    cdef void begin(self, Context context) noexcept nogil
    @cython.locals(before=double)
    cdef int holds(self, Context context, Record record) noexcept nogil

cdef class Happens(Stop):
    cdef long long kinds
    cdef double[::1] lowest
    cdef double[::1] highest
    @cython.locals(number=Py_ssize_t, row=Py_ssize_t, kind=int)
    cdef int holds(self, Context context, Record record) noexcept nogil
    @cython.locals(column=Py_ssize_t, value=double)
    cdef int has_within(self, Py_ssize_t row, Record record) noexcept nogil

cdef class BlockUpToDepth(Stop):
    cdef int channel
    cdef int max_depth
    @cython.locals(number=Py_ssize_t, row=Py_ssize_t, kind=int, channel=int)
    cdef int holds(self, Context context, Record record) noexcept nogil

cdef class Runs(Stop):
    cdef Reaction reaction
    cdef int holds(self, Context context, Record record) noexcept nogil

cdef class BeforeStatement(Watch):
    cdef Expression guard
    cdef Context context
    cdef Watch others
    cdef readonly long long next_tick
    cdef void look(self, Context context) noexcept nogil

cdef class RunsStatement(Stop):
    cdef BeforeStatement before
    cdef int holds(self, Context context, Record record) noexcept nogil

cdef class RunsThrough(Stop):
    cdef RealtimeCycle cycle
    cdef int holds(self, Context context, Record record) noexcept nogil

cdef class Turns(Stop):
    cdef Condition condition
    cdef int truth
    cdef int previous
    cdef void begin(self, Context context) noexcept nogil
    @cython.locals(before=int)
    cdef int holds(self, Context context, Record record) noexcept nogil

cdef class PassesStatement(Stop):
    cdef Sought sought
    cdef long long previous
    cdef void begin(self, Context context) noexcept nogil
    @cython.locals(before=cython.longlong)
    cdef int holds(self, Context context, Record record) noexcept nogil

cdef class Faults(Stop):
    cdef PlcContext plc
    cdef int number
    cdef int previous
    cdef void begin(self, Context context) noexcept nogil
    @cython.locals(before=int)
    cdef int holds(self, Context context, Record record) noexcept nogil

cdef class Link:
    cdef int check(self, Context context, Record record) noexcept nogil

cdef class StopLink(Link):
    cdef Stop stop
    cdef Link others
    @cython.locals(ends=int)
    cdef int check(self, Context context, Record record) noexcept nogil

@cython.final
cdef class Stops:
    cdef Context context
    cdef Record record
    cdef readonly bint is_watching
    cdef Link chain
    cpdef void add(self, Stop stop)
    cdef int check(self, long long tick) noexcept nogil
