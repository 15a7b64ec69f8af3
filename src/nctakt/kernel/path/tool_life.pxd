# SPDX-License-Identifier: MIT
# C types of tool_life.py.
cimport cython

@cython.final
cdef class ToolLifeCounter:
    cdef double cycle_time_us
    cdef bint counts_rapid
    cdef bint is_counted
    cdef bint has_moved
    cdef double time_t
    cdef double distance_d
    cdef double time_factor
    cdef double distance_factor
    cdef double begin_t
    cdef long long ticks
    cdef double begin_d
    cdef double from_d
    cdef double counted_d
    cdef long long tool
    cdef long long basic

    cdef void begin(self, int is_feed) noexcept nogil
    cdef void count(self, double covered_d) noexcept nogil
    cdef void end_tick(self) noexcept nogil
    cdef double before(self, int is_ahead) noexcept nogil
    cdef void go_on(self, double time_t, double distance_d, int is_ahead) noexcept nogil
    @cython.locals(distance_d=double)
    cdef void weigh(
        self, double time_factor, double distance_factor, int is_ahead
    ) noexcept nogil
