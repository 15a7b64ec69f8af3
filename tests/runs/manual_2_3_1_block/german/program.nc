; Ein Zyklus für einen einzigen Satz.
#RT CYCLE [SCOPE = BLOCK]
  $IF ONCE 1 < 2
    V.E.COUNT_POS = 1
  $ENDIF
  $IF V.E.TRIGGER == 1
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END

; das ist der Satz, zu dem er gehört
G00 X100

; und hier ist er weg
#TIME 0.005
M30
