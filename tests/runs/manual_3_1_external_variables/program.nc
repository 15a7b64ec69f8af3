V.E.SYNC = 47   ; through the queue
V.E.ASYNC = 11  ; at once, while the program is read

#RT CYCLE [SCOPE = PROG]

  ; one time is enough
  $IF ONCE 1 < 2

    V.E.SYNC = 99

    ; reads what the statement before has written: 198
    V.E.VALUE1 = 2 * V.E.SYNC

    ; a constant since the definition was read: 22
    V.E.VALUE2 = 2 * V.E.ASYNC

  $ENDIF

#RT CYCLE END

M30
