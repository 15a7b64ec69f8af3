P10 = 0
P1 = 1
P2 = 2
P3 = 3
P4 = 4
P5 = 5
P6 = 6
P7 = 7
P8 = 8
P9 = 9
#MSG ["%g %g %g %g %g %g", P1 + P2 * P3, [P1 + P2] * P3, P9 - P4 - P3, P9 - [P4 - P3], P8 / P4 / P2, P8 / P4 * P2]
#MSG ["%g %g %g %g %g %g", P2 ** P3 ** P2, [P2 ** P3] ** P2, - P2 ** P2, [- P2] ** P2, P2 ** - P1, P2 ** - P1 * P4]
#MSG ["%g %g %g %g %g %g", P2 * P3 ** P2, P9 MOD P4 * P3, P5 * P9 MOD P4, P7 - P9 MOD P4, P5 - - P3, - P2 + P5]
#MSG ["%g %g %g %g %g %g", - P2 * P3 + P1, P1 + P2 < P4, P4 < P1 + P2, P5 == P2 + P3, P5 != P5, P4 >= P4]
#MSG ["%g %g %g %g %g %g", P4 > P4, P4 <= P4, P3 > P2 > P1, P3 < P2 < P1, P6 & P2 == P2, P1 | P6 ^ P3]
#MSG ["%g %g %g %g %g %g", P6 ^ P3 & P1, P1 + P5 & P2, P1 | P2 && P10, P10 && P1 XOR P1, NOT P10 == P2, P1 || P1 XOR P1]
#MSG ["%g %g %g %g %g %g", NOT P5, P1 XOR P1 || P1, P10 || P10 && P1, P1 || P10 && P10, P2 + P3 ** P2 * P4 - P6 / P3 MOD P2, [[P1 + P2] * [P3 + P4] - P5] / P8]
#MSG ["%g", P9 - P2 ** P3 * [P1 + P4 MOD P3]]
M30
