#RT CYCLE [SCOPE = PROG]

  ; the condition outside
  $IF V.E.CONDITION == 1

    ; the latch inside
    $IF ALWAYS V.E.VALUE > 100

      V.E.COUNT += 1

    $ENDIF

  $ENDIF

#RT CYCLE END
#TIME 0.014
M30
