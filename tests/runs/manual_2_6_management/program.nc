; X stands at 0 already: a move of no length
G00 X0

; lay the cycle down
#RT CYCLE DEF [ID = 17 SCOPE = PROG]

  ; once X has gone past 200
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    M100
  $ENDIF

  ; something that is seen only while the cycle is not held
  $IF EDGE V.E.TRIGGER == 1
    V.E.COUNT += 1
  $ENDIF

#RT CYCLE END

; not started yet
G00 X50

#RT CYCLE START [ID = 17]

; M100 happens on this way
G00 X250

#RT CYCLE HOLD [ID = 17]
#TIME 0.01
#RT CYCLE CONTINUE [ID = 17]
#TIME 0.01

; cycle 17 ends with the program
M30
