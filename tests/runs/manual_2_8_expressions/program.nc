#RT CYCLE [SCOPE = PROG]

  ; an expression as a condition
  $IF SQRT[7 * 5] < 12 * SIN[30]

    V.E.COUNT += 1

  $ENDIF

  ; an expression as a value
  V.E.VALUE1 = 12 * SIN[V.E.VALUE2] + SQRT[33]

#RT CYCLE END

M30
