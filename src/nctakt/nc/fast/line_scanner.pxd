# SPDX-License-Identifier: MIT
# C types of line_scanner.py.
cimport cython

cdef class LineScanner:
    cdef double value
    cdef bint has_point

    @cython.locals(mantissa=cython.longlong, count=int, scale=double, has_point=bint, c=Py_UCS4)
    cdef Py_ssize_t decimal(self, str line, Py_ssize_t i, Py_ssize_t end)
    @cython.locals(stop=Py_ssize_t)
    cdef Py_ssize_t signed(self, str line, Py_ssize_t i, Py_ssize_t end)
    @cython.locals(depth=int, c=Py_UCS4)
    cdef Py_ssize_t comment(self, str line, Py_ssize_t i, Py_ssize_t end)
