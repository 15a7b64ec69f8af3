#RT CYCLE [ID = 1 SCOPE = BLOCK]
  V.E.COUNT += 1
#RT CYCLE END
; this block waits, and takes a tick by that
#FLUSH WAIT
#TIME 0.002
#TIME 0.002
M30
