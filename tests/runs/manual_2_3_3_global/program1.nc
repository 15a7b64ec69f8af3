; A global cycle must have an ID, else nobody could address it later.
#RT CYCLE [ID = 17 SCOPE = GLOBAL]
  V.E.COUNT += 1
#RT CYCLE END
#TIME 0.003
M30
