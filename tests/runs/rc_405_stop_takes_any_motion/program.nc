; STOP of one cycle ends the motion of another one
#RT CYCLE [ID=1]
  $IF ONCE 1
    Z[INDP FEED=6000]
  $ENDIF
#RT CYCLE END
#RT CYCLE [ID=2]
  $IF ONCE V.RTA.ACS.ACT_POS.Z >= 10
    Z[INDP STOP]
  $ENDIF
#RT CYCLE END
G04 1
M30
