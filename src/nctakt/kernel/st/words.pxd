# SPDX-License-Identifier: MIT
# What compiled modules have instead of words.py: the processor's own words.
cdef extern from *:
    """
    #include <string.h>
    #include <math.h>
    #if defined(__GNUC__)
    #define NCTAKT_USUAL(x) __builtin_expect(!!(x), 1)
    #else
    #define NCTAKT_USUAL(x) (x)
    #endif
    typedef unsigned long long nctakt_u;
    static inline long long nctakt_load(const unsigned char *p, int kind) {
        if (NCTAKT_USUAL(kind == 3)) { int v; memcpy(&v, p, 4); return v; }
        if (NCTAKT_USUAL(kind <= 2)) {
            if (NCTAKT_USUAL(kind == 0)) return *p != 0;
            if (kind == 2) { short v; memcpy(&v, p, 2); return v; }
            return (signed char)*p;
        }
        switch (kind) {
            case 5: return *p;
            case 6: { unsigned short v; memcpy(&v, p, 2); return v; }
            case 7: { unsigned int v; memcpy(&v, p, 4); return v; }
            default: { long long v; memcpy(&v, p, 8); return v; }
        }
    }
    static inline void nctakt_store(unsigned char *p, int kind, long long value) {
        unsigned int v = (unsigned int)value;
        unsigned short w = (unsigned short)value;
        if (NCTAKT_USUAL(kind == 3)) memcpy(p, &v, 4);
        else if (NCTAKT_USUAL(kind <= 2)) {
            if (NCTAKT_USUAL(kind == 0)) *p = value != 0;
            else if (kind == 2) memcpy(p, &w, 2);
            else *p = (unsigned char)value;
        }
        else switch (kind) {
            case 5: *p = (unsigned char)value; break;
            case 6: memcpy(p, &w, 2); break;
            case 7: memcpy(p, &v, 4); break;
            default: memcpy(p, &value, 8);
        }
    }
    static inline double nctakt_load_real(const unsigned char *p, int kind) {
        if (NCTAKT_USUAL(kind == 10)) { double v; memcpy(&v, p, 8); return v; }
        float v; memcpy(&v, p, 4); return v;
    }
    static inline void nctakt_store_real(unsigned char *p, int kind, double value) {
        if (NCTAKT_USUAL(kind == 10)) memcpy(p, &value, 8);
        else { float v = (float)value; memcpy(p, &v, 4); }
    }
    static inline long long nctakt_divide(long long l, long long r) {
        return r == -1 ? (long long)(0 - (nctakt_u)l) : l / r;
    }
    static inline long long nctakt_modulo(long long l, long long r) {
        return r == -1 ? 0 : l % r;
    }
    static inline long long nctakt_wrap(long long v, int kind) {
        if (NCTAKT_USUAL(kind == 3)) return (int)v;
        switch (kind) {
            case 0: return v != 0;
            case 1: return (signed char)v;
            case 2: return (short)v;
            case 5: return (unsigned char)v;
            case 6: return (unsigned short)v;
            case 7: return (unsigned int)v;
            default: return v;
        }
    }
    #include <stdio.h>
    #include <stdlib.h>
    static inline int nctakt_decimal(unsigned char *p, double value, int is_single) {
        int digits, count = 0;
        for (digits = 0; digits < 17; digits++) {
            count = snprintf((char *)p, 32, "%.*e", digits, value);
            double again = strtod((char *)p, NULL);
            if ((is_single ? (double)(float)again : again) == value) break;
        }
        return count;
    }
    static inline double nctakt_parse(const unsigned char *p, int count) {
        char text[64];
        if (count > 63) count = 63;
        memcpy(text, p, count);
        text[count] = 0;
        return strtod(text, NULL);
    }
    """
    int nctakt_decimal(unsigned char *p, double value, int is_single) noexcept nogil
    double nctakt_parse(const unsigned char *p, int count) noexcept nogil
    long long nctakt_load(const unsigned char *p, int kind) noexcept nogil
    void nctakt_store(unsigned char *p, int kind, long long value) noexcept nogil
    double nctakt_load_real(const unsigned char *p, int kind) noexcept nogil
    void nctakt_store_real(unsigned char *p, int kind, double value) noexcept nogil
    long long nctakt_divide(long long l, long long r) noexcept nogil
    long long nctakt_modulo(long long l, long long r) noexcept nogil
    long long nctakt_wrap(long long v, int kind) noexcept nogil
    void *memmove(void *to, const void *source, size_t count) noexcept nogil
    void *memset(void *to, int value, size_t count) noexcept nogil
    int memcmp(const void *one, const void *other, size_t count) noexcept nogil
    void *memchr(const void *text, int value, size_t count) noexcept nogil

