# SPDX-License-Identifier: MIT
# C types of user_errors.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.cycles cimport instructions
from nctakt.kernel.cycles.expressions cimport Expression
from nctakt.kernel.cycles.instructions cimport Counted
from nctakt.kernel.cycles.context cimport Context

cdef class UserValue:
    cdef void evaluate(self, Context context) noexcept nogil
    cdef void record(self, Context context, long long source) noexcept nogil

cdef class NumberValue(UserValue):
    cdef int code
    cdef Expression expression
    cdef UserValue others
    cdef double number
    cdef void evaluate(self, Context context) noexcept nogil
    cdef void record(self, Context context, long long source) noexcept nogil

cdef class TextValue(UserValue):
    cdef int code
    cdef long long text
    cdef UserValue others
    cdef void evaluate(self, Context context) noexcept nogil
    cdef void record(self, Context context, long long source) noexcept nogil

cdef class RaiseUserError(Counted):
    cdef Expression identity
    cdef Expression reaction
    cdef UserValue values
    @cython.locals(identity=double, reaction=double)
    cdef int run(self, Context context) noexcept nogil
    @cython.locals(value=double)
    cdef double whole(
        self, Context context, Expression expression, double low, double high, int message
    ) noexcept nogil
