# SPDX-License-Identifier: MIT
# What compiled modules have instead of real_leaves.py: constants and variables are read without a
# call.
cdef extern from *:
    """
    #include <string.h>
    #if defined(__GNUC__)
    #define NCTAKT_NEVER __builtin_unreachable()
    #else
    #define NCTAKT_NEVER break
    #endif
    static inline double nctakt_follow(
        const long long *link, long long count, double number, const unsigned char *memory,
        long long frame, long long instance
    ) {
        const long long *end = link + count;
        const unsigned char *from[4];
        from[0] = (const unsigned char *)link;
        from[1] = memory;
        from[2] = memory + frame;
        from[3] = memory + instance;
        do {
            const unsigned char *p = from[link[0]] + link[1];
            double v; float s;
            switch (link[2]) {
                case 0: memcpy(&v, p, 8); number += v; break;
                case 1: memcpy(&s, p, 4); number += s; break;
                case 2: memcpy(&v, p, 8); number -= v; break;
                case 3: memcpy(&s, p, 4); number -= s; break;
                case 4: memcpy(&v, p, 8); number = v - number; break;
                case 5: memcpy(&s, p, 4); number = s - number; break;
                case 6: memcpy(&v, p, 8); number *= v; break;
                case 7: memcpy(&s, p, 4); number *= s; break;
                case 8: number = (float)number; break;
                default: NCTAKT_NEVER;
            }
            link += 4;
        } while (link != end);
        return number;
    }
    """
    double nctakt_follow(
        const long long *link, long long count, double number, const unsigned char *memory,
        long long frame, long long instance
    ) noexcept nogil

from nctakt.kernel.st cimport kinds, words
from nctakt.kernel.st.context cimport PlcContext
from nctakt.kernel.st.reals cimport Real

cdef inline double number_of(Real node, PlcContext context) noexcept nogil:
    cdef long long at = node.offset
    if node.leaf != kinds.IN_DATA:
        if node.leaf == kinds.COMPUTED:
            return node.number(context)
        if node.leaf == kinds.CONSTANT:
            return node.constant
        at += context.frame if node.leaf == kinds.IN_FRAME else context.instance
    return words.load_real(context.memory, at, node.kind)

cdef inline double valid(PlcContext context, double result) noexcept nogil:
    if result != result and context.stops_at_invalid:
        context.fail(kinds.INVALID, 0, 0)
    return result

cdef inline double followed(
    long long[::1] links, double number, PlcContext context
) noexcept nogil:
    if links.shape[0] == 0:
        return number
    return valid(context, nctakt_follow(
        &links[0], links.shape[0], number, &context.memory[0], context.frame, context.instance
    ))
