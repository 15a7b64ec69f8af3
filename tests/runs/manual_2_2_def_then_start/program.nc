; With DEF the cycle is only laid down; it needs an ID to be started by.
#RT CYCLE DEF [ID = 17 SCOPE = PROG]
  V.E.COUNT += 1
#RT CYCLE END

; whatever comes here finds the cycle asleep
#TIME 0.005

; and any later moment can start it
#RT CYCLE START [ID = 17]
M30
