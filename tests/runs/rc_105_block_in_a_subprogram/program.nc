%L WAITING
; the first block that takes time stands in here
#TIME 0.002
#TIME 0.002
M17

%MAIN
#RT CYCLE [ID = 1 SCOPE = BLOCK]
  V.E.COUNT += 1
#RT CYCLE END
LL WAITING
M30
