; A global cycle goes only when it is told to.
#RT CYCLE [ID = 17 SCOPE = GLOBAL]
  V.E.COUNT += 1
#RT CYCLE END

#TIME 0.003

#RT CYCLE DELETE [ID = 17]
M30
