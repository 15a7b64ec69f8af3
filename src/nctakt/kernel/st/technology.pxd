# SPDX-License-Identifier: MIT
# C types of technology.py.
cimport cython
from nctakt.kernel cimport cells, codes
from nctakt.kernel.axes.spindles cimport Spindles
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.plc.technology_slots cimport FunctionTable, Hli, Section
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext

@cython.final
cdef class UnitBanks:
    cdef PlcContext context
    cdef unsigned char[::1] memory
    cdef readonly Py_ssize_t count
    cdef readonly Py_ssize_t area_count
    cdef readonly long long[::1] announced
    cdef readonly long long[::1] since
    cdef long long[::1] first
    cdef long long[::1] units
    cdef long long[::1] stride
    cdef long long[::1] used
    cdef long long[::1] area
    cdef long long[::1] taken
    cdef void announce(self, Py_ssize_t area, long long tick) noexcept nogil
    cdef int is_announced(self, Py_ssize_t bank) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef Py_ssize_t occupy(self, Py_ssize_t bank) noexcept nogil
    cdef long long at(self, Py_ssize_t bank, Py_ssize_t unit) noexcept nogil
    @cython.locals(size=Py_ssize_t)
    cdef void free(self, Py_ssize_t bank, Py_ssize_t unit) noexcept nogil
    @cython.locals(i=Py_ssize_t, count=Py_ssize_t)
    cdef void count_used(self, Py_ssize_t bank) noexcept nogil
    cdef void ask(self, long long at, int kind) noexcept nogil
    cdef long long writer(self, Py_ssize_t bank, Py_ssize_t unit) noexcept nogil
    cdef int is_done(self, Py_ssize_t bank, Py_ssize_t unit) noexcept nogil

cdef class UnitSource:
    cdef void show(self, long long tick) noexcept nogil
    cdef void read_commands(self) noexcept nogil

cdef class SectionSource(UnitSource):
    cdef UnitBanks banks
    cdef Hli hli
    cdef Section section
    cdef bint is_realtime
    cdef FunctionTable places
    cdef FunctionTable types
    cdef long long cycle_time_us
    cdef UnitSource others
    cdef long long[::1] bank
    cdef long long[::1] unit
    cdef long long[::1] serial
    cdef Py_ssize_t shown_count
    @cython.locals(i=Py_ssize_t)
    cdef void show(self, long long tick) noexcept nogil
    @cython.locals(is_waiting=cython.bint, is_same=cython.bint, bank=Py_ssize_t, unit=Py_ssize_t)
    cdef void follow(self, Py_ssize_t slot, long long tick) noexcept nogil
    @cython.locals(
        function=cython.longlong, data=cython.longlong, number=Py_ssize_t, mode=cython.longlong,
        ticks=cython.longlong
    )
    cdef void write(self, long long at, Py_ssize_t slot) noexcept nogil
    @cython.locals(i=Py_ssize_t, writer=cython.longlong)
    cdef void read_commands(self) noexcept nogil

cdef class SpindleSource(UnitSource):
    cdef UnitBanks banks
    cdef Hli hli
    cdef Spindles spindles
    cdef UnitSource others
    cdef long long[::1] bank
    cdef long long[::1] unit
    cdef long long[::1] job
    @cython.locals(i=Py_ssize_t)
    cdef void show(self, long long tick) noexcept nogil
    @cython.locals(is_waiting=cython.bint, is_same=cython.bint, bank=Py_ssize_t, unit=Py_ssize_t)
    cdef void follow(self, Py_ssize_t spindle, long long tick) noexcept nogil
    @cython.locals(function=cython.longlong, speed_v=double)
    cdef double speed_of(self, Py_ssize_t spindle) noexcept nogil
    @cython.locals(data=cython.longlong, position=double, speed=double)
    cdef void write(self, long long at, Py_ssize_t spindle) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void read_commands(self) noexcept nogil
