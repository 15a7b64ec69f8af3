# SPDX-License-Identifier: MIT
# What compiled modules have instead of slots.py: calls of the interpreter's own C functions.
from cpython.object cimport PyTypeObject, Py_TYPE

cdef extern from "Python.h":
    object fresh "PyType_GenericAlloc" (type cls, Py_ssize_t size)

cdef inline int put(object slot, object node, object value) except -1:
    return (<PyTypeObject *>Py_TYPE(slot)).tp_descr_set(slot, node, value)
