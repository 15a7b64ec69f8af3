; ID 1 ist wieder frei: ihr PROG-Zyklus ist gelöscht.
#RT CYCLE [ID = 1 SCOPE = PROG]
  V.E.COUNT_NULL += 1
#RT CYCLE END
#TIME 0.002
M30
