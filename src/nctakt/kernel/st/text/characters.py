# SPDX-License-Identifier: MIT
"""Characters of numbers in texts, and which numbers have an exponent."""

ZERO, NINE, PLUS, MINUS, POINT, HASH, UNDERSCORE, BLANK = 48, 57, 43, 45, 46, 35, 95, 32
LARGE_A, LARGE_E, LARGE_F, COLON = 65, 69, 70, 58
#: Real numbers from 10**-5 up to 10**15 have no exponent.
MIN_EXPONENT = -5
FIRST_EXPONENT = 16

#: Letters: T, F and what follows them in TRUE, FALSE and units of time.
SMALL_D, SMALL_E, SMALL_H, SMALL_M, SMALL_N, SMALL_S, SMALL_U = 100, 101, 104, 109, 110, 115, 117
LARGE_D, LARGE_I, LARGE_L, LARGE_M, LARGE_N, LARGE_O = 68, 73, 76, 77, 78, 79
LARGE_R, LARGE_S, LARGE_T, LARGE_U = 82, 83, 84, 85
#: Difference between lower and upper case, and the value of E among the digits of base 15.
SMALL = 32
DIGIT_E = 14
#: ``true`` as four bytes.
TRUE = 0x65757274
SMALL_LETTERS = 0x20202020
#: The last character of Latin-1, and the replacement for others in a STRING.
LATIN_LAST, QUESTION = 255, 63
#: Bases of whole numbers other than ten (ST-206).
BINARY, OCTAL, HEXADECIMAL = 2, 8, 16
