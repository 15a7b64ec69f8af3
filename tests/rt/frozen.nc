; Asynchronous values are those of the moment when the definition is decoded (RC-302); a definition
; that is decoded again has others.
; --set V.E.VALUE2=5
P1 = 100
$FOR P2 = 1, 2, 1
  P1 = P1 + P2
  #RT CYCLE [SCOPE=BLOCK]
    $IF EDGE V.RTA.ACS.ACT_POS.X > P1 / P2
      V.E.VALUE1 += P[P2 - 1] + V.E.VALUE2
    $ENDIF
  #RT CYCLE END
  G00 X[P2 * 10]
$ENDFOR
#RT CYCLE DEF [ID=[P2 + 5]]
  P1
#RT CYCLE END
M30
