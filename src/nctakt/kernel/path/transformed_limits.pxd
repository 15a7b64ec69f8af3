# SPDX-License-Identifier: MIT
# C types of transformed_limits.py.
cimport cython
from nctakt.kernel cimport rows
from nctakt.kernel.axes.transformations cimport Transformations
from nctakt.kernel.base cimport arithmetic
from nctakt.kernel.path cimport cubic

cdef double MAX_STEP
cdef double MIN_STEP
cdef double CUBIC_TURN
cdef double END_STEP
cdef Py_ssize_t MAX_SAMPLES
cdef double MARGIN
cdef double BEND_A
cdef double BEND_J
cdef double BEND_RAMP_J

@cython.final
cdef class TransformedLimits:
    cdef Py_ssize_t count
    cdef Py_ssize_t room
    cdef Transformations transformations
    cdef long long[::1] linear
    cdef double[::1] rapid_v
    cdef double[::1] max_v
    cdef double[::1] axis_a
    cdef double[::1] axis_j
    cdef double free_a
    cdef double free_j
    cdef double turn
    cdef Py_ssize_t steps
    cdef bint is_even
    cdef Py_ssize_t plane_axis
    cdef double[::1] near
    cdef double[::1] point
    cdef double[::1] start
    cdef double[::1] target
    cdef double[::1] samples
    cdef double[::1] result
    cdef double[::1] first
    cdef double[::1] second
    cdef double[::1] third
    cdef double[::1] entering
    cdef double[::1] leaving
    cdef double[::1] entering_curve
    cdef double[::1] leaving_curve

    @cython.locals(i=Py_ssize_t)
    cdef void start_at(self, double[::1] axes, long long[::1] members) noexcept nogil
    cdef void transform(self, Py_ssize_t number) noexcept nogil
    @cython.locals(i=Py_ssize_t, k=Py_ssize_t, widest=double, angle=double)
    cdef void count_samples(
        self, double[::1] segments, Py_ssize_t row, Py_ssize_t number, double arc
    ) noexcept nogil
    cdef void share(self, Transformations transformations)
    @cython.locals(
        start=Py_ssize_t, target=Py_ssize_t, i=Py_ssize_t, begin=double, first=Py_ssize_t,
        second=Py_ssize_t, number=Py_ssize_t, angle=double, cosine=double, sine=double, x=double,
        y=double
    )
    cdef void locate(
        self, double[::1] segments, Py_ssize_t row, double part, Py_ssize_t sample
    ) noexcept nogil
    @cython.locals(start=Py_ssize_t, i=Py_ssize_t, number=Py_ssize_t, angle=double, arc=double)
    cdef void measure_turn(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(length=double, i=Py_ssize_t, slope=double)
    cdef void survey(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(steps=Py_ssize_t, number=Py_ssize_t, part=double, i=Py_ssize_t)
    cdef void survey_cubic(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(curvature2=double, i=Py_ssize_t)
    cdef double curvature(self) noexcept nogil
    @cython.locals(
        steps=Py_ssize_t, part=double, step_d=double, number=Py_ssize_t, i=Py_ssize_t
    )
    cdef void sample_bend(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(
        i=Py_ssize_t, last=Py_ssize_t, newest=double, middle=double, before=double, slope=double,
        curve=double, bend=double
    )
    cdef void take_differences(
        self, double step_d, int is_start, int is_end, int has_third
    ) noexcept nogil
    @cython.locals(step=double, step_d=double, i=Py_ssize_t, slope=double)
    cdef void sample_end(
        self, double[::1] segments, Py_ssize_t row, double part, double[::1] slopes
    ) noexcept nogil
    @cython.locals(speed=double, i=Py_ssize_t)
    cdef double highest_speed(self, double[::1] limits) noexcept nogil
    @cython.locals(speed2=double, i=Py_ssize_t)
    cdef double bent_speed(self, double[::1] limits) noexcept nogil
    @cython.locals(share=double, i=Py_ssize_t)
    cdef double bend_share(self, double[::1] limits, double speed) noexcept nogil
    @cython.locals(limit_a=double, i=Py_ssize_t, left_a=double)
    cdef double acceleration(self, double[::1] limits, double speed) noexcept nogil
    @cython.locals(speed=double, i=Py_ssize_t, speed3=double)
    cdef double bent_jerk_speed(self, double[::1] limits) noexcept nogil
    @cython.locals(limit_a=double, i=Py_ssize_t, jerk=double)
    cdef double bent_acceleration(self, double[::1] limits, double speed) noexcept nogil
    @cython.locals(limit_j=double, i=Py_ssize_t, bend=double, left_j=double)
    cdef double jerk(self, double[::1] limits, double speed, double ramp_a) noexcept nogil
    @cython.locals(speed=double)
    cdef double measure(
        self, double[::1] segments, Py_ssize_t row, double max_factor
    ) noexcept nogil
    @cython.locals(speed=double, limit_a=double)
    cdef void limit_jerk(self, double[::1] segments, Py_ssize_t row) noexcept nogil
    @cython.locals(
        first=Py_ssize_t, second=Py_ssize_t, x=double, y=double, distance=double, length2=double,
        start=Py_ssize_t, i=Py_ssize_t, rise=double
    )
    cdef double arc_length(self, double[::1] segments, Py_ssize_t row) noexcept nogil
