%crossing
; M100 as soon as X passes 200 mm, and three quarters of the speed from there on
#RT CYCLE [ID = 17 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    M100
    V.E.COUNT += 1
  $ENDIF
  $IF V.RTA.ACS.ACT_POS.X > 200
    V.RTG.OVERRIDE.VEL.CYCLE = 75
  $ENDIF
#RT CYCLE END
N10 G00 X500
N20 #MSG ["X has arrived, %d crossing", V.E.COUNT]
M30
