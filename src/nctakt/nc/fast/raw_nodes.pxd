# SPDX-License-Identifier: MIT
# What compiled modules have instead of raw_nodes.py: calls of the interpreter's own C functions.
from cpython.object cimport PyTypeObject, Py_TYPE

cdef extern from "Python.h":
    object new_node "PyType_GenericAlloc" (type cls, Py_ssize_t size)

cdef inline int set_field(object slot, object node, object value) except -1:
    return (<PyTypeObject *>Py_TYPE(slot)).tp_descr_set(slot, node, value)
