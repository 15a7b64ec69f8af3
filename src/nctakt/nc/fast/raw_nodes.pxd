# SPDX-License-Identifier: MIT
# What compiled modules have instead of raw_nodes.py: calls of the interpreter's own C functions.
# All slots have one type, whose function is asked for once: the limited API shows no fields of it.
cdef extern from *:
    """
    static CYTHON_INLINE int nctakt_set_field(PyObject *slot, PyObject *node, PyObject *value)
    {
        static descrsetfunc set = NULL;
        if (!set)
            set = (descrsetfunc)PyType_GetSlot(Py_TYPE(slot), Py_tp_descr_set);
        return set(slot, node, value);
    }
    """
    object new_node "PyType_GenericAlloc" (type cls, Py_ssize_t size)
    int set_field "nctakt_set_field" (object slot, object node, object value) except -1
