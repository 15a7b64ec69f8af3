; Ohne DEF läuft der Zyklus, sobald der Kanal seine Definition nimmt.
#RT CYCLE [SCOPE = PROG]
  ; die ersten drei Durchläufe zählen
  $IF V.E.COUNT < 3
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END

; der Zyklus arbeitet, bevor dieser Satz sich überhaupt bewegt
N10 G00 X100
M30
