# SPDX-License-Identifier: MIT
# What compiled modules have instead of leaves.py: constants and variables are read without a call.
cdef extern from *:
    pass

from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.wholes cimport ElementPlace, Whole

cdef inline long long value_of(Whole node, PlcContext context) noexcept nogil:
    cdef long long at = node.offset
    if node.leaf != kinds.IN_DATA:
        if node.leaf <= kinds.COMPUTED:
            return node.value(context)
        if node.leaf == kinds.CONSTANT:
            return at
        at += context.frame if node.leaf == kinds.IN_FRAME else context.instance
    return words.load(context.memory, at, node.kind)

cdef inline long long place_of(Whole node, PlcContext context) noexcept nogil:
    if node.leaf == kinds.CONSTANT:
        return node.offset
    if node.leaf == kinds.INSTANCE_PLACE:
        return node.offset + context.instance
    if node.leaf == kinds.FRAME_PLACE:
        return node.offset + context.frame
    return node.value(context)

cdef inline bint is_near(Whole node) noexcept nogil:
    return node.leaf > kinds.COMPUTED

cdef inline long long near_value(Whole node, PlcContext context) noexcept nogil:
    cdef long long at = node.offset
    if node.leaf != kinds.IN_DATA:
        if node.leaf == kinds.CONSTANT:
            return at
        at += context.frame if node.leaf == kinds.IN_FRAME else context.instance
    return words.load(context.memory, at, node.kind)

cdef inline bint is_near_place(Whole node) noexcept nogil:
    return node.leaf == kinds.CONSTANT or node.leaf < kinds.COMPUTED

cdef inline long long near_place(Whole node, PlcContext context) noexcept nogil:
    if node.leaf == kinds.CONSTANT:
        return node.offset
    return node.offset + (context.instance if node.leaf < kinds.FRAME_PLACE else context.frame)

cdef inline long long near_element(Whole node, PlcContext context) noexcept nogil:
    cdef long long number = near_value((<ElementPlace>node).index, context)
    number = words.subtract(number, (<ElementPlace>node).lowest)
    if <unsigned long long>number >= <unsigned long long>(<ElementPlace>node).count:
        return 0
    number *= (<ElementPlace>node).stride
    return near_place((<ElementPlace>node).address, context) + node.offset + number

cdef inline long long target_of(Whole node, PlcContext context) noexcept nogil:
    cdef long long at = place_of(node, context)
    if at < kinds.NULL_BYTES or at >= context.plain_end:
        return context.checked_target(at, 1)
    return at
