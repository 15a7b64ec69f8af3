; a PROG cycle moves Z while X is on its way; the block behind it programs Z
#RT CYCLE [ID=1]
  $IF EDGE V.RTA.ACS.ACT_POS.X > 5
    Z[INDP G90 G00 POS=100]
  $ENDIF
#RT CYCLE END
G00 X10
N20 G00 X0 Z50
N30 G00 Z60
N40 G00 X10
N50 G00 Z0
M30
