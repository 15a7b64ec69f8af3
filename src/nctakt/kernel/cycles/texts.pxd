# SPDX-License-Identifier: MIT
# C types of texts.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.cycles cimport instructions
from nctakt.kernel.cycles.context cimport Context
from nctakt.kernel.cycles.expressions cimport Expression
from nctakt.kernel.cycles.instructions cimport Counted

cdef class CellRange(Expression):
    cdef Py_ssize_t cell
    cdef Expression index
    cdef double value(self, Context context) noexcept nogil

@cython.final
cdef class Text:
    cdef unsigned char[::1] characters
    cdef CellRange cell_range
    cdef readonly Py_ssize_t size

cdef int character(Text text, Py_ssize_t first, Py_ssize_t number) noexcept nogil

cdef class CompareTexts(Expression):
    cdef Text left
    cdef Text right
    cdef bint is_equal
    cdef Py_ssize_t count
    @cython.locals(left=Py_ssize_t, right=Py_ssize_t, i=Py_ssize_t, byte=int)
    cdef double value(self, Context context) noexcept nogil

@cython.locals(
    length=Py_ssize_t, is_new=bint, i=Py_ssize_t, byte=int, first=Py_ssize_t, first_read=Py_ssize_t
)
cdef void assign(
    Counted statement, Context context, unsigned char[::1] target, Py_ssize_t to,
    unsigned char[::1] source, Py_ssize_t from_, Py_ssize_t size
) noexcept nogil
@cython.locals(
    number=Py_ssize_t, done=Py_ssize_t, half=Py_ssize_t, parts=Py_ssize_t, left=double,
    right=double, name=double
)
cdef void report(
    Counted statement, Context context, unsigned char[::1] characters, Py_ssize_t cell,
    Py_ssize_t length
) noexcept nogil
@cython.locals(number=double, i=Py_ssize_t)
cdef double packed(
    unsigned char[::1] characters, Py_ssize_t first, Py_ssize_t start, Py_ssize_t end
) noexcept nogil

cdef class AssignText(Counted):
    cdef Text target
    cdef Text text
    @cython.locals(to=Py_ssize_t, from_=Py_ssize_t, size=Py_ssize_t)
    cdef int run(self, Context context) noexcept nogil

cdef class Copy(Counted):
    cdef CellRange target
    cdef CellRange value
    cdef unsigned char[::1] characters
    cdef unsigned char[::1] frozen_characters
    cdef double[::1] frozen
    cdef Py_ssize_t count
    cdef long long[::1] leaf_cell
    cdef long long[::1] leaf_size
    cdef unsigned char[::1] leaf_is_live
    @cython.locals(
        to=Py_ssize_t, from_=Py_ssize_t, i=Py_ssize_t, cell=Py_ssize_t, size=Py_ssize_t,
        is_live=bint
    )
    cdef int run(self, Context context) noexcept nogil
    cdef void copy_text(
        self, Context context, Py_ssize_t to, Py_ssize_t from_, Py_ssize_t size
    ) noexcept nogil
