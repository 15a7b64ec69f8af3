# SPDX-License-Identifier: MIT
# C types of interface_image.py.
cimport cython
from nctakt.kernel cimport cells, codes, rows
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.base.record cimport Record
from nctakt.kernel.plc.image_bytes cimport ImageBytes, NumberBytes
from nctakt.kernel.plc.image_slots cimport Units

@cython.final
cdef class ImageTable:
    cdef long long[::1] words
    cdef Py_ssize_t count
    cdef long long[::1] is_input
    cdef double[::1] factor
    cdef long long[::1] is_scaled
    cdef long long[::1] offset
    cdef long long[::1] kind
    cdef long long[::1] cell
    cdef long long[::1] size
    cdef long long[::1] cell_count
    cdef long long[::1] first_shadow
    cdef long long[::1] is_stale
    cdef Py_ssize_t shadow_count
    cdef Py_ssize_t stale_count
    cdef long long[::1] shadow
    cdef long long[::1] shadowed_cell
    cdef long long[::1] shadowed_entry

    @cython.locals(i=Py_ssize_t)
    cdef Py_ssize_t next_changed(self, Py_ssize_t first) noexcept nogil
    @cython.locals(i=Py_ssize_t, first=Py_ssize_t, cell=Py_ssize_t)
    cdef void remember(self, Py_ssize_t entry) noexcept nogil
    cdef void mark_stale(self, Py_ssize_t entry) noexcept nogil
    cdef void mark_written(self, Py_ssize_t entry) noexcept nogil

@cython.final
cdef class RefusedValues:
    cdef Py_ssize_t capacity
    cdef long long[::1] cells
    cdef Py_ssize_t count
    cdef Py_ssize_t reported

    @cython.locals(slot=Py_ssize_t)
    cdef void note(self, Py_ssize_t cell) noexcept nogil

@cython.final
cdef class InterfaceImage:
    cdef double[::1] cells
    cdef unsigned char[::1] characters
    cdef object memory
    cdef Record record
    cdef NumberBytes number
    cdef readonly RefusedValues refused
    cdef readonly bint is_attached
    cdef Py_ssize_t event_bound
    cdef Py_ssize_t word_count
    cdef Py_ssize_t clock_word
    cdef Py_ssize_t first_input_word
    cdef Units units
    cdef ImageBytes bytes
    cdef ImageTable table
    cdef long long[::1] was_refused

    @cython.locals(i=Py_ssize_t)
    cdef void latch(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef int is_as_published(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, first=Py_ssize_t)
    cdef int has_changed(self, Py_ssize_t entry) noexcept nogil
    @cython.locals(i=Py_ssize_t, first=Py_ssize_t, character=Py_ssize_t)
    cdef void take_string(self, Py_ssize_t entry) noexcept nogil
    @cython.locals(i=Py_ssize_t, first=Py_ssize_t, cell=Py_ssize_t, value=double)
    cdef void take_number(self, Py_ssize_t entry) noexcept nogil
    cdef void refuse(self, Py_ssize_t entry, double value) noexcept nogil
    cdef void publish(self, long long ticks) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void publish_cells(self) noexcept nogil
    cdef void put(self, Py_ssize_t entry) noexcept nogil
    @cython.locals(i=Py_ssize_t, first=Py_ssize_t, character=Py_ssize_t)
    cdef void put_string(self, Py_ssize_t entry) noexcept nogil
    @cython.locals(value=double)
    cdef void put_number(self, Py_ssize_t entry) noexcept nogil
