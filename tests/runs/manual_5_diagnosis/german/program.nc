; alles melden
V.RTG.CYCLES.DIAG_LEVEL = 99

#RT CYCLE [SCOPE = PROG]

  ; etwas zu erzählen
  $IF ONCE V.E.TRIGGER == 0
    M100
    V.E.COUNT += 1
  $ENDIF

#RT CYCLE END

M30
