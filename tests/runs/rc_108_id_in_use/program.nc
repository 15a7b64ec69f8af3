#RT CYCLE [ID = 1 SCOPE = PROG]
#RT CYCLE END
#TIME 0.005
; the cycle above is still alive
#RT CYCLE [ID = 1 SCOPE = PROG]
#RT CYCLE END
M30
