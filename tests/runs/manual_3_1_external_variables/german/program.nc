V.E.SYNC = 47   ; durch die Warteschlange
V.E.ASYNC = 11  ; sofort, während das Programm gelesen wird

#RT CYCLE [SCOPE = PROG]

  ; einmal genügt
  $IF ONCE 1 < 2

    V.E.SYNC = 99

    ; liest, was die Anweisung davor geschrieben hat: 198
    V.E.VALUE1 = 2 * V.E.SYNC

    ; seit dem Lesen der Definition eine Konstante: 22
    V.E.VALUE2 = 2 * V.E.ASYNC

  $ENDIF

#RT CYCLE END

M30
