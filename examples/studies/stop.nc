%stop
; V.E.TRIGGER stops the path at once: the later it comes, the farther X goes
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF V.E.TRIGGER > 0
    V.RTG.OVERRIDE.VEL.CYCLE = 0
  $ENDIF
#RT CYCLE END
N10 G01 X100 F6000
M30
