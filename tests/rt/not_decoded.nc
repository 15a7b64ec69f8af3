; Only definitions that the decoder meets are listed.
$IF V.E.COUNT == 1
  #RT CYCLE [ID=1]
    M100
  #RT CYCLE END
$ELSE
  #RT CYCLE DEF [ID=2]
  #RT CYCLE END
$ENDIF
M30
