; A cycle without DEF runs as soon as the channel takes its definition.
#RT CYCLE [SCOPE = PROG]
  ; count the first three run-throughs
  $IF V.E.COUNT < 3
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END

; the cycle is at work before this block has moved at all
N10 G00 X100
M30
