# SPDX-License-Identifier: MIT
# C types of tape_lines.py.
cimport cython

cdef class InputLines:
    cdef object _write
    cdef long long _first_tick
    cdef long long _next_tick
    cdef list _sources
    cdef list _names
    cdef list _numbers
    cdef dict _texts
    @cython.locals(
        at=Py_ssize_t, count=Py_ssize_t, end=Py_ssize_t, width=Py_ssize_t, cell=Py_ssize_t,
        tick=cython.longlong, are_numbers=bint, goes_on=bint,
    )
    cpdef note(self, list cells)
    cdef _begin(self, list cells, Py_ssize_t at, Py_ssize_t end)
    cpdef flush(self)
    cdef _write_tick(self, long long tick, inputs)
    cdef str _text_of(self, number)
