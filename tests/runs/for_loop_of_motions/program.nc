; Blocks of a loop are blocks like any other.
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > 0.5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
$FOR P1 = 1, 3, 1
  G00 X1
  G00 X0
$ENDFOR
M30
