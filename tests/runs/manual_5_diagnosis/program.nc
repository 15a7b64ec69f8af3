; tell everything
V.RTG.CYCLES.DIAG_LEVEL = 99

#RT CYCLE [SCOPE = PROG]

  ; something to tell
  $IF ONCE V.E.TRIGGER == 0
    M100
    V.E.COUNT += 1
  $ENDIF

#RT CYCLE END

M30
