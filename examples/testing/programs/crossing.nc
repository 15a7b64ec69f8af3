%crossing
; M100 as soon as X passes 200 mm; its counter; slower from there on
; expect: ended; expect: fired never after 0.5s
#RT CYCLE [ID = 17 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200     ; expect: fired once at 463ms
    M100                                 ; expect: M100 at 463ms
    V.E.COUNT += 1
  $ENDIF
  $IF V.E.COUNT == 1
    V.RTG.OVERRIDE.VEL.CYCLE = 75        ; expect: OVERRIDE.VEL.TOTAL = 75 at 0.6s
  $ENDIF
#RT CYCLE END
N10 G00 X500                             ; expect: X = 200.25 at 463 ticks; X = 500 at end
N20 #MSG ["done"]                        ; expect: message "done" after 1s
M30                                      ; expect: V.E.COUNT = 1 at end
