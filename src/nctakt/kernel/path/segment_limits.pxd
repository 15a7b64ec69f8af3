# SPDX-License-Identifier: MIT
# C types of segment_limits.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.axes.spindles cimport Spindles
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path cimport arc_limits
from nctakt.kernel.path cimport geometry
from nctakt.kernel.path.arc_limits cimport ArcLimits
from nctakt.kernel.path.transformed_limits cimport TransformedLimits

@cython.final
cdef class SegmentLimits:
    cdef readonly Py_ssize_t count
    cdef readonly Py_ssize_t room
    cdef double max_factor
    cdef double tick_t
    cdef long long[::1] linear
    cdef double[::1] rapid_v
    cdef double[::1] max_v
    cdef double[::1] rapid_a
    cdef double[::1] feed_a
    cdef double[::1] rapid_slope_a
    cdef double[::1] feed_slope_a
    cdef double[::1] rapid_j
    cdef double[::1] feed_j
    cdef ArcLimits arcs
    cdef TransformedLimits transformed
    cdef double[::1] direction
    cdef double[::1] unused
    cdef readonly bint has_jerk_limit
    cdef Spindles spindles
    cdef double[::1] axis_a
    cdef double[::1] axis_j
    cdef double[::1] listed_v
    cdef double[::1] listed_a
    cdef double[::1] kept_rapid_a
    cdef double[::1] kept_feed_a
    cdef double[::1] kept_rapid_slope_a
    cdef double[::1] kept_feed_slope_a
    cdef double[::1] kept_rapid_j
    cdef double[::1] kept_feed_j
    cdef double[::1] vector
    cdef public bint is_reduced
    cdef public double rounded_part
    cdef public double max_bend
    cdef bint has_changed
    @cython.locals(i=Py_ssize_t)
    cdef void keep(self) noexcept nogil
    @cython.locals(i=Py_ssize_t, limit=double)
    cdef void use_stricter_limits(self) noexcept nogil
    @cython.locals(i=Py_ssize_t)
    cdef void end_corner(self) noexcept nogil
    @cython.locals(is_rapid=bint, limit=double)
    cdef double vector_limit(
        self, double[::1] segments, Py_ssize_t row, Py_ssize_t column
    ) noexcept nogil
    @cython.locals(limit_a=double, limit_j=double, speed=double)
    cdef void limit_radially(
        self, double[::1] segments, Py_ssize_t row, double radius, double part
    ) noexcept nogil

    @cython.locals(share=double)
    cdef double measure(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(is_rapid=bint, is_smooth=bint, i=Py_ssize_t)
    cdef void choose(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(share=double, limit_v=double, limit_a=double, curvature=double)
    cdef double measure_bent(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(
        spindle=Py_ssize_t, turn=double, limit_v=double, limit_a=double, limit_j=double
    )
    cdef void limit_tap(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(
        start=Py_ssize_t, target=Py_ssize_t, limit_j=double, i=Py_ssize_t, distance=double,
        part=double
    )
    cdef void limit_jerk(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(
        first=Py_ssize_t, second=Py_ssize_t, x=double, y=double, radius=double, turn=double,
        distance=double, part=double, first_a=double, plane_a=double,
        plane_j=double, max_v=double, outer_a=double, outer_j=double, best_t=double, speed=double,
        centre_a=double, turned_j=double, free_a=double, ramp_a=double, crossing_j=double,
        jerk=double, time=double, _=int
    )
    cdef void limit_jerk_on_arc(
        self, double[::1] segments, Py_ssize_t row, double[::1] shares, double[::1] turns
    ) noexcept nogil
    cdef void stop_at_end(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(
        start=Py_ssize_t, target=Py_ssize_t, linear2=double, rotary2=double, i=Py_ssize_t,
        distance=double
    )
    cdef double straight_length(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(
        is_rapid=bint, start=Py_ssize_t, target=Py_ssize_t, highest=double, limit_a=double,
        rapid=double, i=Py_ssize_t, distance=double, part=double, limit_v=double
    )
    cdef void bound(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    cdef int in_plane(self, double[::1] segments, Py_ssize_t row, Py_ssize_t index) noexcept nogil
    @cython.locals(
        start=Py_ssize_t, target=Py_ssize_t, first=Py_ssize_t, second=Py_ssize_t, x=double,
        y=double, radius=double, angle=double, distance=double, length2=double, i=Py_ssize_t,
        rise=double, length=double, part=double, plane_a=double, highest=double, commanded_v=double,
        share=double, centripetal=double, speed=double, limit_a=double, by_speed=bint
    )
    cdef double measure_arc(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(slower=double)
    cdef int is_even(self, double[::1] segments, Py_ssize_t row, double commanded_v) noexcept nogil
    @cython.locals(limit_a=double, i=Py_ssize_t, part=double)
    cdef double straight_acceleration(self, double[::1] parts) noexcept nogil
    @cython.locals(angle=double, pieces=Py_ssize_t)
    cdef void divide_arc(self, double[::1] segments, Py_ssize_t row, double piece) noexcept nogil
    cdef double speed_of(self, double speed, double max_speed) noexcept nogil
    cdef double axis_jerk(self, Py_ssize_t index) noexcept nogil
    cdef double axis_acceleration(self, Py_ssize_t index) noexcept nogil
    cdef double slope_acceleration(self, Py_ssize_t index) noexcept nogil
