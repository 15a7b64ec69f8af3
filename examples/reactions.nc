%reactions
; ONCE, EDGE, a latch inside a plain $IF, and a condition that two things must meet
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    M100
  $ENDIF
  $IF EDGE V.RTA.ACS.ACT_POS.X > 100
    V.E.COUNT += 1
  $ENDIF
  $IF V.E.CONDITION == 1
    $IF ALWAYS V.E.VALUE > 100
      V.E.LIST[0] += 1
    $ENDIF
  $ENDIF
  $IF V.RTA.ACS.ACT_POS.X > 290 && V.E.TRIGGER == 1
    V.E.COUNT = 0
  $ENDIF
#RT CYCLE END
N10 G00 X300
N20 G00 X0
N30 G00 X300
M30
