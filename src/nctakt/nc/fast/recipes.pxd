# SPDX-License-Identifier: MIT
# C types of recipes.py.
cimport cython
from nctakt.nc.fast cimport raw_nodes
from nctakt.nc.fast.shapes cimport Shape

cdef class Occurrence:
    cdef readonly str file
    cdef readonly long long first
    cdef readonly list lines
    cdef readonly list numbers
    cdef readonly list ends
    cdef readonly list inside

cdef class Recipe:
    cpdef object make(self, Occurrence occurrence)

cdef class SharedRecipe(Recipe):
    cdef object value
    cpdef object make(self, Occurrence occurrence)

cdef class SpanRecipe(Recipe):
    cdef Py_ssize_t line
    cdef Py_ssize_t begin
    cdef Py_ssize_t column
    cdef Py_ssize_t end
    cdef Py_ssize_t end_column
    @cython.locals(column=Py_ssize_t, end_column=Py_ssize_t)
    cpdef object make(self, Occurrence occurrence)

cdef class NumberRecipe(Recipe):
    cdef readonly Py_ssize_t index
    cdef readonly double sign
    cpdef object make(self, Occurrence occurrence)

cdef class TupleRecipe(Recipe):
    cdef list parts
    @cython.locals(part=Recipe)
    cpdef object make(self, Occurrence occurrence)

cdef class BodyRecipe(Recipe):
    cdef list parts
    @cython.locals(statements=list)
    cpdef object make(self, Occurrence occurrence)

cdef class NodeRecipe(Recipe):
    cdef type cls
    cdef list fields
    cdef list parts
    @cython.locals(i=Py_ssize_t, part=Recipe)
    cpdef object make(self, Occurrence occurrence)

cdef class ExpressionRecipe(Recipe):
    cdef type cls
    cdef object template
    cdef object template_slot
    cdef object occurrence_slot
    cpdef object make(self, Occurrence occurrence)

cdef class RecipeBook:
    cdef public dict recipes

    @cython.locals(recipe=Recipe, inside=list, run=list, statements=list, inner=Shape)
    cpdef object statement(self, Shape shape, str file, long long first)
