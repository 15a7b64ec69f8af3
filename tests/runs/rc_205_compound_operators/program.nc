#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF ONCE 1 < 2
    V.E.VALUE1 = 10
    V.E.VALUE1 += V.E.VALUE
    V.E.VALUE1 -= 3 * 2
    V.E.VALUE1 *= 1 + 1
    V.E.VALUE1 /= V.E.VALUE
    V.E.COUNT_POS = 7
    V.E.COUNT_POS /= 2
    V.E.COUNT_POS *= 0.625
    V.E.COUNT_POS -= 2.5
    V.E.COUNT_POS += 1.5
    V.E.LIST[3] += 5
    V.E.LIST[V.E.COUNT_POS + 1] *= 2
    V.CH.Total -= 1
  $ENDIF
#RT CYCLE END
P1 = 10
P1 += 8
P1 -= 3 * 2
P1 *= 1 + 1
P1 /= 8
#MSG ["%d", P1]
M30
