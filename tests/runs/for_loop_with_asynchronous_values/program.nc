; The loop is the decoder's; each cycle keeps the values of its own pass.
$FOR P1 = 1, 3, 1
  V.E.ASYNC = 10 * P1
  #RT CYCLE [ID = P1 SCOPE = PROG]
    $IF ONCE 1 < 2
      V.E.LIST[P1] = V.E.ASYNC + P1
    $ENDIF
  #RT CYCLE END
$ENDFOR
V.E.ASYNC = 99
M30
