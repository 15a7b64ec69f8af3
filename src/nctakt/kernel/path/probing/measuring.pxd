# SPDX-License-Identifier: MIT
# C types of measuring.py.
cimport cython
from nctakt.kernel cimport codes
from nctakt.kernel.path.probing.edge_probe cimport EdgeProbe
from nctakt.kernel.path.path cimport Path
from nctakt.kernel.path.probing.touch_probe cimport TouchProbe

@cython.final
cdef class Measuring:
    cdef Path path
    cdef readonly EdgeProbe edge_probe
    cdef readonly TouchProbe touch_probe

    @cython.locals(brakes=int)
    cdef int watch(self, long long tick) noexcept nogil
    cdef void clear(self) noexcept nogil
