#RT CYCLE DEF [ID = 8 SCOPE = PROG]
  $IF EDGE 1 < 2
    V.E.COUNT_POS += 1
  $ENDIF
  $IF ONCE 1 < 2
    V.E.COUNT_NEG += 1
  $ENDIF
#RT CYCLE END
#RT CYCLE START [ID = 8]
#TIME 0.003
; a start of a running cycle
#RT CYCLE START [ID = 8]
#TIME 0.003
#RT CYCLE HOLD [ID = 8]
#TIME 0.002
; keeps the states
#RT CYCLE CONTINUE [ID = 8]
#TIME 0.002
#RT CYCLE HOLD [ID = 8]
#TIME 0.002
; a start of a held cycle
#RT CYCLE START [ID = 8]
M30
