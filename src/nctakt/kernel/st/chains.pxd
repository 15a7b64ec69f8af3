# SPDX-License-Identifier: MIT
# C types of chains.py.
cimport cython
from nctakt.kernel.st cimport kinds, real_leaves
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.reals cimport Real

cdef class RealChain(Real):
    cdef readonly Real start
    cdef readonly tuple parts
    cdef long long[::1] links
    @cython.locals(number=double)
    cdef double number(self, PlcContext context) noexcept nogil
