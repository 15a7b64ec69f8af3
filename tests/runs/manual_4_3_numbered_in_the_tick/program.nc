; Numbers begin anew in each tick and run through all cycles.
#RT CYCLE [ID = 2 SCOPE = PROG]
  $IF ONCE 1 < 2
    M101
    M100
  $ENDIF
#RT CYCLE END
#RT CYCLE [ID = 1 SCOPE = PROG]
  M102
#RT CYCLE END
#TIME 0.003
M30
