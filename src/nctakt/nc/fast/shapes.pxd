# SPDX-License-Identifier: MIT
# C types of shapes.py.
cimport cython
from nctakt.nc.fast.line_scanner cimport LineScanner

cdef class Shape:
    cdef readonly bytes key
    cdef readonly list lines
    cdef readonly list numbers
    cdef readonly list ends
    cdef readonly list runs

    @cython.locals(inside=Shape, run=list)
    cdef int is_of(self, set keys) except -1

@cython.final
cdef class ShapeScanner(LineScanner):
    cdef bytearray room
    cdef unsigned char[::1] text
    cdef double[::1] numbers
    cdef long long[::1] ends
    cdef readonly Shape shape
    cdef readonly Py_ssize_t index
    cdef Py_ssize_t end
    cdef Py_ssize_t count
    cdef Py_ssize_t length
    cdef int opens
    cdef bint controls
    cdef bint is_name
    cdef int depth
    cdef int element_depth
    cdef bint behind_element

    @cython.locals(end=Py_ssize_t, shape=Shape)
    cpdef Py_ssize_t skip_known(self, list lines, Py_ssize_t index, set keys) except -1
    cpdef Py_ssize_t read(self, list lines, Py_ssize_t index) except -1
    @cython.locals(i=Py_ssize_t, shape=Shape, own=list, runs=list)
    cdef Shape statement(self, list lines, Py_ssize_t start, Py_ssize_t first_mark, int depth)
    @cython.locals(
        start=Py_ssize_t, before=Py_ssize_t, first_mark=Py_ssize_t, shape=Shape, run=list
    )
    cdef int inside(self, list lines, list own, list runs, int depth) except -1
    @cython.locals(
        end=Py_ssize_t, start=Py_ssize_t, marks=Py_ssize_t, i=Py_ssize_t, is_empty=bint,
        is_head=bint, before=Py_UCS4, last=Py_UCS4, c=Py_UCS4
    )
    cdef int line(self, str line)
    cdef void begin_line(self)
    cdef void open_index(self, str line, Py_ssize_t i, Py_ssize_t end)
    cdef Py_ssize_t figure(
        self, str line, Py_ssize_t i, Py_ssize_t end, Py_UCS4 before, Py_UCS4 last,
        bint is_head
    )
    @cython.locals(c=Py_UCS4)
    cdef int sign(self, str line, Py_ssize_t i, Py_ssize_t end, Py_UCS4 before)
    cdef int has_nul(self, str line, Py_ssize_t i, Py_ssize_t end)
    cdef void append(self, Py_UCS4 c)
    cdef int is_sign(self, Py_UCS4 c)
    cdef void add_mark(self, unsigned char mark, double value, Py_ssize_t end)
    cdef Py_ssize_t digits(self, str line, Py_ssize_t i, Py_ssize_t end)
    @cython.locals(stop=Py_ssize_t)
    cdef Py_ssize_t number(self, str line, Py_ssize_t i, Py_ssize_t end, bint is_whole)
    @cython.locals(first=Py_ssize_t, stop=Py_ssize_t, c=Py_UCS4, is_one=bint, is_value=bint)
    cdef Py_ssize_t word(self, str line, Py_ssize_t i, Py_ssize_t end)
    cdef int takes_number(self, Py_UCS4 c)
    @cython.locals(c=Py_UCS4)
    cdef Py_ssize_t name(self, str line, Py_ssize_t i, Py_ssize_t end)
    cdef int is_letter_or_digit(self, Py_UCS4 c)
    @cython.locals(first=Py_UCS4, second=Py_UCS4)
    cdef void control(self, str line, Py_ssize_t i, Py_ssize_t end)
