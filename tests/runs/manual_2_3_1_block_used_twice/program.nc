; Laid down once, usable for several blocks.
#RT CYCLE DEF [ID = 17 SCOPE = BLOCK]
  $IF ONCE 1 < 2
    V.E.COUNT += 1
  $ENDIF
  $IF V.E.TRIGGER == 1
    V.E.COUNT_POS += 1
  $ENDIF
#RT CYCLE END

; arm it for this block
#RT CYCLE START [ID = 17]
G00 X100
#TIME 0.01

; arm it again
#RT CYCLE START [ID = 17]
G00 X200
#TIME 0.005

M30
