# SPDX-License-Identifier: MIT
# C types of image_slots.py.
cimport cython
from nctakt.kernel cimport cells, codes
from nctakt.kernel.plc.image_bytes cimport ImageBytes
from nctakt.kernel.plc.technology_slots cimport FunctionTable, Section
from nctakt.kernel.axes.spindles cimport Spindles

cdef class Units:
    cdef void latch(self) noexcept nogil
    cdef void publish(self) noexcept nogil

cdef class SectionUnits(Units):
    cdef Section section
    cdef ImageBytes shown
    cdef Py_ssize_t first
    cdef Py_ssize_t acknowledged
    cdef long long cycle_time_us
    cdef int identifier
    cdef FunctionTable types
    cdef Units others
    cdef long long version

    @cython.locals(i=Py_ssize_t, serial=int)
    cdef void latch(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void publish(self) noexcept nogil
    @cython.locals(
        first=Py_ssize_t, word=Py_ssize_t, function=cython.longlong, number=Py_ssize_t,
        ticks=cython.longlong, synchronisation=cython.longlong
    )
    cdef void put(self, Py_ssize_t slot) noexcept nogil

cdef class SpindleUnits(Units):
    cdef Spindles spindles
    cdef ImageBytes shown
    cdef Py_ssize_t job
    cdef Py_ssize_t stride
    cdef Py_ssize_t acknowledged
    cdef Py_ssize_t answer_stride
    cdef long long cycle_time_us
    cdef Units others
    cdef long long version

    @cython.locals(i=Py_ssize_t, answer=Py_ssize_t, serial=int)
    cdef void latch(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void publish(self) noexcept nogil
    @cython.locals(
        first=Py_ssize_t, word=Py_ssize_t, direction=cython.longlong,
        ticks=cython.longlong
    )
    cdef void put(self, Py_ssize_t i) noexcept nogil
