#RT CYCLE [SCOPE = PROG]

  ; ein Ausdruck als Bedingung
  $IF SQRT[7 * 5] < 12 * SIN[30]

    V.E.COUNT += 1

  $ENDIF

  ; ein Ausdruck als Wert
  V.E.VALUE1 = 12 * SIN[V.E.VALUE2] + SQRT[33]

#RT CYCLE END

M30
