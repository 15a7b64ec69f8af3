#RT CYCLE [SCOPE = PROG]

  ; from the first time that X is past 200
  $IF ALWAYS V.RTA.ACS.ACT_POS.X > 200

    ; in each tick, also when X has gone back again
    M100

  $ENDIF

#RT CYCLE END

N10 G00 X200.5
N20 G00 X199.5
M30
