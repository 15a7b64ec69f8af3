#RT CYCLE [SCOPE = PROG]

  ; die äußere Bedingung
  $IF V.E.CONDITION == 1

    ; die innere Verriegelung
    $IF ALWAYS V.E.VALUE > 100

      V.E.COUNT += 1

    $ENDIF

  $ENDIF

#RT CYCLE END
#TIME 0.014
M30
