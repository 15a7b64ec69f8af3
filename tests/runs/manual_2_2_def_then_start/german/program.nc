; Mit DEF ist er nur abgelegt; eine ID braucht er für den Start.
#RT CYCLE DEF [ID = 17 SCOPE = PROG]
  V.E.COUNT += 1
#RT CYCLE END

; was hier kommt, trifft den Zyklus schlafend
#TIME 0.005

; und zu jeder späteren Zeit kann er starten
#RT CYCLE START [ID = 17]
M30
