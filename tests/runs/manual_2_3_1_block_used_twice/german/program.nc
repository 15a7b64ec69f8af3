; Einmal abgelegt, für mehrere Sätze zu gebrauchen.
#RT CYCLE DEF [ID = 17 SCOPE = BLOCK]
  $IF ONCE 1 < 2
    V.E.COUNT += 1
  $ENDIF
  $IF V.E.TRIGGER == 1
    V.E.COUNT_POS += 1
  $ENDIF
#RT CYCLE END

; für diesen Satz scharf machen
#RT CYCLE START [ID = 17]
G00 X100
#TIME 0.01

; noch einmal scharf machen
#RT CYCLE START [ID = 17]
G00 X200
#TIME 0.005

M30
