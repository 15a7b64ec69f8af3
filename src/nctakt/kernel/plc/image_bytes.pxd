# SPDX-License-Identifier: MIT
# C types of image_bytes.py.
cimport cython
from nctakt.kernel cimport codes

@cython.final
cdef class NumberBytes:
    cdef unsigned char[::1] scratch
    cdef signed char[::1] as_signed_8
    cdef short[::1] as_signed_16
    cdef unsigned short[::1] as_unsigned_16
    cdef int[::1] as_signed_32
    cdef unsigned int[::1] as_unsigned_32
    cdef double[::1] as_real

    cdef double value(self, int kind) noexcept nogil
    cdef void put(self, int kind, double value) noexcept nogil

@cython.final
cdef class ImageBytes:
    cdef readonly Py_ssize_t count
    cdef unsigned char[::1] image
    cdef int[::1] halves
    cdef long long[::1] words
    cdef double[::1] reals
    cdef unsigned char[::1] published
    cdef int[::1] published_halves
    cdef long long[::1] published_words

    @cython.locals(i=Py_ssize_t)
    cdef void put(self, Py_ssize_t first, NumberBytes number, Py_ssize_t size) noexcept nogil
