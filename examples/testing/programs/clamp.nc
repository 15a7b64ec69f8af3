%clamp
; The program waits for the clamp: M111 has to be acknowledged before X moves.
; given: plc ../clamp_plc.py
; given: V.E.VALUE = 2
; given: V.E.TRIGGER = 1 at 150ms
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF EDGE V.E.TRIGGER == 1              ; expect: fired 1 at 150ms
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
N10 M111 G00 X10                         ; expect: M111 at 0s; X = 0 at 51ms; X = 0.002 at 52ms
M30                                      ; expect: ended; V.E.CONDITION = 1 at end