cdef inline long long load(unsigned char[::1] memory, long long at, int kind) noexcept nogil:
    return nctakt_load(&memory[at], kind)

cdef inline void store(
    unsigned char[::1] memory, long long at, int kind, long long value
) noexcept nogil:
    nctakt_store(&memory[at], kind, value)

cdef inline double load_real(unsigned char[::1] memory, long long at, int kind) noexcept nogil:
    return nctakt_load_real(&memory[at], kind)

cdef inline void store_real(
    unsigned char[::1] memory, long long at, int kind, double value
) noexcept nogil:
    nctakt_store_real(&memory[at], kind, value)

cdef inline void copy(
    unsigned char[::1] memory, long long to, long long source, long long count
) noexcept nogil:
    memmove(&memory[to], &memory[source], count)

cdef inline void fill(
    unsigned char[::1] memory, long long at, long long count, int value
) noexcept nogil:
    memset(&memory[at], value, count)

cdef inline int compare(
    unsigned char[::1] memory, long long one, long long other, long long count
) noexcept nogil:
    cdef int order = memcmp(&memory[one], &memory[other], count)
    return (order > 0) - (order < 0)

cdef inline long long length(
    unsigned char[::1] memory, long long at, long long count
) noexcept nogil:
    cdef unsigned char *found = <unsigned char *>memchr(&memory[at], 0, count)
    return count if found == NULL else found - &memory[at]

cdef inline long long length_wide(
    unsigned char[::1] memory, long long at, long long count
) noexcept nogil:
    cdef long long i = 0
    while i < count and (memory[at + 2 * i] or memory[at + 2 * i + 1]):
        i += 1
    return i

cdef inline int compare_wide(
    unsigned char[::1] memory, long long one, long long other, long long count
) noexcept nogil:
    cdef long long i, left, right
    for i in range(count):
        left = nctakt_load(&memory[one + 2 * i], 6)
        right = nctakt_load(&memory[other + 2 * i], 6)
        if left != right:
            return 1 if left > right else -1
    return 0

cdef inline long long add(long long left, long long right) noexcept nogil:
    return <long long>(<unsigned long long>left + <unsigned long long>right)

cdef inline long long subtract(long long left, long long right) noexcept nogil:
    return <long long>(<unsigned long long>left - <unsigned long long>right)

cdef inline long long multiply(long long left, long long right) noexcept nogil:
    return <long long>(<unsigned long long>left * <unsigned long long>right)

cdef inline long long divide(long long left, long long right) noexcept nogil:
    return nctakt_divide(left, right)

cdef inline long long modulo(long long left, long long right) noexcept nogil:
    return nctakt_modulo(left, right)

cdef inline long long divide_unsigned(long long left, long long right) noexcept nogil:
    return <long long>(<unsigned long long>left / <unsigned long long>right)

cdef inline long long modulo_unsigned(long long left, long long right) noexcept nogil:
    return <long long>(<unsigned long long>left % <unsigned long long>right)

cdef inline long long wrap(long long value, int kind) noexcept nogil:
    return nctakt_wrap(value, kind)

cdef inline long long shift_left(long long value, int count) noexcept nogil:
    return <long long>(<unsigned long long>value << count)

cdef inline long long shift_right(long long value, int count) noexcept nogil:
    return <long long>(<unsigned long long>value >> count)

cdef inline double real_of_unsigned(long long value) noexcept nogil:
    return <double><unsigned long long>value

cdef inline long long unsigned_of_real(double value) noexcept nogil:
    return <long long><unsigned long long>value

cdef inline double single(double value) noexcept nogil:
    return <double><float>value

cdef inline long long decimal(
    unsigned char[::1] memory, long long at, double value, bint is_single
) noexcept nogil:
    return nctakt_decimal(&memory[at], value, is_single)

cdef inline double parse(unsigned char[::1] memory, long long at, long long count) noexcept nogil:
    return nctakt_parse(&memory[at], count)
