N5 V.CH.VarTest1 = -5

N10 #RT CYCLE [ID = 17 SCOPE = PROG]
  ; synchronous here, whatever the list says
N20 $IF ONCE Vs.CH.VarTest1 < 1
N30 Vs.CH.VarTest1 = 1 ; and here
  ; as the list says: frozen
N32 V.E.VALUE1 = V.CH.VarTest1
N34 V.E.VALUE2 = Vs.CH.VarTest1
N40 $ENDIF
N50 #RT CYCLE END
N60 M30
