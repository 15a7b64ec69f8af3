# SPDX-License-Identifier: MIT
# C types of plain_lines.py.
cimport cython
from nctakt.nc.fast.line_scanner cimport LineScanner

cdef class PlainScanner(LineScanner):
    cdef long long[::1] axis_of_letter
    cdef readonly double[::1] values
    cdef readonly unsigned char[::1] motions
    cdef readonly long long number
    cdef readonly Py_ssize_t column
    cdef readonly int motion
    cdef readonly bint has_feed
    cdef readonly double feed
    cdef readonly long long axes
    cdef readonly unsigned long long shape
    cdef int words

    @cython.locals(last=cython.ulonglong, what=int)
    cpdef Py_ssize_t skip_known(
        self, list lines, Py_ssize_t index, Py_ssize_t end, set shapes
    ) except -1
    @cython.locals(end=Py_ssize_t, i=Py_ssize_t)
    cpdef int read(self, str line)
    cdef Py_ssize_t blanks(self, str line, Py_ssize_t i, Py_ssize_t end)
    @cython.locals(first=Py_ssize_t)
    cdef Py_ssize_t digits(self, str line, Py_ssize_t i, Py_ssize_t end)
    @cython.locals(letter=int, axis=cython.longlong)
    cdef Py_ssize_t word(self, str line, Py_ssize_t i, Py_ssize_t end)
