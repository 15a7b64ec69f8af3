%coolant
; coolant before the cut; past 200 mm a realtime cycle asks the PLC for less speed
#RT CYCLE [ID = 4 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    M100
  $ENDIF
#RT CYCLE END
N5 G04 0.02
N10 M7
N20 G01 X400 F12000
N30 M9
M30
