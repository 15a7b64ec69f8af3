; A cycle for one block only.
#RT CYCLE [SCOPE = BLOCK]
  $IF ONCE 1 < 2
    V.E.COUNT_POS = 1
  $ENDIF
  $IF V.E.TRIGGER == 1
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END

; this is the block that it belongs to
G00 X100

; and here it is gone
#TIME 0.005
M30
