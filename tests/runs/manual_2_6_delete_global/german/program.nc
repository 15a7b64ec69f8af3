; Ein globaler Zyklus geht erst, wenn man es ihm sagt.
#RT CYCLE [ID = 17 SCOPE = GLOBAL]
  V.E.COUNT += 1
#RT CYCLE END

#TIME 0.003

#RT CYCLE DELETE [ID = 17]
M30
