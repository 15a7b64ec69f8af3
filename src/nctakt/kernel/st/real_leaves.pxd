# SPDX-License-Identifier: MIT
# What compiled modules have instead of real_leaves.py: constants and variables are read without a
# call.
cdef extern from *:
    pass

from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.reals cimport Real

cdef inline double number_of(Real node, PlcContext context) noexcept nogil:
    cdef long long at
    if node.leaf == kinds.COMPUTED:
        return node.number(context)
    if node.leaf == kinds.CONSTANT:
        return node.constant
    at = node.offset
    if node.leaf == kinds.IN_FRAME:
        at += context.frame
    elif node.leaf == kinds.IN_INSTANCE:
        at += context.instance
    return words.load_real(context.memory, at, node.kind)
