#RT CYCLE [SCOPE = PROG]
  ; je Takt einer von drei Zählern
  $IF V.E.VALUE > 0
    V.E.COUNT_POS += 1
  $ELSEIF V.E.VALUE < 0
    V.E.COUNT_NEG += 1
  $ELSE
    V.E.COUNT_NULL += 1
  $ENDIF
#RT CYCLE END

#TIME 0.012
M30
