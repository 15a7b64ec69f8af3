; ID 1 is free again: the PROG cycle that had it is deleted.
#RT CYCLE [ID = 1 SCOPE = PROG]
  V.E.COUNT_NULL += 1
#RT CYCLE END
#TIME 0.002
M30
