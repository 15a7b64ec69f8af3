# SPDX-License-Identifier: MIT
# C types of kept_content.py.
cimport cython

@cython.final
cdef class KeptContent:
    cdef readonly frozenset replaced
    cdef readonly list attributes
    cdef readonly list slots
    cdef readonly list empty
    cdef readonly list new
    cdef readonly list lists
    cdef readonly list memories
    cdef readonly list dicts
    cdef readonly list others
    @cython.locals(
        attributes=dict, container=dict, cells=list, kept=dict, items=list, kept_items=list
    )
    cpdef put_back(self)
    cdef put_attributes_back(self, dict attributes, dict kept)

@cython.locals(at=Py_ssize_t)
cdef bint holds(dict content, list cells) except -1
@cython.locals(i=Py_ssize_t)
cdef bint holds_items(list items, list kept_items) except -1
