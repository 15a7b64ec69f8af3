%late
; a mistake to find: M100 never comes, the path never slows down; nctakt why late.nc
#RT CYCLE [ID = 4 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 400
    M100
  $ENDIF
#RT CYCLE END
N10 G01 X400 F12000
M30
