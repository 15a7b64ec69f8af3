#RT CYCLE [SCOPE = PROG]

  ; jedes Mal, wenn X aufwärts über 200 geht
  $IF EDGE V.RTA.ACS.ACT_POS.X > 200

    M100

  $ENDIF

#RT CYCLE END

N10 G00 X300
N20 G00 X0
N30 G00 X300
N40 G00 X100
N50 G00 X250
M30
