V.E.ASYNC = 11
#RT CYCLE DEF [ID = 3 SCOPE = PROG]
  V.E.VALUE1 = V.E.ASYNC
  V.E.VALUE2 = V.E.VALUE
#RT CYCLE END

; too late for the cycle above, though it has not been started
V.E.ASYNC = 12
V.E.VALUE = 5
#TIME 0.002
#RT CYCLE START [ID = 3]
#TIME 0.003
M30
