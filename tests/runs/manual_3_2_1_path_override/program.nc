#RT CYCLE [SCOPE = PROG]

  ; plain $IF: the override has to be written in each tick
  $IF V.RTA.ACS.ACT_POS.X > 200

    V.RTG.OVERRIDE.VEL.CYCLE = 75

  $ENDIF

#RT CYCLE END

; slower from 200 mm on
N10 G00 X500

M30
