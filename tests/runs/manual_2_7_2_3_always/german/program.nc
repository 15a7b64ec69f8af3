#RT CYCLE [SCOPE = PROG]

  ; vom ersten Mal an, dass X über 200 ist
  $IF ALWAYS V.RTA.ACS.ACT_POS.X > 200

    ; in jedem Takt, auch wenn X wieder zurück ist
    M100

  $ENDIF

#RT CYCLE END

N10 G00 X200.5
N20 G00 X199.5
M30
