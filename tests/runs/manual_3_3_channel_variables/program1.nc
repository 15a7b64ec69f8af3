V.CH.Total = 2.5
V.CH.Table[4] = 7
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF ONCE 1 < 2
    V.CH.Total += V.CH.Table[4]
    V.CH.Var_name = 100.4
    V.CH.Level.UNS08 = 3
  $ENDIF
#RT CYCLE END
M30
