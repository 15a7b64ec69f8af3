# SPDX-License-Identifier: MIT
# C types of interface.py.
cimport cython
from nctakt.kernel cimport cells, codes
from nctakt.kernel.axes.axes cimport Axes
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.plc.interface_image cimport InterfaceImage
from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.technology cimport UnitBanks, UnitSource

cdef class CncSide:
    cdef void latch(self) noexcept nogil
    cdef void guard(self) noexcept nogil
    cdef Py_ssize_t event_bound(self) noexcept nogil
    cdef void follow(self, long long tick) noexcept nogil
    cdef void show(self, long long tick) noexcept nogil
    cdef int read_commands(self) noexcept nogil
    cdef void leave(self) noexcept nogil

@cython.final
cdef class ShownValues:
    cdef unsigned char[::1] memory
    cdef double[::1] cells
    cdef Py_ssize_t count
    cdef long long[::1] address
    cdef long long[::1] kind
    cdef long long[::1] cell
    cdef long long[::1] how
    cdef double[::1] operand
    cdef double[::1] low
    cdef double[::1] high
    cdef double[::1] table
    @cython.locals(i=Py_ssize_t)
    cdef void show(self) noexcept nogil
    @cython.locals(
        value=double, how=cython.longlong, operand=double, number=cython.longlong,
        table=Py_ssize_t
    )
    cdef double number(self, Py_ssize_t entry) noexcept nogil
    @cython.locals(number=cython.longlong)
    cdef void put(self, long long address, int kind, double value) noexcept nogil

@cython.final
cdef class ControlUnits:
    cdef ShownValues values
    cdef UnitBanks banks
    cdef Py_ssize_t count
    cdef long long[::1] enable
    cdef long long[::1] command
    cdef long long[::1] request
    cdef long long[::1] kind
    cdef long long[::1] cell
    cdef double[::1] factor
    cdef long long[::1] area
    cdef long long[::1] is_edge
    cdef long long[::1] is_decided
    cdef long long[::1] is_released
    cdef long long[::1] is_pressed
    cdef long long[::1] was_commanded
    cdef double[::1] requested
    cdef double[::1] commanded
    @cython.locals(i=Py_ssize_t, cell=Py_ssize_t)
    cdef void guard(self) noexcept nogil
    @cython.locals(cell=Py_ssize_t)
    cdef void press(self, Py_ssize_t unit) noexcept nogil
    cdef int was_pressed(self, Py_ssize_t unit) noexcept nogil
    @cython.locals(i=Py_ssize_t, requested=double)
    cdef void show(self) noexcept nogil
    @cython.locals(
        i=Py_ssize_t, is_set=cython.longlong, number=cython.longlong, decides=cython.bint
    )
    cdef void read_commands(self) noexcept nogil

@cython.final
cdef class ChannelRecords:
    cdef ShownValues values
    cdef UnitBanks banks
    cdef Py_ssize_t count
    cdef long long[::1] places
    cdef double[::1] read_error
    cdef long long at(self, Py_ssize_t record, int what) noexcept nogil
    cdef double cell(self, Py_ssize_t record, int what) noexcept nogil
    @cython.locals(
        i=Py_ssize_t, mode=cython.longlong, state=cython.longlong, has_error=cython.bint,
        is_new=cython.bint, at=cython.longlong
    )
    cdef void show(self) noexcept nogil
    @cython.locals(state=double, is_held=cython.bint, is_armed=cython.bint)
    cdef int state_of(self, Py_ssize_t record) noexcept nogil
    @cython.locals(is_commanded=int, i=Py_ssize_t, at=cython.longlong)
    cdef int read_commands(self) noexcept nogil
    @cython.locals(enable=cython.longlong)
    cdef int is_commanded(self, Py_ssize_t record) noexcept nogil

@cython.final
cdef class AxisReleases:
    cdef ShownValues values
    cdef Axes axes
    cdef Py_ssize_t count
    cdef long long[::1] places
    cdef long long[::1] is_locked
    @cython.locals(at=cython.longlong)
    cdef int flag(self, Py_ssize_t row, Py_ssize_t what) noexcept nogil
    @cython.locals(i=Py_ssize_t, k=Py_ssize_t, is_locked=int, axis=Py_ssize_t)
    cdef void read_commands(self) noexcept nogil

cdef class CncInterface(CncSide):
    cdef ShownValues values
    cdef ControlUnits units
    cdef UnitBanks banks
    cdef UnitSource sources
    cdef ChannelRecords records
    cdef AxisReleases releases
    cdef InterfaceImage variables
    cdef long long tick
    cdef Py_ssize_t count
    cdef long long[::1] present
    cdef long long[::1] present_cell
    cdef long long[::1] own
    cdef long long[::1] published
    @cython.locals(i=Py_ssize_t, cell=Py_ssize_t)
    cdef void latch(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, cell=Py_ssize_t)
    cdef void guard(self) noexcept nogil
    cdef Py_ssize_t event_bound(self) noexcept nogil
    cdef void follow(self, long long tick) noexcept nogil
    cdef void show(self, long long tick) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef int read_commands(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void leave(self) noexcept nogil
