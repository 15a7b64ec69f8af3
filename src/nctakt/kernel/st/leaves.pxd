# SPDX-License-Identifier: MIT
# What compiled modules have instead of leaves.py: constants and variables are read without a call.
cdef extern from *:
    pass

from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.wholes cimport Whole

cdef inline long long value_of(Whole node, PlcContext context) noexcept nogil:
    cdef long long at
    if node.leaf == kinds.COMPUTED:
        return node.value(context)
    at = node.offset
    if node.leaf == kinds.CONSTANT:
        return at
    if node.leaf == kinds.IN_FRAME or node.leaf == kinds.FRAME_PLACE:
        at += context.frame
    elif node.leaf != kinds.IN_DATA:
        at += context.instance
    if node.leaf >= kinds.FRAME_PLACE:
        return at
    return words.load(context.memory, at, node.kind)
