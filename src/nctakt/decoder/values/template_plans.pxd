# SPDX-License-Identifier: MIT
# C types of template_plans.py.
cimport cython
from nctakt.kernel.cycles.expressions cimport Expression
from nctakt.kernel.cycles.context cimport Context
from nctakt.nc.fast.recipes cimport Occurrence

cdef class TemplatePlan:
    cdef Expression node
    cdef list number_indices
    cdef list signs
    cdef readonly list names
    cdef readonly list parameters
    cdef list values
    cdef long long changes
    cdef bint is_real

    cpdef int find(self, object scopes) except -1

cdef class TemplateEvaluator:
    cdef Context context
    cdef double[::1] cells
    cdef object scopes
    cdef dict parameters

    @cython.locals(
        i=Py_ssize_t, cell=Py_ssize_t, sign=double, values=list, context=Context, result=double
    )
    cpdef object value(self, TemplatePlan plan, Occurrence occurrence)
    cpdef int write(self, TemplatePlan plan, double value) except -1
