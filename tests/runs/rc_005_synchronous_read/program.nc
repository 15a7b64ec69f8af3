#RT CYCLE [ID = 1 SCOPE = PROG]
  V.E.VALUE1 = 10 * V.E.VALUE
#RT CYCLE END
#TIME 0.003
; the decoder waits here until the path stands
P1 = V.E.VALUE1
#MSG ["VALUE1 %d", P1]
M30
