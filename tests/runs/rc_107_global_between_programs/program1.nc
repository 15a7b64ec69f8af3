; Keeps its $IF states over the end of the program.
#RT CYCLE [ID = 17 SCOPE = GLOBAL]
  $IF EDGE V.E.TRIGGER == 1
    V.E.COUNT += 1
  $ENDIF
  $IF ALWAYS V.E.VALUE > 0
    M100
  $ENDIF
#RT CYCLE END
#TIME 0.002
M30
